#include "streetgen/lane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "lane/arrow_paint.hpp"
#include "random_town.hpp"
#include "rounds.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace lane_test {

AxisLanes general(int forward, int backward) {
  return {std::vector<LaneWish>(forward), std::vector<LaneWish>(backward)};
}

const Line straight{{0, 0, 0}, {100, 0, 0}};

std::vector<Lane> on_straight(const AxisLanes& wanted, LaneSettings settings = {},
                              double width = 12) {
  return axis_lanes(straight, width, width, wanted, settings);
}

std::vector<int> ordinalities(int count, LaneOrder order) {
  LaneSettings settings;
  settings.order = order;
  std::vector<int> out;
  for (const Lane& lane : on_straight(general(count, 0), settings)) out.push_back(lane.ordinality);
  return out;
}

TEST(Lane, IsNumberedFromTheMiddleOutwards) {
  using V = std::vector<int>;
  EXPECT_EQ(ordinalities(1, LaneOrder::left_first), (V{1}));
  EXPECT_EQ(ordinalities(2, LaneOrder::left_first), (V{1, 2}));
  EXPECT_EQ(ordinalities(3, LaneOrder::left_first), (V{2, 1, 3}));
  EXPECT_EQ(ordinalities(4, LaneOrder::left_first), (V{3, 1, 2, 4}));
  EXPECT_EQ(ordinalities(5, LaneOrder::left_first), (V{4, 2, 1, 3, 5}));
  EXPECT_EQ(ordinalities(2, LaneOrder::right_first), (V{2, 1}));
  EXPECT_EQ(ordinalities(3, LaneOrder::right_first), (V{3, 1, 2}));
  EXPECT_EQ(ordinalities(4, LaneOrder::right_first), (V{4, 2, 1, 3}));
}

TEST(Lane, RunsAlongTheAxisOnTheSideThatOneDrivesOn) {
  for (const DrivingSide side : {DrivingSide::left, DrivingSide::right}) {
    LaneSettings settings;
    settings.driving_side = side;
    for (const Lane& lane : on_straight(general(3, 1), settings)) {
      const bool on_own_side = side == DrivingSide::right ? lane.position > 1 : lane.position < 4;
      EXPECT_EQ(lane.along_axis, on_own_side);
      EXPECT_LT(lane.line.front().x, lane.line.back().x) << "lines keep the order of the axis";
    }
  }
}

TEST(Lane, OfBothDirectionsLiesBetweenTheOthers) {
  AxisLanes wanted = general(2, 1);
  wanted.both_ways.resize(1);
  for (const DrivingSide side : {DrivingSide::left, DrivingSide::right}) {
    LaneSettings settings;
    settings.driving_side = side;
    for (const Lane& lane : on_straight(wanted, settings)) {
      EXPECT_EQ(lane.both_ways, lane.position == (side == DrivingSide::right ? 2 : 3));
      EXPECT_TRUE(lane.along_axis || !lane.both_ways);
    }
  }
}

TEST(Lane, SharesTheRoadwayEquallyAndKnowsItsSide) {
  const std::vector<Lane> lanes = on_straight(general(2, 1));
  ASSERT_EQ(lanes.size(), 3u);
  const LaneSide sides[] = {LaneSide::left, LaneSide::centre, LaneSide::right};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(lanes[i].width, 4, 1e-12);
    EXPECT_NEAR(lanes[i].axis_offset, 4 - 4 * i, 1e-12);
    EXPECT_NEAR(lanes[i].line.front().y, 4 - 4 * i, 1e-12);
    EXPECT_EQ(lanes[i].side, sides[i]);
    EXPECT_NEAR(area(lanes[i].surface), 400, 1e-9);
  }
}

TEST(Lane, KeepsItsOwnWidthAndLeavesTheRestToTheOthers) {
  AxisLanes wanted = general(3, 1);
  wanted.forward[2].width = 1.5;
  wanted.forward[2].kind = LaneKind::cycle;
  const std::vector<Lane> lanes = on_straight(wanted);
  EXPECT_NEAR(lanes[3].width, 1.5, 1e-12);
  EXPECT_EQ(lanes[3].kind, LaneKind::cycle);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(lanes[i].width, 3.5, 1e-12);
}

