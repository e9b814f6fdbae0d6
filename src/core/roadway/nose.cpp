#include "roadway/nose.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "layout/surface_ring.hpp"

namespace streetgen {

namespace {

constexpr double nearly_parallel = 20 * M_PI / 180 + same_angle;
constexpr double radius_step = 1e-6;  // metres, the end of the bisection

// Whether the arc lies farther from the crossing of its kerbs, or closes more ground, than wanted.
bool paves_too_much(const Course& a, const Course& b, const CornerArc& crossing,
                    const CornerArc& corner, const StreetSettings& settings) {
  const double along =
      std::max(corner.abscissa_a - crossing.abscissa_a, corner.abscissa_b - crossing.abscissa_b);
  if (along > settings.follow_length) return true;
  const Polygon ground = cusp(a, b, crossing, corner);
  return !ground.empty() && std::abs(signed_area(ground.front())) > settings.follow_area;
}

}  // namespace

bool ends_a_median(const SolvedCorner& corner) {
  const CornerArc& arc = corner.gap.corner;
  if (arc.radius <= 0) return false;
  if (corner.method == Method::followed) return true;
  const Point from = unit(arc.arc.start - arc.centre), to = unit(arc.arc.end - arc.centre);
  return cross(from, to) < 0 && dot(from, to) < -std::cos(nearly_parallel);
}

std::optional<SolvedCorner> nose(const Course& a, const Course& b, const SolvedCorner& corner,
                                 const CornerWish& wish, const StreetSettings& settings) {
  const double least = settings.median_width_minimal / 2;
  const bool too_far = corner.method == Method::radius_minimal;
  const double widest = too_far ? wish.radius : corner.gap.corner.radius;
  if (widest <= least) return std::nullopt;
  const auto crossing = corner_arc(a, b, 0);
  if (!crossing || (!too_far && !paves_too_much(a, b, *crossing, corner.gap.corner, settings)))
    return std::nullopt;
  const Point node = planar(a.front().line.front());
  const auto near = [&](const CornerArc& arc) {
    return distance(arc.centre, node) <= wish.max_arc_distance;
  };
  auto found = corner_arc(a, b, least);
  if (!found || (too_far && !near(*found))) return std::nullopt;
  for (double low = least, high = widest; high - low > radius_step;) {
    const double middle = (low + high) / 2;
    const auto tried = corner_arc(a, b, middle);
    const bool fits = tried && near(*tried) && !paves_too_much(a, b, *crossing, *tried, settings);
    (fits ? low : high) = middle;
    if (fits) found = tried;
  }
  SolvedCorner solved = corner;
  solved.gap.corner = *found;
  if (!corner.gap.meets) solved.gap.beyond = cusp(a, b, *crossing, *found);
  solved.limit_a = found->abscissa_a;
  solved.limit_b = found->abscissa_b;
  solved.method = Method::nose;
  return solved;
}

}  // namespace streetgen
