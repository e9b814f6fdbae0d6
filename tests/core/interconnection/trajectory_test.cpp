#include "streetgen/trajectory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace trajectory_test {

constexpr double tolerance = 0.01;
const Point centre{0, 0, 0};

Line ray(const Point& from, double angle, double size) {
  return {from, {from.x + size * std::cos(angle), from.y + size * std::sin(angle), 0}};
}

// A lane that comes in northwards at (2, -10), and one that goes out in `angle` from `start`.
const Line northwards{{2, -60, 0}, {2, -10, 0}};

Trajectory bezier(const Line& out) {
  return trajectory(northwards, out, centre, TrajectoryRule::bezier, tolerance);
}

Point at(const Point& s, const Point& c, const Point& e, double t) {
  return s * ((1 - t) * (1 - t)) + c * (2 * t * (1 - t)) + e * (t * t);
}

void expect_point(const Point& a, const Point& b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
}

// 2.7.3: the barycentre of the lanes' crossing, here (2, -2), and the centre.
TEST(Trajectory, TheSharpestTurnIsThatOfTwoChords) {
  EXPECT_EQ(sharpest_turn({{0, 0, 0}, {9, 0, 0}}), 0);
  EXPECT_NEAR(sharpest_turn({{0, 0, 0}, {9, 0, 0}, {9, 0, 0}, {9, 7, 0}}), 90, 1e-9);
  EXPECT_NEAR(sharpest_turn({{0, 0, 0}, {9, 0, 0}, {1, 0, 0}}), 180, 1e-9);
  EXPECT_EQ(sharpest_turn({{3, 3, 0}, {3, 3, 0}}), 0);
  for (const int chords : {3, 5, 24, 360}) {
    Line circle;
    for (int i = 0; i <= chords; ++i)
      circle.push_back({std::cos(2 * M_PI * i / chords), std::sin(2 * M_PI * i / chords), 0});
    EXPECT_NEAR(sharpest_turn(circle), 360. / chords, 1e-6);
  }
}

TEST(Trajectory, NotParallelLanesBendAboutTheirCrossingAndTheCentre) {
  expect_point(bezier(ray({10, -2, 0}, 0, 50)).control, {1, -1, 0});
}

TEST(Trajectory, ParallelLanesAreJoinedByAStraightLine) {
  const Trajectory path = bezier(ray({3, 10, 0}, M_PI_2, 50));
  expect_point(path.control, {2.5, 0, 0});
  EXPECT_EQ(path.line.size(), 2u);
}

TEST(Trajectory, ParallelAndOppositeLanesBendAboutTheMiddleOfTheirEndsAndTheCentre) {
  expect_point(bezier(ray({-2, -10, 0}, -M_PI_2, 50)).control, {0, -5, 0});
}

TEST(Trajectory, AGivenControlPointMakesABezierCurveByEitherRule) {
  const Point control{5, 3, 0};
  for (const TrajectoryRule rule : {TrajectoryRule::bezier, TrajectoryRule::arcs}) {
    const Trajectory path =
        trajectory(northwards, ray({10, -2, 0}, 0, 50), centre, rule, tolerance, 3, control);
    expect_point(path.control, control);
    for (const double t : {0.25, 0.5, 0.75})
      EXPECT_LE(distance_to_line(at({2, -10, 0}, control, {10, -2, 0}, t), path.line), tolerance);
  }
}

class Random {
 public:
  double between(double low, double high) {
    return low + (high - low) * (engine_() >> 11) * 0x1p-53;
  }
  Line lane() { return ray({between(-20, 20), between(-20, 20), 0}, between(0, 2 * M_PI), 30); }

 private:
  std::mt19937_64 engine_{20261121};
};

