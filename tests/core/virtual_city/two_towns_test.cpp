#include "streetgen/two_towns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <set>
#include <string>

#include "cities.hpp"
#include "geometry/polyline.hpp"
#include "rounds.hpp"
#include "streetgen/error.hpp"

namespace streetgen {
namespace two_towns_test {

using Place = std::pair<double, double>;
Place place(const Point& p) { return {p.x, p.y}; }

// Options that make the greatest or the least of what lies beside each other.
std::vector<TwoTownsOptions> country_kinds() {
  TwoTownsOptions broad, tight, far;
  broad.highway_lanes = 4;
  broad.highway_lane_width = 5;
  broad.median = 30;
  broad.ramp_length = 350;
  broad.ramp_speed = 70;
  broad.lanes = {6, 4, 2};
  broad.overpasses = 0;
  tight.distance = 2000 + 4 * 200;
  tight.overpasses = 4;
  tight.town_size = 500;
  tight.highway_speed = 140;
  tight.median = 1;
  far.distance = 20000;
  far.overpasses = 15;
  far.ramp_length = 1000;
  far.town_size = 3000;
  far.roundabouts = 1;
  return {TwoTownsOptions{}, broad, tight, far};
}

struct Case {
  std::int64_t seed;
  bool keeps_left;
  TwoTownsOptions options;
  std::vector<TownAxis> axes;
};

// Calls `hold` with towns of many seeds, every kind and both sides to drive on.
template <class Hold>
void for_all_towns(Hold hold) {
  std::int64_t seed = -3;
  for (int turn = 0; turn < rounds(3); ++turn)
    for (const TwoTownsOptions& options : country_kinds())
      for (const bool keeps_left : {false, true}) {
        seed = seed * 3 + 7;
        SCOPED_TRACE("seed " + std::to_string(seed) + (keeps_left ? ", left" : ", right"));
        hold(Case{seed, keeps_left, options, two_towns(100.5, -40, seed, keeps_left, options)});
      }
}

bool in_town(const TownAxis& axis, const std::string& town) {
  return axis.built_up && axis.name.compare(0, town.size(), town) == 0;
}

// Places that a car reaches from the streets of a town over axes that `takes` allows.
template <class Takes>
std::set<Place> reached(const std::vector<TownAxis>& axes, const std::string& town, Takes takes) {
  std::map<Place, std::vector<Place>> next;
  std::queue<Place> open;
  std::set<Place> seen;
  for (const TownAxis& axis : axes) {
    if (!takes(axis)) continue;
    for (std::size_t i = 1; i < axis.line.size(); ++i) {
      const Place a = place(axis.line[i - 1]), b = place(axis.line[i]);
      if (axis.direction != CityDirection::reverse) next[a].push_back(b);
      if (axis.direction != CityDirection::direct) next[b].push_back(a);
    }
    if (in_town(axis, town) && seen.insert(place(axis.line.front())).second)
      open.push(place(axis.line.front()));
  }
  for (; !open.empty(); open.pop())
    for (const Place& to : next[open.front()])
      if (seen.insert(to).second) open.push(to);
  return seen;
}

// The radius of the circle through each three points that follow each other, the least.
double least_radius(const Line& line) {
  double least = 1e300;
  for (std::size_t i = 2; i < line.size(); ++i) {
    const Point a = line[i - 1] - line[i - 2], b = line[i] - line[i - 1];
    least = std::min(least, norm(a) * norm(b) * norm(a + b) / (2 * std::abs(cross(a, b)) + 1e-9));
  }
  return least;
}

TEST(TwoTowns, EqualArgumentsGiveEqualTowns) {
  const std::vector<TownAxis> a = two_towns(0, 0, 5, false, {}), b = two_towns(0, 0, 5, false, {});
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(same(a[i].line, b[i].line));
  const std::vector<TownAxis> other = two_towns(0, 0, 6, false, {});
  EXPECT_FALSE(other.size() == a.size() && same(other.front().line, a.front().line) &&
               same(other.back().line, a.back().line));
}

TEST(TwoTowns, LeftHandTrafficIsTheMirrorImage) {
  const std::vector<TownAxis> right = two_towns(0, 0, 3, false, {});
  const std::vector<TownAxis> left = two_towns(0, 0, 3, true, {});
  ASSERT_EQ(right.size(), left.size());
  double height = 0;
  for (const TownAxis& axis : right)
    for (const Point& p : axis.line) height = std::max(height, p.y);
  for (std::size_t i = 0; i < right.size(); ++i) {
    ASSERT_EQ(right[i].line.size(), left[i].line.size());
    for (std::size_t k = 0; k < right[i].line.size(); ++k) {
      EXPECT_NEAR(right[i].line[k].x, left[i].line[k].x, 1e-9);
      EXPECT_NEAR(right[i].line[k].y, height - left[i].line[k].y, 1e-9);
    }
  }
}

TEST(TwoTowns, CornerIsTheLowerLeftOne) {
  for_all_towns([](const Case& c) {
    double x = 1e300, y = 1e300;
    for (const TownAxis& axis : c.axes)
      for (const Point& p : axis.line) {
        x = std::min(x, p.x);
        y = std::min(y, p.y);
        EXPECT_NEAR(p.x * 1000, std::round(p.x * 1000), 1e-4);
      }
    EXPECT_EQ(x, 100.5);
    EXPECT_EQ(y, -40);
  });
}

TEST(TwoTowns, EachIsReachedFromTheOtherByTheHighway) {
  for_all_towns([](const Case& c) {
    const auto not_by_country = [](const TownAxis& axis) {
      return axis.built_up || axis.kind == "motorway" || axis.kind == "motorway_link" ||
             axis.kind == "primary";
    };
    const auto by_country = [](const TownAxis& axis) {
      return axis.kind != "motorway" && axis.kind != "motorway_link";
    };
    for (const auto& [from, to] : {std::pair{"Weston", "Easton"}, std::pair{"Easton", "Weston"}}) {
      const std::set<Place> by_highway = reached(c.axes, from, not_by_country);
      const std::set<Place> beside = reached(c.axes, from, by_country);
      int streets = 0;
      for (const TownAxis& axis : c.axes)
        if (in_town(axis, to)) {
          ++streets;
          EXPECT_TRUE(by_highway.count(place(axis.line.front()))) << axis.name;
          EXPECT_TRUE(beside.count(place(axis.line.front()))) << axis.name;
        }
      EXPECT_GT(streets, 3);
    }
  });
}

TEST(TwoTowns, AxesMeetInVerticesAndCrossAtBridgesAlone) {
  for_all_towns([](const Case& c) {
    std::map<std::string, int> crossed;  // carriageways, by the middle of a bridge
    for (std::size_t i = 0; i < c.axes.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const TownAxis &a = c.axes[i], &b = c.axes[j];
        for (std::size_t k = 1; k < a.line.size(); ++k)
          for (std::size_t l = 1; l < b.line.size(); ++l) {
            const Point &p = a.line[k - 1], &q = a.line[k], &r = b.line[l - 1], &s = b.line[l];
            if (std::max(p.x, q.x) < std::min(r.x, s.x) ||
                std::max(r.x, s.x) < std::min(p.x, q.x) ||
                std::max(p.y, q.y) < std::min(r.y, s.y) || std::max(r.y, s.y) < std::min(p.y, q.y))
              continue;
            if (same(p, r) || same(p, s) || same(q, r) || same(q, s)) continue;
            if (!crossing(p, q, r, s)) continue;
            EXPECT_TRUE(a.bridge != b.bridge) << a.name << " crosses " << b.name;
            EXPECT_EQ(a.bridge ? b.kind : a.kind, "motorway") << a.name << " crosses " << b.name;
            ++crossed[a.bridge ? a.name : b.name];
          }
      }
    EXPECT_EQ(static_cast<double>(crossed.size()), 2 + c.options.overpasses);
    for (const auto& [name, times] : crossed) EXPECT_EQ(times, 2) << name;
  });
}

TEST(TwoTowns, CarriagewaysKeepTheirSideOfTheMedian) {
  for_all_towns([](const Case& c) {
    const Line &east = c.axes[0].line, &west = c.axes[1].line;
    EXPECT_EQ(c.axes[0].name, "Highway East");
    EXPECT_LT(east.front().x, east.back().x);
    EXPECT_GT(west.front().x, west.back().x);
    const double apart = c.options.highway_lanes * c.options.highway_lane_width + c.options.median;
    for (const Point& p : east) {
      double nearest = 1e300;
      for (std::size_t i = 1; i < west.size(); ++i)
        nearest =
            std::min(nearest, norm(p - west[i]) < 300 ? distance_to_segment(p, west[i - 1], west[i])
                                                      : nearest);
      if (nearest < 1e300) {
        EXPECT_NEAR(nearest, apart, 0.01);
      }
    }
    EXPECT_EQ(cross(east.back() - east.front(), west.front() - east.front()) > 0, !c.keeps_left);
    const double speed = c.options.highway_speed / 3.6;
    EXPECT_GT(std::min(least_radius(east), least_radius(west)), 0.95 * speed * speed / 0.981);
  });
}

TEST(TwoTowns, RampsLeadFromCarriagewaysToTheRoadsOfTowns) {
  for_all_towns([](const Case& c) {
    std::map<Place, const TownAxis*> carriageway, road;
    for (const TownAxis& axis : c.axes)
      for (const Point& p : axis.line) {
        if (axis.kind == "motorway") carriageway[place(p)] = &axis;
        if (axis.kind == "primary" && !axis.built_up) road[place(p)] = &axis;
      }
    std::map<std::string, int> ramps;
    for (const TownAxis& axis : c.axes) {
      if (axis.kind != "motorway_link") continue;
      ++ramps[axis.name];
      EXPECT_EQ(axis.direction, CityDirection::direct);
      EXPECT_EQ(axis.lane_count, 1);
      const bool leaves = axis.name.find("Exit") != std::string::npos;
      Line line = axis.line;
      if (!leaves) std::reverse(line.begin(), line.end());
      ASSERT_TRUE(carriageway.count(place(line.front()))) << axis.name;
      ASSERT_TRUE(road.count(place(line.back()))) << axis.name;
      // With the traffic, which it leaves on its outer side, at 1 in 7 or less.
      const bool east = axis.name.find("East", 6) != std::string::npos;
      const Point along{(east ? 1. : -1.) * (leaves ? 1 : -1), 0, 0}, off = line[1] - line[0];
      EXPECT_LT(angle(along, off), 8.2) << axis.name;
      EXPECT_EQ(cross(along, off) > 0, c.keeps_left == leaves) << axis.name;
      EXPECT_EQ(carriageway[place(line.front())]->name, east ? "Highway East" : "Highway West");
      // Square to the road of the town.
      EXPECT_EQ(line.back().y, line[line.size() - 2].y) << axis.name;
      const double speed = c.options.ramp_speed / 3.6;
      EXPECT_GT(least_radius(line), 0.95 * speed * speed / (9.81 * 0.2)) << axis.name;
      EXPECT_NEAR(std::abs(line.back().x - line.front().x), c.options.ramp_length, 1e-6);
    }
    EXPECT_EQ(ramps.size(), 8u);
    for (const auto& [name, times] : ramps) EXPECT_EQ(times, 1) << name;
  });
}

TEST(TwoTowns, OptionsOfOneListAreSetByName) {
  TwoTownsOptions options;
  for (const TwoTownsOption& option : two_towns_options()) {
    const std::vector<double> was = option.of(options);
    EXPECT_NO_THROW(set_option(two_towns_options(), options, option.name, was)) << option.name;
    EXPECT_THROW(set_option(two_towns_options(), options, option.name,
                            std::vector<double>(was.size(), option.range.high * 2 + 1)),
                 Error)
        << option.name;
  }
  EXPECT_THROW(set_option(two_towns_options(), options, "axes", {7}), Error);
}

TEST(TwoTowns, RefusesWhatLeavesNoRoom) {
  TwoTownsOptions options;
  options.overpasses = 50;
  EXPECT_THROW(two_towns(0, 0, 1, false, options), Error);
  options = {};
  options.town_size = 4000;
  EXPECT_THROW(two_towns(0, 0, 1, false, options), Error);
  EXPECT_THROW(two_towns(NAN, 0, 1, false, {}), Error);
  EXPECT_THROW(two_towns(0, INFINITY, 1, false, {}), Error);
}

}  // namespace two_towns_test
}  // namespace streetgen
