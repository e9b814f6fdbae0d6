#include "ramp/find_ramps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/surface_distance.hpp"
#include "streetgen/street_model.hpp"

namespace streetgen {
namespace find_ramps_test {

constexpr double lane = 3.5;
constexpr std::int64_t before = 1, after = 2, link = 3;

Point turned(const Point& p, bool mirrored) { return {p.x, mirrored ? -p.y : p.y, 0}; }

// A highway along x through (0, 0), and a link that comes to it, or leaves it, from the right at an
// angle in degrees; mirrored: from the left.
class Highway {
 public:
  int lanes_before = 3, lanes_ramp = 1, lanes_after = 3;
  bool on = true, mirrored = false;
  double angle = 15, speed = 100, link_speed = 50, link_length = 250, length_after = 600;
  RampRules rules{};

  StreetModelInput input() const {
    StreetModelInput in;
    const double turn = angle * M_PI / 180, x = (on ? -1 : 1) * link_length * std::cos(turn);
    Line ramp{turned({x, -link_length * std::sin(turn), 0}, mirrored), {0, 0, 0}};
    if (!on) std::reverse(ramp.begin(), ramp.end());
    add(in, before, {{-600, 0, 0}, {0, 0, 0}}, lanes_before, RampPart::highway, speed);
    add(in, after, {{0, 0, 0}, {length_after, 0, 0}}, lanes_after, RampPart::highway, speed);
    add(in, link, ramp, lanes_ramp, RampPart::link, link_speed);
    in.settings.island_area = 0;
    return in;
  }

