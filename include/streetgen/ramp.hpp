// Ramps: where a link joins a highway or leaves it, and the lanes that merging traffic needs there.
// Wilkie, Sewall and Lin, 4.3.2.
//
// A ramp is a node of three edges: a link for one direction of traffic, and a highway that comes
// and goes on, bent by less than 30 degrees.  The link leaves the highway's course by up to 60
// degrees.  On a highway with traffic in both directions it lies on the outer side of its own
// direction.  Everything else is a junction, no ramp.
//
// Lanes are counted in the direction of the ramp's traffic.  Where a ramp comes upon the highway,
// before + ramp - after lanes are missing behind the node; where one leaves, after + ramp - before
// are missing before it, less the lanes marked for both ways on.  So many merging lanes, at most as
// many as the ramp has, lie outside of the highway's lanes on the side of the ramp.
//
// Merging lanes run along the highway over each node that only joins two of its edges: no other
// edge is there, and the highway bends by less than 30 degrees. Merging lanes end at any other
// node, and where the lanes or the width of the highway change.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace streetgen {

struct Edge;

// The part that an axis may take at a ramp.
enum class RampPart {
  none,
  highway,
  link,
  unclassed,  // no class is known: the straightest of three is the highway, at 80 km/h and more
};

// The lanes of one direction, general and bus lanes together.
struct RampLanes {
  int count = 0;
  // The number of these lanes that are marked both to go on and to turn to that side.  Sides are
  // those of the traffic.
  int parting_left = 0, parting_right = 0;
};

constexpr double steepest_ramp = 0.5;  // cosine of the angle between a link and its highway
constexpr double longest_taper = 300;  // metres, of a merging lane

struct RampAxis {
  std::int64_t axis_id = 0;
  RampPart part = RampPart::none;
  bool counted = true;  // a source states its lanes; else no merging lane is due
};

// The lanes of an edge, as they are once roundabouts and a user have decided.
struct RampEdgeLanes {
  RampLanes along{}, against{};
  bool both_ways = false;   // it has lanes for both directions: it takes no part
  double lane_width = 3.5;  // metres, of a merging lane beside its lanes
};

// By hand: of the ramp at the end of an edge of the link that is nearer to `abscissa`.  One without
// its ramp changes nothing; of two for one ramp the later holds in what it says.
struct RampOverride {
  std::int64_t axis_id = 0;                   // the link
  double abscissa = 0;                        // metres along the axis
  std::optional<double> tangent{}, length{};  // metres; length 0: no merging lane
};

struct RampRules {
  std::vector<RampAxis> axes{};  // by axis_id, each at most once; those without take no part
  std::vector<RampOverride> overrides{};
  // The lanes of an edge; street_model fills it in.
  std::function<RampEdgeLanes(const Edge&)> lanes_of{};
  double tangent = 15;         // metres, setting ramp_tangent
  double merging_length = 60;  // metres, setting merging_length
  int outer_side = -1;         // of traffic: -1 right, where it keeps right; +1 left
};

// Lanes that lie beside the others on a stretch of an edge only: as wide as all of them together
// between full_from and full_to, linear from and to nothing outside.  Abscissas in metres along the
// edge, beyond its ends where the lanes lie on the next edge too.  They end at the limit of the
// edge there, and where from and full_from are equal, or full_to and to.
struct MergingStretch {
  int side = -1;  // of the edge: +1 left, -1 right
  int lanes = 1;
  double width = 0;  // metres, of all of them
  double from = 0, full_from = 0, full_to = 0, to = 0;
  // Before and beyond the section the width stays as it is at its limits.
  double section_from = -std::numeric_limits<double>::infinity();
  double section_to = std::numeric_limits<double>::infinity();
  bool along_axis = true;  // their traffic
  // Whether traffic comes upon the highway where they begin, and whether it leaves where they end,
  // be that on this edge or on another one.
  bool enters = false, leaves = false;
  // Whether they lie on the edge at the start of this one too, and on that at its end.
  bool comes_on = false, goes_on = false;

  bool begins_at_limit() const { return comes_on || from == full_from; }
  bool ends_at_limit() const { return goes_on || full_to == to; }
  double width_at(double abscissa) const {
    abscissa = std::clamp(abscissa, section_from, section_to);
    if (abscissa < from || abscissa > to) return 0;
    if (abscissa < full_from) return width * (abscissa - from) / (full_from - from);
    if (abscissa > full_to) return width * (to - abscissa) / (to - full_to);
    return width;
  }
  // Abscissas between which the width is linear.
  std::vector<double> places() const {
    std::vector<double> places{from, full_from, full_to, to};
    for (double& place : places) place = std::clamp(place, section_from, section_to);
    if (comes_on) places.push_back(section_from);
    if (goes_on) places.push_back(section_to);
    return places;
  }
  // The same, seen from the other end of an edge of that length.
  MergingStretch turned(double length) const;
};

struct Ramp {
  int node = 0;
  bool on = true;             // traffic comes upon the highway; else it leaves
  int link = 0;               // edges
  bool link_at_start = true;  // the end of the link that touches the node
  int before = 0, after = 0;  // of the highway, in the direction of the ramp's traffic
  bool before_at_start = false, after_at_start = true;  // the ends that touch the node
  int side = -1;  // of the highway with its traffic, on which the ramp lies: +1 left, -1 right
  int lanes_before = 0, lanes_ramp = 0, lanes_after = 0;
  int missing = 0;           // merging lanes that are due; 0 where `length` is
  double merging_width = 0;  // metres, of all of them
  double tangent = 0;        // metres, as wanted
  double length = 0;         // metres of full width, as wanted
  double taper = 0;          // metres, as the taper ratio has it
  bool by_hand = false;
  // The merging lanes that were made, and what kept them from being as wanted.
  int merging = 0;          // lanes
  double full_length = 0;   // metres that the lanes keep their width, from the limit on
  bool cut = false;         // the next junction leaves less room than wanted
  bool auxiliary = false;   // the lanes go on to those of the next ramp
  bool short_link = false;  // the link is too short for its tangent

  int merging_edge() const { return on ? after : before; }
  bool merging_at_start() const { return on ? after_at_start : before_at_start; }
};

}  // namespace streetgen
