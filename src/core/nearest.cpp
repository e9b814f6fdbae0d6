#include "nearest.hpp"

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>
#include <set>

#include "overlap.hpp"
#include "polyline.hpp"
#include "ring.hpp"

namespace streetgen {

namespace {

using Diagram = boost::polygon::voronoi_diagram<double>;
using Edge = Diagram::edge_type;
using Cross = boost::polygon::point_data<std::int32_t>;

constexpr double finest = 1e-5;  // metres; the grid that sites are placed on

// Rings of the boundary, with the chosen cells on their left.
template <class Chosen>
std::vector<Ring> boundary(const Diagram& diagram, Chosen chosen) {
  const auto bounds = [&](const Edge& edge) {
    return chosen(*edge.cell()) && !chosen(*edge.twin()->cell());
  };
  std::vector<Ring> rings;
  std::set<const Edge*> walked;
  for (const Edge& start : diagram.edges()) {
    if (!bounds(start) || walked.count(&start) > 0) continue;
    Ring ring;
    for (const Edge* edge = &start; walked.insert(edge).second;) {
      ring.push_back({edge->vertex0()->x(), edge->vertex0()->y(), 0});
      edge = edge->next();
      while (!bounds(*edge)) edge = edge->twin()->next();
    }
    ring.push_back(ring.front());
    rings.push_back(std::move(ring));
  }
  return rings;
}

MultiPolygon polygons_of(std::vector<Ring> rings) {
  MultiPolygon out;
  for (Ring& ring : rings)
    if (signed_area(ring) > 0) out.push_back({std::move(ring)});
  std::sort(out.begin(), out.end(), [](const Polygon& a, const Polygon& b) {
    return signed_area(a.front()) < signed_area(b.front());
  });
  const std::size_t shells = out.size();
  for (Ring& ring : rings)
    if (!ring.empty() && signed_area(ring) < 0) {
      const Point inner = (ring[0] + ring[1]) * 0.5;
      for (std::size_t i = 0; i < shells; ++i)
        if (inside(inner, {out[i].front()})) {
          out[i].push_back(std::move(ring));
          break;
        }
    }
  return out;
}

}  // namespace

MultiPolygon nearest_to_first(const std::vector<Site>& sites, double far) {
  Box box;
  for (const Site& site : sites) box.add(site.point);
  const double reach = 4 * (far + box.max_x - box.min_x + box.max_y - box.min_y);
  const double grid = std::max(finest, reach / 1e9);
  const Point origin{std::round(box.min_x), std::round(box.min_y), 0};
  std::vector<Cross> places;
  std::vector<bool> first;
  std::set<std::pair<std::int32_t, std::int32_t>> taken;
  const auto place = [&](const Point& p, bool is_first) {
    const auto x = static_cast<std::int32_t>(std::llround((p.x - origin.x) / grid));
    const auto y = static_cast<std::int32_t>(std::llround((p.y - origin.y) / grid));
    if (!taken.emplace(x, y).second) return;
    places.emplace_back(x, y);
    first.push_back(is_first);
  };
  for (const Site& site : sites) place(site.point, site.first);
  // Four far sites of the other owner bound every cell.
  const Point middle{(box.min_x + box.max_x) / 2, (box.min_y + box.max_y) / 2, 0};
  for (const Point& away :
       {Point{reach, 0, 0}, Point{-reach, 0, 0}, Point{0, reach, 0}, Point{0, -reach, 0}})
    place(middle + away, false);
  Diagram diagram;
  boost::polygon::construct_voronoi(places.begin(), places.end(), &diagram);
  std::vector<Ring> rings =
      boundary(diagram, [&](const Diagram::cell_type& cell) { return first[cell.source_index()]; });
  for (Ring& ring : rings) {
    for (Point& p : ring) p = origin + p * grid;
    ring = closed(std::move(ring));
  }
  return polygons_of(std::move(rings));
}

}  // namespace streetgen