// A right turn about a kerb of 3 m: the lanes cross at (2, -2).
TEST(Trajectory, ATightBezierPathBendsNearerToTheCrossingOfItsLanes) {
  const Line in{{2, -60, 0}, {2, -7, 0}}, out{{7, -2, 0}, {60, -2, 0}};
  const Trajectory paper = trajectory(in, out, centre, TrajectoryRule::bezier, 1e-3);
  const Trajectory wider = trajectory(in, out, centre, TrajectoryRule::bezier, 1e-3, 3);
  ASSERT_LT(quarter_radius(paper.line), 3);
  EXPECT_GE(quarter_radius(wider.line), 3);
  // On the way from the paper's control point to the crossing.
  EXPECT_NEAR(distance_to_line(wider.control, {paper.control, {2, -2, 0}}), 0, 1e-9);
}

// About a kerb of 3 m with lanes of 1.5 m even the curve about the crossing is tighter than 3 m.
TEST(Trajectory, WhereNoBezierPathIsWideEnoughArcsAre) {
  const Line in{{0.75, -60, 0}, {0.75, -4.5, 0}}, out{{4.5, -0.75, 0}, {60, -0.75, 0}};
  const Line wider = trajectory(in, out, centre, TrajectoryRule::bezier, 1e-3, 3).line;
  for (const Point& p : wider) EXPECT_NEAR(distance(p, {4.5, -4.5, 0}), 3.75, 1e-9);
}

TEST(Trajectory, ABezierPathThatIsWideEnoughIsThePapers) {
  Random random;
  for (int i = 0; i < 2000; ++i) {
    const Line in = random.lane(), out = random.lane();
    const Trajectory paper = trajectory(in, out, centre, TrajectoryRule::bezier, tolerance);
    const Trajectory other = trajectory(in, out, centre, TrajectoryRule::bezier, tolerance, 3);
    EXPECT_GE(quarter_radius(other.line), quarter_radius(paper.line));
    if (quarter_radius(paper.line) >= 3) {
      EXPECT_EQ(distance(other.control, paper.control), 0);
    }
  }
}

TEST(Trajectory, EndsLieOnTheLanesExactly) {
  Random random;
  for (int i = 0; i < 2000; ++i) {
    const Line in = random.lane(), out = random.lane();
    for (const TrajectoryRule rule : {TrajectoryRule::bezier, TrajectoryRule::arcs}) {
      const Line line = trajectory(in, out, centre, rule, tolerance).line;
      EXPECT_EQ(distance(line.front(), in.back()), 0);
      EXPECT_EQ(distance(line.back(), out.front()), 0);
    }
  }
}

TEST(Trajectory, TheSampledCurveIsAsNearAsTheTolerance) {
  Random random;
  for (const double wanted : {0.5, 0.01, 0.001})
    for (int i = 0; i < 200; ++i) {
      const Line in = random.lane(), out = random.lane();
      const Trajectory path = trajectory(in, out, centre, TrajectoryRule::bezier, wanted);
      for (double t = 0; t <= 1; t += 1. / 64)
        EXPECT_LE(distance_to_line(at(in.back(), path.control, out.front(), t), path.line),
                  wanted + 1e-9);
    }
}

TEST(Trajectory, ATighterToleranceHasMorePoints) {
  const Line out = ray({10, -2, 0}, 0, 50);
  std::size_t before = 0;
  for (const double wanted : {0.1, 0.01, 0.001}) {
    const std::size_t size =
        trajectory(northwards, out, centre, TrajectoryRule::arcs, wanted).line.size();
    EXPECT_GT(size, before);
    before = size;
  }
}

// The heading never jumps by more than a chord of the arc turns: C1 with both lanes.
TEST(Trajectory, ArcsAreTangentToBothLanes) {
  Random random;
  for (int i = 0; i < 2000; ++i) {
    const Line in = random.lane(), out = random.lane();
    const Line path = distinct(trajectory(in, out, centre, TrajectoryRule::arcs, 1e-4).line);
    ASSERT_GE(path.size(), 2u);
    std::vector<Point> headings{unit(in[1] - in[0])};
    for (std::size_t k = 1; k < path.size(); ++k) headings.push_back(unit(path[k] - path[k - 1]));
    headings.push_back(unit(out[1] - out[0]));
    for (std::size_t k = 1; k < headings.size(); ++k) {
      const double turn = std::abs(
          std::atan2(cross(headings[k - 1], headings[k]), dot(headings[k - 1], headings[k])));
      EXPECT_LT(turn, 0.35) << i << " at " << k << " of " << headings.size();
    }
  }
}