  void add(StreetModelInput& in, std::int64_t id, const Line& line, int lanes, RampPart part,
           double kmh) const {
    StreetAxis axis{id, line, 0, lanes * lane, lanes * lane, 5, part == RampPart::link ? 2 : 1};
    axis.speed = kmh;
    in.axes.push_back(axis);
    in.lanes.push_back({id, {std::vector<LaneWish>(lanes), {}}});
    if (in.ramps.axes.empty()) {
      in.ramps = rules;
      in.ramps.axes.clear();
    }
    in.ramps.axes.push_back({id, part});
  }
};

std::vector<Lane> merging(const StreetModel& model) {
  std::vector<Lane> found;
  for (const Lane& lane : model.lanes.lanes)
    if (lane.kind == LaneKind::merging) found.push_back(lane);
  return found;
}

std::int64_t axis_of(const StreetModel& model, int edge) {
  return model.streets.network.edges[edge].axis_id;
}

TEST(FindRamps, GivesTheLanesThatDoNotAddUp) {
  for (const bool on : {true, false})
    for (int b = 1; b <= 4; ++b)
      for (int r = 1; r <= 2; ++r)
        for (int a = 1; a <= 4; ++a) {
          Highway highway;
          highway.on = on;
          highway.lanes_before = b;
          highway.lanes_ramp = r;
          highway.lanes_after = a;
          const StreetModel model = street_model(highway.input());
          ASSERT_EQ(model.streets.ramps.size(), 1u);
          const int due = std::clamp(on ? b + r - a : a + r - b, 0, r);
          EXPECT_EQ(model.streets.ramps[0].missing, due) << b << " " << r << " " << a;
          const std::vector<Lane> lanes = merging(model);
          ASSERT_EQ(static_cast<int>(lanes.size()), due);
          for (const Lane& found : lanes)
            EXPECT_EQ(axis_of(model, found.edge), on ? after : before);
        }
}

TEST(FindRamps, KeepsTheWidthOverTheLengthAndThenTapers) {
  for (const bool mirrored : {false, true}) {
    Highway highway;
    highway.mirrored = mirrored;
    const StreetModel model = street_model(highway.input());
    const Ramp& ramp = model.streets.ramps.at(0);
    EXPECT_EQ(ramp.side, mirrored ? +1 : -1);
    const std::vector<Lane> lanes = merging(model);
    ASSERT_EQ(lanes.size(), 1u);
    const Roadway& roadway = model.streets.roadways[lanes[0].edge];
    ASSERT_EQ(roadway.merging.size(), 1u);
    // 30 m along for each metre aside at 100 km/h.
    const double from = model.streets.limits[2 * lanes[0].edge].abscissa;
    EXPECT_NEAR(roadway.merging[0].full_to, from + 60, 1e-9);
    EXPECT_NEAR(roadway.merging[0].to, from + 60 + 30 * lane, 1e-9);
    EXPECT_NEAR(*lanes[0].end, roadway.merging[0].to, 1e-9);
    EXPECT_FALSE(lanes[0].start.has_value());
    // Its middle is half a lane beyond the three others, then runs out on their kerb.
    const double side = mirrored ? +1 : -1;
    EXPECT_NEAR(position_at(lanes[0].line, 30).point.y, side * 2 * lane, 1e-6);
    EXPECT_NEAR(lanes[0].line.back().y, side * 1.5 * lane, 1e-6);
    // Lanes tile the section, which is as wide as they are.
    double ground = 0;
    for (const Lane& one : model.lanes.lanes)
      if (one.edge == lanes[0].edge) ground += area(one.surface);
    for (const Section& section : model.streets.sections) {
      if (section.edge == lanes[0].edge) {
        EXPECT_NEAR(ground, area(section.surface), 1e-3);
      }
    }
  }
}

TEST(FindRamps, LeavesTheOtherLanesTheirPlaces) {
  Highway with, without;
  without.rules.merging_length = 0;
  const StreetModel a = street_model(with.input()), b = street_model(without.input());
  EXPECT_EQ(merging(a).size(), 1u);
  EXPECT_TRUE(merging(b).empty());
  for (const Lane& lane : b.lanes.lanes) {
    const auto same = std::find_if(a.lanes.lanes.begin(), a.lanes.lanes.end(), [&](const Lane& l) {
      return l.edge == lane.edge && l.ordinality == lane.ordinality;
    });
    ASSERT_NE(same, a.lanes.lanes.end());
    EXPECT_NEAR(same->axis_offset, lane.axis_offset, 1e-9);
    EXPECT_NEAR(same->width, lane.width, 1e-9);
  }
}

// Degrees between two segments.
double turn_between(const Point& a, const Point& b, const Point& c, const Point& d) {
  return std::abs(std::atan2(cross(b - a, d - c), dot(b - a, d - c))) * 180 / M_PI;
}

TEST(FindRamps, BendsTangentToTheLaneForItsSpeed) {
  for (const bool on : {true, false})
    for (const double angle : {5., 10., 20., 30., 45.}) {
      Highway highway;
      highway.on = on;
      highway.angle = angle;
      const StreetModel model = street_model(highway.input());
      const auto& lanes = model.lanes.lanes;
      int found = 0;
      for (const Interconnection& path : model.interconnections) {
        const Lane &in = lanes[path.lane_in], &out = lanes[path.lane_out];
        if (!path.plausible || axis_of(model, on ? in.edge : out.edge) != link) continue;
        ++found;
        EXPECT_EQ((on ? out : in).kind, LaneKind::merging) << angle;
        const Line &l = in.line, &p = path.line, &m = out.line;
        EXPECT_LE(turn_between(l[l.size() - 2], l.back(), p[0], p[1]), 0.1) << angle;
        EXPECT_LE(turn_between(p[p.size() - 2], p.back(), m[0], m[1]), 0.1) << angle;
        double least = 1e9;
        for (std::size_t i = 1; i + 1 < p.size(); ++i) {
          const double turn = turn_between(p[i - 1], p[i], p[i], p[i + 1]) * M_PI / 180;
          const double step = (distance(p[i - 1], p[i]) + distance(p[i], p[i + 1])) / 2;
          if (turn > 1e-9) least = std::min(least, step / turn);
        }
        // 50 km/h by a friction of 0.35.
        const double wanted = std::pow(50 / 3.6, 2) / (0.35 * 9.81);
        EXPECT_GE(least, 0.98 * wanted) << angle;
      }
      EXPECT_EQ(found, 1) << angle;
    }
}

TEST(FindRamps, LetsTheHighwayGoOnLaneByLane) {
  for (const bool on : {true, false}) {
    Highway highway;
    highway.on = on;
    const StreetModel model = street_model(highway.input());
    const auto& lanes = model.lanes.lanes;
    int through = 0;
    for (const Interconnection& path : model.interconnections) {
      const Lane &in = lanes[path.lane_in], &out = lanes[path.lane_out];
      if (!path.plausible || axis_of(model, in.edge) == link || axis_of(model, out.edge) == link)
        continue;
      ++through;
      EXPECT_EQ(in.position, out.position);
      EXPECT_NEAR(path.line.front().y, path.line.back().y, 1e-6);
    }
    EXPECT_EQ(through, 3);
  }
}

TEST(FindRamps, JoinsTwoThatMeetAndPartsTwoThatDoNot) {
  for (const double apart : {150., 800.}) {
    Highway highway;
    highway.length_after = apart;
    StreetModelInput input = highway.input();
    highway.add(input, 4, {{apart, 0, 0}, {apart + 600, 0, 0}}, 3, RampPart::highway, 100);
    highway.add(input, 5, {{apart, 0, 0}, {apart + 240, -60, 0}}, 1, RampPart::link, 50);
    const StreetModel model = street_model(input);
    ASSERT_EQ(model.streets.ramps.size(), 2u);
    const bool one = apart < 200;
    EXPECT_EQ(merging(model).size(), one ? 1u : 2u);
    for (const Ramp& ramp : model.streets.ramps) {
      EXPECT_EQ(ramp.auxiliary, one);
      EXPECT_FALSE(ramp.cut);
    }
    if (one) {
      EXPECT_TRUE(merging(model)[0].reaches(true));
      EXPECT_TRUE(merging(model)[0].reaches(false));
    }
  }
}

TEST(FindRamps, CutsALaneAtTheNextJunction) {
  Highway highway;
  highway.length_after = 90;
  StreetModelInput input = highway.input();
  highway.add(input, 4, {{90, 0, 0}, {700, 0, 0}}, 3, RampPart::highway, 100);
  highway.add(input, 5, {{90, -90, 0}, {90, 0, 0}}, 1, RampPart::none, 50);
  const StreetModel model = street_model(input);
  ASSERT_EQ(model.streets.ramps.size(), 1u);
  EXPECT_TRUE(model.streets.ramps[0].cut);
  const std::vector<Lane> lanes = merging(model);
  ASSERT_EQ(lanes.size(), 1u);
  EXPECT_LE(*lanes[0].end, model.streets.limits[2 * lanes[0].edge + 1].abscissa + 1e-9);
}

// Lanes tile the section, which is as wide as they are.
void expect_tiled(const StreetModel& model, int edge, const std::string& what) {
  for (const Section& section : model.streets.sections) {
    if (section.edge != edge) continue;
    EXPECT_EQ(section.method, Method::hypothesis) << what;
    double ground = 0;
    for (const Lane& lane : model.lanes.lanes)
      if (lane.edge == edge) ground += area(lane.surface);
    EXPECT_NEAR(ground, area(section.surface), 1e-3) << what;
  }
}

// The highway begins so near before its ramp.
TEST(FindRamps, KeepsAShortLaneWithinItsSection) {
  for (double size = 20.5; size < 60; size += 3.7) {
    Highway highway;
    highway.on = false;
    StreetModelInput input = highway.input();
    input.axes[0].line = {{-size, 0, 0}, {0, 0, 0}};
    const StreetModel model = street_model(input);
    EXPECT_TRUE(model.streets.ramps.at(0).cut) << size;
    const std::vector<Lane> lanes = merging(model);
    ASSERT_EQ(lanes.size(), 1u) << size;
    expect_tiled(model, lanes[0].edge, std::to_string(size));
  }
}

// The highway before or behind its ramp in pieces from one place to the next, some drawn against
// the traffic; bent by so many degrees at each.
class Pieces {
 public:
  Highway highway;
  std::vector<double> places;
  double bend = 0;
  bool one_is_turned = false;

