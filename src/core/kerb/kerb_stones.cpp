#include "geometry/offset.hpp"
#include "geometry/polyline.hpp"
#include "geometry/ring_simplicity.hpp"
#include "roadway/surface_ring.hpp"
#include "streetgen/kerb.hpp"

namespace streetgen {

MultiPolygon stones_of(const Kerb& kerb) {
  const double width = kerb.stone_width;
  if (width <= 0) return {};
  const Line behind = offset_line(kerb.line, 0, length(kerb.line), width, width);
  Ring ring = reversed(kerb.line);
  ring.insert(ring.end(), behind.begin(), behind.end());
  ring.push_back(ring.front());
  ring = closed(std::move(ring));
  // The strip lies on the left of the line, so that the line is walked backwards.
  if (!ring.empty() && signed_area(ring) < 0) ring = reversed(std::move(ring));
  const bool around = distance(kerb.line.front(), kerb.line.back()) == 0;
  if (!around && !ring.empty() && simple({{ring}}).value_or(false)) return {{ring}};
  Geos geos;
  const std::size_t count = kerb.line.size();
  return build_buffer(geos, kerb.line, std::vector<double>(count, width),
                      std::vector<double>(count, 0), false);
}

}  // namespace streetgen
