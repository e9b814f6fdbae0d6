#include "geometry/box.hpp"

namespace streetgen {

Box box_of(const MultiPolygon& surface) {
  Box box;
  for (const Polygon& polygon : surface)
    for (const Point& p : polygon.front()) box.add(p);
  return box;
}

}  // namespace streetgen
