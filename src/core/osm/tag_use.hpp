// The keys of ways that importers look at.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "streetgen/osm_lanes.hpp"

namespace streetgen {

// What becomes of each key.
const std::map<std::string, const OsmTagUse*>& told_keys();

// Does the table of tags say what becomes of this key?
bool tag_is_told(const std::string& key);

// The parts of a text between marks.
std::vector<std::string> parted(const std::string& text, const std::string& mark);

}  // namespace streetgen
