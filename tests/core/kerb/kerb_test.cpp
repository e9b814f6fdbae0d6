#include "streetgen/kerb.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "kerb/kerb_place.hpp"
#include "random_town.hpp"
#include "rounds.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace kerb_test {

Streets with_kerbs(const std::vector<StreetAxis>& axes, const StreetSettings& settings = {}) {
  return streets(axes, settings, {}, {}, true);
}

StreetAxis axis(std::int64_t id, Line line, double width, double radius, int level = 0) {
  return {id, std::move(line), level, width, width, radius};
}

double length_of(const std::vector<Kerb>& kerbs) {
  double sum = 0;
  for (const Kerb& kerb : kerbs) sum += length(kerb.line);
  return sum;
}

std::map<std::string, int> sides_of(const Streets& town) {
  std::map<std::string, int> sides;
  for (const Kerb& kerb : town.kerbs) ++sides[kerb_side_name(kerb.side)];
  return sides;
}

std::vector<StreetAxis> cross_roads() {
  return {axis(1, {{-60, 0}, {0, 0}}, 8, 5), axis(2, {{0, 0}, {60, 0}}, 8, 5),
          axis(3, {{0, -50}, {0, 0}}, 6, 5), axis(4, {{0, 0}, {0, 50}}, 6, 5)};
}

// A one-way street with another carriageway of its name beside its middle.
TEST(Kerb, IsCutWhereAMedianBeginsAndEnds) {
  for (const bool bent : {false, true}) {
    Line line{{0, 0}, {300, 0}};
    if (bent) line = {{0, 0}, {150, 0}, {300, -20}};
    StreetAxis whole = axis(1, line, 7, 5);
    StreetAxis part = axis(2, {{140, 12}, {60, 12}}, 7, 5);
    whole.street = part.street = 5;
    whole.leads_backward = part.leads_backward = false;
    const Streets town = with_kerbs({whole, part});
    const int e = town.network.edges[0].axis_id == 1 ? 0 : 1;
    // To the places at which the edge looks across.
    const std::vector<double>& median = town.beside.medians[2 * e];
    ASSERT_EQ(median.size(), 2u);
    EXPECT_NEAR(median[0], 60, 2.5);
    EXPECT_NEAR(median[1], 140, 2.5);
    std::vector<Kerb> left, right;
    for (const Kerb& kerb : town.kerbs) {
      if (kerb.edge == e && kerb.side == KerbSide::left) left.push_back(kerb);
      if (kerb.edge == e && kerb.side == KerbSide::right) right.push_back(kerb);
    }
    EXPECT_EQ(right.size(), 1u);
    EXPECT_EQ(right[0].line.size(), bent ? 3u : 2u);
    ASSERT_EQ(left.size(), 3u);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(left[k].part, k + 1);
      EXPECT_EQ(left[k].beside, k == 1 ? Beside::median : Beside::outer);
      if (k > 0) EXPECT_EQ(distance(left[k].line.front(), left[k - 1].line.back()), 0);
    }
    EXPECT_NEAR(left[1].line.front().x, median[0], 1e-9);
    EXPECT_NEAR(left[1].line.back().x, median[1], 1e-9);
  }
}

TEST(Kerb, OfACrossAreItsSidesCornersAndDeadEnds) {
  const Streets town = with_kerbs(cross_roads());
  const std::map<std::string, int> sides = sides_of(town);
  EXPECT_EQ(sides.at("left"), 4);
  EXPECT_EQ(sides.at("right"), 4);
  EXPECT_EQ(sides.at("start") + sides.at("end"), 4);
  int curves = 0;
  double arcs = 0, straight = 0;
  for (const Kerb& kerb : town.kerbs) {
    EXPECT_EQ(kerb.method, Method::hypothesis);
    (kerb.curve ? arcs : straight) += length(kerb.line);
    curves += kerb.curve.has_value();
  }
  EXPECT_EQ(curves, 4);
  // Each side from the dead end to where the arc begins: half of the other street and the radius
  // before the node.
  EXPECT_NEAR(straight, 4 * (60 - 3 - 5) + 4 * (50 - 4 - 5) + 2 * 8 + 2 * 6, 1e-9);
  EXPECT_NEAR(arcs, 4 * M_PI / 2 * 5, 0.1);
  EXPECT_LT(arcs, 4 * M_PI / 2 * 5);
}

