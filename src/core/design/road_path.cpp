// The path of a road, leg by leg, and the curves at its vertices.
#include <algorithm>
#include <cmath>

#include "design/path_leg.hpp"
#include "design/settle_vertices.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "streetgen/road_design.hpp"

namespace streetgen {
namespace {

// No curve is wider than so many times the wanted radius.
constexpr double widest = 10;
constexpr double least_radius = 0.01;  // metres; a tighter curve is a kink

std::optional<SidesAbout::Side> side_between(const Point& a, const Point& b) {
  return SidesAbout::Side{std::atan2(b.y - a.y, b.x - a.x), distance(planar(a), planar(b))};
}

// The sides that the leg to place i keeps clear of: those of the path so far, and those to come.
std::vector<PathSide> other_sides(const std::vector<PathVertex>& path, const Line& places,
                                  std::size_t i) {
  std::vector<PathSide> sides;
  for (std::size_t k = 1; k < path.size(); ++k) sides.push_back({path[k - 1].point, path[k].point});
  for (std::size_t k = i + 1; k < places.size(); ++k) sides.push_back({places[k - 1], places[k]});
  return sides;
}

}  // namespace

RoadPath road_path(const DesignSite& site, const Line& places, const std::vector<bool>& straight) {
  RoadPath path;
  if (places.size() < 2) throw Error(ErrorKind::degenerate, "a road needs two places");
  const auto on_ground = [&](Point p) {
    p.z = site.terrain.ground(p.x, p.y).height;
    return p;
  };
  double cell = 0;
  path.vertices.push_back({on_ground(places[0]), true});
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Point &a = places[i - 1], &b = places[i];
    if (distance(planar(a), planar(b)) < 1e-3)
      throw Error(ErrorKind::degenerate,
                  "two places of a road are one: " + text_of(a.x) + " " + text_of(a.y),
                  "Move one of them, or delete it.");
    if (!straight[i]) {
      SidesAbout about;
      if (const std::size_t n = path.vertices.size(); n > 1)
        about.before = side_between(path.vertices[n - 2].point, path.vertices[n - 1].point);
      if (i + 1 < places.size() && straight[i + 1]) about.behind = side_between(b, places[i + 1]);
      const PathLeg found = find_leg(site, a, b, about, other_sides(path.vertices, places, i));
      if (!found.line) return {{}, found.barrier};
      cell = std::max(cell, found.cell);
      for (std::size_t k = 1; k + 1 < found.line->size(); ++k)
        path.vertices.push_back({(*found.line)[k], false});
    }
    path.vertices.push_back({on_ground(b), true});
  }
  if (cell > 0) settle_vertices(site, cell, path.vertices);
  return path;
}

std::vector<VertexCurve> road_curves(const DesignRules& rules, const Line& line,
                                     const std::vector<VertexCurve>& given) {
  std::vector<VertexCurve> curves(line.size());
  const double wanted = std::max(rules.curve_radius, rules.radius);
  std::vector<double> turns(line.size(), 0);
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const Point a = planar(line[i] - line[i - 1]), b = planar(line[i + 1] - line[i]);
    turns[i] = std::abs(std::atan2(cross(a, b), dot(a, b)));
  }
  const auto scaled = [&](double radius) {
    const double clothoid = rules.clothoid * std::sqrt(radius / rules.radius);
    return VertexCurve{radius, clothoid, clothoid};
  };
  const auto room_at = [&](std::size_t i) {
    return std::min(distance(planar(line[i]), planar(line[i - 1])),
                    distance(planar(line[i + 1]), planar(line[i])));
  };
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    if (given[i].radius > 0) {
      curves[i] = given[i];
      continue;
    }
    if (turns[i] < 1e-6) continue;
    // A slight turn gets a wide curve, so that it has an arc between its clothoids.
    const double slight = rules.clothoid * rules.clothoid / rules.radius / turns[i];
    double radius = std::max(wanted, std::min(slight, widest * wanted));
    while (radius > rules.radius &&
           curve_shape(turns[i], scaled(radius)).tangent_in > 0.49 * room_at(i))
      radius = std::max(rules.radius, radius * 0.9);
    curves[i] = scaled(radius);
  }
  const auto shrinks = [&](std::size_t i) {
    return given[i].radius <= 0 && curves[i].radius > rules.radius * (1 + 1e-9);
  };
  // Wide curves shrink where two overlap on a side; two least ones both shrink until they
  // fit. Each pass shrinks one by a thousandth at least; below a centimetre none has a curve.
  for (bool fit = false; !fit;) {
    poll_cancel();
    fit = true;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double side = distance(planar(line[i - 1]), planar(line[i]));
      const double before = curve_shape(turns[i - 1], curves[i - 1]).tangent_out;
      const double after = curve_shape(turns[i], curves[i]).tangent_in;
      if (before + after <= side) continue;
      const double share = side / (before + after) * 0.999;
      const bool wide = shrinks(i - 1) || shrinks(i);
      for (std::size_t k : {i - 1, i}) {
        if (given[k].radius > 0 || (wide && !shrinks(k))) continue;
        const double radius = curves[k].radius * share;
        if (!(radius > 0)) continue;
        curves[k] = radius < least_radius ? VertexCurve{}
                                          : scaled(wide ? std::max(radius, rules.radius) : radius);
        fit = false;
      }
    }
    if (fit) break;
  }
  return curves;
}

}  // namespace streetgen
