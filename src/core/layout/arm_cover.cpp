#include "layout/arm_cover.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/tolerance.hpp"
#include "layout/parting.hpp"

namespace streetgen {

namespace {

double angle_about(const Point& node, const Point& p) {
  const Point d = p - node;
  return std::atan2(d.y, d.x);
}

// The arm that comes last before a point, counter-clockwise about the node.
std::size_t sector(const std::vector<Arm>& arms, const Point& p) {
  const Point& node = arms.front().line.front();
  const double angle = angle_about(node, p);
  std::size_t last = 0;
  double least = 7;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const double of_arm = angle_about(node, position_at(arms[i].line, 1).point);
    const double turn = std::fmod(angle - of_arm + 4 * M_PI, 2 * M_PI);
    if (turn >= least) continue;
    least = turn;
    last = i;
  }
  return last;
}

// The turn of a street that goes on from one arm to the other.
double bend(const std::vector<Gap>& gaps, std::size_t from, std::size_t to) {
  double angle = 0;
  for (std::size_t i = from; i != to; i = (i + 1) % gaps.size()) angle += gaps[i].angle;
  return std::abs(angle - M_PI);
}

// Whether a street goes on nearly straight to the other arm, and no other one straighter; where it
// keeps its width, no other one that does.
bool goes_on(const std::vector<Arm>& arms, const std::vector<Gap>& gaps, std::size_t from,
             std::size_t to) {
  const double own = bend(gaps, from, to);
  if (!nearly_in_line(M_PI + own)) return false;
  const bool keeps_width = as_wide(arms[from], arms[to]);
  for (std::size_t i = 0; i < gaps.size(); ++i)
    if (i != from && i != to && bend(gaps, i, to) < own - same_angle &&
        (!keeps_width || as_wide(arms[i], arms[to])))
      return false;
  return true;
}

}  // namespace

bool covers(const MultiPolygon& surface, const std::vector<Arm>& arms,
            const std::vector<Gap>& gaps) {
  constexpr double step = 1.0, inwards = 1e-3;  // metres
  const PreparedSurface ground(surface);
  const auto held = [&](std::size_t arm, const Point& p) {
    if (ground.holds(p)) return true;
    const std::size_t at = sector(arms, p), next = (at + 1) % arms.size();
    return at != arm && next != arm && !goes_on(arms, gaps, arm, at) &&
           !goes_on(arms, gaps, arm, next);
  };
  // In the place of a kerb that tapers the axis alone, and of one far beside the axis before its
  // corner: the end of such an arm may lie beyond the other street.
  const auto lines_at = [&](std::size_t k, double abscissa) {
    const Line border = border_across(arms[k], abscissa);
    const Point across = unit(border[1] - border[0]) * inwards;
    const double aside = arms[k].roadway_offset;
    const Point axis = (border[0] + border[1]) * 0.5 + unit(border[1] - border[0]) * aside;
    const auto stays_out = [&](const Gap& gap, double corner) {
      return gap.tapers || (aside != 0 && gap.meets && abscissa < corner);
    };
    const Gap &left = gaps[k], &right = gaps[(k + gaps.size() - 1) % gaps.size()];
    return std::array{stays_out(left, left.corner.abscissa_a) ? axis : border[0] + across, axis,
                      stays_out(right, right.corner.abscissa_b) ? axis : border[1] - across};
  };
  // Inside a bend a kerb point before the limit may lie behind the border line, in the section.
  const auto behind_border = [](const Arm& arm, const Point& p) {
    return dot(p - arm.border[0], left_normal(arm.border[1] - arm.border[0])) > 0;
  };
  // On the section of another arm, behind its limit.
  const auto in_section = [&](std::size_t k, const Point& p) {
    for (std::size_t i = 0; i < arms.size(); ++i)
      if (i != k && beyond_limit(arms[i], p)) return true;
    return false;
  };
  std::vector<double> cuts;
  // Straight lines that cross nothing are inside where their ends are.
  const auto covers_whole = [&](const auto& first, const auto& last) {
    cuts.clear();
    for (std::size_t i = 0; i < first.size(); ++i) {
      ground.cut(first[i], last[i], cuts);
      if (!cuts.empty() || !ground.holds(first[i]) || !ground.holds(last[i])) return false;
    }
    return true;
  };
  for (std::size_t k = 0; k < arms.size(); ++k) {
    const Arm& arm = arms[k];
    if (arm.limit <= 0) continue;
    const double margin = std::min(inwards, arm.limit / 2);
    const auto clamped = [&](double abscissa) {
      return std::clamp(abscissa, margin, arm.limit - margin);
    };
    if (distance(arm.line[0], arm.line[1]) >= arm.limit + step &&
        covers_whole(lines_at(k, clamped(0)), lines_at(k, clamped(arm.limit))))
      continue;
    const int steps = static_cast<int>(std::ceil(arm.limit / step));
    for (int i = 0; i <= steps; ++i)
      for (const Point& p : lines_at(k, clamped(arm.limit * i / steps)))
        if (!behind_border(arm, p) && !held(k, p) && !in_section(k, p)) return false;
  }
  return true;
}

}  // namespace streetgen
