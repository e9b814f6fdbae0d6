#include "../../src/core/nearest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>

#include "../../src/core/polyline.hpp"

namespace streetgen {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double chords = 0.01;  // metres: how far segments leave a parabola, in both distances

const Point origin{650000, 6860000, 0};

void append_pieces(const Line& line, std::vector<Straight>& pieces) {
  append_pieces(line, 0, infinite, origin, pieces);
}

std::vector<Straight> pieces_of(const Line& line) {
  std::vector<Straight> pieces;
  append_pieces(line, pieces);
  return pieces;
}

double nearest(const std::vector<Straight>& pieces, const Point& p) {
  double best = infinite;
  for (const Straight& piece : pieces)
    best = std::min(best, distance_to_segment(p - origin, piece.start, piece.end));
  return best;
}

using Border = std::vector<std::pair<Point, Point>>;

// Each segment lies where both owners are equally near, and the ends of all form lines that go on
// up to the outside of the box.
void expect_border(const std::vector<Straight>& leader, const std::vector<Straight>& other,
                   const Border& border, const Box& within) {
  std::map<std::pair<double, double>, int> ends;
  for (const auto& [from, to] : border) {
    for (const double t : {0.0, 0.3, 1.0}) {
      const Point p = from + (to - from) * t;
      if (within.holds(p, 0)) {
        EXPECT_NEAR(nearest(leader, p), nearest(other, p), chords);
      }
    }
    ++ends[{from.x, from.y}];
    ++ends[{to.x, to.y}];
  }
  for (const auto& [end, count] : ends)
    if (within.holds({end.first, end.second, 0}, 0.5)) {
      EXPECT_EQ(count % 2, 0) << end.first << " " << end.second;
    }
}

// Wherever the owner changes on the way from a place to another, the way meets the border.
void expect_parted(const NearestOwner& nearer, const std::vector<Straight>& leader,
                   const std::vector<Straight>& other, const Border& border, const Point& p,
                   const Point& q) {
  for (const Point& end : {p, q})
    if (std::abs(nearest(leader, end) - nearest(other, end)) < chords) return;
  const auto met = std::count_if(border.begin(), border.end(), [&](const auto& segment) {
    return crossing(p, q, segment.first, segment.second).has_value();
  });
  EXPECT_EQ(met % 2 == 1, nearer.leader_owns(p) != nearer.leader_owns(q));
}

// Lines of a few bends each, whatever they cross, also drawn on each other.
struct RandomAxes {
  std::vector<Straight> leader, other;

  RandomAxes(std::mt19937& random, int lines, int bends, double step) {
    std::uniform_real_distribution<double> place(0, 50), turn(-step, step);
    for (int i = 0; i < lines; ++i) {
      Line line{{650000 + place(random), 6860000 + place(random), 0}};
      for (int k = 0; k <= bends; ++k)
        line.push_back(line.back() + Point{turn(random), turn(random), 0});
      append_pieces(line, i % 2 == 0 ? leader : other);
      if (i % 7 == 3) append_pieces({line[1], line[0]}, leader);
    }
  }
};

const Box within{650005, 6860005, 650045, 6860045};

TEST(Nearest, PlacesAreOfTheOwnerOfTheNearestAxis) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(5, 45);
  for (int round = 0; round < 50; ++round) {
    const RandomAxes axes(random, round < 49 ? 6 : 300, 2, 15);
    const NearestOwner nearer(axes.leader, axes.other, origin, within, infinite);
    for (int i = 0; i < 200; ++i) {
      const Point p{650000 + place(random), 6860000 + place(random), 0};
      const double ahead = nearest(axes.other, p) - nearest(axes.leader, p);
      if (std::abs(ahead) > 2e-4) {
        EXPECT_EQ(nearer.leader_owns(p), ahead > 0);
      }
    }
  }
}

