// The keys of ways that importers look at, and slips in them.
#pragma once

#include <string>

namespace streetgen {

// Does the table of tags say what becomes of this key?
bool tag_is_told(const std::string& key);

// The first word of a value, without spaces and in small letters, that means nothing there; empty:
// none.
std::string strange_word(const std::string& key, const std::string& said);

// The known key that somebody who wrote this one means, another case or one letter away; empty:
// none.
std::string key_nearest_to(const std::string& key);

}  // namespace streetgen
