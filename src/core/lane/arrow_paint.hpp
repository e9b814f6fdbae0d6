// What arrows on lanes look like.
#pragma once

#include <map>

#include "geometry/geos.hpp"
#include "streetgen/lane.hpp"

namespace streetgen {

class ArrowPaint {
 public:
  // Metres from the foot to the tip.
  static double length_on(const Lane& lane);

  // Along a line from its foot to its tip, with a branch for each of the turns; of none: straight
  // on.
  MultiPolygon on(const Lane& lane, unsigned turns, const Line& line);

 private:
  const MultiPolygon& shape_of(unsigned turns);

  Geos geos_;
  std::map<unsigned, MultiPolygon> shapes_;  // towards x, from the origin, at full size
};

}  // namespace streetgen