  StreetModel model() const {
    StreetModelInput input = highway.input();
    const std::size_t whole = highway.on ? 1 : 0;
    Point at = {0, 0, 0};
    double last = 0, heading = highway.on ? 0 : M_PI;
    std::vector<double> ends = places;
    ends.push_back(600);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const Point next = at + Point{std::cos(heading), std::sin(heading), 0} * (ends[i] - last);
      Line line{at, next};
      bool turned = !highway.on;
      if (one_is_turned && i == 1) turned = !turned;
      if (turned) std::reverse(line.begin(), line.end());
      if (i == 0)
        input.axes[whole].line = line;
      else
        highway.add(input, 10 + static_cast<int>(i), line, 3, RampPart::highway, highway.speed);
      if (one_is_turned && i == 1)
        std::swap(input.lanes.back().lanes.forward, input.lanes.back().lanes.backward);
      at = next, last = ends[i], heading += bend * M_PI / 180;
    }
    return street_model(input);
  }
};

double ground_of(const std::vector<Lane>& lanes) {
  double ground = 0;
  for (const Lane& lane : lanes) ground += area(lane.surface);
  return ground;
}

TEST(FindRamps, RunsOnOverNodesThatOnlyJoinTwoEdges) {
  for (const bool on : {true, false})
    for (const bool turned : {false, true}) {
      Pieces whole;
      whole.highway.on = on;
      const StreetModel as_one = whole.model();
      // At full width, in the taper, in both, and an edge as short as they may be.
      for (const std::vector<double>& places :
           std::vector<std::vector<double>>{{30}, {120}, {30, 70, 130}, {50, 51}, {17, 41, 320}}) {
        Pieces pieces = whole;
        pieces.places = places;
        pieces.one_is_turned = turned;
        const StreetModel model = pieces.model();
        const Ramp& ramp = model.streets.ramps.at(0);
        EXPECT_FALSE(ramp.cut);
        EXPECT_NEAR(ramp.full_length, 60, 1e-9);
        // The lanes and the roadway are those of a highway in one piece.
        const std::vector<Lane> lanes = merging(model);
        EXPECT_NEAR(ground_of(lanes), ground_of(merging(as_one)), 1e-6);
        double roadway = 0, roadway_as_one = 0;
        for (const Section& section : model.streets.sections) roadway += area(section.surface);
        for (const Section& section : as_one.streets.sections)
          roadway_as_one += area(section.surface);
        EXPECT_NEAR(roadway, roadway_as_one, 1e-6);
        for (const Lane& lane : lanes) expect_tiled(model, lane.edge, std::to_string(places[0]));
        // One ends by its taper, the others go on to it, straight over each node.
        const auto ends = [&](const Lane& lane) { return lane.start || lane.end; };
        EXPECT_EQ(std::count_if(lanes.begin(), lanes.end(), ends), 1);
        for (const Lane& lane : lanes)
          EXPECT_EQ(lane.turns, on ? turn::merge_left : turn::slight_right);
        int over = 0;
        for (const Interconnection& path : model.interconnections) {
          const Lane &in = model.lanes.lanes[path.lane_in], &out = model.lanes.lanes[path.lane_out];
          if (in.kind != LaneKind::merging || out.kind != LaneKind::merging) continue;
          EXPECT_TRUE(path.plausible);
          ++over;
        }
        EXPECT_EQ(over, static_cast<int>(lanes.size()) - 1);
      }
    }
}

TEST(FindRamps, RunsOnRoundABend) {
  for (const bool on : {true, false})
    for (const double bend : {-12., -3., -0.4, 0.4, 3., 12.}) {
      const std::string what = std::to_string(bend);
      Pieces pieces;
      pieces.highway.on = on;
      pieces.bend = bend;
      pieces.places = {70, 120};
      const StreetModel model = pieces.model();
      const Ramp& ramp = model.streets.ramps.at(0);
      EXPECT_FALSE(ramp.cut) << what;
      EXPECT_NEAR(ramp.full_length, 60, 1e-9) << what;
      const std::vector<Lane> lanes = merging(model);
      ASSERT_EQ(lanes.size(), 3u) << what;
      // Its lanes are as long together as length and taper ask for: tapers pause at a bend.
      double metres = 0;
      for (const Lane& one : lanes) {
        const auto& limits = model.streets.limits;
        metres += one.end.value_or(limits[2 * one.edge + 1].abscissa) -
                  one.start.value_or(limits[2 * one.edge].abscissa);
      }
      EXPECT_NEAR(metres, 60 + 30 * lane, 1e-6) << what;
      // At a bend both edges are equally wide there: their border lines are.
      for (const SectionLimit& a : model.streets.limits)
        for (const SectionLimit& b : model.streets.limits) {
          const auto node = [&](const SectionLimit& limit) {
            const Edge& edge = model.streets.network.edges[limit.edge];
            return limit.at_start ? edge.from_node : edge.to_node;
          };
          if (a.edge == b.edge || node(a) != node(b) || node(a) == ramp.node) continue;
          EXPECT_NEAR(length(a.border_line), length(b.border_line), 1e-9) << what;
        }
    }
}

TEST(FindRamps, EndsWhereTheHighwayChanges) {
  for (const int lanes_there : {2, 4}) {
    Highway highway;
    highway.length_after = 90;
    StreetModelInput input = highway.input();
    highway.add(input, 4, {{90, 0, 0}, {700, 0, 0}}, lanes_there, RampPart::highway, 100);
    const StreetModel model = street_model(input);
    EXPECT_TRUE(model.streets.ramps.at(0).cut) << lanes_there;
    ASSERT_EQ(merging(model).size(), 1u) << lanes_there;
  }
}

TEST(FindRamps, JoinsTwoThatMeetOverANode) {
  for (const bool in_pieces : {false, true}) {
    Highway highway;
    highway.length_after = in_pieces ? 60 : 150;
    StreetModelInput input = highway.input();
    if (in_pieces) highway.add(input, 6, {{60, 0, 0}, {150, 0, 0}}, 3, RampPart::highway, 100);
    highway.add(input, 4, {{150, 0, 0}, {750, 0, 0}}, 3, RampPart::highway, 100);
    highway.add(input, 5, {{150, 0, 0}, {390, -60, 0}}, 1, RampPart::link, 50);
    const StreetModel model = street_model(input);
    ASSERT_EQ(model.streets.ramps.size(), 2u);
    for (const Ramp& ramp : model.streets.ramps) {
      EXPECT_TRUE(ramp.auxiliary);
      EXPECT_FALSE(ramp.cut);
    }
    const std::vector<Lane> lanes = merging(model);
    ASSERT_EQ(lanes.size(), in_pieces ? 2u : 1u);
    for (const Lane& lane : lanes) EXPECT_TRUE(lane.reaches(true) && lane.reaches(false));
    for (const Lane& lane : lanes) EXPECT_EQ(lane.turns, turn::slight_right);
  }
}

TEST(FindRamps, CountsALaneForBothWaysTwice) {
  Highway highway;
  highway.on = false;
  StreetModelInput input = highway.input();
  input.lanes[0].lanes.forward.back().turns = turn::through | turn::slight_right;
  EXPECT_EQ(street_model(input).streets.ramps.at(0).missing, 0);
  input.lanes[0].lanes.forward.back().turns = turn::through | turn::left;
  EXPECT_EQ(street_model(input).streets.ramps.at(0).missing, 1);
}

// Lanes are numbered from the left kerb of a one-way street on: the link's two are 1 and 2.
TEST(FindRamps, CountsLanesAsTheyAreDecided) {
  Highway highway;
  highway.lanes_ramp = 2;
  StreetModelInput input = highway.input();
  ASSERT_EQ(street_model(input).streets.ramps.at(0).missing, 2);
  input.lane_overrides = {{link, 10, 1, LaneOverride::Direction::against}};
  EXPECT_TRUE(street_model(input).streets.ramps.empty()) << "a link for both directions";
  input.lane_overrides = {{link, 10, 1, LaneOverride::Direction::both}};
  EXPECT_TRUE(street_model(input).streets.ramps.empty()) << "a lane for both directions";
  input.lane_overrides = {};
  input.circulations = {{link, 10, false, true}};
  const StreetModel turned = street_model(input);
  EXPECT_TRUE(turned.streets.ramps.empty() || !turned.streets.ramps[0].on) << "traffic leaves";
  input.circulations = {};
  // Three lanes come, one of them turned against the others: a lane less goes on.
  input.lanes[1].lanes.forward.resize(4);
  EXPECT_EQ(street_model(input).streets.ramps.at(0).missing, 1);
  input.lane_overrides = {{after, 10, 1, LaneOverride::Direction::against}};
  EXPECT_EQ(street_model(input).streets.ramps.at(0).missing, 2);
}

TEST(FindRamps, PaintsNoLineWhereTrafficHasALaneOfItsOwn) {
  const auto lines = [](const StreetModel& model) {
    return std::count_if(model.lanes.markings.begin(), model.lanes.markings.end(),
                         [](const Marking& m) { return m.kind != MarkingKind::arrow; });
  };
  Highway highway;
  EXPECT_EQ(lines(street_model(highway.input())), 0);
  highway.rules.overrides = {{link, 240, {}, 0.}};
  EXPECT_EQ(lines(street_model(highway.input())), 1) << "without a merging lane it waits";
  highway.rules.overrides = {};
  StreetModelInput input = highway.input();
  input.controls = {{link, 240, ControlKind::yield}};
  EXPECT_EQ(lines(street_model(input)), 1) << "a sign says so";
}

TEST(FindRamps, DecidesByHand) {
  Highway highway;
  highway.rules.overrides = {{link, 240, 40., 100.}};
  const Ramp put = street_model(highway.input()).streets.ramps.at(0);
  EXPECT_TRUE(put.by_hand);
  EXPECT_EQ(put.tangent, 40);
  EXPECT_EQ(put.length, 100);
  highway.rules.overrides = {{link, 240, {}, 0.}};
  EXPECT_TRUE(merging(street_model(highway.input())).empty());
  highway.rules.overrides = {{link, 10, 40., 100.}};
  EXPECT_FALSE(street_model(highway.input()).streets.ramps.at(0).by_hand)
      << "the other end is meant";
}

TEST(FindRamps, TakesNoOtherNode) {
  const auto ramps = [](StreetModelInput input) {
    return street_model(input).streets.ramps.size();
  };
  Highway highway;
  EXPECT_EQ(ramps(highway.input()), 1u);
  StreetModelInput input = highway.input();
  input.ramps.axes[2].part = RampPart::none;
  EXPECT_EQ(ramps(input), 0u) << "no link";
  input = highway.input();
  input.lanes[2].lanes.backward = {{}};
  EXPECT_EQ(ramps(input), 0u) << "a link for both directions";
  highway.angle = 70;
  EXPECT_EQ(ramps(highway.input()), 0u) << "too steep";
  highway.angle = 15;
  input = highway.input();
  for (LanesOfAxis& axis : input.lanes)
    if (axis.axis_id != link) axis.lanes.backward = {{}};
  EXPECT_EQ(ramps(input), 1u) << "on its outer side";
  highway.mirrored = true;
  input = highway.input();
  for (LanesOfAxis& axis : input.lanes)
    if (axis.axis_id != link) axis.lanes.backward = {{}};
  EXPECT_EQ(ramps(input), 0u) << "across the other direction";
}

TEST(FindRamps, TellsALinkShorterThanItsTangent) {
  Highway highway;
  highway.link_length = 25;
  const StreetModel model = street_model(highway.input());
  ASSERT_EQ(model.streets.ramps.size(), 1u);
  EXPECT_TRUE(model.streets.ramps[0].short_link);
  for (const Lane& lane : model.lanes.lanes)
    for (const Point& p : lane.line) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
}

// A link that a service road comes upon shortly behind its ramp has no room for its bend: its kerb
// leads straight on from the corner of the flat end of the highway's lanes.
TEST(FindRamps, LeadsTheOuterKerbPastAFlatEndWithoutAStep) {
  const double inwards = 1e-3;
  for (const bool on : {true, false})
    for (const bool mirrored : {true, false})
      for (const double length : {12, 15, 20, 25})
        for (const double angle : {10, 15, 20}) {
          Highway highway;
          highway.on = on;
          highway.mirrored = mirrored;
          highway.link_length = length;
          highway.angle = angle;
          StreetModelInput input = highway.input();
          const Line& ramp = input.axes[2].line;
          const Point end = on ? ramp.front() : ramp.back();
          const Point far = end * (250 / length);
          highway.add(input, 4, on ? Line{far, end} : Line{end, far}, 1, RampPart::link, 50);
          highway.add(input, 5, {end, turned({end.x, -100, 0}, mirrored)}, 1, RampPart::none, 30);
          const Streets streets = street_model(input).streets;
          ASSERT_EQ(streets.ramps.size(), 1u);
          const Point corner = turned({0, inwards - 2.5 * lane, 0}, mirrored);
          Point limit = corner;
          for (const SectionLimit& of : streets.limits)
            if (of.edge == streets.ramps[0].link && of.at_start == streets.ramps[0].link_at_start)
              limit = std::max(of.border_line[0], of.border_line[1],
                               [](auto& p, auto& q) { return std::abs(p.y) < std::abs(q.y); });
          const Point middle = (corner + limit) * 0.5;
          const auto on_roadway = [&](const Point& place) {
            const auto holds = [&](const auto& row) { return inside(place, row.surface); };
            return std::any_of(streets.intersections.begin(), streets.intersections.end(), holds) ||
                   std::any_of(streets.sections.begin(), streets.sections.end(), holds);
          };
          Point out = left_normal(unit(limit - corner));
          if ((out.y > 0) == (middle.y < 0)) out = out * -1;
          EXPECT_TRUE(on_roadway(middle) && !on_roadway(middle + out * 0.1))
              << (on ? "on" : "off") << (mirrored ? " left " : " right ") << length << " m, "
              << angle;
        }
}

// A longer tangent would make the arc of a link that comes round a loop greater, up to where the
// link has turned by 90 degrees.
TEST(FindRamps, DoesNotReachAroundALoopForAGreaterRadius) {
  const double radius = 50;
  for (const bool on : {true, false})
    for (const bool mirrored : {true, false}) {
      Highway highway;
      highway.on = on;
      highway.mirrored = mirrored;
      highway.lanes_ramp = 2;
      highway.link_speed = 80;
      StreetModelInput input = highway.input();
      Line& loop = input.axes[2].line;
      loop.clear();
      for (double turn = 0; turn < 1.5 * M_PI; turn += 0.02)
        loop.push_back(turned(
            {(on ? -1 : 1) * radius * std::sin(turn), radius * (std::cos(turn) - 1), 0}, mirrored));
      if (on) std::reverse(loop.begin(), loop.end());
      const Streets streets = street_model(input).streets;
      ASSERT_EQ(streets.ramps.size(), 1u);
      const Edge& edge = streets.network.edges[streets.ramps[0].link];
      for (const SectionLimit& limit : streets.limits)
        if (limit.edge == streets.ramps[0].link &&
            limit.at_start == streets.ramps[0].link_at_start) {
          const double from_node =
              limit.at_start ? limit.abscissa : length(edge.line) - limit.abscissa;
          EXPECT_LT(from_node / radius * 180 / M_PI, 60) << (on ? "on" : "off");
        }
    }
}

// The outer kerb of a ramp of Hannover meets the link at a vertex, and the limit of the link is that
// vertex, on this side or the other by rounding.
TEST(FindRamps, BendsAsOnTurnedPaperWhereTheLimitIsAVertex) {
  const auto limit_of = [](double degrees) {
    const double c = std::cos(degrees * M_PI / 180), s = std::sin(degrees * M_PI / 180);
    const auto turned_by = [&](double x, double y) {
      return Point{5e5 + c * x - s * y, 5.8e6 + s * x + c * y, 0};
    };
    const Highway highway;
    StreetModelInput in;
    highway.add(in, before, {turned_by(64.7232, -9.388), turned_by(0.3925, 0.3643)}, 3,
                RampPart::highway, 100);
    highway.add(in, after, {turned_by(0.3925, 0.3643), turned_by(-165.1101, 29.8862)}, 4,
                RampPart::highway, 100);
    highway.add(in, link,
                {turned_by(69.3369, 5.4978), turned_by(35.9376, 7.2549), turned_by(0.3925, 0.3643)},
                1, RampPart::link, 80);
    const Streets streets = street_model(in).streets;
    for (const SectionLimit& limit : streets.limits)
      if (streets.network.edges[limit.edge].axis_id == link && !limit.at_start)
        return length(streets.network.edges[limit.edge].line) - limit.abscissa;
    return -1.0;
  };
  const double drawn = limit_of(0);
  EXPECT_GT(drawn, 30);
  for (double degrees = 7; degrees < 360; degrees += 7)
    EXPECT_NEAR(limit_of(degrees), drawn, 1e-6) << degrees;
}

}  // namespace find_ramps_test
}  // namespace streetgen