TEST(Lane, LeavesWhatStatedWidthsDoNotTakeAtBothKerbs) {
  AxisLanes wanted = general(2, 0);
  wanted.forward[0].width = 4;
  wanted.forward[1].width = 2;
  std::vector<Lane> lanes = on_straight(wanted, {}, 12);
  EXPECT_NEAR(lanes[0].width, 4, 1e-12);
  EXPECT_NEAR(lanes[0].axis_offset, 1, 1e-12)
      << "3 m lie left of it, to the kerb 6 m from the axis";
  EXPECT_NEAR(area(lanes[0].surface), 400, 1e-9);
  EXPECT_NEAR(lanes[1].width, 2, 1e-12);
  EXPECT_NEAR(lanes[1].axis_offset, -2, 1e-12);
  EXPECT_NEAR(area(lanes[1].surface), 200, 1e-9);
  wanted.forward[1].kind = LaneKind::cycle;
  EXPECT_NEAR(on_straight(wanted, {}, 12)[0].width, 4, 1e-12);
  wanted.forward[0].kind = LaneKind::parking;
  EXPECT_NEAR(on_straight(wanted, {}, 12)[0].width, 8, 1e-12)
      << "a way of cycle and parking lanes alone has no other ground";
  lanes = axis_lanes(straight, 12, 24, {{LaneWish{LaneKind::general, true, false, 4}}, {}}, {});
  EXPECT_NEAR(lanes[0].width, 4, 1e-12);
  EXPECT_NEAR(area(lanes[0].surface), 600, 1e-9) << "its share of the roadway stays";
}

TEST(Lane, SaysWhereItLiesWhereTheRoadwayWidens) {
  for (const Lane& lane : on_straight(general(1, 1))) EXPECT_TRUE(lane.borders.empty());
  const std::vector<Lane> lanes = axis_lanes(straight, 6, 12, general(1, 1), {});
  ASSERT_EQ(lanes.size(), 2u);
  for (const Lane& lane : lanes) {
    ASSERT_EQ(lane.borders.places.size(), 2u);
    const double outwards = lane.position == 1 ? 1 : -1;
    EXPECT_NEAR(lane.borders.at(0).left, outwards > 0 ? 3 : 0, 1e-12);
    EXPECT_NEAR(lane.borders.at(0).right, outwards > 0 ? 0 : 3, 1e-12);
    EXPECT_NEAR(lane.borders.at(50).on(outwards > 0 ? 1 : -1), 4.5, 1e-12);
    EXPECT_NEAR(lane.borders.at(100).on(outwards > 0 ? 1 : -1), 6, 1e-12);
  }
  EXPECT_NEAR(lanes[0].borders.at(70).right, -lanes[1].borders.at(70).left, 1e-12)
      << "neighbours share a border";
}

TEST(Lane, GrowsToItsWidestAndLeavesTheRestAtBothKerbs) {
  AxisLanes wanted = general(2, 0);
  for (LaneWish& lane : wanted.forward) lane.widest = 4;
  std::vector<Lane> lanes = on_straight(wanted, {}, 9);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(lanes[i].width, 4, 1e-12);
    EXPECT_NEAR(lanes[i].axis_offset, i == 0 ? 2 : -2, 1e-12) << "0.5 m lie at either kerb";
  }
  lanes = on_straight(wanted, {}, 7);
  for (int i = 0; i < 2; ++i) EXPECT_NEAR(lanes[i].width, 3.5, 1e-12) << "there is no such room";
  wanted.forward[0].width = 3;
  EXPECT_NEAR(on_straight(wanted, {}, 9)[1].width, 4, 1e-12) << "6 m are left to it";
  wanted.forward[0].width = 5;
  EXPECT_NEAR(on_straight(wanted, {}, 9)[0].width, 5, 1e-12) << "its own width is stated";
}

TEST(Lane, FillsTheRoadwayInProportionWhereWidthsSumToMore) {
  AxisLanes wanted = general(2, 0);
  wanted.forward[0].width = 4;
  wanted.forward[1].width = 2;
  EXPECT_NEAR(on_straight(wanted, {}, 3)[0].width, 2, 1e-12);
  wanted.forward[1].width = 0;  // nothing left: as if it were half as narrow as may be
  const std::vector<Lane> lanes = on_straight(wanted, {}, 3);
  EXPECT_NEAR(lanes[0].width, 2.4, 1e-12);
  EXPECT_NEAR(lanes[1].width, 0.6, 1e-12);
}

