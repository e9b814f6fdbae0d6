#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/object.hpp"

namespace streetgen {

Line roadway_border(const Line& axis, const WidthProfile& borders, const BorderStretch& stretch) {
  using Place = WidthProfile::Place;
  const Line whole = distinct(planar(axis));
  const auto offset = [&](const Place& place) {
    return stretch.side * (place.on(stretch.side) + stretch.beside);
  };
  Line line;
  borders.each_stretch(stretch.from, stretch.to, [&](const Place& start, const Place& end) {
    if (end.abscissa - start.abscissa <= same_place) return;
    const Line part = substring(whole, start.abscissa, end.abscissa);
    for (const Point& point : offset_line(part, offset(start), offset(end)))
      if (line.empty() || distance(line.back(), point) > same_place) line.push_back(point);
  });
  return line;
}

}  // namespace streetgen
