// The keys that the reader of lanes looks at.
#pragma once

#include <string>

namespace streetgen {

// Does the table of tags say what becomes of this key?
bool tag_is_told(const std::string& key);

}  // namespace streetgen
