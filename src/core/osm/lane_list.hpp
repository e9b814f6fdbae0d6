// Lists of lanes of one direction, and what they say of each lane.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "osm/way_tags.hpp"

namespace streetgen {

// Metres; none where a word is no width that a lane of this kind may have.
std::optional<double> lane_width_of(const std::string& word, LaneKind kind);

// Of a street of both directions a list without one speaks of each where tag lanes counts it twice.
bool speaks_of_each_direction(const std::string& list, const WayTags& tags);

// Of one direction of a way.
class LaneLists {
 public:
  LaneLists(WayTags& tags, Heading heading);

  struct List {
    std::string key;
    std::vector<std::string> words;
  };
  const std::vector<List>& all() const { return lists_; }
  bool empty() const { return lists_.empty(); }

  // How the lanes of this direction can be read: the lists of one length say so many lanes.
  struct Reading {
    std::vector<LaneKind> kinds;  // of each lane of the lists
    int counted = 0;              // lanes that tag lanes counts, if this is how the lists are meant
    bool disagrees = false;       // tag lanes counts the cycle lanes too, against its definition
    bool supposed = false;        // a mark is not meant, or a cycle lane has none
    int of_motor_traffic() const;  // also closed ones
  };
  // The longest first; of one length that first where all that may be a cycle lane is one.  Lists
  // that name no cycle lane may count those of the kerbs.
  struct KerbCycles {
    bool at_left = false, at_right = false;
  };
  std::vector<Reading> readings(KerbCycles kerbs, WayTags& tags) const;

  // Does a list say who drives here?  On a one-way street it makes a lane against the traffic.
  bool say_who() const;

 private:
  enum class Mark { general, bus, carpool, cycle, maybe_cycle, closed };
  std::string word(const std::string& name, std::size_t length, std::size_t lane) const;
  void name_word_of_cars(std::size_t length, std::size_t lane, const char* reason,
                         WayTags& tags) const;
  Mark mark(std::size_t length, std::size_t lane, WayTags& tags) const;

  Heading heading_;
  std::vector<List> lists_;
  std::vector<std::string> names_;  // of each list: turn, vehicle, …
};

}  // namespace streetgen
