#include "streetgen/clean.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

namespace clean_test {

std::vector<double> xs(const Line& line) {
  std::vector<double> out;
  for (const auto& point : line) out.push_back(point.x);
  return out;
}

double distance_to(const Line& line, const Point& p) {
  double nearest = INFINITY;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double dx = line[i + 1].x - line[i].x, dy = line[i + 1].y - line[i].y;
    const double at = ((p.x - line[i].x) * dx + (p.y - line[i].y) * dy) / (dx * dx + dy * dy);
    const double t = std::clamp(at, 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(p.x - line[i].x - t * dx, p.y - line[i].y - t * dy));
  }
  return nearest;
}

double farthest_from(const Line& cleaned, const Line& line) {
  double farthest = 0;
  for (const auto& point : line) farthest = std::max(farthest, distance_to(cleaned, point));
  return farthest;
}

constexpr double millimetre = 1e-3 + 1e-8;

TEST(Clean, RemovesPointsNearerThanEpsilonToTheLastKeptOne) {
  const Line line{{0, 0}, {10, 1}, {10.2, 1}, {20, 0}};
  EXPECT_EQ(xs(clean(line, {}, 0.3, 0)), (std::vector<double>{0, 10, 20}));
  EXPECT_EQ(xs(clean(line, {}, 0.1, 0)), xs(line));
}

TEST(Clean, RemovesCollinearPoints) {
  const Line line{{0, 0}, {10, 0.0009}, {20, 0}, {30, 5}};
  EXPECT_EQ(xs(clean(line, {}, 0.3, 0)), (std::vector<double>{0, 20, 30}));
  const Line bent{{0, 0}, {10, 0.0011}, {20, 0}, {30, 5}};
  EXPECT_EQ(xs(clean(bent, {}, 0.3, 0)), xs(bent));
}

TEST(Clean, KeepsAnArcWithinAMillimetreWhateverItsRadiusAndSpacing) {
  for (const double radius : {20.0, 100.0, 1000.0, 10000.0})
    for (const double spacing : {0.35, 1.0, 5.0}) {
      Line arc;
      for (int i = 0; i < 400 && i * spacing < 6 * radius; ++i) {
        const double turn = i * spacing / radius;
        arc.push_back({radius * std::cos(turn), radius * std::sin(turn)});
      }
      EXPECT_LT(farthest_from(clean(arc, {}, 0.3, 0), arc), millimetre) << radius << ' ' << spacing;
    }
}

TEST(Clean, KeepsARandomWalkWithinAMillimetre) {
  std::mt19937 random(20);
  std::size_t before = 0, after = 0;
  for (int round = 0; round < 200; ++round) {
    const double sharpest = std::pow(10.0, -std::uniform_real_distribution<>(0, 4)(random));
    std::uniform_real_distribution<> turn(-sharpest, sharpest), step(0.01, 3);
    Line line{{650000, 6860000}};
    double heading = 0;
    for (int i = 0; i < 300; ++i) {
      heading += i % 50 == 49 ? M_PI : turn(random);
      const double length = step(random);
      line.push_back(
          {line.back().x + length * std::cos(heading), line.back().y + length * std::sin(heading)});
    }
    const Line cleaned = clean(line, {}, 0, 0);
    EXPECT_LT(farthest_from(cleaned, line), millimetre) << round;
    before += line.size();
    after += cleaned.size();
  }
  EXPECT_LT(after, before);
}

TEST(Clean, KeepsHowFarALineGoesBeforeItTurnsBack) {
  const Line line{{0, 0}, {30, 0}, {10, 0}, {20, 5}};
  EXPECT_EQ(xs(clean(line, {}, 0.3, 0)), xs(line));
}

TEST(Clean, RemovesTurnsThatDoNotFitTheirSegments) {
  const Line line{{0, 0}, {20, 0}, {20, 4}, {40, 4}};  // 3 m tan 45 degrees > 4 m / 2
  EXPECT_EQ(xs(clean(line, {}, 0.3, 3)), (std::vector<double>{0, 20, 40}));
  EXPECT_EQ(clean(line, {}, 0.3, 1.9).size(), 4u);
}

TEST(Clean, NeverRemovesAnEndNorAKeptPoint) {
  const Line near_ends{{0, 0}, {0.1, 0}, {0.2, 0}};
  EXPECT_EQ(xs(clean(near_ends, {}, 0.3, 3)), (std::vector<double>{0, 0.2}));
  const Line line{{0, 0}, {10, 0}, {10.1, 0}, {20, 0}, {20, 1}, {40, 1}};
  EXPECT_EQ(xs(clean(line, {false, true, true, true, true, false}, 0.3, 3)), xs(line));
  EXPECT_EQ(xs(clean(line, {}, 0.3, 3)), (std::vector<double>{0, 20, 40}));
}

