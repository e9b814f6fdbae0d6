#include <algorithm>
#include <cmath>

#include "geometry/space.hpp"
#include "streetgen/arc_road.hpp"
#include "streetgen/error.hpp"
#include "truths.hpp"

namespace streetgen::fuzz {

namespace {

bool finite(const Point& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

double size_of(const Point& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z); }

void curve_holds_together(const ArcRoad& road, Faults& faults) {
  const CurvedLine curve = road.curve();
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Arc& arc = curve[i].arc;
    if (!finite(arc.start) || !finite(arc.middle) || !finite(arc.end))
      faults.push_back("a curve is not finite");
    if (i > 0 && space::distance(curve[i - 1].arc.end, arc.start) != 0)
      faults.push_back("a curve has a gap");
  }
  const ArcRoad again = ArcRoad::along(curve);
  // Each piece is known to the resolution of its coordinates.
  const double slack = 1e-6 + 1e-13 * size_of(curve[0].arc.start) * curve.size();
  if (std::abs(again.length() - road.length()) > slack)
    faults.push_back("a curve has another length than its road");
}

void places_are_found(Random& random, const ArcRoad& road, Faults& faults) {
  for (int i = 0; i < 10; ++i) {
    const RoadPlace place = road.at(random.between(-0.1, 1.1) * road.length());
    const RoadFoot foot = road.locate(place.point);
    if (!finite(place.point) || !finite(place.up) || place.up.z <= 0)
      faults.push_back("a place has no frame");
    if (!(foot.distance <= 1e-7 + 1e-14 * size_of(place.point)))
      faults.push_back("a place of the road is not found on it");
  }
}

void neighbours_are_finite(Random& random, const ArcRoad& road, Faults& faults) {
  const double offset = random.scaled(0.1, 60) * (random.one_in(2) ? 1 : -1);
  const double tolerance = random.scaled(0.001, 10);
  for (const Point& p : road.line(tolerance))
    if (!finite(p)) faults.push_back("a line is not finite");
  for (const Triangle& t : road.mesh(std::abs(offset), random.between(-60, 0), tolerance))
    if (!std::all_of(t.begin(), t.end(), finite)) faults.push_back("a mesh is not finite");
  try {
    if (const auto beside = road.offset(offset)) curve_holds_together(*beside, faults);
  } catch (const Error& e) {
    if (e.kind() != ErrorKind::unsupported || road.flat()) throw;
  }
}

}  // namespace

Faults alignment_faults(std::uint64_t seed) {
  Random random(seed);
  Line line = random_line(
      random, random.of(std::vector<Point>{{0, 0, 0}, {650000, 6860000, 0}, {1e9, -1e9, 0}}));
  if (random.one_in(3))
    for (Point& p : line) p.z += random.between(-5, 5);
  ArcRoadFit fit;
  if (random.one_in(2)) fit.cap = random.one_in(5) ? 0 : random.scaled(0.1, 4000);
  if (random.one_in(2)) fit.shift = random.scaled(0.01, 10);
  Faults faults;
  try {
    const ArcRoad road = ArcRoad::fit(line, fit);
    for (const RoadArc& arc : road.arcs())
      if (!(arc.radius >= 0 && arc.radius <= fit.cap)) faults.push_back("a radius beyond the cap");
    curve_holds_together(road, faults);
    places_are_found(random, road, faults);
    neighbours_are_finite(random, road, faults);
  } catch (const Error& e) {
    // Heights drawn at points that repeat each other are vertical.
    if (std::string(e.what()).find("vertical") == std::string::npos) throw;
  }
  return faults;
}

}  // namespace streetgen::fuzz
