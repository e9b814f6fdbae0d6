#include "osm/tag_slip.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <vector>

#include "osm/tag_use.hpp"

namespace streetgen {

namespace {

// Keys that people write in place of one that is known.
std::string known_in_place_of(const std::string& key) {
  const std::string start = "access:";
  if (key.compare(0, start.size(), start) == 0 && tag_is_told(key.substr(start.size())))
    return key.substr(start.size());
  for (const char* unit :
       {"feet", "foot", "ft", "inches", "metres", "meters", "metre", "meter", "m"})
    if (key == std::string("width:") + unit) return "width";
  return {};
}

constexpr std::size_t shortest_misspelt = 4;  // letters; shorter keys are too much alike

// A key, and what it is with a letter taken out.  Keys that are a letter away from each other share
// one of these.
template <class Take>
void each_worn(const std::string& key, const Take& take) {
  take(key);
  if (key.size() <= shortest_misspelt) return;
  for (std::size_t i = 0; i < key.size(); ++i) take(key.substr(0, i) + key.substr(i + 1));
}

// One of the words, but for a letter.
bool misspells(const std::string& said, const std::vector<std::string>& words) {
  std::set<std::string> worn;
  each_worn(said, [&](const std::string& each) { worn.insert(each); });
  bool near = false;
  for (const std::string& word : words) {
    if (word == said) return false;
    each_worn(word, [&](const std::string& each) { near = near || worn.count(each) > 0; });
  }
  return near;
}

// Without what parts the words of a key.
std::string bare(const std::string& key) {
  std::string letters;
  for (const char letter : key)
    if (std::isalnum(static_cast<unsigned char>(letter))) letters += letter;
  return letters;
}

// A known key whose words, or the first of them, are those of this one, parted otherwise.
std::string parted_otherwise(const std::string& key) {
  static const std::map<std::string, std::string> known = [] {
    std::map<std::string, std::string> keys;
    for (const auto& [told, use] : told_keys()) keys[bare(told)] = told;
    for (const auto& [told, use] : told_keys())
      for (std::size_t end = told.rfind(':'); end != told.npos && end > 0;
           end = told.rfind(':', end - 1))
        if (const std::string start = told.substr(0, end); start.find(':') != start.npos)
          keys.emplace(bare(start), told);
    return keys;
  }();
  const auto found = known.find(bare(key));
  const bool same_start = found != known.end() && found->second.compare(0, key.size(), key) == 0;
  return found == known.end() || same_start ? std::string{} : found->second;
}

// The known key that somebody who wrote this one means: another case, one letter away, or parted
// otherwise; empty: none.
std::string key_nearest_to(const std::string& key) {
  static const std::map<std::string, std::string> worn = [] {
    std::map<std::string, std::string> keys;
    for (const auto& [told, use] : told_keys())
      each_worn(told, [&, &meant = told](const std::string& each) { keys.emplace(each, meant); });
    return keys;
  }();
  std::string small;
  for (const char letter : key)
    small += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  if (tag_is_told(small)) return small;
  if (const std::string known = known_in_place_of(small); !known.empty()) return known;
  if (const std::string known = parted_otherwise(small); !known.empty()) return known;
  std::string nearest;
  if (small.size() >= shortest_misspelt)
    each_worn(small, [&](const std::string& each) {
      const auto found = worn.find(each);
      if (nearest.empty() && found != worn.end()) nearest = found->second;
    });
  return nearest;
}

// Does a key speak of lanes in words that tags about lanes have, which are not said so together?
bool is_joined_of_known_words(const std::string& key) {
  static const std::set<std::string> starts = {"lanes",    "width",  "est_width", "oneway",
                                               "turn",     "change", "placement", "busway",
                                               "cycleway", "parking"},
                                     ends = {"forward", "backward", "both", "both_ways",
                                             "left",    "right",    "lane", "lanes"};
  const std::vector<std::string> words = parted(key, ":");
  return words.size() > 1 && starts.count(words.front()) > 0 &&
         std::all_of(words.begin() + 1, words.end(),
                     [&](const std::string& word) { return ends.count(word) > 0; });
}

// Does a tag about lanes hold at times only?
bool holds_at_times(const std::string& key) {
  const std::size_t end = key.rfind(":conditional");
  if (end == key.npos || end + std::string(":conditional").size() != key.size()) return false;
  const auto told = told_keys().find(key.substr(0, end));
  if (told == told_keys().end()) return (":" + key).find(":lanes:") != key.npos;
  const std::vector<OsmTagUse>& of_lanes = osm_tag_uses();
  return told->second >= of_lanes.data() && told->second < of_lanes.data() + of_lanes.size();
}

}  // namespace

std::string strange_word(const std::string& key, const std::string& said) {
  const auto told = told_keys().find(key);
  if (told == told_keys().end()) return {};
  if (told->second->meant && misspells(said, parted(told->second->meant, " "))) return said;
  if (!told->second->words) return {};
  const std::string known = " " + std::string(told->second->words) + " ";
  for (std::size_t from = 0; from <= said.size();) {
    const std::size_t to = std::min(said.find_first_of("|;", from), said.size());
    const std::string word = said.substr(from, to - from);
    if (known.find(" " + word + " ") == std::string::npos && !word.empty()) return word;
    from = to + 1;
  }
  return {};
}

std::string strange_key(const std::string& key) {
  if (tag_is_told(key)) return {};
  if (holds_at_times(key)) return "it holds at times only";
  if (const std::string meant = key_nearest_to(key); !meant.empty())
    return "it is not known; " + meant + " is";
  const bool of_lanes = (":" + key + ":").find(":lanes:") != key.npos;
  return of_lanes || is_joined_of_known_words(key) ? "it is not known" : "";
}

}  // namespace streetgen
