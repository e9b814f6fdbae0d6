// Around one node: the order of its arms, their corners, and how far each arm reaches.
#pragma once

#include <optional>
#include <vector>

#include "geometry/tolerance.hpp"
#include "layout/surface_ring.hpp"
#include "streetgen/street.hpp"
#include "support/infinite.hpp"

namespace streetgen {

// Indices of the arms in their leaving_order; of arms that never part the wider one ranks first,
// then the longer one, then the smaller index.
std::vector<std::size_t> counter_clockwise(const std::vector<Arm>& arms);

// Counter-clockwise from a to b about the node, radians, 0 to 2 pi; seen 1 m away from it.
double angle_between(const Arm& a, const Arm& b);

// Metres along both streets of a corner from its node, past which its arc may not end.
struct ArcEnds {
  double until_a = infinite, until_b = infinite;

  bool bound() const { return until_a < infinite || until_b < infinite; }
  bool hold(const CornerArc& arc) const {
    return arc.abscissa_a <= until_a + same_place && arc.abscissa_b <= until_b + same_place;
  }
};

struct CornerWish {
  double radius = 0;
  double max_arc_distance = 60;
  double radius_minimal = 0.15;
  bool by_hand = false;  // of a centre too far the largest radius that is near, not the minimal
  double corner_length = infinite;  // metres along the kerbs from their crossing to the arc's end
  double corner_area = infinite;    // square metres between the kerbs and the arc
  ArcEnds ends{};
};

struct SolvedCorner {
  Gap gap;
  Method method = Method::hypothesis;
  double limit_a = 0;  // what the corner asks of the two arms' limits, metres
  double limit_b = 0;
  ArcEnds ends{};
  double ground = infinite;  // square metres that it may close beside the others of its node
  bool too_short = false;    // an axis is too short for the radius that is wanted and may be
};

// Counter-clockwise from a to b.  Section 2.4: no candidate, no arc; an axis too short, or the arc
// farther from the crossing of the kerbs than it may be, the largest radius that fits; the centre
// too far, the minimal radius.
SolvedCorner solve_corner(const Arm& a, const Arm& b, const CornerWish& wish);

// The corner of arms[i] and the next, arms counter-clockwise. On the roadway of a third arm it lies
// where one of both comes out from under its kerb, if the other one goes on as that arm. Else none
// is rounded there beside a nearly straight pair: the third arm's kerb is the outer one.
SolvedCorner solve_corner(const std::vector<const Arm*>& arms, std::size_t i,
                          const CornerWish& wish);

// Whether a corner can have an arc beyond its arms' ends: it is none that is nearly straight.
bool may_follow(const Arm& a, const Arm& b);

// The corner of two arms that run straight on behind their node: abscissas are negative there.
std::optional<CornerArc> corner_behind(const Arm& a, const Arm& b, double radius);

// The same on the axes that go on from the arms' ends: an arc beyond the arms' own lengths, if
// there is one.  Failure 3 of the paper.
std::optional<SolvedCorner> follow_corner(const Arm& a, const Arm& b, const Course& onwards_a,
                                          const Course& onwards_b, const CornerWish& wish);

void widen_limits(Arm& a, Arm& b, const SolvedCorner& corner);

// The first abscissa from `limit` outwards whose border line ends on the kerbs, not in
// the inside of a bend; `limit` itself where the arm has none.
double kerb_clear_limit(const Arm& arm, double limit);

}  // namespace streetgen
