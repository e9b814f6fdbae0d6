#include "streetgen/link_conflict.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "rounds.hpp"
#include "streetgen/error.hpp"

namespace streetgen {
namespace link_conflict_test {

// Compass of the tests: a movement from `from` degrees (where its traffic heads) that starts `back`
// metres before the middle, `aside` metres to the right of it.
ConflictMovement straight(std::int64_t lane, double degrees, double aside = 0, double back = 15) {
  const double heading = degrees * M_PI / 180;
  ConflictMovement made;
  made.lane_in = lane;
  made.lane_out = lane + 100;
  made.length = 2 * back;
  made.course = {{0, -back * std::cos(heading) + aside * std::sin(heading),
                  -back * std::sin(heading) - aside * std::cos(heading), heading, 0}};
  return made;
}

// A quarter turn to the left or right that starts as a straight one does.
ConflictMovement turn(std::int64_t lane, double degrees, bool left, double radius,
                      double aside = 0) {
  ConflictMovement made = straight(lane, degrees, aside);
  made.turn = left ? Turn::left : Turn::right;
  made.length = radius * M_PI / 2;
  made.course[0].curvature = (left ? 1 : -1) / radius;
  made.lane_out = lane + (left ? 200 : 300);
  return made;
}

using Corners = std::array<Point, 4>;

// The usual car with its front `metres` along a movement, step by step along its course.
class Drive {
 public:
  explicit Drive(const ConflictMovement& movement, double step) : step_(step) {
    const LinkPiece& start = movement.course.front();
    double x = start.x - back * std::cos(start.heading);
    double y = start.y - back * std::sin(start.heading), heading = start.heading;
    for (double s = -back; s < movement.length + usual_car_length + 1; s += fine) {
      axles_.push_back({x, y, heading});
      double curvature = 0;
      for (const LinkPiece& piece : movement.course)
        if (piece.metres <= s) curvature = piece.curvature;
      if (s < 0 || s >= movement.length) curvature = 0;
      x += fine * std::cos(heading + curvature * fine / 2);
      y += fine * std::sin(heading + curvature * fine / 2);
      heading += curvature * fine;
    }
    for (double s = 0; s <= movement.length + usual_car_length; s += step) fronts_.push_back(s);
  }

  const std::vector<double>& fronts() const { return fronts_; }

  Corners corners(double front, double grown) const {
    const Point& axle =
        axles_[static_cast<std::size_t>(std::lround((front - usual_axle_to_front + back) / fine))];
    const double c = std::cos(axle.z), s = std::sin(axle.z);
    Corners corners;
    int i = 0;
    for (const auto& [ahead, left] :
         {std::pair{1, 1}, std::pair{-1, 1}, std::pair{-1, -1}, std::pair{1, -1}}) {
      const double along = ahead > 0 ? usual_axle_to_front + grown : -(usual_axle_to_rear + grown);
      const double aside = left * (usual_car_width / 2 + grown);
      corners[i++] = {axle.x + along * c - aside * s, axle.y + along * s + aside * c, 0};
    }
    return corners;
  }

