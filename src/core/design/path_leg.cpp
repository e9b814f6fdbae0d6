// The search of a leg, layer by layer, and the choice of a leg without a loop.
#include "design/path_leg.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"

namespace streetgen {
namespace {

constexpr int corridor_cells = 8;
// Cells of the first layer between both ends, so that it stays small.
constexpr double coarse_cells = 60;
constexpr int most_layers = 3;
constexpr double least_cell = 8;
// A leg that winds by so much more than the straight side goes a long way about.
constexpr double loop_turn = M_PI / 2;

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

// The finest layer that has a way: a layer may find none where the coarser one did.
PathLeg search_layers(const DesignSite& site, const Point& a, const Point& b,
                      const SidesAbout& about) {
  const double span = distance(planar(a), planar(b)), finest = finest_cell(site.rules);
  int layers = 1;
  while (layers < most_layers && span / (finest * (1 << layers)) > coarse_cells / 2) ++layers;
  double first = finest * (1 << (layers - 1));
  SearchGrid grid = grid_between(a, b, first);
  PathLeg found;
  for (int layer = 0; layer < layers; ++layer) {
    std::vector<bool> corridor;
    if (found.line) corridor = corridor_along(grid, *found.line);
    auto line = SearchLayer(site, grid, std::move(corridor), {}).search(about);
    if (line) found = {std::move(line), grid.cell, Barrier::none};
    if (layer + 1 < layers) grid = halved(grid);
    // Without a coarse way the fine grid is searched whole, once.
    if (!found.line && layer + 1 < layers) {
      while (layer + 2 < layers) grid = halved(grid), ++layer;
    }
  }
  return found;
}

Barrier barrier_between(const DesignSite& site, const Point& a, const Point& b) {
  for (const Point& p : {a, b})
    if (std::isnan(site.terrain.ground(p.x, p.y).height)) return Barrier::terrain;
  const double cell =
      std::max(finest_cell(site.rules), distance(planar(a), planar(b)) / coarse_cells);
  const SearchGrid grid = grid_between(a, b, cell);
  if (SearchLayer(site, grid, {}, {true, false}).search({})) return Barrier::zone;
  return SearchLayer(site, grid, {}, {true, true}).search({}) ? Barrier::grade : Barrier::terrain;
}

// The greatest turn to one side between any two of the sides, those about the line included.
double winding(const Line& line, const SidesAbout& about) {
  std::vector<double> headings;
  if (about.before) headings.push_back(about.before->heading);
  for (std::size_t i = 1; i < line.size(); ++i)
    headings.push_back(std::atan2(line[i].y - line[i - 1].y, line[i].x - line[i - 1].x));
  if (about.behind) headings.push_back(about.behind->heading);
  double left = 0, right = 0, most = 0;
  for (std::size_t i = 1; i < headings.size(); ++i) {
    const double turn = std::remainder(headings[i] - headings[i - 1], 2 * M_PI);
    left = std::max(0.0, left + turn);
    right = std::max(0.0, right - turn);
    most = std::max({most, left, right});
  }
  return most;
}

// Sides that meet at their ends do not cross.
bool sides_cross(const PathSide& p, const PathSide& q) {
  const auto at = crossing(p.from, p.to, q.from, q.to);
  if (!at) return false;
  const auto ends_there = [&](const PathSide& side) {
    return std::min(distance(*at, planar(side.from)), distance(*at, planar(side.to))) < 1e-6;
  };
  return !ends_there(p) || !ends_there(q);
}

// Whether the line crosses itself, or one of the others that the straight side does not cross.
bool ties_knot(const Line& line, const std::vector<PathSide>& others) {
  const PathSide straight{line.front(), line.back()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const PathSide side{line[i - 1], line[i]};
    for (std::size_t k = i + 2; k < line.size(); ++k)
      if (sides_cross(side, {line[k - 1], line[k]})) return true;
    for (const PathSide& other : others)
      if (sides_cross(side, other) && !sides_cross(straight, other)) return true;
  }
  return false;
}

}  // namespace

PathLeg find_leg(const DesignSite& site, const Point& a, const Point& b, const SidesAbout& about,
                 const std::vector<PathSide>& others) {
  const bool alone = !about.before && !about.behind;
  PathLeg found = search_layers(site, a, b, about);
  if (alone && !found.line) return {{}, 0, barrier_between(site, a, b)};
  if (found.line && !ties_knot(*found.line, others) &&
      (alone || winding(*found.line, about) <= winding({a, b}, about) + loop_turn))
    return found;
  if (!alone) return find_leg(site, a, b, {}, others);
  return site.zones.bars(a, b) ? PathLeg{{}, 0, Barrier::turn} : PathLeg{Line{a, b}};
}

}  // namespace streetgen