TEST(Lane, HoldsStatedWidthsWhereLanesWithoutOneHaveRoomToGiveWay) {
  AxisLanes wanted = general(2, 1);
  wanted.forward[1] = {LaneKind::cycle};
  wanted.forward[1].width = 1.8;
  wanted.backward.push_back({LaneKind::parking});
  wanted.backward[1].width = 2;
  wanted.backward[1].yields = true;
  // From left to right: parking, general, general, cycle.
  const std::vector<Lane> lanes = on_straight(wanted, {}, 7);
  EXPECT_NEAR(lanes[3].width, 1.8, 1e-12);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(lanes[i].width, 5.2 / 3, 1e-12) << i;
  wanted.backward[1].yields = false;
  const std::vector<Lane> stated = on_straight(wanted, {}, 7);
  EXPECT_NEAR(stated[0].width, 2, 1e-12);
  EXPECT_NEAR(stated[3].width, 1.8, 1e-12);
  for (int i = 1; i < 3; ++i) EXPECT_NEAR(stated[i].width, 1.6, 1e-12) << i;
  wanted.forward[1].width = 0;
  wanted.forward[1].kind = LaneKind::general;
  EXPECT_NEAR(on_straight(wanted, {}, 9)[0].width, 2, 1e-12) << "nothing is short";
}

TEST(Lane, WithoutAnyWishIsOneAlongTheAxis) {
  const std::vector<Lane> lanes = on_straight({});
  ASSERT_EQ(lanes.size(), 1u);
  EXPECT_TRUE(lanes[0].along_axis);
  EXPECT_EQ(lanes[0].side, LaneSide::centre);
}

TEST(Lane, FollowsAWidthThatChanges) {
  const std::vector<Lane> lanes = axis_lanes(straight, 6, 12, general(1, 1), {});
  EXPECT_NEAR(lanes[0].line.front().y, 1.5, 1e-12);
  EXPECT_NEAR(lanes[0].line.back().y, 3, 1e-12);
  EXPECT_NEAR(area(lanes[0].surface), 450, 1e-9);
}

Line random_line(std::mt19937_64& random, int points, double step) {
  Line line{{0, 0, 0}};
  double heading = 0;
  for (int i = 1; i < points; ++i) {
    heading += (random() % 1000 / 1000.0 - 0.5) * 1.2;
    const Point last = line.back();
    line.push_back({last.x + step * std::cos(heading), last.y + step * std::sin(heading), 0});
  }
  return line;
}

TEST(OffsetLine, LiesAtItsOffset) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 50; ++i) {
    const Line axis = random_line(random, 4, 30);
    for (const double offset : {-3.0, -0.5, 0.5, 3.0}) {
      const Line line = offset_line(axis, offset, offset);
      ASSERT_GE(line.size(), 2u);
      for (std::size_t k = 0; k + 1 < line.size(); ++k) {
        const Point middle = (line[k] + line[k + 1]) * 0.5;
        EXPECT_NEAR(distance_to_line(middle, axis), std::abs(offset), 0.01 * std::abs(offset));
        EXPECT_GT(offset * cross(position_at(axis, 0).direction, line.front() - axis.front()), 0);
      }
    }
  }
}

// Bends tighter than the offset: what is nearer to the axis than the offset must go.
TEST(OffsetLine, HasNoLoopInATightBend) {
  Line axis{{0, 0, 0}};
  for (int i = 0; i <= 16; ++i) {
    const double angle = -M_PI_2 + M_PI * i / 16;
    axis.push_back({50 + 2 * std::cos(angle), 2 + 2 * std::sin(angle), 0});
  }
  axis.push_back({0, 24, 0});
  const Line inside = offset_line(axis, 3, 3);
  double nearest = 3;
  for (const Point& p : inside) nearest = std::min(nearest, distance_to_line(p, axis));
  EXPECT_NEAR(nearest, 3, 1e-6);
  const Line outside = offset_line(axis, -3, -3);
  for (const Point& p : outside) EXPECT_NEAR(distance_to_line(p, axis), 3, 0.05);
}

