#include "roadway/nose.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "layout/surface_ring.hpp"

namespace streetgen {

namespace {

constexpr double narrow_angle = 20 * M_PI / 180 + same_angle;
constexpr double radius_step = 1e-6;  // metres, the end of the bisection

bool nearly_parallel(const Point& u, const Point& v) {
  return dot(u, v) > std::cos(narrow_angle) * norm(u) * norm(v);
}

// Whether the streets run nearly parallel anywhere up to the arc.
bool may_part_slowly(const Course& a, const Course& b, const CornerArc& arc) {
  const Line on_a = walked(a, arc.abscissa_a), on_b = walked(b, arc.abscissa_b);
  for (std::size_t i = 1; i < on_a.size(); ++i)
    for (std::size_t j = 1; j < on_b.size(); ++j)
      if (nearly_parallel(on_a[i] - on_a[i - 1], on_b[j] - on_b[j - 1])) return true;
  return false;
}

// Where the kerbs cross, or at the arc.
bool part_slowly(const Course& a, const Course& b, const CornerArc& crossing,
                 const CornerArc& corner) {
  const auto at = [&](const CornerArc& arc) {
    return nearly_parallel(direction_at(a, arc.abscissa_a + coordinate_margin),
                           direction_at(b, arc.abscissa_b + coordinate_margin));
  };
  return at(crossing) || at(corner);
}

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

std::optional<SolvedCorner> nose(const Course& a, const Course& b, const SolvedCorner& corner,
                                 const CornerWish& wish, const StreetSettings& settings) {
  const double least = settings.median_width_minimal / 2;
  const bool too_far = corner.method == Method::radius_minimal;
  const double widest = too_far ? wish.radius : corner.gap.corner.radius;
  const bool follows = corner.method == Method::followed;
  if (widest <= least || !(follows || may_part_slowly(a, b, corner.gap.corner)))
    return std::nullopt;
  const auto crossing = corner_arc(a, b, 0);
  if (!crossing || !(follows || part_slowly(a, b, *crossing, corner.gap.corner)) ||
      (!too_far && !paves_too_much(a, b, *crossing, corner.gap.corner, settings)))
    return std::nullopt;
  const Point node = planar(a.front().line.front());
  const auto near = [&](const CornerArc& arc) {
    return distance(arc.centre, node) <= wish.max_arc_distance && wish.ends.hold(arc);
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
