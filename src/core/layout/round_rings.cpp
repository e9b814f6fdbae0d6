#include "layout/round_rings.hpp"

#include <cmath>
#include <optional>
#include <unordered_map>

#include "geometry/fit_circle.hpp"
#include "geometry/polyline.hpp"
#include "layout/smooth_edges.hpp"

namespace streetgen {

namespace {

constexpr std::size_t least_points = 4;    // a circle goes through any three
constexpr double greatest_radius = 150;    // metres
constexpr double chord_off = 0.02;         // metres from the middle of a chord to its arc
constexpr double least_sweep = M_PI / 24;  // an edge about less of the circle stays as it is

std::optional<Circle> circle_of(const StreetAxis& axis, double shift) {
  const Line points = distinct(planar(axis.line));
  if (points.size() < least_points) return std::nullopt;
  const std::optional<Circle> circle = fit_circle(points.data(), points.size());
  if (!circle || circle->radius > greatest_radius) return std::nullopt;
  for (const Point& p : points)
    if (std::abs(distance(p, circle->centre) - circle->radius) > shift) return std::nullopt;
  return circle;
}

// None where the line turns back about the middle, or an arc leaves it by more than `shift`.
std::optional<Line> arc_along(const Line& line, const Point& middle, double shift) {
  std::vector<double> sweeps{0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point before = line[i - 1] - middle, after = line[i] - middle;
    const double turn = std::atan2(cross(before, after), dot(before, after));
    if (turn == 0 || turn * sweeps.back() < 0) return std::nullopt;
    sweeps.push_back(sweeps.back() + turn);
  }
  const double all = sweeps.back();
  if (std::abs(all) < least_sweep) return std::nullopt;
  const double from = distance(line.front(), middle), to = distance(line.back(), middle);
  const auto radius_at = [&](double share) { return from + (to - from) * share; };
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    if (std::abs(distance(line[i], middle) - radius_at(sweeps[i] / all)) > shift)
      return std::nullopt;
  const double chord = 2 * std::acos(1 - chord_off / std::max(from, to));
  const int count = static_cast<int>(std::ceil(std::abs(all) / chord));
  const Point start = line.front() - middle;
  const double angle = std::atan2(start.y, start.x);
  Line arc{line.front()};
  for (int i = 1; i < count; ++i) {
    const double share = static_cast<double>(i) / count, at = angle + all * share;
    arc.push_back(middle + Point{std::cos(at), std::sin(at), 0} * radius_at(share));
  }
  arc.push_back(line.back());
  return arc;
}

}  // namespace

void round_rings(Network& network, const std::vector<StreetAxis>& axes, double shift) {
  if (shift <= 0) return;
  std::unordered_map<std::int64_t, Circle> circles;
  for (const StreetAxis& axis : axes)
    if (axis.on_ring)
      if (const std::optional<Circle> circle = circle_of(axis, shift))
        circles.emplace(axis.axis_id, *circle);
  if (circles.empty()) return;
  for (Edge& edge : network.edges) {
    const auto circle = circles.find(edge.axis_id);
    if (circle == circles.end()) continue;
    if (std::optional<Line> arc =
            arc_along(distinct(planar(edge.line)), circle->second.centre, shift))
      edge.line = with_heights(std::move(*arc), edge.line);
  }
}

}  // namespace streetgen
