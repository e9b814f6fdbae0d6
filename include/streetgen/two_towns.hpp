// Two virtual towns with a divided highway between them: the axes of a network with interchanges
// and overpasses.  Source: Wilkie, Sewall and Lin, "Transforming GIS data into functional road
// models for large-scale traffic simulation", figure 5a.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "streetgen/number_option.hpp"
#include "streetgen/virtual_city.hpp"

namespace streetgen {

// The options that `two_towns_options` describes, in metres, km/h and numbers; those of a virtual
// city are of each town.
struct TwoTownsOptions : CityOptions {
  TwoTownsOptions();

  double distance = 4000;
  double town_size = 1500;
  double highway_lanes = 2;
  double highway_lane_width = 3.75;
  double highway_speed = 110;
  double median = 4;
  double overpasses = 3;
  double ramp_length = 400;
  double ramp_speed = 60;
};

// Those of a virtual city are among them, but for the number of axes.
using TwoTownsOption = NumberOption<TwoTownsOptions>;
const std::vector<TwoTownsOption>& two_towns_options();

// An axis of the towns or of the country between them; a ramp and a carriageway are drawn with
// their traffic.
struct TownAxis : CityAxis {
  std::string kind;       // the class, in the words of OpenStreetMap
  bool bridge = false;    // it leads over the highway from end to end
  bool built_up = false;  // it lies in a town, where people walk along it
};

// The highway leads from west to east through the whole extent, of which x and y are the lower
// left corner.  Its first interchange is that of Weston, the second that of Easton; the seed says
// on which side each town lies.  An interchange is a diamond.  The road of the town crosses the
// highway by a bridge.  It meets at each end of it a ramp that comes off the highway and one that
// leads on.  A country road runs along either side, and roads that join the two pass over the
// highway.  Where traffic keeps left all is mirrored from north to south.
//
// Two axes share a vertex wherever they meet, and cross without one at bridges alone; all are
// connected.  Coordinates are whole millimetres, made as those of `virtual_city`: the same towns
// on every machine.  Error{invalid_input}, with a hint: options that leave no room for each other.
std::vector<TownAxis> two_towns(double x, double y, std::int64_t seed, bool keeps_left,
                                const TwoTownsOptions& options);

}  // namespace streetgen
