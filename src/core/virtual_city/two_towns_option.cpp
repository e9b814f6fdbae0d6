#include <cstring>
#include <variant>

#include "streetgen/two_towns.hpp"

namespace streetgen {

// A town is small and bends, and only its main road leaves it.
TwoTownsOptions::TwoTownsOptions() {
  lanes = {2};
  lane_width = 3.25;
  speed = {50, 50, 30};
  spacing_least = 130;
  threshold = {0.35, 0.6};
  clearance = 30;
  transit = 2;
  bend = 6;
  roundabouts = 0.1;
  stretch = 600;
}

namespace {

// The road of a town is a bridge over the highway, which no more lanes lead over.
constexpr double most_town_lanes = 6;

std::vector<TwoTownsOption> options_of_both() {
  using O = TwoTownsOptions;
  std::vector<TwoTownsOption> options = {
      {"distance", &O::distance, "m", "from the one interchange to the other, from west to east",
       2000, 1e5, false, 1, 1},
      {"town_size", &O::town_size, "m", "side of the square in which a town is drawn", 500, 2e4,
       false, 1, 1},
      {"highway_lanes", &O::highway_lanes, "", "lanes of each carriageway of the highway", 2, 4,
       true, 1, 1},
      {"highway_lane_width", &O::highway_lane_width, "m", "width of a lane of the highway", 3, 5,
       false, 1, 1},
      {"highway_speed", &O::highway_speed, "km/h", "speed of the highway", 80, 140, false, 1, 1},
      {"median", &O::median, "m", "from the one carriageway to the other, kerb to kerb", 1, 30,
       false, 1, 1},
      {"overpasses", &O::overpasses, "",
       "how many country roads pass over the highway between the interchanges", 0, 100, true, 1, 1},
      {"ramp_length", &O::ramp_length, "m",
       "from where a ramp leaves the highway to the road of the town, along the highway", 350, 1000,
       false, 1, 1},
      {"ramp_speed", &O::ramp_speed, "km/h",
       "speed of a ramp, from which the radius of its bends follows", 30, 70, false, 1, 1},
  };
  for (const CityOption& option : city_options()) {
    if (std::strcmp(option.name, "axes") == 0) continue;
    TwoTownsOption of_town = {
        option.name,
        std::visit([](auto member) { return decltype(TwoTownsOption::value){member}; },
                   option.value),
        option.unit, option.description, option.range};
    if (std::strcmp(option.name, "lanes") == 0) of_town.range.high = most_town_lanes;
    options.push_back(of_town);
  }
  return options;
}

}  // namespace

const std::vector<TwoTownsOption>& two_towns_options() {
  static const std::vector<TwoTownsOption> options = options_of_both();
  return options;
}

}  // namespace streetgen
