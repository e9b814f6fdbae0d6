#include "geometry/arrangement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {
namespace arrangement_test {

const Ring square{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}};

Arrangement faces_of(const std::vector<Line>& lines) {
  return Arrangement({lines.begin(), lines.end()});
}

std::vector<bool> those_in(const Arrangement& faces, const Polygon& polygon) {
  std::vector<bool> kept;
  for (const Point& place : faces.places()) kept.push_back(inside(place, polygon));
  return kept;
}

TEST(Arrangement, KeepsVerticesAndCrossesExactly) {
  const Arrangement faces = faces_of({square, {{4.5, -1}, {4.5, 10}}});
  const MultiPolygon left =
      faces.joined(those_in(faces, {{{0, 0}, {4.5, 0}, {4.5, 9}, {0, 9}, {0, 0}}}));
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left.front().size(), 1u);
  EXPECT_EQ(left.front().front().size(), 5u);
  EXPECT_DOUBLE_EQ(area(left), 40.5);
}

TEST(Arrangement, KnowsIslands) {
  const Ring island{{2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}};
  const Arrangement faces = faces_of({square, island});
  const MultiPolygon around = faces.joined(those_in(faces, {square, island}));
  ASSERT_EQ(around.size(), 1u);
  EXPECT_EQ(around.front().size(), 2u);
  EXPECT_DOUBLE_EQ(area(around), 77);
  EXPECT_DOUBLE_EQ(area(faces.joined(those_in(faces, {square}))), 81);
}

// Across from the middle of its longest side lies a step, one side of which runs along the way.
TEST(Arrangement, TellsAFaceFromWhatLiesBesideItsSteps) {
  for (int quarter = 0; quarter < 4; ++quarter)
    for (const int mirrored : {-1, 1})
      for (const double tilt : {-1e-8, 0.0, 1e-8}) {
        Ring step{{0, -7}, {0, 7}, {-0.1, 7}, {-0.1, 0}, {-9, tilt}, {-9, -7}, {0, -7}};
        for (Point& p : step) {
          p.y *= mirrored;
          for (int turn = 0; turn < quarter; ++turn) p = left_normal(p);
        }
        const Arrangement faces = faces_of({step});
        EXPECT_NEAR(area(faces.joined(those_in(faces, {step}))), 63.7, 1e-6) << quarter;
        for (const Point& place : faces.places())
          for (std::size_t i = 1; i < step.size(); ++i)
            EXPECT_GT(distance_to_segment(place, step[i - 1], step[i]), 1e-4) << quarter;
      }
}

// A hole that touches its shell in one point.
TEST(Arrangement, TakesRingsThatTouchThemselvesApart) {
  Geos geos;
  const Ring inner{{0, 4}, {3, 6}, {3, 2}, {0, 4}};
  const Arrangement faces = faces_of({square, inner});
  const MultiPolygon around = faces.joined(those_in(faces, {square, inner}));
  EXPECT_TRUE(geos.valid(geos.surface(around).get()));
  EXPECT_DOUBLE_EQ(area(around), 75);
}

// A face along the shell's side, on it but for the noise of coordinates, is left out.
TEST(Arrangement, LeavesOutAFaceThatNearlyTouchesTheShell) {
  Geos geos;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    std::mt19937_64 random(seed);
    const auto share = [&] { return (random() % 1000001) / 1e6; };
    const double turn = share() * M_PI;
    const Point along{std::cos(turn), std::sin(turn), 0}, across = left_normal(along);
    const Point corner{650000 + share(), 6860000 + share(), 0};
    const auto ring = [&](double from, double to, double height) {
      const Point a = corner + along * from, b = corner + along * to;
      return Ring{a, b, b + across * height, a + across * height, a};
    };
    const Ring shell = ring(0, 9, 9), face = ring(1 + share(), 5 + share(), 2);
    const Arrangement faces = faces_of({shell, face});
    std::vector<bool> kept;
    for (const Point& place : faces.places())
      kept.push_back(inside(place, {shell}) && !inside(place, {face}));
    const double left = 81 - std::abs(signed_area(face));
    EXPECT_NEAR(area(faces.joined(kept)), left, 1e-5) << seed;
    const MultiPolygon on_grid = faces.joined(kept, Arrangement::Vertices::on_grid);
    EXPECT_NEAR(area(on_grid), left, 1e-5) << seed;
    EXPECT_TRUE(geos.valid(geos.surface(on_grid).get())) << seed;
  }
}

// Rectangles that nearly coincide, far from the origin.
TEST(Arrangement, MakesFacesOfWhatNearlyCoincides) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::mt19937_64 random(seed);
    const auto share = [&] { return (random() % 1000001) / 1e6; };
    const auto rectangle = [](double turn, double x, double y, double length, double width) {
      const Point along{std::cos(turn), std::sin(turn), 0}, across = left_normal(along);
      const Point corner{653000 + x, 6861000 + y, 0};
      return MultiPolygon{
          {{corner, corner + along * length, corner + along * length + across * width,
            corner + across * width, corner}}};
    };
    Geos geos;
    const double turn = 7 * share();
    std::vector<MultiPolygon> all;
    std::vector<Line> lines;
    for (int i = 0; i < 6; ++i) {
      const double width = 1 + 4 * share(), length = 10 + 10 * share();
      const double y = 3 * share(), x = 3 * share();
      const double by = random() % 3 ? 1e-6 * share() : share();
      all.push_back(rectangle(turn + by, x, y, length, width));
      lines.push_back(all.back().front().front());
    }
    const Arrangement faces = faces_of(lines);
    for (const MultiPolygon& rectangle : all) {
      std::vector<bool> held;
      for (const Point& place : faces.places()) held.push_back(inside(place, rectangle.front()));
      const MultiPolygon joined = faces.joined(held);
      EXPECT_TRUE(geos.valid(geos.surface(joined).get())) << seed;
      EXPECT_NEAR(area(joined), area(rectangle), 1e-5) << seed;
    }
  }
}

// A hundred diameters of a circle, each of which crosses all others: each step over its crossings
// asks whether to stop, as the search of them does.
TEST(Arrangement, CanBeCancelledAmongCrossings) {
  std::vector<Line> diameters;
  for (int i = 0; i < 100; ++i) {
    const Point end{std::cos(i * 0.03), std::sin(i * 0.03), 0};
    diameters.push_back({end * -50, end * 50});
  }
  static int polls;
  polls = 0;
  set_cancel_check([]() noexcept { return ++polls < 0; });
  faces_of(diameters);
  set_cancel_check(nullptr);
  EXPECT_GE(polls, 2 * 99);
}

}  // namespace arrangement_test
}  // namespace streetgen