std::vector<StreetAxis> bent_town(unsigned seed, int count) {
  std::mt19937_64 random(seed);
  const std::vector<Point> places = random_places(random, count / 2);
  std::vector<StreetAxis> axes;
  for (int i = 0; i < count; ++i) {
    const Point &a = places[random() % places.size()], &b = places[random() % places.size()];
    if (distance(a, b) < 1) continue;
    const Point bend = (a + b) * 0.5 + left_normal(b - a) * (random() % 100 / 300.0 - 0.15);
    StreetAxis axis;
    axis.axis_id = i + 1;
    axis.line = {a, bend, b};
    axis.width = 3 + random() % 120 / 10.0;
    axis.width_end = i % 3 == 0 ? 3 + random() % 120 / 10.0 : axis.width;
    axis.radius = random() % 80 / 10.0;
    axis.importance = 1 + random() % 5;
    axes.push_back(axis);
  }
  return axes;
}

std::vector<LanesOfAxis> random_lanes(unsigned seed, int count) {
  std::mt19937_64 random(seed);
  std::vector<LanesOfAxis> axes;
  for (int i = 0; i < count; ++i) {
    axes.push_back({i + 1, general(random() % 4, random() % 3)});
    for (LaneWish& wish : axes.back().lanes.forward) {
      wish.width = random() % 3 == 0 ? 1 + random() % 3 : 0;
      wish.turns = random() % 1024;
    }
  }
  return axes;
}

struct Town {
  Streets streets, unfilled;  // with slits and holes given to surfaces, and without
  Lanes lanes;
};

constexpr int towns = 3;

const Town& town(unsigned seed) {
  static std::map<unsigned, Town> made;
  const auto found = made.find(seed);
  if (found != made.end()) return found->second;
  StreetSettings settings;
  settings.crossing = Crossing::split;
  settings.kerb_radius_minimal = 0;  // arcs beside a surface may close a hole, which has no lane
  Town town{streetgen::streets(bent_town(seed, 30), settings), {}, {}};
  settings.max_hole_area = settings.island_area_minimal = settings.slit_width = 0;
  town.unfilled = streetgen::streets(bent_town(seed, 30), settings);
  LaneSettings with_edges;
  with_edges.edge_lines = true;
  town.lanes = lanes(town.streets, random_lanes(seed, 30), {}, with_edges);
  return made.emplace(seed, std::move(town)).first->second;
}

// Lanes lie within their section and beside each other, and leave nothing of it, but for the ground
// of slits and holes that a section is given, and up to an arc that lies beyond its limit.
TEST(Lanes, TileTheirSection) {
  int given = 0, all = 0;
  for (int seed = 1; seed <= towns; ++seed) {
    const Town& made = town(seed);
    Geos geos;
    std::vector<double> sum(made.streets.sections.size());
    std::vector<std::vector<MultiPolygon>> grounds(sum.size());
    const auto united_area = [&](const std::vector<MultiPolygon>& surfaces) {
      return area(geos.polygons(geos.unite(surfaces).get()));
    };
    for (const Lane& lane : made.lanes.lanes) {
      EXPECT_TRUE(geos.valid(geos.surface(lane.surface).get()));
      sum[lane.edge] += area(lane.surface);
      grounds[lane.edge].push_back(lane.surface);
    }
    for (const Section& section : made.streets.sections) {
      if (section.method == Method::crossed_limits) {
        EXPECT_EQ(sum[section.edge], 0);
      }
      const auto* limit = &made.streets.limits[2 * section.edge];
      const bool alone = limit[0].shared == 0 && limit[1].shared == 0;
      if (section.method == Method::hypothesis && section.contested_area == 0 && alone) {
        const Section& unfilled = made.unfilled.sections[section.edge];
        ASSERT_EQ(unfilled.edge, section.edge);
        const double whole = area(section.surface), own = area(unfilled.surface);
        EXPECT_NEAR(sum[section.edge], own, 1e-6 * own);
        std::vector<MultiPolygon>& ground = grounds[section.edge];
        EXPECT_NEAR(united_area(ground), own, 1e-6 * own) << "no lane lies upon another";
        ground.push_back(unfilled.surface);
        EXPECT_NEAR(united_area(ground), own, 1e-6 * own) << "no lane lies beyond the section";
        EXPECT_GT(whole, own - 1e-6 * own);
        given += whole > own + 1e-6 * own;
        ++all;
      }
    }
  }
  EXPECT_GT(given, 0);
  EXPECT_LT(20 * given, all);
}