 private:
  static constexpr double fine = 0.005, back = 6;
  double step_;
  std::vector<Point> axles_;  // z is the heading
  std::vector<double> fronts_;
};

bool overlap(const Corners& a, const Corners& b) {
  for (const Corners* of : {&a, &b})
    for (int k = 0; k < 2; ++k) {
      const double nx = (*of)[k + 1].y - (*of)[k].y, ny = (*of)[k].x - (*of)[k + 1].x;
      const auto range = [&](const Corners& corners) {
        double low = 1e300, high = -1e300;
        for (const Point& p : corners) {
          low = std::min(low, p.x * nx + p.y * ny);
          high = std::max(high, p.x * nx + p.y * ny);
        }
        return std::pair{low, high};
      };
      const auto [low_a, high_a] = range(a);
      const auto [low_b, high_b] = range(b);
      if (high_a <= low_b || high_b <= low_a) return false;
    }
  return true;
}

struct Sampled {
  double first_from = 1e9, first_to = -1e9, second_from = 1e9, second_to = -1e9;
};

Sampled sampled(const ConflictMovement& a, const ConflictMovement& b, double step, double grown) {
  const Drive first(a, step), second(b, step);
  std::vector<Corners> others;
  for (const double s : second.fronts()) others.push_back(second.corners(s, grown));
  Sampled found;
  for (const double s : first.fronts()) {
    const Corners one = first.corners(s, grown);
    for (std::size_t i = 0; i < others.size(); ++i) {
      if (std::abs(one[0].x - others[i][0].x) + std::abs(one[0].y - others[i][0].y) > 20) continue;
      if (!overlap(one, others[i])) continue;
      found.first_from = std::min(found.first_from, s);
      found.first_to = std::max(found.first_to, s);
      found.second_from = std::min(found.second_from, second.fronts()[i]);
      found.second_to = std::max(found.second_to, second.fronts()[i]);
    }
  }
  return found;
}

TEST(LinkConflicts, TellWhereTwoStraightOnesCross) {
  const auto found = link_conflicts({straight(1, 0), straight(2, 90)});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, ConflictKind::crossing);
  EXPECT_LE(found[0].first_from, 15 - 0.9);
  EXPECT_NEAR(found[0].first_from, 15 - 0.9, 0.5);
  EXPECT_GE(found[0].first_to, 15 + 0.9 + 5);
  EXPECT_NEAR(found[0].first_to, 15 + 0.9 + 5, 0.5);
  EXPECT_NEAR(found[0].second_from, 15 - 0.9, 0.5);
  EXPECT_TRUE(link_conflicts({straight(1, 0), straight(2, 0, 3)}).empty()) << "lanes side by side";
  EXPECT_TRUE(link_conflicts({straight(1, 0), turn(1, 0, true, 8)}).empty()) << "from one lane";
  EXPECT_TRUE(link_conflicts({straight(1, 0)}).empty());
  EXPECT_TRUE(link_conflicts({}).empty());
}

TEST(LinkConflicts, MissNoCarsThatOverlap) {
  std::mt19937_64 random(52);
  const auto real = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int met = 0, apart = 0;
  for (int round = 0; round < rounds(400); ++round) {
    std::vector<ConflictMovement> pair;
    for (int i = 0; i < 2; ++i) {
      ConflictMovement made;
      made.lane_in = i;
      made.lane_out = 10 + i;
      made.length = real(3, 25);
      LinkPiece piece{0, real(-12, 12), real(-12, 12), real(-M_PI, M_PI), real(-0.3, 0.3)};
      made.course = {piece};
      const double at = real(0, made.length), k = piece.curvature;
      made.course.push_back(
          {at, piece.x + (std::sin(piece.heading + k * at) - std::sin(piece.heading)) / k,
           piece.y - (std::cos(piece.heading + k * at) - std::cos(piece.heading)) / k,
           piece.heading + k * at, round % 2 ? 0 : real(-0.3, 0.3)});
      pair.push_back(made);
    }
    const auto found = link_conflicts(pair);
    const Sampled needed = sampled(pair[0], pair[1], 0.1, 0);
    if (needed.first_to < 0) {
      ++apart;
      if (found.empty()) continue;
    } else {
      ++met;
      ASSERT_EQ(found.size(), 1u) << "round " << round;
      EXPECT_LE(found[0].first_from, needed.first_from + 1e-9) << "round " << round;
      EXPECT_GE(found[0].first_to, needed.first_to - 1e-9) << "round " << round;
      EXPECT_LE(found[0].second_from, needed.second_from + 1e-9) << "round " << round;
      EXPECT_GE(found[0].second_to, needed.second_to - 1e-9) << "round " << round;
    }
    // No longer than what cars need that are larger by some decimetres on each side.
    const Sampled enough = sampled(pair[0], pair[1], 0.1, 0.4);
    EXPECT_GE(found[0].first_from, enough.first_from - 0.4) << "round " << round;
    EXPECT_LE(found[0].first_to, enough.first_to + 0.4) << "round " << round;
    EXPECT_GE(found[0].second_from, enough.second_from - 0.4) << "round " << round;
    EXPECT_LE(found[0].second_to, enough.second_to + 0.4) << "round " << round;
  }
  EXPECT_GT(met, rounds(400) / 10);
  EXPECT_GT(apart, rounds(400) / 10);
}

TEST(LinkConflicts, EndWithTheLaneInWhichTwoMerge) {
  ConflictMovement through = straight(1, 0, 0, 8), ramp = straight(2, 0, 0, 8);
  ramp.course = {{0, -8, -4, 0.3, 0}};
  ramp.course = {{0, 8 - 16 * std::cos(0.2), -16 * std::sin(0.2), 0.2, 0}};
  ramp.lane_out = through.lane_out;
  const auto found = link_conflicts({through, ramp});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, ConflictKind::merging);
  EXPECT_DOUBLE_EQ(found[0].first_to, 16);
  EXPECT_DOUBLE_EQ(found[0].second_to, 16);
  EXPECT_LT(found[0].first_from, 10);
}