TEST(Trajectory, ArcsThatMeetAheadHaveTheRadiusOfTheShorterTangent) {
  const Line path = trajectory({{0, -40, 0}, {0, -20, 0}}, ray({8, 0, 0}, 0, 20), centre,
                               TrajectoryRule::arcs, 1e-4)
                        .line;
  for (const Point& p : path)
    if (p.y > -8) {
      EXPECT_NEAR(distance(p, {8, -8, 0}), 8, 1e-9);
    }
}

TEST(Trajectory, TangentsEquallyLongButForARoundingLeaveNoPieceWithoutDirection) {
  for (const double rounding : {1e-8, -1e-8}) {
    const Line path = trajectory(northwards, ray({10 + rounding, -2, 0}, 0, 50), centre,
                                 TrajectoryRule::arcs, 1e-4)
                          .line;
    for (std::size_t k = 1; k < path.size(); ++k) EXPECT_GT(distance(path[k - 1], path[k]), 1e-6);
  }
}

TEST(Trajectory, TurningBackByArcsIsHalfACircle) {
  const Line path =
      trajectory(northwards, ray({-2, -10, 0}, -M_PI_2, 50), centre, TrajectoryRule::arcs, 1e-4)
          .line;
  for (const Point& p : path) EXPECT_NEAR(distance(p, {0, -10, 0}), 2, 1e-9);
  EXPECT_NEAR(length(path), 2 * M_PI, 1e-3);
}

TEST(Trajectory, LanesThatTouchHaveAPathWithoutLength) {
  for (const TrajectoryRule rule : {TrajectoryRule::bezier, TrajectoryRule::arcs}) {
    const Line line =
        trajectory(northwards, ray({2, -10, 0}, M_PI_2, 50), centre, rule, tolerance).line;
    EXPECT_EQ(line.size(), 2u);
    EXPECT_EQ(length(line), 0);
  }
}

// Mirrored, moved and turned lanes have the mirrored, moved and turned path.
TEST(Trajectory, FollowsTheMotionsOfThePlane) {
  Random random;
  for (int i = 0; i < 500; ++i) {
    const Line in = random.lane(), out = random.lane();
    const double angle = random.between(0, 2 * M_PI);
    const Point shift{random.between(-100, 100), random.between(-100, 100), 0};
    const auto moved = [&](const Point& p) {
      return Point{std::cos(angle) * p.x + std::sin(angle) * p.y + shift.x,
                   std::sin(angle) * p.x - std::cos(angle) * p.y + shift.y, 0};
    };
    const auto moved_line = [&](Line line) {
      for (Point& p : line) p = moved(p);
      return line;
    };
    for (const TrajectoryRule rule : {TrajectoryRule::bezier, TrajectoryRule::arcs}) {
      const Line path = trajectory(in, out, centre, rule, tolerance).line;
      const Line other =
          trajectory(moved_line(in), moved_line(out), moved(centre), rule, tolerance).line;
      EXPECT_NEAR(length(path), length(other), 1e-6 * (1 + length(path)));
      EXPECT_NEAR(distance(moved(position_at(path, length(path) / 2).point),
                           position_at(other, length(other) / 2).point),
                  0, 1e-5 * (1 + length(path)));
    }
  }
}

TEST(QuarterRadius, OfAQuarterCircleIsItsRadius) {
  const Line path = trajectory({{0, -40, 0}, {0, -8, 0}}, ray({8, 0, 0}, 0, 20), centre,
                               TrajectoryRule::arcs, 1e-6)
                        .line;
  EXPECT_NEAR(quarter_radius(path), 8, 1e-3);
}

TEST(QuarterRadius, OfAStraightOrEmptyPathIsInfinite) {
  EXPECT_TRUE(std::isinf(quarter_radius({{0, 0, 0}, {9, 0, 0}})));
  EXPECT_TRUE(std::isinf(quarter_radius({{1, 1, 0}, {1, 1, 0}})));
}

}  // namespace trajectory_test
}  // namespace streetgen
