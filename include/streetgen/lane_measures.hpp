// The same places along an axis and along a lane beside it.  Wilkie, Sewall and Lin, section 4.2.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// Metres along the axis and along the lane, ascending; between two of them shares are equal.
struct LaneMeasures {
  std::vector<double> on_axis, on_lane;
};

// About a vertex of the axis a lane inside has a point where one outside has an arc: both are one
// stretch there.  The lane leads as the axis does.  `widest` is the largest offset of a lane from
// the axis, metres, so that all lanes of an edge have the same places.  `first` and `last` are where
// the lane begins and ends, metres along the axis.  Lanes between limits that coincide get a metre
// of the axis, and so keep their length.
LaneMeasures lane_measures(const Line& axis, const Line& lane, double widest, double first,
                           double last);

// The measure of a place between others, by equal shares.  A place before the first one has the
// measure of the first, and one behind the last that of the last.
double measure_at(const std::vector<double>& places, const std::vector<double>& measures,
                  double place);

}  // namespace streetgen
