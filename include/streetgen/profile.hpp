// Heights of roads that pass over and under each other.  Wilkie, Sewall, Lin, section 5.2.
//
// A road follows the ground.  Where it passes over another one it lies at least the clearance above
// it, nowhere steeper than its usual grade.  The heights are the least ones that hold all this: at
// each place the greatest of the ground and of every lift less grade times distance.  A crossing
// whose lower road has a level under 0 is mirrored: that road sinks, as little as holds.
//
// A bridge or a tunnel of which no heights are stated leads evenly from end to end and is clear of
// the ground between its ends.  Over crossings that follow each other nearer than a road comes down
// it stays up.
//
// Lifts that raise each other without end cannot all hold.  The roads of such a circle get their
// greatest grades.  Where these do not help the last lift is left unmet, so that heights stay
// finite.
#pragma once

#include <cstdint>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

struct ProfileEdge {
  std::int64_t from_node = 0;  // edges of one node have one height there
  std::int64_t to_node = 0;
  Line line;  // z: the ground, metres; at least two distinct points in the plane
  // Usual rise for each metre along the road, positive. A road whose ground is steeper over 20
  // m, or over its length where that is less, keeps that grade.
  double grade = 0.06;
  double radius = 0;          // metres, of vertical arcs; 0: kinks stay
  double grade_greatest = 0;  // where the usual one leaves no heights; below that: the usual one
  // A bridge lies so much over its line, a tunnel so much under it (negative), metres, but for its
  // first and last ten metres, and leads evenly from end to end; 0: the road follows its line.
  double rise = 0;
  // Does the bridge end at that node?  Else others lead it on, and all are solved together.
  bool ends_from = true, ends_to = true;
};

struct ProfileLift {
  int above = 0;        // index of the edge that passes over
  double at_above = 0;  // metres along it
  int below = 0;
  double at_below = 0;
  double clearance = 0;  // metres from road to road, not negative
  bool sinks = false;    // the road below sinks, else the one above is lifted
};

// By hand: the road lies at least so high there.  One at the ground or below it changes nothing.
struct ProfileHeight {
  int edge = 0;
  double abscissa = 0;  // metres along it
  double height = 0;
};

struct ProfileRules {
  // Bridges and tunnels that are shorter, and cross no road, may stay level with the ground,
  // metres.
  double level_length = 0;
  // A road stays up between crossings nearer than so many times the way on which it comes down.
  double plateau = 0;
};

enum class ProfileMethod {
  ground,  // as its line
  lifted,
  sunk,  // lifted elsewhere or not
};

struct Profile {
  Line
      line;  // the edge's, with the heights of the road, and further points where its grade changes
  ProfileMethod method = ProfileMethod::ground;
  double grade = 0;  // that it keeps
  // Are the edges at from_node, and at to_node, solved together?  They are where one of them left
  // the ground there in any step of solving, wherever it lies in the end.
  bool tied_from = false, tied_to = false;
};

struct Profiles {
  std::vector<Profile> edges;  // one per edge
  std::vector<bool> unmet;     // one per lift: the road above lies lower than it should
};

// Each edge has the heights of those that it hangs together with alone: by lifts and by tied nodes.
// Others that are solved in the same call say nothing of them.  Some edges alone have the heights
// that they have among all, if no lift and no node that is tied, by any of the two, leads from them
// to others.
//
// Independent of the order of edges, but for the choice among the lifts of a circle, which goes by
// their order.  A vertical arc bends a change of grade: over a crossing the road is lifted by what
// the arc takes, and an arc ends where it would touch another crossing, so that clearances hold.
// Ground by itself is not bent.
Profiles profiles(const std::vector<ProfileEdge>& edges, const std::vector<ProfileLift>& lifts,
                  const std::vector<ProfileHeight>& by_hand, const ProfileRules& rules = {});

}  // namespace streetgen