TEST(Lanes, TileTheirSectionWhereKinksOfItsKerbsAreRound) {
  StreetSettings settings;
  settings.kerb_radius_minimal = 1.5;
  LaneSettings as_wide;
  as_wide.kerb_radius_minimal = settings.kerb_radius_minimal;
  for (const Point& end : {Point{60, 40, 0}, Point{30, 40, 0}, Point{45, -20, 0}}) {
    const Streets bent = streets({{1, {{0, 0, 0}, {40, 0, 0}, end}, 0, 7, 9, 6, 3}}, settings);
    double sum = 0;
    for (const Lane& lane : lanes(bent, {{1, {{{}}, {{}}}}}, {}, as_wide).lanes)
      sum += area(lane.surface);
    EXPECT_NEAR(sum, area(bent.sections.front().surface), 1e-9);
  }
}

TEST(Lanes, RunBetweenTheLimitsAlongTheAxis) {
  for (int seed = 1; seed <= towns; ++seed) {
    const Town& made = town(seed);
    for (const Lane& lane : made.lanes.lanes) {
      const SectionLimit &start = made.streets.limits[2 * lane.edge],
                         &end = made.streets.limits[2 * lane.edge + 1];
      const Line axis = planar(made.streets.network.edges[lane.edge].line);
      const double u = start.abscissa, v = end.abscissa;
      const Point from = position_at(axis, u).point, to = position_at(axis, v).point;
      EXPECT_LT(distance_to_line(lane.line.front(), start.border_line), 0.02);
      if (start.askew == 0)
        EXPECT_NEAR(distance(lane.line.front(), from), std::abs(lane.axis_offset), 0.02);
      EXPECT_LT(distance(lane.line.back(), to), 8);
      if (v - u > 1) {
        EXPECT_GT(dot(lane.line[1] - lane.line[0], position_at(axis, u).direction), 0);
      }
    }
  }
}

TEST(Lanes, AreNumberedOncePerEdge) {
  const Town& made = town(3);
  std::vector<std::vector<int>> seen(made.streets.network.edges.size());
  for (const Lane& lane : made.lanes.lanes) seen[lane.edge].push_back(lane.ordinality);
  for (std::vector<int>& ordinality : seen) {
    std::sort(ordinality.begin(), ordinality.end());
    ASSERT_FALSE(ordinality.empty());
    for (std::size_t i = 0; i < ordinality.size(); ++i)
      EXPECT_EQ(ordinality[i], static_cast<int>(i) + 1);
  }
}

TEST(Lanes, DoNotDependOnTheOrderOfWishes) {
  const Streets streets = streetgen::streets(random_town(4, 20), {});
  std::vector<LanesOfAxis> axes = random_lanes(4, 20);
  const Lanes first = lanes(streets, axes, {}, {});
  std::reverse(axes.begin(), axes.end());
  const Lanes second = lanes(streets, axes, {}, {});
  ASSERT_EQ(first.lanes.size(), second.lanes.size());
  ASSERT_EQ(first.markings.size(), second.markings.size());
  for (std::size_t i = 0; i < first.lanes.size(); ++i)
    EXPECT_EQ(first.lanes[i].width, second.lanes[i].width);
}

TEST(Lane, AlongABentAxisHasNoPointTwice) {
  const Line bent{{0, 0, 0}, {100, 0, 0}, {140, 30, 0}, {180, 0, 0}, {180, 90, 0}};
  const std::vector<Lane> made = axis_lanes(bent, 4, 4, general(1, 0), {});
  ASSERT_EQ(made.size(), 1u);
  EXPECT_EQ(made[0].line.size(), bent.size());
  for (std::size_t i = 1; i < made[0].line.size(); ++i)
    EXPECT_GT(distance(made[0].line[i - 1], made[0].line[i]), 1);
}

