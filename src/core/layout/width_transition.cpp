#include "layout/width_transition.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "geometry/closed_ring.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "layout/node_corner.hpp"
#include "layout/surface_pieces.hpp"

namespace streetgen {

bool changes_width(const Arm& a, const Arm& b) {
  return !as_wide(a, b) && std::abs(angle_between(a, b) - M_PI) < widest_bend;
}

double sideways(const Arm& a, const Arm& b) { return std::abs(a.start_to(+1) - b.start_to(-1)); }

double taper_length(double sideways, double speed, const TaperRatio& ratio) {
  if (ratio.empty()) return 10 * sideways;
  const auto after = ratio.upper_bound(speed);
  return sideways * (after == ratio.begin() ? after : std::prev(after))->second;
}

double transition_limit(const Arm& arm, double wanted) {
  return std::min(wanted / 2, 0.4 * length(arm.line));
}

double step_length(double limit_a, double limit_b) { return std::min({0.5, limit_a, limit_b}); }

MultiPolygon build_transition(Geos& geos, const Arm& a, const Arm& b, TransitionKind kind) {
  Line line = substring(a.line, a.limit, 0);
  const Line rest = substring(b.line, 0, b.limit);
  line.insert(line.end(), rest.begin() + 1, rest.end());
  const double total = a.limit + b.limit;
  const double step = step_length(a.limit, b.limit);
  const bool steps = kind != TransitionKind::symmetric && step > 0;
  if (steps) {
    Line cut = substring(line, 0, a.limit - step / 2);
    for (const Line& part : {substring(line, a.limit - step / 2, a.limit + step / 2),
                             substring(line, a.limit + step / 2, total)})
      cut.insert(cut.end(), part.begin() + 1, part.end());
    line = cut;
  }
  line = distinct(planar(line));
  const bool left_steps = kind == TransitionKind::right, right_steps = kind == TransitionKind::left;
  std::vector<double> left, right;
  double abscissa = 0;
  // The line comes in along a, whose left is seen from the node.
  const auto between = [&](int side, double share) {
    const double before = half_at(a, a.limit, -side);
    return before + (half_at(b, b.limit, side) - before) * share;
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) abscissa += distance(line[i - 1], line[i]);
    const double t = total > 0 ? std::min(abscissa / total, 1.0) : 0;
    const double s = steps ? std::clamp((abscissa - a.limit) / step + 0.5, 0.0, 1.0) : t;
    left.push_back(between(+1, left_steps ? s : t));
    right.push_back(between(-1, right_steps ? s : t));
  }
  return build_between(geos, line, left, right, {a.border[1], a.border[0]}, b.border);
}

MultiPolygon with_round_end(Geos& geos, const MultiPolygon& surface, const Arm& arm) {
  const Point across = left_normal(local_direction(arm.line, 0));
  const Point middle = planar(arm.line.front()) + across * arm.roadway_offset;
  const Line border = border_across(arm, 0);
  Ring half{border[0]};
  append_arc(half, middle, border[0], border[1], true, 8);
  half.push_back(border[1]);
  return geos.polygons(geos.unite({surface, {{closed(half)}}}).get());
}

}  // namespace streetgen