TEST(Kerb, HasTheRoadwayOnItsRight) {
  const Streets town = with_kerbs(cross_roads());
  std::vector<MultiPolygon> surfaces;
  for (const Section& section : town.sections) surfaces.push_back(section.surface);
  for (const Intersection& intersection : town.intersections)
    surfaces.push_back(intersection.surface);
  const auto on_roadway = [&](const Point& p) {
    for (const MultiPolygon& surface : surfaces)
      if (inside(p, surface)) return true;
    return false;
  };
  for (const Kerb& kerb : town.kerbs)
    for (std::size_t i = 1; i < kerb.line.size(); ++i) {
      const Point middle = (kerb.line[i - 1] + kerb.line[i]) * 0.5,
                  left = left_normal(unit(kerb.line[i] - kerb.line[i - 1])) * 0.01;
      EXPECT_TRUE(on_roadway(middle - left));
      EXPECT_FALSE(on_roadway(middle + left));
    }
}

TEST(Kerb, CurveIsTheArcOfItsCorner) {
  const Streets town = with_kerbs(cross_roads());
  for (const Kerb& kerb : town.kerbs) {
    if (!kerb.curve) continue;
    EXPECT_TRUE(same(kerb.curve->start, kerb.line.front()));
    EXPECT_TRUE(same(kerb.curve->end, kerb.line.back()));
    const Corner* corner = nullptr;
    for (const Corner& c : town.corners)
      if (c.node == kerb.node && c.edge_a == kerb.edge &&
          c.at_start_a == (kerb.side == KerbSide::corner_at_start))
        corner = &c;
    ASSERT_NE(corner, nullptr);
    EXPECT_NEAR(distance(kerb.curve->middle, *corner->centre), 5, 1e-9);
    for (const Point& p : kerb.line) EXPECT_NEAR(distance(p, *corner->centre), 5, 1e-6);
  }
}

// By level.
std::map<int, std::vector<const MultiPolygon*>> roadway_of(const Streets& town) {
  std::map<int, std::vector<const MultiPolygon*>> surfaces;
  for (const Section& section : town.sections)
    surfaces[town.network.edges[section.edge].level].push_back(&section.surface);
  for (const Intersection& intersection : town.intersections)
    surfaces[intersection.level].push_back(&intersection.surface);
  return surfaces;
}

int kerbs_through(const Streets& town, int level, const Point& p) {
  int through = 0;
  for (const Kerb& kerb : town.kerbs)
    if (kerb.level == level && distance_to_line(p, kerb.line) <= 2e-6) ++through;
  return through;
}

// Places along the sides of all surfaces: one kerb lies where no other surface goes on beyond, and
// none where one does.
void expect_border(const Streets& town, const std::string& what) {
  for (const auto& [level, surfaces] : roadway_of(town))
    for (const MultiPolygon* surface : surfaces)
      for (const Polygon& polygon : *surface)
        for (const Ring& ring : polygon)
          for (std::size_t i = 1; i < ring.size(); ++i) {
            const Point beyond = left_normal(unit(ring[i] - ring[i - 1])) * -2e-5;
            if (distance(ring[i], ring[i - 1]) < 1e-3) continue;
            for (const double share : {0.07, 0.31, 0.52, 0.76, 0.98}) {
              const Point place = ring[i - 1] + (ring[i] - ring[i - 1]) * share;
              // A step beyond may look past a corner that is as near.
              if (std::min(distance(place, ring[i - 1]), distance(place, ring[i])) < 2e-4) continue;
              const bool goes_on = std::any_of(
                  surfaces.begin(), surfaces.end(),
                  [&](const MultiPolygon* other) { return inside(place + beyond, *other); });
              EXPECT_EQ(kerbs_through(town, level, place), goes_on ? 0 : 1)
                  << what << ", level " << level << " at " << std::to_string(place.x) << " "
                  << std::to_string(place.y);
            }
          }
}

