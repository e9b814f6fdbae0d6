#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/ring_simplicity.hpp"
#include "layout/surface_pieces.hpp"
#include "road/curve_chords.hpp"
#include "streetgen/surface.hpp"
#include "strip/back_line.hpp"
#include "strip/kerb_front.hpp"

namespace streetgen {

namespace {

std::vector<double> widths_along(const Line& kerb, double width_start, double width_end) {
  const double total = length(kerb);
  std::vector<double> widths;
  double abscissa = 0;
  for (std::size_t i = 0; i < kerb.size(); ++i) {
    if (i > 0) abscissa += distance(kerb[i - 1], kerb[i]);
    widths.push_back(width_start + (width_end - width_start) * abscissa / total);
  }
  return widths;
}

// Empty where the strip is no ring.
Ring ring_of_strip(const Line& kerb, const std::vector<double>& widths) {
  std::vector<KerbSegment> segments;
  for (std::size_t i = 1; i < kerb.size(); ++i)
    segments.push_back(
        {kerb[i - 1], kerb[i], widths[i - 1], widths[i], 0, unit(kerb[i] - kerb[i - 1])});
  const FrontPassed passed = pass_front(segments, false, {}, {});
  if (!passed.grounds[0].whole) return {};
  Ring ring = ring_behind(kerb, passed.grounds[0], BackLine(segments, passed, false), 0,
                          static_cast<int>(segments.size()) - 1);
  if (ring.empty() || signed_area(ring) <= 0 || !simple({{ring}}).value_or(false)) return {};
  return ring;
}

}  // namespace

MultiPolygon offset_strip(const Line& kerb, double width_start, double width_end) {
  const Line whole = distinct(planar(kerb));
  const Line line = whole.size() > 2 ? without_noise(whole) : whole;
  if (line.size() < 2 || (width_start <= 0 && width_end <= 0)) return {};
  const std::vector<double> widths = widths_along(line, width_start, width_end);
  if (distance(line.front(), line.back()) > 0) {
    Ring ring = ring_of_strip(line, widths);
    if (!ring.empty()) return {{std::move(ring)}};
  }
  // For any line: the strips of its segments and the sectors at its bends, united.
  Geos geos;
  return build_buffer(geos, line, widths, std::vector<double>(line.size(), 0), false);
}

MultiPolygon offset_strip(const CurvedLine& kerb, double width_start, double width_end) {
  return offset_strip(curve_chords(kerb), width_start, width_end);
}

}  // namespace streetgen
