// Which tight paths traffic takes all the same.
#include "interconnection/tight_path.hpp"

#include <gtest/gtest.h>

#include "interconnection/join_lanes.hpp"

namespace streetgen {
namespace tight_path_test {

LaneEnd end(LaneKind kind, const Point& place, const Point& direction) {
  LaneEnd made;
  made.kind = kind;
  made.place = place;
  made.direction = direction;
  return made;
}

Leg leg(std::vector<LaneEnd> in, std::vector<LaneEnd> out, const Point& course) {
  Leg made;
  made.in = std::move(in);
  made.out = std::move(out);
  made.outset = made.course = course;
  made.stand = course * 10;
  return made;
}

Movement movement(int from, int to, std::vector<double> radius, std::vector<bool> drivable) {
  Movement made;
  made.from = from;
  made.to = to;
  made.least_radius = 3;
  made.radius = std::move(radius);
  made.drivable = std::move(drivable);
  return made;
}

// A car lane comes from the west, and bicycles from the north. One goes on to the east, or sharply
// back into a street of two lanes: to one of them on a tight path, to the other round a corner.
TEST(TightPath, StaysWhereBicyclesAloneReachTheStreetBesides) {
  const Point east{1, 0, 0}, south{0, -1, 0}, back{-0.5, -0.866, 0};
  const LaneKind car = LaneKind::general;
  const std::vector<Leg> legs{
      leg({end(car, {-10, 0, 0}, east)}, {}, {-1, 0, 0}),
      leg({}, {end(car, {10, 0, 0}, east)}, east),
      leg({}, {end(car, {-3, -9, 0}, back), end(car, {-6, -8, 0}, back)}, back),
      leg({end(LaneKind::cycle, {0, 10, 0}, south)}, {}, {0, 1, 0})};
  std::vector<Movement> movements{
      movement(0, 1, {1000}, {true}), movement(0, 2, {2, 0.5}, {true, false}),
      movement(3, 1, {5}, {true}), movement(3, 2, {20, 20}, {true, true})};
  join_lanes(legs, movements);
  EXPECT_TRUE(movements[1].verdicts[0].plausible);
  EXPECT_FALSE(movements[1].verdicts[1].plausible);
}

}  // namespace tight_path_test
}  // namespace streetgen
