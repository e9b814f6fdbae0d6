#include <utility>

#include "alignment/curve_chords.hpp"
#include "geometry/offset.hpp"
#include "geometry/polyline.hpp"
#include "geometry/ring_simplicity.hpp"
#include "roadway/surface_ring.hpp"
#include "streetgen/surface.hpp"

namespace streetgen {

namespace {

// For any line: the strips of its segments and the sectors at its bends, united.
MultiPolygon united_strip(const Line& kerb, double width_start, double width_end) {
  const double total = length(kerb);
  std::vector<double> widths;
  double abscissa = 0;
  for (std::size_t i = 0; i < kerb.size(); ++i) {
    if (i > 0) abscissa += distance(kerb[i - 1], kerb[i]);
    widths.push_back(width_start + (width_end - width_start) * abscissa / total);
  }
  Geos geos;
  return build_buffer(geos, kerb, widths, std::vector<double>(kerb.size(), 0), false);
}

}  // namespace

MultiPolygon offset_strip(const Line& kerb, double width_start, double width_end) {
  const Line line = distinct(planar(kerb));
  if (line.size() < 2 || (width_start <= 0 && width_end <= 0)) return {};
  const Line behind = offset_line(line, 0, length(line), width_start, width_end);
  Ring ring = reversed(line);
  ring.insert(ring.end(), behind.begin(), behind.end());
  ring.push_back(ring.front());
  ring = closed(std::move(ring));
  // The strip lies on the left of the line, so that the line is walked backwards.
  if (!ring.empty() && signed_area(ring) < 0) ring = reversed(std::move(ring));
  const bool around = distance(line.front(), line.back()) == 0;
  if (!around && !ring.empty() && simple({{ring}}).value_or(false)) return {{ring}};
  return united_strip(line, width_start, width_end);
}

MultiPolygon offset_strip(const CurvedLine& kerb, double width_start, double width_end) {
  return offset_strip(curve_chords(kerb), width_start, width_end);
}

}  // namespace streetgen
