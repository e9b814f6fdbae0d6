// A virtual city: the axes of its streets, drawn by a fractal of main and outgoing roads.
// Source: Pluciennik, "Generating roads structure of a virtual city for GIS systems testing".
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "streetgen/geometry.hpp"
#include "streetgen/number_option.hpp"

namespace streetgen {

// The rectangle in which the city is drawn: lower left corner, width and height in metres.
struct CityExtent {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

// The options that `city_options` describes, in metres, degrees, shares and numbers.  The values
// are the paper's where it names them.  A list by level holds its last entry for all further
// levels.
struct CityOptions {
  double axes = 0;
  std::vector<double> centres = {0.5, 0.5};
  double deviation = 0.35;
  std::vector<double> threshold = {0.5, 0.75};
  std::vector<double> lanes = {6, 4, 2};
  double lane_width = 3;
  std::vector<double> speed = {70, 50, 50, 30};
  double length_ratio = 0.45;
  double length_drawn = 0.5;
  double spacing_ratio = 0.14;
  double spacing_least = 230;
  double scatter = 0.7;
  double start_gap = 40;
  double right_angles = 0.8;
  double angle_least = 45;
  double clearance = 20;
  double node_gap = 15;
  double transit = 6;
  double fade = 0.9;
  double bend = 0;
  double roundabouts = 0;
  double roundabout_radius = 20;
  double stretch = 0;
  double one_way_pairs = 0;
};

using CityOption = NumberOption<CityOptions>;
const std::vector<CityOption>& city_options();

// The value of a list by level for a level.
double at_level(const std::vector<double>& list, int level);

enum class CityDirection { both, direct, reverse };

struct CityAxis {
  Line line;         // a vertex wherever another axis meets it; closed for a roundabout
  int level = 0;     // of the fractal: 0 is the first road
  double width = 0;  // metres, kerb to kerb
  int lane_count = 0;
  int importance = 0;  // 1 highest
  double speed = 0;    // km/h
  CityDirection direction = CityDirection::both;
  std::string name;
};

// exp(-dx^2 / 2 sx^2 - dy^2 / 2 sy^2) about the nearest centre, where it is greatest.
double city_density(const Point& at, const CityExtent& extent, const CityOptions& options);

// Every axis starts or ends on another one, so that all are connected; no two cross without a
// vertex.  Coordinates are whole millimetres from the corner, all decisions are made on them with
// operations that IEEE 754 defines to the bit: the same city on every machine.
// Error{invalid_input}, with a hint: an extent too small or too large, options that contradict
// each other, a number of axes that no scale of the extent draws.
std::vector<CityAxis> virtual_city(const CityExtent& extent, std::int64_t seed,
                                   const CityOptions& options);

}  // namespace streetgen
