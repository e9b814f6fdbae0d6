// The tags of a way as somebody sees them who drives it: a one-way street is driven along,
// whichever way it is drawn.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "streetgen/osm_lanes.hpp"

namespace streetgen {

enum class Heading { along, against };  // the traffic; of a two-way street: the way
// Of those who drive along: near is the side on which one drives.
enum class RoadSide { near, far };

// The reason why a word is named, of which a long one is cut.
std::string means_nothing(const std::string& word);

// The words of a list, parted by |.
std::vector<std::string> parted_list(const std::string& list);

bool is_among(const std::string& word, std::initializer_list<const char*> words);
// The first of several words, parted by ;, that is one of these; where none is: all that is said.
std::string word_among(const std::string& said, std::initializer_list<const char*> wanted);

class WayTags {
 public:
  WayTags(const OsmTags& tags, DrivingSide side);

  bool one_way() const { return direction_ != WayDirection::both; }
  // One direction at a time: all lanes are for both.
  bool takes_turns() const { return takes_turns_; }
  WayDirection direction() const { return direction_; }
  bool drawn_against() const { return direction_ == WayDirection::reverse; }

  // The value of a tag without spaces about it, in small letters; empty: there is none.
  std::string value(const std::string& key) const;
  std::string key_of(const std::string& base, Heading heading) const;  // lanes -> lanes:forward
  std::string key_of(const std::string& base, RoadSide kerb) const;    // busway -> busway:left
  // The first of these keys that the way has: with the suffix of the heading, and, where one alone
  // is driven, without one.
  std::string said_of(const std::string& base, Heading heading) const;
  std::string said_of(const std::string& base, RoadSide kerb) const;  // also :both

  // A count of a tag from `least` to 30; a value that is none is named.
  std::optional<int> count(const std::string& key, int least);

  void name(const std::string& key, const std::string& reason);
  void name_first_of(const std::vector<std::string>& keys,
                     const std::string& reason);  // that it has
  // Tags about lanes that nobody knows, keys that are misspelt, and words that mean nothing.
  void name_strangers();
  std::vector<UnreadTag> take_unread() { return std::move(unread_); }

 private:
  // Words of a list of speeds that are none.
  void name_strange_speeds(const std::string& key, const std::string& list);

  const OsmTags& tags_;
  bool near_is_right_;  // of the way as it is drawn
  bool takes_turns_ = false;
  WayDirection direction_ = WayDirection::both;
  std::vector<UnreadTag> unread_;
};

}  // namespace streetgen
