#include "lane/lane_extent.hpp"

#include <algorithm>

#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

constexpr double least_length = 0.01;  // metres, of which a lane has a direction

}  // namespace

LaneExtent lane_extent(const Streets& streets, int edge) {
  const SectionLimit &start = streets.limits[2 * edge], &end = streets.limits[2 * edge + 1];
  LaneExtent reach{start.abscissa, end.abscissa};
  if (!limits_crossed(streets, edge)) return reach;
  const double total = length(streets.network.edges[edge].line);
  reach.from = std::clamp((reach.from + reach.to - least_length) / 2, 0.0,
                          std::max(0.0, total - least_length));
  reach.to = std::min(total, reach.from + least_length);
  return reach;
}

}  // namespace streetgen