std::vector<StreetAxis> moved(std::vector<StreetAxis> axes, double turn, bool mirror, Point by) {
  for (StreetAxis& axis : axes)
    for (Point& p : axis.line) {
      const double y = mirror ? -p.y : p.y;
      p = Point{p.x * std::cos(turn) - y * std::sin(turn),
                p.x * std::sin(turn) + y * std::cos(turn), 0} +
          by;
    }
  return axes;
}

TEST(Kerb, IsTheSameWhereverTheStreetsLie) {
  const Streets town = with_kerbs(cross_roads());
  for (const bool mirror : {false, true})
    for (const double turn : {0.0, 0.3, 2.0}) {
      const Streets other = with_kerbs(moved(cross_roads(), turn, mirror, {650000, 6860000, 0}));
      EXPECT_EQ(sides_of(other), sides_of(town));
      EXPECT_NEAR(length_of(other.kerbs), length_of(town.kerbs), 1e-6);
    }
}

// Two streets beside each other that share ground, and a third across.
std::vector<StreetAxis> narrow_streets() {
  return {axis(1, {{0, 0}, {100, 0}}, 8, 4), axis(2, {{0, 6}, {100, 9}}, 8, 4),
          axis(3, {{0, 0}, {0, 6}}, 5, 4), axis(4, {{100, 0}, {160, -20}}, 7, 4),
          axis(5, {{30, -40}, {60, 50}}, 5, 4, 1)};
}

// Behind a node with streets on one side of it, where a street beside takes part of the ground.
TEST(Kerb, BehindANodeBelongsToTheGapThere) {
  const auto to = [](double degrees) {
    return Point{60 * std::cos(degrees * M_PI / 180), 60 * std::sin(degrees * M_PI / 180), 0};
  };
  const std::vector<StreetAxis> axes{
      axis(1, {{0, 0}, to(-40)}, 8, 0), axis(2, {{0, 0}, to(0)}, 8, 0),
      axis(3, {{0, 0}, to(40)}, 8, 0), axis(4, {{-5, -40}, {-5, 40}}, 4, 0)};
  const std::map<std::string, int> sides = sides_of(with_kerbs(axes));
  for (int turn = 1; turn < 12; ++turn)
    EXPECT_EQ(sides_of(with_kerbs(moved(axes, turn * M_PI / 6, false, {0, 0, 0}))), sides) << turn;
}

// The intersection goes round a dead end that is too short for a section.
TEST(Kerb, AboutADeadEndIsCutInTheAxis) {
  const std::vector<StreetAxis> axes{axis(1, {{-60, 0}, {0, 0}}, 8, 5),
                                     axis(2, {{0, 0}, {60, 0}}, 8, 5),
                                     axis(3, {{0, 0}, {2, 7}}, 6, 5)};
  for (int turn = 0; turn < 24; ++turn) {
    const auto placed = moved(axes, turn * M_PI / 12, turn % 2 == 1, {0, 0, 0});
    const Point tip = placed[2].line.back();
    int from_there = 0, to_there = 0;
    for (const Kerb& kerb : with_kerbs(placed).kerbs) {
      from_there += distance(kerb.line.front(), tip) < 1e-6;
      to_there += distance(kerb.line.back(), tip) < 1e-6;
    }
    EXPECT_EQ(from_there, 1) << turn;
    EXPECT_EQ(to_there, 1) << turn;
  }
}

// Also where another street takes the end of an arc, whatever vertices are left of it.
TEST(Kerb, CurveHasItsMiddleHalfWayAndIsTheSameInTheMirror) {
  const auto axes = random_town(4, 30);
  const Streets town = with_kerbs(axes), mirrored = with_kerbs(moved(axes, 0, true, {0, 0, 0}));
  int curves = 0;
  for (const Kerb& kerb : town.kerbs) {
    if (!kerb.curve) continue;
    ++curves;
    const Arc& arc = *kerb.curve;
    EXPECT_NEAR(distance(arc.start, arc.middle), distance(arc.middle, arc.end), 2e-6);
    const Point start{arc.start.x, -arc.start.y, 0}, middle{arc.middle.x, -arc.middle.y, 0},
        end{arc.end.x, -arc.end.y, 0};
    for (const Kerb& other : mirrored.kerbs)
      if (other.curve && distance(other.curve->end, start) < 1e-6 &&
          distance(other.curve->start, end) < 1e-6) {
        EXPECT_LT(distance(other.curve->middle, middle), 1e-6);
      }
  }
  EXPECT_GT(curves, 4);
}