TEST(Lanes, MarkingsAreValidSurfaces) {
  Geos geos;
  const Town& made = town(2);
  ASSERT_FALSE(made.lanes.markings.empty());
  for (const Marking& marking : made.lanes.markings) {
    EXPECT_GT(area(marking.surface), 0);
    EXPECT_TRUE(geos.valid(geos.surface(marking.surface).get()))
        << "kind " << static_cast<int>(marking.kind) << " of edge " << marking.edge;
  }
  for (const LaneSeparator& separator : made.lanes.separators)
    EXPECT_TRUE(geos.valid(geos.surface(paint_of(separator)).get()));
}

TEST(Lanes, ArrowsOfAnyTurnsAreValidSurfaces) {
  Geos geos;
  ArrowPaint paint;
  Lane lane;
  lane.width = 3;
  for (unsigned turns = 0; turns < 2 * turn::merge_right; ++turns)
    for (int k = 0; k < rounds(7); ++k) {
      const double angle = 0.3 + 0.9 * k;
      const Line line{{100, 200, 0}, {100 + 4 * std::cos(angle), 200 + 4 * std::sin(angle), 0}};
      EXPECT_TRUE(geos.valid(geos.surface(paint.on(lane, turns, line)).get())) << turns;
    }
}

// East, west and south of the origin; the street south is the less important one.
Streets tee(int lower_importance) {
  return streets({{1, {{-100, 0, 0}, {0, 0, 0}}, 0, 8, 8, 5, 3},
                  {2, {{0, 0, 0}, {100, 0, 0}}, 0, 8, 8, 5, 3},
                  {3, {{0, 0, 0}, {0, -100, 0}}, 0, 6, 6, 5, lower_importance}},
                 {});
}

int count_of(const Lanes& lanes, MarkingKind kind) {
  return std::count_if(lanes.markings.begin(), lanes.markings.end(),
                       [&](const Marking& marking) { return marking.kind == kind; });
}

TEST(Lanes, OfALessImportantStreetWait) {
  const std::vector<LanesOfAxis> two_ways{
      {1, general(1, 1)}, {2, general(1, 1)}, {3, general(1, 1)}};
  EXPECT_EQ(count_of(lanes(tee(3), two_ways, {}, {}), MarkingKind::yield), 1)
      << "of equals on important streets the stem";
  const Lanes yields = lanes(tee(4), two_ways, {}, {});
  ASSERT_EQ(count_of(yields, MarkingKind::yield), 1);
  EXPECT_EQ(count_of(yields, MarkingKind::stop), 0);
  for (const Marking& marking : yields.markings) {
    if (marking.kind != MarkingKind::yield) continue;
    // Towards the node one drives north, on the east half of the 6 m wide street.
    const double low = std::min(marking.line.front().x, marking.line.back().x);
    EXPECT_NEAR(low, 0, 1e-9);
    EXPECT_NEAR(length(marking.line), 3, 1e-9);
  }
  EXPECT_EQ(count_of(lanes(tee(5), two_ways, {}, {}), MarkingKind::stop), 1);
}

TEST(Lanes, PartDirectionsByACentreLine) {
  const Lanes made =
      lanes(tee(3), {{1, general(2, 1)}, {2, general(2, 0)}, {3, general(1, 1)}}, {}, {});
  std::vector<SeparatorKind> kinds;
  std::vector<bool> dashed;
  for (const LaneSeparator& separator : made.separators) {
    kinds.push_back(separator.kind);
    dashed.push_back(separator.dashed);
  }
  EXPECT_EQ(kinds,
            (std::vector<SeparatorKind>{SeparatorKind::centre, SeparatorKind::same_direction,
                                        SeparatorKind::same_direction, SeparatorKind::centre}));
  EXPECT_EQ(dashed, (std::vector<bool>{false, true, true, true}));
}

TEST(Lanes, OfBothDirectionsAreEnteredAcrossDashedLines) {
  AxisLanes wanted = general(2, 1);
  wanted.both_ways.resize(2);
  wanted.backward[0].kind = LaneKind::bus;
  AxisLanes cycled = general(1, 1);
  cycled.both_ways.resize(1);
  cycled.forward[0].kind = cycled.backward[0].kind = LaneKind::cycle;
  AxisLanes alone;
  alone.both_ways.resize(1);
  const Lanes made = lanes(tee(3), {{1, wanted}, {2, cycled}, {3, alone}}, {}, {});
  std::vector<SeparatorKind> kinds;
  for (const LaneSeparator& separator : made.separators) {
    kinds.push_back(separator.kind);
    EXPECT_TRUE(separator.dashed);
  }
  EXPECT_EQ(kinds, (std::vector<SeparatorKind>{SeparatorKind::centre, SeparatorKind::same_direction,
                                               SeparatorKind::centre, SeparatorKind::same_direction,
                                               SeparatorKind::same_direction,
                                               SeparatorKind::same_direction}));
}