TEST(Clean, LeavesALineThatReturnsToItsStartItsLength) {
  const Line there_and_back{{0, 0}, {20, 0}, {0, 0}};
  EXPECT_EQ(xs(clean(there_and_back, {}, 0.3, 3)), xs(there_and_back));
  const Line tiny{{0, 0}, {0.1, 0}, {0, 0}};
  EXPECT_EQ(xs(clean(tiny, {}, 0.3, 3)), xs(tiny));
  const Line dead_end{{0, 0}, {20, 0}, {20, 20}, {20, 0}, {40, 0}};
  EXPECT_EQ(farthest_from(clean(dead_end, {}, 0.3, 3), dead_end), 0);
}

// Going back on one's own line, and in a hairpin; what turns within the radius is noise.
TEST(Clean, AFoldKeepsItsFarthestPoint) {
  for (const double aside : {0.0, 0.5, 4.0}) {
    const Line fold{{0, 0}, {100, 0}, {50, aside}};
    EXPECT_EQ(xs(clean(fold, {}, 0.3, 3)), xs(fold)) << aside;
  }
  const Line folds{{50, 0}, {0, 0}, {100, 0}, {60, 0}};
  EXPECT_EQ(xs(clean(folds, {}, 0.3, 3)), xs(folds));
  EXPECT_EQ(xs(clean({{0, 0}, {20, 0}, {19, 0.5}, {40, 0}}, {}, 0.3, 3)),
            (std::vector<double>{0, 19, 40}));
}

TEST(Clean, LeavesASmallLoopItsSides) {
  const Line loop{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};  // every bend tighter than 3 m
  EXPECT_EQ(xs(clean(loop, {}, 0.3, 3)), xs(loop));
}

TEST(Clean, RefusesAKeepOfAnotherLength) {
  EXPECT_THROW(clean({{0, 0}, {1, 0}}, {true}, 0.3, 3), Error);
}

TEST(Clean, Cancels) {
  streetgen::set_cancel_check([]() noexcept { return true; });
  EXPECT_THROW(clean({{0, 0}, {1, 0}}, {}, 0.3, 3), Error);
  streetgen::set_cancel_check(nullptr);
}

TEST(CleanNetwork, APointThatAnotherLineHasStays) {
  const Line street{{0, 0}, {40, 0}, {60, 0}, {100, 0}}, side{{40.05, 0}, {40, 50}};
  EXPECT_EQ(xs(clean({street, side}, {}, 0.1, 0.3, 0)[0]), (std::vector<double>{0, 40, 100}));
  EXPECT_EQ(xs(clean({street}, {side}, 0.1, 0.3, 0)[0]), (std::vector<double>{0, 40, 100}));
  EXPECT_EQ(xs(clean({street, side}, {}, 0.01, 0.3, 0)[0]), (std::vector<double>{0, 100}));
}

TEST(CleanNetwork, ItsOwnPointsKeepNothing) {
  const Line back{{0, 0}, {50, 0}, {50.1, 0}, {100, 0}, {100, 80}, {50, 0.05}};
  EXPECT_EQ(xs(clean({back}, {}, 0.1, 0.3, 0)[0]), xs(clean(back, {}, 0.3, 0)));
}

// Small closed lines among them, for which a filter is passed over.
TEST(CleanNetwork, EachLineAsIfToldWhatOthersHave) {
  std::mt19937 random(5);
  std::uniform_int_distribution<int> step(-4, 4), count(3, 7);
  for (int turn = 0; turn < 200; ++turn) {
    std::vector<Line> lines;
    for (int i = 0; i < 6; ++i) {
      Line line{{0, 0}};
      for (int more = count(random); more > 0; --more)
        line.push_back({line.back().x + step(random) / 4.0, line.back().y + step(random) / 4.0});
      if (turn % 2) line.push_back(line.front());
      lines.push_back(line);
    }
    const std::vector<Line> together = clean(lines, {}, 0.1, 0.3, 0.5);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      std::vector<bool> keep;
      for (const Point& p : lines[i]) {
        bool met = false;
        for (std::size_t k = 0; k < lines.size(); ++k)
          for (const Point& q : lines[k])
            met = met || (k != i && std::hypot(p.x - q.x, p.y - q.y) <= 0.1);
        keep.push_back(met);
      }
      EXPECT_EQ(xs(together[i]), xs(clean(lines[i], keep, 0.3, 0.5))) << turn;
    }
  }
}

}  // namespace clean_test
}  // namespace streetgen
