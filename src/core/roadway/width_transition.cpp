#include "roadway/width_transition.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "roadway/node_corner.hpp"

namespace streetgen {

bool changes_width(const Arm& a, const Arm& b) {
  return std::abs(a.half_start - b.half_start) > same_width &&
         std::abs(angle_between(a, b) - M_PI) < widest_bend;
}

double taper_length(const Arm& a, const Arm& b, double speed, const TaperRatio& ratio) {
  const double sideways = std::abs(a.half_start - b.half_start);
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
  const double half_a = half_at(a, a.limit), half_b = half_at(b, b.limit);
  std::vector<double> linear, stepped;
  double abscissa = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) abscissa += distance(line[i - 1], line[i]);
    const double t = total > 0 ? std::min(abscissa / total, 1.0) : 0;
    linear.push_back(half_a + (half_b - half_a) * t);
    const double s = steps ? std::clamp((abscissa - a.limit) / step + 0.5, 0.0, 1.0) : t;
    stepped.push_back(half_a + (half_b - half_a) * s);
  }
  return build_between(geos, line, kind == TransitionKind::right ? stepped : linear,
                       kind == TransitionKind::left ? stepped : linear, {a.border[1], a.border[0]},
                       b.border);
}

MultiPolygon with_round_end(Geos& geos, const MultiPolygon& surface, const Arm& arm) {
  const Point node = planar(arm.line.front());
  const Line border = border_across(arm, 0);
  Ring half{border[0]};
  append_arc(half, node, border[0], border[1], true, 8);
  half.push_back(border[1]);
  return geos.polygons(geos.unite({surface, {{closed(half)}}}).get());
}

}  // namespace streetgen
