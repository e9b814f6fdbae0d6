// The search of a path, layer by layer, and the curves at its vertices.
#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/polyline.hpp"
#include "streetgen/error.hpp"
#include "streetgen/road_design.hpp"
#include "terrain/search_layer.hpp"
#include "terrain/settle_vertices.hpp"

namespace streetgen {
namespace {

constexpr int corridor_cells = 8;
// Cells of the first layer between both ends, so that it stays small.
constexpr double coarse_cells = 60;
constexpr int most_layers = 3;
constexpr double least_cell = 8;
// No curve is wider than so many times the wanted radius.
constexpr double widest = 10;

// The finest cell: turns need room on a few cells, and the ground shows no more.
double finest_cell(const DesignRules& rules) {
  return std::max(least_cell, std::min(rules.radius, 10 * std::sqrt(rules.radius)));
}

SearchGrid grid_between(const Point& a, const Point& b, double cell) {
  SearchGrid grid;
  const double span = distance(planar(a), planar(b));
  grid.origin = planar(a);
  grid.along = unit(planar(b) - planar(a));
  grid.last = std::max(1, static_cast<int>(std::round(span / cell)));
  grid.cell = span / grid.last;
  grid.margin_x = grid.last / 4 + 8;
  grid.margin_y = grid.last / 2 + 10;
  return grid;
}

SearchGrid halved(SearchGrid grid) {
  grid.cell /= 2;
  grid.last *= 2;
  grid.margin_x *= 2;
  grid.margin_y *= 2;
  return grid;
}

// Cells within eight of the former path.
std::vector<bool> corridor_along(const SearchGrid& grid, const Line& path) {
  std::vector<bool> corridor(static_cast<std::size_t>(grid.columns()) * grid.rows(), false);
  const Point across = left_normal(grid.along);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double span = distance(planar(path[i - 1]), planar(path[i]));
    const int parts = std::max(1, static_cast<int>(std::ceil(span / grid.cell)));
    for (int k = 0; k <= parts; ++k) {
      const Point p = path[i - 1] + (path[i] - path[i - 1]) * (static_cast<double>(k) / parts);
      const Point d = planar(p - grid.origin);
      const int column =
          static_cast<int>(std::round(dot(d, grid.along) / grid.cell)) + grid.margin_x;
      const int row = static_cast<int>(std::round(dot(d, across) / grid.cell)) + grid.margin_y;
      for (int y = std::max(0, row - corridor_cells);
           y <= std::min(grid.rows() - 1, row + corridor_cells); ++y)
        for (int x = std::max(0, column - corridor_cells);
             x <= std::min(grid.columns() - 1, column + corridor_cells); ++x)
          corridor[static_cast<std::size_t>(y) * grid.columns() + x] = true;
    }
  }
  return corridor;
}

struct FoundLine {
  std::optional<Line> line;
  double cell = 0;  // of the grid that the line lies on
};

// The finest layer that has a way: a layer may find none where the coarser one did.
FoundLine search_layers(const DesignSite& site, const Point& a, const Point& b,
                        const std::optional<ArrivingSide>& arriving, Waiver waiver) {
  const double span = distance(planar(a), planar(b)), finest = finest_cell(site.rules);
  int layers = 1;
  while (layers < most_layers && span / (finest * (1 << layers)) > coarse_cells / 2) ++layers;
  double first = finest * (1 << (layers - 1));
  SearchGrid grid = grid_between(a, b, first);
  FoundLine found;
  for (int layer = 0; layer < layers; ++layer) {
    std::vector<bool> corridor;
    if (found.line) corridor = corridor_along(grid, *found.line);
    auto line = SearchLayer(site, grid, std::move(corridor), waiver).search(arriving);
    if (line) found = {std::move(line), grid.cell};
    if (layer + 1 < layers) grid = halved(grid);
    // Without a coarse way the fine grid is searched whole, once.
    if (!found.line && layer + 1 < layers) {
      while (layer + 2 < layers) grid = halved(grid), ++layer;
    }
  }
  return found;
}

Barrier barrier_between(const DesignSite& site, const Point& a, const Point& b,
                        const std::optional<ArrivingSide>& arriving) {
  for (const Point& p : {a, b})
    if (std::isnan(site.terrain.ground(p.x, p.y).height)) return Barrier::terrain;
  const double cell =
      std::max(finest_cell(site.rules), distance(planar(a), planar(b)) / coarse_cells);
  const SearchGrid grid = grid_between(a, b, cell);
  if (SearchLayer(site, grid, {}, {true, false}).search(arriving)) return Barrier::zone;
  if (SearchLayer(site, grid, {}, {true, true}).search(arriving)) return Barrier::grade;
  return SearchLayer(site, grid, {}, {true, true}).search({}) ? Barrier::turn : Barrier::terrain;
}

std::optional<ArrivingSide> arriving_side(const std::vector<PathVertex>& path) {
  if (path.size() < 2) return {};
  const Point side = planar(path.back().point - path[path.size() - 2].point);
  return ArrivingSide{std::atan2(side.y, side.x), norm(side)};
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
      const auto arriving = arriving_side(path.vertices);
      const FoundLine found = search_layers(site, a, b, arriving, {});
      if (!found.line) return {{}, barrier_between(site, a, b, arriving)};
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
  // Where two curves overlap on a side, wide ones shrink; two least ones both shrink until they
  // fit.
  for (int pass = 0; pass < 200; ++pass) {
    bool fit = true;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double side = distance(planar(line[i - 1]), planar(line[i]));
      const double before = curve_shape(turns[i - 1], curves[i - 1]).tangent_out;
      const double after = curve_shape(turns[i], curves[i]).tangent_in;
      if (before + after <= side) continue;
      fit = false;
      const double share = side / (before + after) * 0.999;
      const bool wide = shrinks(i - 1) || shrinks(i);
      for (std::size_t k : {i - 1, i}) {
        if (given[k].radius > 0 || (wide && !shrinks(k))) continue;
        const double radius = curves[k].radius * share;
        curves[k] = scaled(wide ? std::max(radius, rules.radius) : radius);
      }
    }
    if (fit) break;
  }
  return curves;
}

}  // namespace streetgen
