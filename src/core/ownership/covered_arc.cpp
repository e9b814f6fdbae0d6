#include "ownership/covered_arc.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

constexpr int places = 9;        // along the arc, symmetric about its middle
constexpr double behind = 0.05;  // metres from the arc towards its centre, or half of the way there

}  // namespace

bool covered(const Corner& corner, const std::function<bool(const Point&)>& on_roadway) {
  const Point& centre = *corner.centre;
  const Point from = corner.arc->start - centre, middle = corner.arc->middle - centre;
  const double half = std::atan2(cross(from, middle), dot(from, middle));
  const double share = std::max(0.5, 1 - behind / corner.radius);
  int on = 0, off = 0;
  for (int i = 0; 2 * std::max(on, off) < places; ++i) {
    const double turn = half * (2.0 * i + 1) / places;
    const Point along{from.x * std::cos(turn) - from.y * std::sin(turn),
                      from.x * std::sin(turn) + from.y * std::cos(turn), 0};
    ++(on_roadway(centre + along * share) ? on : off);
  }
  return on > off;
}

void leave_covered_arcs(std::vector<Corner>& corners) {
  for (Corner& corner : corners) {
    if (!corner.covered) continue;
    corner.radius = 0;
    corner.centre.reset();
    corner.arc.reset();
    corner.method = Method::covered;
  }
}

}  // namespace streetgen
