#include "geometry/surface_union.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "geometry/arrangement.hpp"
#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

// So many parts of a node with ordinary streets meet few others; more about one point all meet, and
// their borders cross as often as there are pairs of them.
constexpr std::size_t at_once = 64;

// Parts that share a vertex may differ there by noise, and would leave a crack: each vertex lies
// where the first one near it does.
std::vector<MultiPolygon> on_common_vertices(const std::vector<MultiPolygon>& parts) {
  std::vector<MultiPolygon> moved = parts;
  std::vector<std::pair<Point*, int>> order;  // by x, with their places among all
  for (MultiPolygon& part : moved)
    for (Polygon& polygon : part)
      for (Ring& ring : polygon)
        for (Point& p : ring) order.emplace_back(&p, static_cast<int>(order.size()));
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
    return std::tie(a.first->x, a.second) < std::tie(b.first->x, b.second);
  });
  std::vector<Point> before;
  before.reserve(order.size());
  for (const auto& [p, place] : order) before.push_back(*p);
  for (std::size_t k = 0; k < order.size(); ++k) {
    int first = order[k].second;
    const auto look = [&](std::size_t l) {
      if (order[l].second >= first || distance(before[l], before[k]) > same_place) return;
      first = order[l].second;
      *order[k].first = before[l];
    };
    for (std::size_t l = k; l-- > 0 && before[k].x - before[l].x <= same_place;) look(l);
    for (std::size_t l = k + 1; l < order.size() && before[l].x - before[k].x <= same_place; ++l)
      look(l);
  }
  return moved;
}

// Parts that share a side from different ends would leave a crack along it: each side passes the
// vertices that lie on it.
std::vector<MultiPolygon> on_common_sides(std::vector<MultiPolygon> parts) {
  std::vector<Point> vertices;
  std::vector<Box> boxes;
  for (const MultiPolygon& part : parts)
    for (const Polygon& polygon : part)
      for (const Ring& ring : polygon)
        for (std::size_t i = 1; i < ring.size(); ++i) {
          vertices.push_back(ring[i]);
          boxes.push_back(box_of(ring[i], ring[i]));
        }
  const BoxIndex index(boxes);
  const auto pass = [&](const Point& from, const Point& to, Ring& ring) {
    std::vector<std::pair<double, Point>> passed;
    for (const int i : index.near(box_of(from, to), same_place)) {
      const Point& p = vertices[i];
      if (distance_to_segment(p, from, to) <= same_place &&
          std::min(distance(p, from), distance(p, to)) > same_place)
        passed.emplace_back(dot(p - from, to - from), p);
    }
    std::sort(passed.begin(), passed.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [along, p] : passed)
      if (distance(p, ring.back()) > same_place) ring.push_back(p);
    ring.push_back(to);
  };
  for (MultiPolygon& part : parts)
    for (Polygon& polygon : part)
      for (Ring& ring : polygon) {
        Ring passing{ring.front()};
        for (std::size_t i = 1; i < ring.size(); ++i) pass(ring[i - 1], ring[i], passing);
        ring = std::move(passing);
      }
  return parts;
}

MultiPolygon united_faces(Geos& geos, const std::vector<MultiPolygon>& parts) {
  if (parts.size() > at_once) {
    const auto middle = parts.begin() + parts.size() / 2;
    return united_faces(geos, {united_faces(geos, {parts.begin(), middle}),
                               united_faces(geos, {middle, parts.end()})});
  }
  std::vector<LineView> lines;
  for (const MultiPolygon& part : parts)
    for (const Polygon& polygon : part) lines.insert(lines.end(), polygon.begin(), polygon.end());
  const Arrangement faces(lines);
  std::vector<bool> kept;
  for (const Point& place : faces.places()) {
    poll_cancel();
    kept.push_back(std::any_of(parts.begin(), parts.end(),
                               [&](const MultiPolygon& part) { return inside(place, part); }));
  }
  const MultiPolygon joined = faces.joined(kept);
  return geos.valid(joined) ? joined : faces.joined(kept, Arrangement::Vertices::on_grid);
}

}  // namespace

MultiPolygon united(Geos& geos, const std::vector<MultiPolygon>& parts) {
  return united_as_they_lie(geos, on_common_vertices(parts));
}

MultiPolygon united_as_they_lie(Geos& geos, const std::vector<MultiPolygon>& parts) {
  return united_faces(geos, on_common_sides(parts));
}

}  // namespace streetgen