// A narrow street southwards, from one more important street to another.
TEST(Lanes, OfBothDirectionsWaitOnTheHalfOnWhichOneComes) {
  const Streets town = streets({{1, {{-100, 0, 0}, {0, 0, 0}}, 0, 8, 8, 5, 3},
                                {2, {{0, 0, 0}, {100, 0, 0}}, 0, 8, 8, 5, 3},
                                {3, {{0, 0, 0}, {0, -100, 0}}, 0, 4, 4, 5, 4},
                                {4, {{-100, -100, 0}, {0, -100, 0}}, 0, 8, 8, 5, 3},
                                {5, {{0, -100, 0}, {100, -100, 0}}, 0, 8, 8, 5, 3}},
                               {});
  AxisLanes both;
  both.both_ways.resize(1);
  for (const DrivingSide side : {DrivingSide::left, DrivingSide::right}) {
    LaneSettings settings;
    settings.driving_side = side;
    int waiting = 0;
    for (const Marking& marking : lanes(town, {{3, both}}, {}, settings).markings) {
      if (town.network.edges[marking.edge].axis_id != 3) continue;
      EXPECT_EQ(marking.kind, MarkingKind::yield);
      ++waiting;
      // Northwards, against the axis, on the right one comes on the east.
      const bool east = marking.along_axis == (side == DrivingSide::left);
      EXPECT_NEAR(length(marking.line), 2, 1e-9);
      EXPECT_NEAR((marking.line[0].x + marking.line[1].x) / 2, east ? 1 : -1, 1e-9);
      EXPECT_GT(area(marking.surface), 0);
      const Point node = town.network.nodes[marking.node].point;
      EXPECT_EQ(marking.along_axis, node.y < -50);
      EXPECT_LT(distance(marking.line[0], node), 20);
    }
    EXPECT_EQ(waiting, 2);
  }
}

TEST(Lanes, OfAnEndlessStreetAreStillLanes) {
  const Lanes made = lanes(streets({{1, {{-1e12, 0, 0}, {1e12, 5, 0}}, 0, 8, 8, 5, 3}}, {}),
                           {{1, general(1, 1)}}, {}, {});
  ASSERT_EQ(made.lanes.size(), 2u);
  ASSERT_EQ(made.separators.size(), 1u);
  EXPECT_EQ(paint_of(made.separators[0]).size(), 1u);
}

TEST(Lanes, ObeyOverridesOfTheirPlace) {
  using Direction = LaneOverride::Direction;
  const std::vector<LanesOfAxis> axes{{1, general(1, 1)}, {2, general(1, 1)}, {3, general(1, 1)}};
  const Lanes made = lanes(tee(3), axes,
                           {{1, 10, 2, Direction::against, 0},
                            {2, 10, 1, Direction::as_is, 2.5},
                            {2, 10, 7, Direction::along, 9},
                            {3, 1e6, 1, Direction::along, 9}},
                           {});
  ASSERT_EQ(made.lanes.size(), 6u);
  EXPECT_EQ(made.lanes[0].method, Method::hypothesis);
  EXPECT_EQ(made.lanes[1].method, Method::by_hand);
  EXPECT_FALSE(made.lanes[1].along_axis);
  EXPECT_NEAR(made.lanes[1].width, 4, 1e-12);
  EXPECT_NEAR(made.lanes[2].width, 2.5, 1e-12);
  EXPECT_NEAR(made.lanes[3].width, 5.5, 1e-12);
  EXPECT_NEAR(made.lanes[4].width, 3, 1e-12);
  EXPECT_FALSE(made.lanes[4].along_axis);
}

