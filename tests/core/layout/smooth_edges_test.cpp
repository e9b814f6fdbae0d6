// Edges as arc roads: tangents at nodes, bounds, and what stays.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/polyline.hpp"
#include "rounds.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace smooth_edges_test {

StreetSettings smooth() {
  StreetSettings settings;
  settings.smoothing = Smoothing{};
  return settings;
}

double turn_at(const Point& before, const Point& at, const Point& after) {
  const Point in = unit(at - before), out = unit(after - at);
  return std::abs(std::atan2(cross(in, out), dot(in, out)));
}

// Chords of an arc turn by less than this: 2 acos(1 - tolerance / radius).
double chord_turn(const Point& before, const Point& at, const Point& after, double tolerance) {
  return 8 * tolerance / std::min(distance(before, at), distance(at, after)) + 1e-6;
}

// A road of random bends under 50 degrees, in pieces of four segments each.
std::vector<StreetAxis> random_road(unsigned seed) {
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * std::uniform_real_distribution<>()(random);
  };
  std::vector<StreetAxis> axes;
  Point at{650000, 6860000, 0};
  double heading = between(0, 2 * M_PI);
  for (int axis = 1; axis <= 5; ++axis) {
    Line line{at};
    for (int i = 0; i < 4; ++i) {
      heading += between(-0.85, 0.85);
      const double size = between(10, 60);
      at = at + Point{std::cos(heading) * size, std::sin(heading) * size, 0};
      line.push_back(at);
    }
    axes.push_back({axis, line, 0, 6, 6, 6, 3});
  }
  return axes;
}

TEST(SmoothEdges, HaveOneTangentAtANodeOfTwo) {
  for (int seed = 1; seed <= rounds(200); ++seed) {
    const Streets town = streets(random_road(seed), smooth());
    for (std::size_t n = 0; n < town.network.nodes.size(); ++n) {
      Line through;
      for (const Edge& edge : town.network.edges)
        if (edge.to_node == static_cast<int>(n)) through.push_back(edge.line[edge.line.size() - 2]);
      if (through.empty()) continue;
      for (const Edge& edge : town.network.edges)
        if (edge.from_node == static_cast<int>(n)) {
          EXPECT_LT(turn_at(through[0], edge.line[0], edge.line[1]),
                    chord_turn(through[0], edge.line[0], edge.line[1], Smoothing{}.tolerance))
              << "seed " << seed;
        }
    }
  }
}

TEST(SmoothEdges, StayWithinTheShiftAndBendByChords) {
  const double shift = 0.3, tolerance = 0.02;
  StreetSettings settings = smooth();
  settings.smoothing = Smoothing{shift, tolerance};
  for (int seed = 1; seed <= rounds(200); ++seed) {
    const std::vector<StreetAxis> axes = random_road(seed);
    const Streets town = streets(axes, settings);
    ASSERT_EQ(town.network.edges.size(), axes.size());
    for (std::size_t e = 0; e < axes.size(); ++e) {
      const Line &line = town.network.edges[e].line, &axis = axes[e].line;
      EXPECT_TRUE(same(line.front(), axis.front()) && same(line.back(), axis.back()));
      for (const Point& p : line) EXPECT_LE(distance_to_line(p, axis), shift + 1e-9);
      for (const Point& p : axis) EXPECT_LE(distance_to_line(p, line), shift + tolerance);
      for (std::size_t i = 1; i + 1 < line.size(); ++i)
        EXPECT_LT(turn_at(line[i - 1], line[i], line[i + 1]),
                  chord_turn(line[i - 1], line[i], line[i + 1], tolerance))
            << "seed " << seed << " edge " << e << " point " << i;
    }
  }
}

TEST(SmoothEdges, KeepJunctionsHeightsAndAbscissas) {
  const std::vector<StreetAxis> axes{{1, {{0, 0, 10}, {50, 0, 20}, {90, 30, 40}}, 0, 6, 6, 6, 3},
                                     {2, {{90, 30, 40}, {150, 30, 40}}, 0, 6, 6, 6, 3},
                                     {3, {{90, 30, 40}, {90, 100, 50}}, 0, 6, 6, 6, 3}};
  const Streets town = streets(axes, smooth()), before = streets(axes, {});
  const Line& line = town.network.edges[0].line;
  EXPECT_GT(line.size(), 3U);
  EXPECT_EQ(line.back().z, 40);
  EXPECT_NEAR(position_at(line, 25).point.z, 15, 0.1);
  // At the junction of three the edge leaves as its axis does.
  EXPECT_LT(turn_at({50, 0, 0}, {90, 30, 0},
                    {90 + (90 - line[line.size() - 2].x), 30 + (30 - line[line.size() - 2].y), 0}),
            1e-9);
  for (std::size_t e = 0; e < 3; ++e) {
    EXPECT_EQ(town.network.edges[e].start_abscissa, before.network.edges[e].start_abscissa);
    EXPECT_EQ(town.network.edges[e].end_abscissa, before.network.edges[e].end_abscissa);
  }
  EXPECT_TRUE(same(town.network.edges[1].line, axes[1].line));
}

TEST(SmoothEdges, TakeTurnsBackAndLoops) {
  const Streets town =
      streets({{1, {{0, 0, 0}, {50, 0, 0}, {10, 0, 0}}, 0, 6, 6, 6, 3},
               {2, {{0, 100, 0}, {50, 100, 0}, {50, 150, 0}, {0, 100, 0}}, 0, 6, 6, 6, 3}},
              smooth());
  // The first one comes back on itself, and is cut where it ends.
  ASSERT_EQ(town.network.edges.size(), 3U);
  EXPECT_GT(town.network.edges[2].line.size(), 4U);
  EXPECT_TRUE(same(town.network.edges[2].line.front(), town.network.edges[2].line.back()));
}

}  // namespace smooth_edges_test
}  // namespace streetgen
