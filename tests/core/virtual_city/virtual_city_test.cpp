#include "streetgen/virtual_city.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "cities.hpp"
#include "geometry/polyline.hpp"
#include "rounds.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "streetgen/network.hpp"
#include "virtual_city/portable_math.hpp"
#include "support/random.hpp"

namespace streetgen {
namespace virtual_city_test {

Network network_of(const std::vector<CityAxis>& axes) {
  std::vector<NetworkAxis> given;
  for (const CityAxis& axis : axes)
    given.push_back({static_cast<std::int64_t>(given.size()), axis.line, 0});
  return network(given, 0.001, Crossing::over);
}

TEST(Random, IsSplitMix64) {
  // The published sequence of the seed 1234567.
  Random random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317ULL);
  EXPECT_EQ(random.next(), 3203168211198807973ULL);
  EXPECT_EQ(random.next(), 9817491932198370423ULL);
}

TEST(PortableMath, IsTheMathematicsOfTheLibrary) {
  for (double u = 0; u < 60; u += 0.37)
    EXPECT_NEAR(portable::decay(u) / std::exp(-u), 1, 1e-13) << u;
  EXPECT_EQ(portable::decay(1e4), 0);
  for (double degrees = -180; degrees <= 180; degrees += 7.5) {
    const Point turned = portable::turned({0.6, 0.8, 0}, degrees);
    EXPECT_NEAR(turned.x, std::cos(std::atan2(0.8, 0.6) + degrees * M_PI / 180), 1e-14);
    EXPECT_NEAR(turned.y, std::sin(std::atan2(0.8, 0.6) + degrees * M_PI / 180), 1e-14);
  }
}

TEST(CityDensity, IsAGaussianWithDeviationsOfWidthAndHeight) {
  const CityOptions options;
  const Point middle{6570000, 5575000, 0};
  EXPECT_DOUBLE_EQ(city_density(middle, paper, options), 1);
  EXPECT_NEAR(city_density({middle.x + 7000, middle.y, 0}, paper, options), std::exp(-0.5), 1e-14);
  EXPECT_NEAR(city_density({middle.x, middle.y - 3500, 0}, paper, options), std::exp(-0.5), 1e-14);
  EXPECT_NEAR(city_density({middle.x + 7000, middle.y + 7000, 0}, paper, options), std::exp(-2.5),
              1e-14);
}

TEST(CityDensity, IsThatOfTheNearestOfSeveralCentres) {
  CityOptions options;
  options.centres = {0.25, 0.5, 0.75, 0.5};
  options.deviation = 0.1;
  EXPECT_DOUBLE_EQ(city_density({25, 50, 0}, {0, 0, 100, 100}, options), 1);
  EXPECT_DOUBLE_EQ(city_density({75, 50, 0}, {0, 0, 100, 100}, options), 1);
  EXPECT_NEAR(city_density({50, 50, 0}, {0, 0, 100, 100}, options), std::exp(-3.125), 1e-14);
}

TEST(VirtualCity, HasAsManyStreetsAsThePaperShows) {
  for (int seed = 1; seed <= 10; ++seed) {
    const std::size_t count = virtual_city(paper, seed, {}).size();
    EXPECT_GE(count, 1000u) << "seed " << seed;
    EXPECT_LE(count, 2000u) << "seed " << seed;
  }
}

TEST(VirtualCity, IsTheSameAgain) {
  for (const CityOptions& options : kinds()) {
    const std::vector<CityAxis> once = virtual_city(town, 7, options);
    virtual_city(town, 8, options);
    const std::vector<CityAxis> again = virtual_city(town, 7, options);
    ASSERT_EQ(once.size(), again.size());
    for (std::size_t i = 0; i < once.size(); ++i) {
      ASSERT_EQ(once[i].line.size(), again[i].line.size());
      for (std::size_t k = 0; k < once[i].line.size(); ++k) {
        EXPECT_EQ(once[i].line[k].x, again[i].line[k].x);
        EXPECT_EQ(once[i].line[k].y, again[i].line[k].y);
      }
      EXPECT_EQ(once[i].name, again[i].name);
      EXPECT_EQ(once[i].direction, again[i].direction);
    }
    EXPECT_NE(virtual_city(town, 8, options)[0].line[0].y, once[0].line[0].y);
  }
}

TEST(VirtualCity, LiesOnWholeMillimetresInItsExtent) {
  for (const CityOptions& options : kinds())
    for (const CityAxis& axis : virtual_city({500000.25, 100, 5000, 3500}, 3, options))
      for (const Point& p : axis.line) {
        EXPECT_NEAR(p.x * 1000, std::round(p.x * 1000), 1e-5);
        EXPECT_NEAR(p.y * 1000, std::round(p.y * 1000), 1e-5);
        EXPECT_TRUE(p.x >= 500000.25 && p.x <= 505000.25 && p.y >= 100 && p.y <= 3600);
      }
}

TEST(VirtualCity, CrossesAtSharedVerticesOnly) {
  for (const CityOptions& options : kinds())
    for (int seed = 1; seed <= rounds(5); ++seed)
      for (const NetworkReport& report : network_of(virtual_city(town, seed, options)).reports)
        ADD_FAILURE() << "seed " << seed << ": axes " << report.axis_a << ", " << report.axis_b
                      << " at " << report.point.x << " " << report.point.y;
}

// Pieces of the network that are not connected.
int pieces(const Network& n) {
  std::vector<int> piece(n.nodes.size());
  std::iota(piece.begin(), piece.end(), 0);
  const auto root = [&](int i) {
    while (piece[i] != i) i = piece[i] = piece[piece[i]];
    return i;
  };
  int left = static_cast<int>(piece.size());
  for (const Edge& edge : n.edges) {
    const int a = root(edge.from_node), b = root(edge.to_node);
    left -= a != b;
    piece[a] = b;
  }
  return left;
}

TEST(VirtualCity, IsOnePiece) {
  for (const CityOptions& options : kinds())
    for (int seed = 1; seed <= rounds(5); ++seed)
      EXPECT_EQ(pieces(network_of(virtual_city(town, seed, options))), 1);
}

TEST(VirtualCity, IsATopologicalNetworkWhateverTheOptions) {
  for (std::uint64_t run = 0; run < 100; ++run) {
    Random random(run);
    CityOptions options;
    std::string given;
    for (const CityOption& option : city_options()) {
      const std::string name = option.name;
      if (name == "axes" || random.chance(0.6)) continue;
      // Not so that there is no city, nor more of it than a test has time for.
      const double low = name == "spacing_least" ? 60 : option.range.low;
      const double high =
          std::min(option.range.high, name == "spacing_ratio" || name == "deviation" ? 1 : 400.0);
      std::vector<double> values = option.of(options);
      for (double& value : values) {
        value = low + (high - low) * random.uniform() * random.uniform();
        if (option.range.whole) value = std::floor(value);
      }
      std::sort(values.begin(), values.end());
      set_option(city_options(), options, name, values);
      given += name + " " + text_of(values[0]) + " ";
    }
    const Network n =
        network_of(virtual_city({0, 0, random.uniform(900, 6000), random.uniform(900, 6000)},
                                static_cast<std::int64_t>(run), options));
    EXPECT_TRUE(n.reports.empty()) << given;
    EXPECT_EQ(pieces(n), 1) << given;
  }
}

TEST(VirtualCity, MeetsAtTheLeastAngleOrMore) {
  for (const CityOptions& options : {CityOptions{}, kinds()[3]})
    for (int seed = 1; seed <= rounds(5); ++seed) {
      const Network n = network_of(virtual_city(town, seed, options));
      std::vector<std::vector<Point>> arms(n.nodes.size());
      for (const Edge& edge : n.edges) {
        arms[edge.from_node].push_back(edge.line[1] - edge.line[0]);
        arms[edge.to_node].push_back(edge.line[edge.line.size() - 2] - edge.line.back());
      }
      for (const auto& at_node : arms)
        for (std::size_t i = 0; i < at_node.size(); ++i)
          for (std::size_t k = 0; k < i; ++k)
            EXPECT_GE(angle(at_node[i], at_node[k]), options.angle_least - 0.1);
    }
}

TEST(VirtualCity, DrawsTheNumberOfAxesAskedFor) {
  for (const double n : {1, 2, 3, 5, 8, 13, 50, 400, 3000, 20000}) {
    CityOptions options;
    options.axes = n;
    EXPECT_NEAR(virtual_city({0, 0, 2, 1}, 5, options).size(), n, 0.05 * n);
  }
}

TEST(VirtualCity, NamesStretches) {
  CityOptions options;
  options.stretch = 500;
  const std::vector<CityAxis> whole = virtual_city(town, 9, {}),
                              divided = virtual_city(town, 9, options);
  EXPECT_GT(divided.size(), whole.size());
  std::set<std::string> names;
  for (const CityAxis& axis : divided) names.insert(axis.name);
  EXPECT_EQ(names.size(), divided.size());
  double a = 0, b = 0;
  for (const CityAxis& axis : whole) a += length(axis.line);
  for (const CityAxis& axis : divided) b += length(axis.line);
  EXPECT_NEAR(a, b, 1e-6);
}

TEST(VirtualCity, MakesRoundabouts) {
  CityOptions options;
  options.roundabouts = 1;
  for (const double bend : {0, 10}) {
    options.bend = bend;
    const std::vector<CityAxis> axes = virtual_city(town, 10, options);
    std::vector<std::vector<Point>> ends;
    int rings = 0;
    for (const CityAxis& ring : axes) {
      if (distance(ring.line.front(), ring.line.back()) > 0) continue;
      ++rings;
      EXPECT_EQ(ring.direction, CityDirection::direct);
      EXPECT_GT(signed_area(ring.line), 0);
      EXPECT_NEAR(length(ring.line), 2 * M_PI * options.roundabout_radius, 2);
      int arms = 0;
      for (const CityAxis& axis : axes)
        if (&axis != &ring)
          for (const Point& p : ring.line)
            arms += &p != &ring.line.back() &&
                    (distance(p, axis.line.front()) == 0) + (distance(p, axis.line.back()) == 0);
      EXPECT_GE(arms, 3);
    }
    EXPECT_GT(rings, 20);
  }
}

TEST(VirtualCity, PairsOneWayRoads) {
  CityOptions options;
  options.one_way_pairs = 1;
  std::map<CityDirection, int> count;
  for (const CityAxis& axis : virtual_city(paper, 11, options)) ++count[axis.direction];
  EXPECT_EQ(count[CityDirection::direct], count[CityDirection::reverse]);
  EXPECT_GT(count[CityDirection::direct], 20);
  EXPECT_GT(count[CityDirection::both], 20);
  for (const CityAxis& axis : virtual_city(paper, 11, {}))
    EXPECT_EQ(axis.direction, CityDirection::both);
}

TEST(CityOption, IsSetByName) {
  CityOptions options;
  for (const CityOption& option : city_options()) {
    const std::vector<double> was = option.of(options);
    EXPECT_NO_THROW(set_option(city_options(), options, option.name, was)) << option.name;
    std::vector<double> other(was.size(), option.range.high);
    set_option(city_options(), options, option.name, other);
    EXPECT_EQ(option.of(options), other);
    other.back() = std::nextafter(option.range.high, 1e300);
    EXPECT_THROW(set_option(city_options(), options, option.name, other), Error) << option.name;
    EXPECT_THROW(set_option(city_options(), options, option.name, {}), Error) << option.name;
  }
}

TEST(CityOption, EveryOneHasAnEffect) {
  const std::map<std::string, std::vector<double>> other = {{"axes", {100}},
                                                            {"centres", {0.2, 0.2}},
                                                            {"deviation", {0.2}},
                                                            {"threshold", {0, 0.1}},
                                                            {"lanes", {4, 2}},
                                                            {"lane_width", {3.5}},
                                                            {"speed", {30}},
                                                            {"length_ratio", {0.6}},
                                                            {"length_drawn", {0.9}},
                                                            {"spacing_ratio", {1}},
                                                            {"spacing_least", {100}},
                                                            {"scatter", {0}},
                                                            {"start_gap", {100}},
                                                            {"right_angles", {0}},
                                                            {"angle_least", {75}},
                                                            {"clearance", {60}},
                                                            {"node_gap", {60}},
                                                            {"transit", {2}},
                                                            {"fade", {0}},
                                                            {"bend", {5}},
                                                            {"roundabouts", {1}},
                                                            {"stretch", {300}},
                                                            {"one_way_pairs", {1}},
                                                            {"roundabout_radius", {30}}};
  const auto text = [](const CityOptions& options) {
    std::string all;
    for (const CityAxis& axis : virtual_city(town, 12, options)) {
      for (const Point& p : axis.line) all += text_of(p.x) + " " + text_of(p.y) + ",";
      all += text_of(axis.width) + text_of(axis.speed) + text_of(int(axis.direction));
    }
    return all;
  };
  for (const CityOption& option : city_options()) {
    CityOptions plain;
    if (std::string(option.name) == "roundabout_radius") plain.roundabouts = 1;
    CityOptions changed = plain;
    set_option(city_options(), changed, option.name, other.at(option.name));
    EXPECT_NE(text(plain), text(changed)) << option.name;
  }
}

void expect_refused(const CityExtent& extent, const CityOptions& options) {
  try {
    virtual_city(extent, 1, options);
    ADD_FAILURE() << extent.width << " x " << extent.height;
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::invalid_input);
    EXPECT_NE(e.hint(), "");
  }
}

TEST(VirtualCity, RefusesWhatMakesNoCity) {
  for (const double side : {0.0, -5.0, 18.0, 75.9, 1.1e6, 1e300, std::nan(""), HUGE_VAL}) {
    expect_refused({0, 0, side, 1000}, {});
    expect_refused({0, 0, 1000, side}, {});
  }
  expect_refused({std::nan(""), 0, 1000, 1000}, {});
  expect_refused({0, 1e300, 1000, 1000}, {});
  CityOptions options;
  options.threshold = {0.8, 0.2};
  expect_refused(town, options);
  options = {};
  options.centres = {0.5, 0.5, 0.5};
  expect_refused(town, options);
  options = {};
  options.axes = 1000;
  expect_refused({0, 0, 1e6, 1}, options);
  EXPECT_GE(virtual_city({0, 0, 76, 76}, 1, {}).size(), 1u);
}

TEST(VirtualCity, IsCancelled) {
  set_cancel_check([]() noexcept { return true; });
  EXPECT_THROW(virtual_city(town, 1, {}), Error);
  set_cancel_check(nullptr);
}

}  // namespace virtual_city_test
}  // namespace streetgen