TEST(Lanes, DrawnByHandKeepThePlaceThatTheirNeighboursLeave) {
  LaneOverride drawn{1, 10, 1};
  drawn.line = {{20, 3, 0}, {80, 3, 0}};
  const Lanes made = lanes(streets({{1, {{0, 0, 0}, {100, 0, 0}}, 0, 8, 8, 5, 3}}, {}),
                           {{1, general(1, 1)}}, {drawn}, {});
  ASSERT_EQ(made.lanes.size(), 2u);
  const Lane& lane = made.lanes[0].method == Method::by_hand ? made.lanes[0] : made.lanes[1];
  EXPECT_NEAR(lane.axis_offset, 3, 1e-9);
  EXPECT_NEAR(lane.borders.at(50).left, 4, 1e-12);
  EXPECT_NEAR(lane.borders.at(50).right, 0, 1e-12);
  EXPECT_TRUE(made.lanes[lane.position == 1 ? 1 : 0].borders.empty());
}

TEST(Lanes, AreOpenedToBothDirectionsAndClosedByHand) {
  using Direction = LaneOverride::Direction;
  AxisLanes both;
  both.both_ways.resize(1);
  const Lanes made =
      lanes(tee(3), {{1, general(1, 1)}, {2, both}, {3, both}},
            {{1, 10, 1, Direction::both}, {2, 10, 1, Direction::against}, {3, 10, 1}}, {});
  ASSERT_EQ(made.lanes.size(), 4u);
  EXPECT_TRUE(made.lanes[0].both_ways && made.lanes[0].along_axis);
  EXPECT_FALSE(made.lanes[2].both_ways || made.lanes[2].along_axis);
  EXPECT_TRUE(made.lanes[3].both_ways);
}

// The places to which arrows on a street in two pieces lead, by the axis of the first one.
std::vector<double> arrow_tips(double bend, unsigned turns) {
  const Streets town = streets(
      {{1, {{0, 0, 0}, {100, 0, 0}}, 0, 7, 7, 6, 3},
       {2, {{100, 0, 0}, {100 + 100 * std::cos(bend), 100 * std::sin(bend), 0}}, 0, 7, 7, 6, 3}},
      {});
  AxisLanes first = general(1, 1);
  first.forward[0].turns = turns;
  std::vector<double> tips;
  for (const Marking& marking : lanes(town, {{1, first}, {2, general(1, 1)}}, {}, {}).markings)
    if (marking.kind == MarkingKind::arrow) tips.push_back(marking.line.back().x);
  std::sort(tips.begin(), tips.end());
  return tips;
}

TEST(Lane, HasAnArrowWhereItIsMarked) {
  EXPECT_EQ(arrow_tips(0, 0).size(), 0u);
  EXPECT_EQ(arrow_tips(0.3, 0).size(), 0u);
  const std::vector<double> marked = arrow_tips(0, turn::left);
  ASSERT_EQ(marked.size(), 2u) << "its mark is of where the street leads";
  EXPECT_NEAR(marked[0], 95, 1e-6);
  EXPECT_NEAR(marked[1], 195, 1e-6);
}

// Streets of two lanes each way, and signals on all of them; one street has no paint.
TEST(Lanes, OfABareStreetAreNotPainted) {
  const Streets town = tee(3);
  const std::vector<LanesOfAxis> wanted{{1, general(2, 2)}, {2, general(2, 2)}, {3, general(2, 2)}};
  PaintRules paint;
  paint.bare = {3};
  const Lanes made = lanes(town, wanted, {}, {}, {{3, 0, ControlKind::signals}}, {}, paint);
  int stripes = 0, lines = 0;
  for (const LaneSeparator& separator : made.separators) {
    const bool bare = town.network.edges[separator.edge].axis_id == 3;
    stripes += bare ? 1 : 0;
    EXPECT_EQ(paint_of(separator).empty(), bare);
  }
  for (const Marking& marking : made.markings) {
    const bool bare = town.network.edges[marking.edge].axis_id == 3;
    EXPECT_EQ(marking.surface.empty(), bare);
    if (!bare) continue;
    EXPECT_EQ(marking.kind, MarkingKind::stop);
    EXPECT_EQ(marking.line.size(), 2u);
    ++lines;
  }
  EXPECT_EQ(stripes, 3);
  EXPECT_EQ(lines, 2);
}

}  // namespace lane_test
}  // namespace streetgen