TEST(Kerb, OfContestedGroundIsWhatBordersTheRoadway) {
  const Streets town = with_kerbs(narrow_streets());
  expect_border(town, "narrow streets");
  bool contested = false;
  for (const Kerb& kerb : town.kerbs) contested = contested || kerb.method == Method::contested;
  EXPECT_TRUE(contested);
}

// Of a section that a neighbour has cut down to the right of its axis; rounding puts the border on
// either side of the axis.
TEST(Kerb, OnTheAxisIsLeftOfTheGroundOnItsRight) {
  const StreetSettings settings;
  for (const double noise : {-1e-10, 0.0, 1e-10}) {
    Layout layout({axis(1, {{0, 0}, {10, 0}}, 8, 5)}, settings, {});
    layout.streets.beside = {std::vector<Beside>(2), std::vector<Beside>(2),
                             std::vector<std::vector<double>>(2)};
    layout.streets.limits.resize(2);
    layout.streets.limits[0].border_line = {{0, 4}, {0, -4}};
    layout.streets.limits[1].border_line = {{10, 4}, {10, -4}};
    const BorderLoop loop{{{0, -3}, {0, noise}},
                          {{0, noise}, {10, noise}},
                          {{10, noise}, {10, -3}},
                          {{10, -3}, {0, -3}}};
    std::vector<KerbSide> sides;
    for (const KerbPlace& place : places_of_section(layout, 0, loop)) sides.push_back(place.side);
    EXPECT_EQ(sides, (std::vector<KerbSide>{KerbSide::start, KerbSide::left, KerbSide::end,
                                            KerbSide::right}));
  }
}

TEST(Kerb, OfRoundKinksIsTheBorderOfTheRoadway) {
  StreetSettings settings;
  settings.kerb_radius_minimal = 2;
  expect_border(with_kerbs(narrow_streets(), settings), "narrow streets");
  expect_border(with_kerbs({axis(1, {{0, 0}, {40, 0}, {60, 40}, {20, 70}}, 8, 4),
                            axis(2, {{60, 40}, {90, 30}}, 6, 0)},
                           settings),
                "bends");
}

TEST(Kerb, GoesAcrossWhereTheRoadwayGoesOnOnAnotherLevel) {
  const Streets town =
      with_kerbs({axis(1, {{0, 0}, {50, 0}}, 6, 3), axis(2, {{50, 0}, {100, 0}}, 6, 3),
                  axis(3, {{50, 0}, {50, 60}}, 6, 3, 1)});
  const std::map<std::string, int> sides = sides_of(town);
  EXPECT_EQ(sides.at("across_start"), 1);
  for (const Kerb& kerb : town.kerbs)
    if (kerb.method == Method::level_change) {
      EXPECT_NEAR(length(kerb.line), 6, 1e-9);
      EXPECT_TRUE(kerb.side == KerbSide::across_start || kerb.side == KerbSide::start);
    }
  expect_border(town, "levels");
}

// No section is left of the short street from the crossing to the bridge: their intersections meet.
TEST(Kerb, GoesAcrossBetweenTwoIntersectionsOfDifferentLevels) {
  const Streets town =
      with_kerbs({axis(1, {{0, 0}, {50, 0}}, 6, 3), axis(2, {{50, 0}, {100, 0}}, 6, 3),
                  axis(3, {{50, 0}, {50, 4}}, 6, 3), axis(4, {{50, 4}, {50, 60}}, 6, 3, 1)});
  ASSERT_TRUE(std::all_of(town.sections.begin(), town.sections.end(), [&](const Section& section) {
    return town.network.edges[section.edge].axis_id != 3 || section.surface.empty();
  }));
  double across = 0;
  for (const Kerb& kerb : town.kerbs)
    if (kerb.method == Method::level_change && kerb.level == 0 && kerb.node >= 0)
      across += length(kerb.line);
  EXPECT_NEAR(across, 6, 0.01);
  expect_border(town, "levels without a section");
}

