// The line between two lanes: who may cross it, and how it is painted where that is said.
#pragma once

#include <vector>

#include "streetgen/lane.hpp"

namespace streetgen {

class LaneChanges {
 public:
  LaneChanges(std::vector<LaneChange> by_hand, std::vector<LeavingOfAxis> leaving);

  // `lanes` and `separators` are all of one edge.  A change is as decided by hand; else it is
  // forbidden to and from parking, and between cycle lanes and others; else it is as the source
  // says of lanes of one direction, merging ones apart; else it is allowed over a dashed line.
  // The paint of a line between opposite directions, and of one of which nothing is said, stays.
  void settle(const Edge& edge, const std::vector<Lane>& lanes,
              std::vector<LaneSeparator>& separators) const;

 private:
  struct Change {
    bool said = false, allowed = false;
  };
  Change change(const Edge& edge, const std::vector<Lane>& lanes, const Lane& from, const Lane& to,
                bool dashed) const;
  Change by_source(const Edge& edge, const std::vector<Lane>& lanes, const Lane& from,
                   const Lane& to) const;

  std::vector<LaneChange> by_hand_;     // by axis_id
  std::vector<LeavingOfAxis> leaving_;  // by axis_id
};

}  // namespace streetgen