TEST(Nearest, TheBorderPartsTheOwners) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(5, 45);
  for (const double step : {0.5, 5.0, 40.0})
    for (int round = 0; round < 200; ++round) {
      const RandomAxes axes(random, 2 + round % 8, round % 5, step);
      const NearestOwner nearer(axes.leader, axes.other, origin, within, infinite);
      const Border border = nearer.border();
      expect_border(axes.leader, axes.other, border, within);
      for (int i = 0; i < 40; ++i)
        expect_parted(nearer, axes.leader, axes.other, border,
                      {650000 + place(random), 6860000 + place(random), 0},
                      {650000 + place(random), 6860000 + place(random), 0});
    }
}

// Where many are as near in one place.
TEST(Nearest, TheBorderOfARegularGridHasNoGaps) {
  std::vector<Straight> leader, other;
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 6; ++y)
      append_pieces({{x - 0.1, 1.0 * y, 0}, {x + 0.1, 1.0 * y, 0}},
                    (x + y) % 2 == 0 ? leader : other);
  const Box box{-0.5, -0.5, 5.5, 5.5};
  const NearestOwner nearer(leader, other, origin, box, infinite);
  expect_border(leader, other, nearer.border(), box);
}

TEST(Nearest, BetweenStraightPiecesTheBorderIsOneLine) {
  const Box beside{10, 1, 90, 9};
  const Border border =
      NearestOwner(pieces_of({{0, 0, 0}, {100, 0, 0}}), pieces_of({{0, 10, 0}, {100, 12, 0}}),
                   origin, beside, infinite)
          .border();
  ASSERT_EQ(border.size(), 1u);
  const auto& [from, to] = border.front();
  EXPECT_NEAR(crossing(from, to, {50, 0, 0}, {50, 12, 0})->y, 5.5, 0.01);
}

// Also where coordinates are rounded to a tenth of a micrometre.
TEST(Nearest, WhereAnAxisGoesOnTheBorderLiesAcrossIt) {
  for (const double far : {0.0, 1e9})
    for (const double at : {3.0, 10.1, 17.3}) {
      const Point here{far, far, 0};
      const Line line{here, here + Point{30, 10.7, 0}};
      std::vector<Straight> leader, other;
      append_pieces(line, 0, at, here, leader);
      append_pieces(line, at, infinite, here, other);
      const Box box{far - 10, far - 10, far + 30, far + 30};
      const NearestOwner nearer(leader, other, here, box, infinite);
      double size = 0;
      for (const auto& [from, to] : nearer.border()) {
        size += distance(from, to);
        for (const Point& end : {from, to}) EXPECT_NEAR(dot(end - here, leader[0].along), at, 1e-3);
      }
      EXPECT_GT(size, 40);
    }
}

TEST(Nearest, AxesDrawnOnTheLeadersAreTheLeaders) {
  const Box box{0, -5, 30, 5};
  const std::vector<Straight> leader = pieces_of({{0, 0, 0}, {20, 0, 0}});
  for (const double off : {0.0, 8e-6, -8e-6}) {
    const NearestOwner same(leader, pieces_of({{19, off, 0}, {2, off, 0}}), origin, box, infinite);
    EXPECT_TRUE(same.border().empty());
    EXPECT_TRUE(same.leader_owns({10, 3, 0}));
    EXPECT_TRUE(same.leader_owns({10, -3, 0}));
    const NearestOwner longer(leader, pieces_of({{10, off, 0}, {30, off, 0}}), origin, box,
                              infinite);
    EXPECT_TRUE(longer.leader_owns({19.9, 3, 0}));
    EXPECT_FALSE(longer.leader_owns({20.1, 3, 0}));
  }
}

TEST(Nearest, WhereOneOwnerHasNoAxisAllIsTheOthers) {
  const Box box{0, -5, 30, 5};
  const std::vector<Straight> one = pieces_of({{0, 0, 0}, {20, 0, 0}});
  EXPECT_TRUE(NearestOwner(one, {}, origin, box, infinite).leader_owns({1, 1, 0}));
  EXPECT_FALSE(NearestOwner({}, one, origin, box, infinite).leader_owns({1, 1, 0}));
  EXPECT_TRUE(NearestOwner(one, {}, origin, box, infinite).border().empty());
}

}  // namespace
}  // namespace streetgen
