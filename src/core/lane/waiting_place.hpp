// Where lanes come to the street that they cross, or to a roundabout, and wait.
#pragma once

#include <optional>
#include <vector>

#include "lane/lane_layout.hpp"
#include "lane/lane_wishes.hpp"
#include "streetgen/street.hpp"

namespace streetgen {

class WaitingPlaces {
 public:
  // `before_kerb`: metres along the lane from a line to the roadway before which it lies.
  WaitingPlaces(const Streets& streets, const LaneWishes& wishes, double before_kerb);

  bool on_ring(int edge) const { return on_ring_[edge]; }
  // Whether traffic that leaves the edge at that end comes to a ring.
  bool enters_ring(int edge, bool at_start) const;

  // The middle of a line across a lane.
  struct Place {
    Point middle;
    Point rightwards;  // unit, seen along the axis
  };
  // The last place where the lane's ground is its own: before the roadways of the other streets of
  // the node, as their axes and widths give them; of the ring alone where it comes to one.  Traffic
  // goes on from the end of the lane along the axis.  Roadways that go on straight ahead are in
  // nobody's way.  None where the lane's ground is never its own, or no roadway is before it.
  std::optional<Place> before_roadway(const LaneStrip& strip, const Lane& lane, bool at_start,
                                      bool limits_crossed) const;

 private:
  // Roadway that a street has near its node.
  struct Arm {
    Line line;            // from the node outwards
    double half = 0;      // metres, at the node
    double widens = 0;    // of the half width, a metre
    double offset = 0;    // of the middle of the roadway, metres to the left
    bool across = true;   // it takes ground behind its end at the node, as wide as it is
    bool goes_on = true;  // behind the node, as another arm
    bool covers(const Point& place) const;
  };
  std::vector<Arm> arms_before(int edge, bool at_start, double reach) const;
  Arm arm_of(int edge, bool at_start, double reach) const;

  const Streets& streets_;
  double clear_;                        // metres, from the middle of a line
  std::vector<bool> on_ring_;           // by edge
  std::vector<std::vector<int>> ends_;  // by node: slots of the edges there
};

}  // namespace streetgen
