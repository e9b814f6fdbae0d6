#include "layout/surface_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/closed_ring.hpp"
#include "geometry/offset.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

// Left and right of a segment's end, each as far as its half width.
Line across(const Point& foot, const Point& normal, double left, double right) {
  return {foot + normal * left, foot - normal * right};
}

Polygon disc(const Point& centre, double radius) {
  Ring ring;
  for (int i = 0; i <= 4 * join_quarter; ++i) {
    const double angle = 2 * M_PI * (i % (4 * join_quarter)) / (4 * join_quarter);
    ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle), 0});
  }
  return {ring};
}

// The ring's vertex nearest to p moves there, or p becomes one on the nearest segment; false where
// the ring comes nowhere near.
bool pass_through(Ring& ring, const Point& p) {
  std::size_t vertex = 0, segment = 0;
  double to_vertex = distance(ring[0], p), to_segment = infinite;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    if (const double off = distance(ring[i], p); off < to_vertex) {
      to_vertex = off;
      vertex = i;
    }
    if (const double off = distance_to_segment(p, ring[i - 1], ring[i]); off < to_segment) {
      to_segment = off;
      segment = i;
    }
  }
  if (to_vertex <= same_place) {
    ring[vertex] = p;
    if (vertex == 0 || vertex + 1 == ring.size()) ring.front() = ring.back() = p;
    return true;
  }
  if (to_segment > same_place) return false;
  ring.insert(ring.begin() + segment, p);
  return true;
}

}  // namespace

Polygon fan(const Point& centre, const Point& from, const Point& to) {
  Ring ring{centre, from};
  append_arc(ring, centre, from, to, true, join_quarter);
  ring.push_back(to);
  return {closed(std::move(ring))};
}

MultiPolygon pieces(const Line& line, const std::vector<double>& left,
                    const std::vector<double>& right, const Line& from, const Line& to) {
  MultiPolygon out;
  const auto add = [&](Polygon polygon) {
    if (!polygon.front().empty()) out.push_back(std::move(polygon));
  };
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point normal = left_normal(unit(line[i] - line[i - 1]));
    const bool last = i + 1 == line.size();
    const Line start =
        i == 1 && !from.empty() ? from : across(line[i - 1], normal, left[i - 1], right[i - 1]);
    const Line end = last && !to.empty() ? to : across(line[i], normal, left[i], right[i]);
    // The axis points are part of the ring, so that fans and quads share whole edges.
    add({closed({start[0], line[i - 1], start[1], end[1], line[i], end[0]})});
    if (last) break;
    const Point next = left_normal(unit(line[i + 1] - line[i]));
    const double turn = cross(normal, next);
    if (std::abs(turn) < 1e-12 && dot(normal, next) > 0) continue;
    if (turn > 0)
      add(fan(line[i], end[1], line[i] - next * right[i]));
    else
      add(fan(line[i], line[i] + next * left[i], end[0]));
  }
  return out;
}

MultiPolygon ending_on(Geos& geos, MultiPolygon surface, const std::vector<Line>& borders) {
  MultiPolygon moved = surface;
  std::vector<Ring*> rings;
  for (Polygon& polygon : moved)
    for (Ring& ring : polygon) rings.push_back(&ring);
  for (const Line& border : borders)
    for (const Point& end : border)
      for (Ring* ring : rings)
        if (pass_through(*ring, end)) break;
  return same(moved, surface) || !geos.valid(moved) ? surface : moved;
}

MultiPolygon build_buffer(Geos& geos, const Line& line, const std::vector<double>& left,
                          const std::vector<double>& right, bool round_ends) {
  MultiPolygon all = pieces(line, left, right, {}, {});
  if (round_ends) {
    all.push_back(disc(line.front(), std::max(left.front(), right.front())));
    all.push_back(disc(line.back(), std::max(left.back(), right.back())));
  }
  return geos.polygons(geos.unite({all}).get());
}

MultiPolygon build_between(Geos& geos, const Line& line, const std::vector<double>& left,
                           const std::vector<double>& right, const Line& from, const Line& to) {
  const MultiPolygon parts = pieces(line, left, right, from, to);
  return ending_on(geos, geos.polygons(geos.unite({parts}).get()), {from, to});
}

}  // namespace streetgen
