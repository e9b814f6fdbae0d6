#include <cmath>
#include <string>
#include <vector>

#include "streetgen/virtual_city.hpp"

namespace streetgen {

const std::vector<CityOption>& city_options() {
  using O = CityOptions;
  static const std::vector<CityOption> options = {
      {"axes", &O::axes, "",
       "how many axes to draw: the extent is scaled about its lower left corner until so many are "
       "drawn, within 5 %; 0: as many as the extent holds",
       0, 5e6, true, 1, 1},
      {"centres", &O::centres, "share of width and height",
       "places of greatest density, [x, y] each", 0, 1, false, 2, 64},
      {"deviation", &O::deviation, "share of width and height",
       "standard deviation of the density about a centre", 0.01, 100, false, 1, 1},
      {"threshold", &O::threshold, "",
       "a road starts only where the density is at least a number drawn between these two", 0, 1,
       false, 2, 2},
      {"lanes", &O::lanes, "", "lanes of a road, by level", 1, 30, true, 1, 20},
      {"lane_width", &O::lane_width, "m", "width of a lane", 2, 6, false, 1, 1},
      {"speed", &O::speed, "km/h", "speed of a road, by level", 5, 400, false, 1, 20},
      {"length_ratio", &O::length_ratio, "",
       "greatest length of a road against that of the level before; the first road's is the longer "
       "side of the extent",
       0.05, 0.9, false, 1, 1},
      {"length_drawn", &O::length_drawn, "",
       "a road's own length is drawn between this share of the greatest and all of it", 0.05, 1,
       false, 1, 1},
      {"spacing_ratio", &O::spacing_ratio, "",
       "length of a main road for each outgoing one, against the greatest length of those", 0.01,
       10, false, 1, 1},
      {"spacing_least", &O::spacing_least, "m",
       "least length of a main road for each outgoing one; a shorter road has none, and the "
       "recursion stops",
       20, 1e5, false, 1, 1},
      {"scatter", &O::scatter, "",
       "how far the starts stray from equal distances; 1: each anywhere in its part of the main "
       "road",
       0, 1, false, 1, 1},
      {"start_gap", &O::start_gap, "m",
       "least distance between the starts of roads along their main road, and between them and its "
       "ends; a shorter road is not drawn",
       20, 1e4, false, 1, 1},
      {"right_angles", &O::right_angles, "",
       "share of roads that leave their main road at a right angle", 0, 1, false, 1, 1},
      {"angle_least", &O::angle_least, "degrees", "least angle between roads that meet", 30, 80,
       false, 1, 1},
      {"clearance", &O::clearance, "m", "least distance between the kerbs of roads side by side",
       10, 1e4, false, 1, 1},
      {"node_gap", &O::node_gap, "m",
       "a road that would end nearer to a node of the road it meets ends in that node", 1, 100,
       false, 1, 1},
      {"transit", &O::transit, "", "how many ends of roads may lie on the border", 2, 1e6, true, 1,
       1},
      {"fade", &O::fade, "",
       "a road that does not reach the border ends where the density is below this share of the "
       "number drawn for its start; 0: nowhere",
       0, 1, false, 1, 1},
      {"bend", &O::bend, "degrees per 100 m", "how sharply roads bend; 0: straight", 0, 60, false,
       1, 1},
      {"roundabouts", &O::roundabouts, "",
       "share of the crossings with room for it that become roundabouts", 0, 1, false, 1, 1},
      {"roundabout_radius", &O::roundabout_radius, "m", "radius of their axes", 12, 100, false, 1,
       1},
      {"stretch", &O::stretch, "m",
       "a longer road is divided at nodes into axes of about this length, with a name each; 0: one "
       "name a road",
       0, 1e6, false, 1, 1},
      {"one_way_pairs", &O::one_way_pairs, "",
       "share of the pairs of neighbouring roads between the same two roads that are one-way, "
       "against each other",
       0, 1, false, 1, 1},
  };
  return options;
}

void check_option(const std::string& name, const std::string& description, const OptionRange& range,
                  const std::vector<double>& values) {
  const std::string hint = "Expected " + std::string(range.whole ? "whole numbers" : "numbers") +
                           " from " + text_of(range.low) + " to " + text_of(range.high) + ": " +
                           description + ".";
  const int count = static_cast<int>(values.size());
  if (count < range.fewest || count > range.most)
    throw Error(ErrorKind::invalid_input,
                "option \"" + name + "\" has " + std::to_string(count) + " numbers, expected " +
                    std::to_string(range.fewest) +
                    (range.most > range.fewest ? " to " + std::to_string(range.most) : ""),
                hint);
  for (const double value : values)
    if (!(value >= range.low && value <= range.high) || (range.whole && value != std::floor(value)))
      throw Error(ErrorKind::invalid_input,
                  "option \"" + name + "\" is " + text_of(value) + ", out of range", hint);
}

}  // namespace streetgen
