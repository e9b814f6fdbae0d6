#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "design/section_cost.hpp"
#include "geometry/polyline.hpp"
#include "made_terrain.hpp"
#include "streetgen/error.hpp"
#include "streetgen/road_design.hpp"

namespace streetgen {
namespace road_path_test {

Line line_of(const RoadPath& path) {
  Line line;
  for (const PathVertex& vertex : path.vertices) line.push_back(planar(vertex.point));
  return line;
}

RoadPath path_between(const DesignSite& site, const Point& a, const Point& b) {
  return road_path(site, {a, b}, {false, false});
}

double cost_of(const DesignSite& site, const RoadPath& path) {
  const Line line = line_of(path);
  const auto elements = horizontal_alignment(
      line, road_curves(site.rules, line, std::vector<VertexCurve>(line.size())));
  ProfileWish wish;
  wish.start_height = path.vertices.front().point.z;
  wish.end_height = path.vertices.back().point.z;
  const RoadCostTerms c =
      road_estimate(site, elements, vertical_alignment(road_profile(site, elements, wish))).cost;
  return c.pavement + c.land + c.fill + c.cut + c.bridge + c.tunnel + c.zones + c.use;
}

TEST(RoadPath, FlatGroundGivesAStraightLine) {
  const Terrain flat = made_terrain([](double, double) { return 100.0; });
  const DesignRules rules;
  for (const Point& b : {Point{5500, 700, 0}, Point{900, 5300, 0}, Point{5000, 5200, 0}}) {
    const RoadPath path = path_between({flat, {}, rules}, {500, 600, 0}, b);
    ASSERT_GE(path.vertices.size(), 2u);
    const Line line = line_of(path);
    EXPECT_NEAR(length(line), distance(line.front(), line.back()), 1e-6);
  }
}

TEST(RoadPath, AWallWithOneGapIsPassedByTheGap) {
  const Terrain flat = made_terrain([](double, double) { return 100.0; });
  const DesignRules rules;
  const ZoneGrid wall(
      {rectangle_zone(2900, -100, 3100, 4200, 0), rectangle_zone(2900, 4600, 3100, 7000, 0)},
      {{0, Passage::forbidden}}, 10);
  const RoadPath path = path_between({flat, wall, rules}, {500, 3000, 0}, {5500, 3000, 0});
  const Line line = line_of(path);
  ASSERT_GT(line.size(), 2u);
  bool through = false;
  for (double s = 0; s < length(line); s += 5) {
    const Point p = position_at(line, s).point;
    EXPECT_EQ(wall.at(p.x, p.y), nullptr) << p.x << " " << p.y;
    through = through || (std::abs(p.x - 3000) < 50 && p.y > 4200 && p.y < 4600);
  }
  EXPECT_TRUE(through);
}

TEST(RoadPath, AWallWithoutAGapBarsTheWayAndIsNamed) {
  const Terrain flat = made_terrain([](double, double) { return 100.0; });
  const DesignRules rules;
  const ZoneGrid wall({rectangle_zone(2900, -9000, 3100, 15000, 0)}, {{0, Passage::forbidden}}, 10);
  const RoadPath path = path_between({flat, wall, rules}, {500, 3000, 0}, {5500, 3000, 0});
  EXPECT_TRUE(path.vertices.empty());
  EXPECT_EQ(path.barrier, Barrier::zone);
  EXPECT_EQ(path_between({flat, {}, rules}, {500, 3000, 0}, {9500, 3000, 0}).barrier,
            Barrier::terrain);
}

TEST(RoadPath, ARiverIsBridgedWhereItIsNarrow) {
  const Terrain flat = made_terrain([](double, double) { return 100.0; });
  DesignRules rules;
  // 300 m of water, 40 m of it between 3,600 and 4,000.
  const ZoneGrid river(
      {rectangle_zone(2800, -100, 3100, 3600, 0), rectangle_zone(2930, 3600, 2970, 4000, 0),
       rectangle_zone(2800, 4000, 3100, 9000, 0)},
      {{0, Passage::bridge}}, 10);
  const DesignSite site{flat, river, rules};
  const RoadPath path = path_between(site, {500, 3000, 0}, {5500, 3000, 0});
  const Line line = line_of(path);
  const auto elements =
      horizontal_alignment(line, road_curves(rules, line, std::vector<VertexCurve>(line.size())));
  const auto grades = vertical_alignment(road_profile(site, elements, {{}, {}, {}, 100, 100}));
  const RoadEstimate estimate = road_estimate(site, elements, grades);
  ASSERT_EQ(estimate.structures.size(), 1u);
  EXPECT_EQ(estimate.structures[0].kind, StructureKind::bridge);
  EXPECT_LT(estimate.structures[0].end_abscissa - estimate.structures[0].start_abscissa, 120);
}

TEST(RoadPath, APlaneSteeperThanTheGradeIsClimbedAslant) {
  const DesignRules rules;
  const Terrain plane = made_terrain([](double x, double) { return 0.12 * x; });
  const RoadPath path = path_between({plane, {}, rules}, {1500, 3000, 0}, {4500, 3000, 0});
  const double run = length(line_of(path)), climb = 0.12 * 3000;
  EXPECT_GE(run, climb / rules.grade - 1);
  EXPECT_LE(run, climb / rules.grade * 1.1);
}

TEST(RoadPath, ReversedAndMirroredItCostsTheSame) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> phase(0, 6);
  const DesignRules rules;
  for (int round = 0; round < 3; ++round) {
    const double p = phase(random), q = phase(random);
    const auto hills = [&](double x, double y) {
      return 60 * std::sin(x / 600 + p) * std::cos(y / 500 + q);
    };
    const Terrain ground = made_terrain(hills);
    const Terrain mirrored = made_terrain([&](double x, double y) { return hills(x, 6000 - y); });
    const Point a{600, 2500, 0}, b{5400, 3700, 0};
    const DesignSite site{ground, {}, rules}, other{mirrored, {}, rules};
    const double there = cost_of(site, path_between(site, a, b));
    const double back = cost_of(site, path_between(site, b, a));
    const double beside =
        cost_of(other, path_between(other, {a.x, 6000 - a.y, 0}, {b.x, 6000 - b.y, 0}));
    // The search is symmetric; ways of equal cost and the descent after it may differ a little.
    EXPECT_NEAR(back / there, 1, 0.01);
    EXPECT_NEAR(beside / there, 1, 0.01);
  }
}

TEST(RoadPath, ItRunsThroughPlacesByHandAndKeepsStraightSides) {
  const Terrain hills =
      made_terrain([](double x, double y) { return 40 * std::sin(x / 500) * std::sin(y / 700); });
  const DesignRules rules;
  const Point by_hand{3000, 4000, 0};
  const RoadPath path = road_path({hills, {}, rules}, {{500, 3000, 0}, by_hand, {5500, 3000, 0}},
                                  {false, false, false});
  EXPECT_TRUE(std::any_of(path.vertices.begin(), path.vertices.end(), [&](const PathVertex& v) {
    return v.by_hand && distance(planar(v.point), by_hand) < 1e-9;
  }));
  const RoadPath straight = road_path(
      {hills, {}, rules}, {{500, 3000, 0}, by_hand, {5500, 3000, 0}}, {false, true, true});
  EXPECT_EQ(straight.vertices.size(), 3u);
}

bool crosses_itself(const Line& line) {
  for (std::size_t i = 1; i < line.size(); ++i)
    for (std::size_t k = i + 2; k < line.size(); ++k)
      if (crossing(line[i - 1], line[i], line[k - 1], line[k])) return true;
  return false;
}

// The greatest turn to one side between any two places of a line.
double winding(const Line& line) {
  double left = 0, right = 0, most = 0;
  for (std::size_t i = 2; i < line.size(); ++i) {
    const Point a = line[i - 1] - line[i - 2], b = line[i] - line[i - 1];
    const double turn = std::atan2(cross(a, b), dot(a, b));
    left = std::max(0.0, left + turn);
    right = std::max(0.0, right - turn);
    most = std::max({most, left, right});
  }
  return most;
}

Line chords_of(const std::vector<AlignmentElement>& elements) {
  Line line;
  for (double s : chord_abscissas(elements, 0.05))
    line.push_back(planar(alignment_place(elements, s).point));
  return line;
}

// A road across the square, with vertices by hand up to `aside` metres beside the straight line.
Line random_places(std::mt19937& random, double aside) {
  std::uniform_real_distribution<double> share(-1, 1);
  Line places{{500, 3000 + 500 * share(random), 0}};
  for (double x = 700 + 200 * share(random); x < 5300; x += 350 + 250 * share(random))
    places.push_back({x, 3000 + aside * share(random), 0});
  places.push_back({5500, 3000 + 500 * share(random), 0});
  return places;
}

TEST(RoadPath, VerticesByHandTieNoLoops) {
  std::mt19937 random(11);
  const DesignRules rules;
  const Terrain hills =
      made_terrain([](double x, double y) { return 30 * std::sin(x / 500) * std::sin(y / 700); });
  for (int round = 0; round < 60; ++round) {
    const Line places = random_places(random, 20 + 100 * (round % 4));
    std::vector<bool> straight(places.size());
    // The search fills a side or two beside one vertex, every third side, or all.
    const std::size_t filled = 1 + random() % (places.size() - 1);
    for (std::size_t i = 1; i < places.size(); ++i)
      straight[i] = round % 3 == 0   ? i != filled && i != filled + 1
                    : round % 3 == 1 ? random() % 3 != 0
                                     : false;
    const RoadPath path = road_path({hills, {}, rules}, places, straight);
    ASSERT_EQ(path.barrier, Barrier::none) << round;
    const Line line = line_of(path);
    const auto elements =
        horizontal_alignment(line, road_curves(rules, line, std::vector<VertexCurve>(line.size())));
    const Line road = chords_of(elements);
    EXPECT_FALSE(crosses_itself(road)) << round;
    EXPECT_LE(winding(road), winding(places) + M_PI) << round;
    EXPECT_LE(length(road), 1.3 * length(places)) << round;
  }
}

TEST(SectionCost, EarthworksAreTheAreasOfTheSection) {
  // By strips of a millimetre across the formation and its slopes.
  for (double height : {-6.0, -1.0, 0.0, 0.7, 4.0, 12.0})
    for (double slope : {0.0, 0.1, 0.3, 0.5}) {
      const double b = 12, m = 1.5, step = 0.001;
      Earthwork strips;
      for (double x = -200 + step / 2; x < 200; x += step) {
        const double ground = slope * x;
        const double out = std::max(0.0, std::abs(x) - b / 2);
        const double low = height - out / m, high = height + out / m;
        strips.fill += step * std::max(0.0, low - ground);
        strips.cut += step * std::max(0.0, ground - high);
      }
      const Earthwork work = earthwork(b, m, height, slope);
      EXPECT_NEAR(work.fill, strips.fill, 0.02) << height << " " << slope;
      EXPECT_NEAR(work.cut, strips.cut, 0.02) << height << " " << slope;
    }
}

TEST(RoadProfile, ItKeepsGradeParabolasLimitsAndFixedPoints) {
  const DesignRules rules;
  const Terrain hills = made_terrain([](double x, double) { return 50 * std::sin(x / 300); });
  const auto elements = horizontal_alignment({{500, 3000}, {5500, 3000}}, {{}, {}});
  ProfileWish wish;
  wish.start_height = hills.ground(500, 3000).height;
  wish.end_height = hills.ground(5500, 3000).height;
  wish.fixed = {{2000, hills.ground(2500, 3000).height + 3, 0}};
  wish.limits = {{3333, 30, 30}};
  const auto points = road_profile({hills, {}, rules}, elements, wish);
  const auto pieces = vertical_alignment(points);
  for (const GradePiece& piece : pieces) {
    EXPECT_LE(std::abs(piece.grade), rules.grade + 2e-3);
    if (piece.bend < 0) {
      EXPECT_GE(-1 / piece.bend, rules.crest * 0.98);
    }
    if (piece.bend > 0) {
      EXPECT_GE(1 / piece.bend, rules.sag * 0.98);
    }
  }
  EXPECT_NEAR(grade_place(pieces, 3333).height, 30, 1e-6);
  EXPECT_TRUE(std::any_of(points.begin(), points.end(), [&](const GradePoint& p) {
    return p.abscissa == 2000 && p.height == wish.fixed[0].height;
  }));
}

TEST(RoadEstimate, ARidgeIsCutBelowBreakEvenAndTunnelledAboveIt) {
  DesignRules rules;
  rules.cut_greatest = 200;
  const SectionCost section(rules);
  // Cut of depth h costs 6 (b h + m h^2) + 2 m h 2 + 2 b; a tunnel 2,000 b.
  double even = 0;
  while (6 * (12 * even + 1.5 * even * even) + 6 * even + 24 < 24000) even += 0.001;
  EXPECT_EQ(section.kind(-even + 0.01, 0, nullptr), SectionKind::earth);
  EXPECT_EQ(section.kind(-even - 0.01, 0, nullptr), SectionKind::tunnel);
}

}  // namespace road_path_test
}  // namespace streetgen