TEST(LinkConflicts, HoldForALaneForBothDirections) {
  ConflictMovement in = straight(1, 0, 0, 8), out = turn(2, 180, false, 6);
  out.course[0] = {0, 8, 0, M_PI, -1 / 6.0};
  in.lane_out = out.lane_in = 7;
  in.along_out = true;
  out.along_in = false;
  const auto found = link_conflicts({in, out});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, ConflictKind::opposing);
  EXPECT_DOUBLE_EQ(found[0].first_to, in.length);
  EXPECT_DOUBLE_EQ(found[0].second_from, 0);
  EXPECT_GT(found[0].second_to, 0);
}

Precedence of_first(const std::vector<ConflictMovement>& movements, bool left_hand = false) {
  const auto found = link_conflicts(movements, left_hand);
  EXPECT_EQ(found.size(), 1u);
  return found.empty() ? Precedence::by_arrival : found[0].precedence;
}

TEST(LinkConflicts, SayWhoGivesWay) {
  ConflictMovement east = straight(1, 0), north = straight(2, 90);
  EXPECT_EQ(of_first({east, north}), Precedence::gives_way)
      << "who heads north comes from the right";
  EXPECT_EQ(of_first({north, east}), Precedence::goes_first);
  east.importance = 2, north.importance = 3;
  EXPECT_EQ(of_first({east, north}), Precedence::goes_first) << "importance before right";
  east.rank = 2, north.rank = 0;
  EXPECT_EQ(of_first({east, north}), Precedence::gives_way) << "rank before importance";
  const ConflictMovement oncoming = straight(3, 180, 2);
  const ConflictMovement left = turn(4, 0, true, 14);
  EXPECT_EQ(of_first({oncoming, left}), Precedence::goes_first);
  EXPECT_EQ(of_first({oncoming, left}, true), Precedence::by_arrival) << "traffic keeps left";
  ConflictMovement first = east, second = north;
  first.protected_states = 1, second.protected_states = 2;
  EXPECT_EQ(of_first({first, second}), Precedence::by_signal);
  second.permitted_states = 1;
  EXPECT_EQ(of_first({first, second}), Precedence::goes_first) << "permitted after protected";
  first.protected_states = 0, first.permitted_states = 1, first.precedence = 2;
  second.precedence = 1;
  EXPECT_EQ(of_first({first, second}), Precedence::gives_way) << "by precedence";
  ConflictMovement slip = straight(5, 5, 0.3);
  slip.lane_out = straight(6, 0).lane_out;
  EXPECT_EQ(of_first({slip, straight(6, 0)}), Precedence::by_arrival) << "side by side";
}

TEST(LinkConflicts, FourFromTheRightDoNotWaitForEachOther) {
  std::vector<ConflictMovement> four;
  for (int i = 0; i < 4; ++i) four.push_back(straight(i, 90 * i, 1.75));
  const auto found = link_conflicts(four);
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(std::count_if(
                found.begin(), found.end(),
                [](const MovementConflict& c) { return c.precedence == Precedence::by_arrival; }),
            1);
}

// Whether any wait for each other in a circle.
bool circle(const std::vector<MovementConflict>& found, int count) {
  std::vector<std::vector<int>> waits(count);
  for (const MovementConflict& c : found) {
    if (c.precedence == Precedence::gives_way) waits[c.first].push_back(c.second);
    if (c.precedence == Precedence::goes_first) waits[c.second].push_back(c.first);
  }
  std::vector<int> seen(count);
  const std::function<bool(int)> visit = [&](int i) {
    if (seen[i]) return seen[i] == 1;
    seen[i] = 1;
    for (const int next : waits[i])
      if (visit(next)) return true;
    seen[i] = 2;
    return false;
  };
  for (int i = 0; i < count; ++i)
    if (visit(i)) return true;
  return false;
}

