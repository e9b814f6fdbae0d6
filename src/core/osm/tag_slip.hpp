// Slips in keys and words of tags.
#pragma once

#include <string>

namespace streetgen {

// The first word of a value, without spaces and in small letters, that means nothing there; empty:
// none.
std::string strange_word(const std::string& key, const std::string& said);

// Why a key that no importer knows is named: it is like one that is known, or speaks of lanes all
// the same; empty: it does not.
std::string strange_key(const std::string& key);

}  // namespace streetgen
