#include "osm/way_tags.hpp"

#include <algorithm>
#include <cctype>

#include "osm/tag_slip.hpp"
#include "osm/tag_use.hpp"
#include "streetgen/measure_text.hpp"
#include "support/invariant.hpp"

namespace streetgen {

namespace {

// Without spaces, in small letters.
std::string plain(const std::string& text) {
  std::string word;
  for (const char letter : text)
    if (!std::isspace(static_cast<unsigned char>(letter)))
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return word;
}

}  // namespace

WayTags::WayTags(const OsmTags& tags, DrivingSide side) : tags_(tags) {
  const std::string oneway = value("oneway"), junction = value("junction"),
                    highway = value("highway");
  const auto is = [](const std::string& word, std::initializer_list<const char*> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  takes_turns_ = is(oneway, {"reversible", "alternating"});
  if (is(oneway, {"yes", "true", "1"}))
    direction_ = WayDirection::direct;
  else if (is(oneway, {"-1", "reverse"}))
    direction_ = WayDirection::reverse;
  else if (!takes_turns_ && !is(oneway, {"no", "false", "0"})) {
    if (!oneway.empty()) name("oneway", "it is no direction");
    // Lanes that are stated against it go before a direction that the class alone implies.
    const bool motorway = is(highway, {"motorway", "motorway_link"}) &&
                          !(count("lanes:backward", 0) > 0 && value("oneway:bus") != "no" &&
                            value("oneway:psv") != "no");
    if (is(junction, {"roundabout", "circular"}) || motorway) direction_ = WayDirection::direct;
  }
  near_is_right_ = (side == DrivingSide::right) != drawn_against();
}

std::string WayTags::value(const std::string& key) const {
  must_hold(tag_is_told(key), "the table of tags says what becomes of each key that is read", 0);
  const auto found = tags_.find(key);
  return found == tags_.end() ? std::string{} : plain(found->second);
}

std::string means_nothing(const std::string& word) {
  std::size_t end = std::min<std::size_t>(word.size(), 40);
  // Not within a letter of several bytes.
  while (end < word.size() && (static_cast<unsigned char>(word[end]) & 0xC0) == 0x80) --end;
  return "\"" + word.substr(0, end) + "\" means nothing there";
}

std::vector<std::string> parted_list(const std::string& list) {
  std::vector<std::string> words;
  for (std::size_t from = 0;;) {
    const std::size_t to = list.find('|', from);
    words.push_back(list.substr(from, to - from));
    if (to == std::string::npos) return words;
    from = to + 1;
  }
}

bool is_among(const std::string& word, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string word_among(const std::string& said, std::initializer_list<const char*> wanted) {
  for (std::size_t from = 0; from <= said.size();) {
    const std::size_t to = std::min(said.find(';', from), said.size());
    const std::string word = said.substr(from, to - from);
    if (std::find(wanted.begin(), wanted.end(), word) != wanted.end()) return word;
    from = to + 1;
  }
  return said;
}

std::string WayTags::key_of(const std::string& base, Heading heading) const {
  return base + ((heading == Heading::along) != drawn_against() ? ":forward" : ":backward");
}

std::string WayTags::key_of(const std::string& base, RoadSide kerb) const {
  return base + ((kerb == RoadSide::near) == near_is_right_ ? ":right" : ":left");
}

std::string WayTags::said_of(const std::string& base, Heading heading) const {
  const std::string key = key_of(base, heading);
  if (heading == Heading::along && one_way() && value(key).empty()) return base;
  return key;
}

std::string WayTags::said_of(const std::string& base, RoadSide kerb) const {
  const std::string key = key_of(base, kerb);
  return value(key).empty() ? base + ":both" : key;
}

std::optional<int> WayTags::count(const std::string& key, int least) {
  const std::string word = value(key);
  if (word.empty()) return std::nullopt;
  const std::string whole = word.substr(0, word.find('.'));
  const bool is_whole =
      word.size() == whole.size() || word.find_first_not_of('0', whole.size() + 1) == word.npos;
  if (is_whole && !whole.empty() && whole.size() <= 2 &&
      whole.find_first_not_of("0123456789") == whole.npos) {
    const int number = std::stoi(whole);
    if (number >= least && number <= 30) return number;
  }
  name(key, "it is no number of lanes from " + std::to_string(least) + " to 30");
  return std::nullopt;
}

void WayTags::name(const std::string& key, const std::string& reason) {
  for (const UnreadTag& tag : unread_)
    if (tag.key == key) return;
  unread_.push_back({key, reason});
}

void WayTags::name_first_of(const std::vector<std::string>& keys, const std::string& reason) {
  const auto had = std::find_if(keys.begin(), keys.end(),
                                [&](const std::string& key) { return tags_.count(key) > 0; });
  if (had != keys.end()) name(*had, reason);
}

void WayTags::name_strange_speeds(const std::string& key, const std::string& list) {
  for (const std::string& word : parted_list(list)) {
    const std::string small = plain(word);
    if (!small.empty() && small != "none" && small != "signals" && small != "variable" &&
        !read_kmh(word))
      name(key, means_nothing(word));
  }
}

void WayTags::name_strangers() {
  for (const auto& [key, word] : tags_) {
    if (key.compare(0, 7, "source:") == 0) continue;
    if (tag_is_told(key)) {
      if (word.find('|') != std::string::npos && key.find(":lanes") == std::string::npos)
        name(key, "it lists lanes, and its key speaks of none");
      if (const std::string strange = strange_word(key, value(key)); !strange.empty())
        name(key, means_nothing(strange));
      if (key.compare(0, 14, "maxspeed:lanes") == 0) name_strange_speeds(key, word);
    } else if (const std::string reason = strange_key(key); !reason.empty())
      name(key, reason);
  }
}

}  // namespace streetgen