TEST(LinkConflicts, NeverWaitInACircle) {
  std::mt19937_64 random(9);
  const auto below = [&](int n) { return static_cast<int>(random() % n); };
  for (int round = 0; round < rounds(300); ++round) {
    std::vector<ConflictMovement> movements;
    const bool signals = round % 3 == 0;
    for (int lane = 0; lane < 3 + below(10); ++lane)
      for (int k = below(3); k >= 0; --k) {
        const double degrees = 15 * below(24), aside = below(4);
        ConflictMovement m = below(2) ? straight(lane, degrees, aside)
                                      : turn(lane, degrees, below(2), 4 + below(12), aside);
        m.lane_out = 100 + below(12);
        m.rank = below(2), m.importance = below(2), m.precedence = below(3);
        if (below(10) == 0) m.turn = Turn::u_turn;
        if (signals) {
          m.protected_states = random() % 16;
          m.permitted_states = random() % 16 & ~m.protected_states;
        }
        movements.push_back(m);
      }
    for (const bool left_hand : {false, true}) {
      const auto found = link_conflicts(movements, left_hand);
      EXPECT_FALSE(circle(found, static_cast<int>(movements.size()))) << "round " << round;
      for (std::size_t i = 0; i < found.size(); ++i) {
        const MovementConflict& c = found[i];
        EXPECT_LT(c.first, c.second);
        EXPECT_LE(0, c.first_from);
        EXPECT_LT(c.first_from, c.first_to + 1e-9);
        EXPECT_LE(c.first_to, movements[c.first].length + usual_car_length + 1e-9);
        if (i > 0) {
          EXPECT_LT((std::pair{found[i - 1].first, found[i - 1].second}),
                    (std::pair{c.first, c.second}));
        }
      }
      const auto merges = [&](std::size_t a, std::size_t b) {
        return std::any_of(found.begin(), found.end(), [&](const MovementConflict& c) {
          return c.first == static_cast<int>(a) && c.second == static_cast<int>(b) &&
                 c.kind == ConflictKind::merging;
        });
      };
      for (std::size_t a = 0; a < movements.size(); ++a)
        for (std::size_t b = a + 1; b < movements.size(); ++b)
          EXPECT_EQ(merges(a, b), movements[a].lane_in != movements[b].lane_in &&
                                      movements[a].lane_out == movements[b].lane_out);
    }
  }
}

TEST(LinkConflicts, AreOfOneJunction) {
  std::vector<ConflictMovement> movements{straight(1, 0), straight(2, 90), straight(3, 0),
                                          straight(4, 90)};
  movements[2].junction = movements[3].junction = 8;
  const auto found = link_conflicts(movements);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].first, 0);
  EXPECT_EQ(found[0].second, 1);
  EXPECT_EQ(found[1].first, 2);
  EXPECT_EQ(found[1].second, 3);
  EXPECT_EQ(found[0].first_from, found[1].first_from);
}

TEST(LinkConflicts, RefuseMovementsThatCannotBe) {
  const auto refused = [](const std::function<void(ConflictMovement&)>& spoil) {
    ConflictMovement bad = straight(2, 90);
    spoil(bad);
    try {
      link_conflicts({straight(1, 0), bad});
    } catch (const Error& e) {
      return e.kind() == ErrorKind::invalid_input &&
             std::string(e.what()).find("movement 2") != std::string::npos;
    }
    return false;
  };
  EXPECT_TRUE(refused([](ConflictMovement& m) { m.length = 0; }));
  EXPECT_TRUE(refused([](ConflictMovement& m) { m.length = 1e9; }));
  EXPECT_TRUE(refused([](ConflictMovement& m) { m.width = NAN; }));
  EXPECT_TRUE(refused([](ConflictMovement& m) { m.course.clear(); }));
  EXPECT_TRUE(refused([](ConflictMovement& m) { m.course[0].heading = INFINITY; }));
  ConflictMovement elsewhere = straight(2, 90);
  elsewhere.junction = 1;
  EXPECT_THROW(link_conflicts({straight(1, 0), elsewhere, straight(3, 180)}), Error);
}

}  // namespace link_conflict_test
}  // namespace streetgen