TEST(Kerb, IsTheBorderOfTheRoadwayWhateverTheTown) {
  for (int seed = 1; seed <= rounds(5); ++seed) {
    StreetSettings settings;
    settings.crossing = Crossing::split;
    settings.round_dead_ends = seed % 2 == 0;
    settings.kerb_radius_minimal = 0;
    expect_border(with_kerbs(random_town(seed, 30), settings), "seed " + std::to_string(seed));
  }
}

// What is told of each kerb, those of every second axis and its own nodes left out.
std::map<std::string, double> kerbs_within(const Streets& town, bool (*outer)(std::int64_t)) {
  const auto& edges = town.network.edges;
  std::map<std::string, double> within;
  for (const Kerb& kerb : town.kerbs) {
    const bool beyond = std::none_of(edges.begin(), edges.end(), [&](const Edge& edge) {
      const bool here = kerb.node < 0 ? &edge == &edges[kerb.edge]
                                      : edge.from_node == kerb.node || edge.to_node == kerb.node;
      return here && !outer(edge.axis_id);
    });
    if (!beyond)
      within[std::to_string(kerb.node) + " " + std::to_string(kerb.edge) + " " +
             kerb_side_name(kerb.side) + " " + std::to_string(kerb.part)] = length(kerb.line);
  }
  return within;
}

TEST(Kerb, EndsWhereANeighbourHoldsTheGround) {
  const auto outer = [](std::int64_t axis_id) { return axis_id % 2 == 0; };
  for (int seed = 1; seed <= rounds(5); ++seed) {
    std::vector<StreetAxis> axes = random_town(seed, 30);
    for (StreetAxis& axis : axes) axis.level = axis.axis_id % 5 == 0;
    const Streets town = with_kerbs(axes);
    const auto& edges = town.network.edges;
    Former former;
    former.neighbours.emplace();
    for (const Section& section : town.sections) {
      const Edge& edge = edges[section.edge];
      if (outer(edge.axis_id))
        former.neighbours->push_back(
            {{town.network.nodes[edge.from_node].point, town.network.nodes[edge.to_node].point},
             section.surface,
             edge.level});
    }
    for (const Intersection& crossing : town.intersections)
      if (std::none_of(edges.begin(), edges.end(), [&](const Edge& edge) {
            return (edge.from_node == crossing.node || edge.to_node == crossing.node) &&
                   !outer(edge.axis_id);
          }))
        former.neighbours->push_back(
            {{town.network.nodes[crossing.node].point}, crossing.surface, crossing.level});
    for (StreetAxis& axis : axes) {
      axis.outer = outer(axis.axis_id);
      axis.changed = !axis.outer;
    }
    const auto whole = kerbs_within(town, outer);
    EXPECT_GT(whole.size(), 20u);
    const auto alone = kerbs_within(streets(axes, {}, {}, former, true), outer);
    for (const auto& [name, size] : whole) {
      const auto found = alone.find(name);
      EXPECT_NEAR(found == alone.end() ? 0 : found->second, size, 1e-6) << seed << " " << name;
    }
    EXPECT_EQ(alone.size(), whole.size()) << "seed " << seed;
  }
}

TEST(Kerb, StonesLieOnItsLeft) {
  Kerb kerb;
  kerb.line = {{0, 0}, {10, 0}, {10, 10}};
  kerb.stone_width = 0.3;
  EXPECT_NEAR(area(stones_of(kerb)), 0.3 * 20 - 0.09, 1e-9);
  kerb.line = {{0, 0}, {10, 0}};
  EXPECT_NEAR(area(stones_of(kerb)), 3, 1e-12);
  EXPECT_TRUE(inside({5, 0.1, 0}, stones_of(kerb)));
  kerb.line = {{0, 0}, {0, 10}, {10, 10}, {10, 0}, {0, 0}};
  EXPECT_GT(area(stones_of(kerb)), 0.3 * 40 - 4 * 0.09 - 1e-9);
}

}  // namespace kerb_test
}  // namespace streetgen
