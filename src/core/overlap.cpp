#include "overlap.hpp"

#include <cmath>

#include "polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double depth = 1e-6;

double distance_to_boundary(const Point& p, const Polygon& polygon) {
  double best = std::numeric_limits<double>::infinity();
  for (const Ring& ring : polygon) best = std::min(best, distance_to_line(p, ring));
  return best;
}

bool deep_inside(const Point& p, const MultiPolygon& surface) {
  for (const Polygon& polygon : surface)
    if (inside(p, polygon)) return distance_to_boundary(p, polygon) > depth;
  return false;
}

bool cross_deeply(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point u = b - a, v = d - c;
  const double nu = norm(u), nv = norm(v);
  const double o1 = cross(u, c - a), o2 = cross(u, d - a);
  if (o1 * o2 >= 0 || std::min(std::abs(o1), std::abs(o2)) <= depth * nu) return false;
  const double o3 = cross(v, a - c), o4 = cross(v, b - c);
  return o3 * o4 < 0 && std::min(std::abs(o3), std::abs(o4)) > depth * nv;
}

template <class Use>
bool any_segment(const MultiPolygon& surface, const Box& within, Use use) {
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon)
      for (std::size_t i = 1; i < ring.size(); ++i) {
        Box box;
        box.add(ring[i - 1]);
        box.add(ring[i]);
        if (box.meets(within, depth) && use(ring[i - 1], ring[i], box)) return true;
      }
  return false;
}

// A vertex of a, or a place just inside one of its edges, lies inside b.
bool reaches_into(const MultiPolygon& a, const MultiPolygon& b, const Box& shared) {
  constexpr double step = 1e-4;
  return any_segment(a, shared, [&](const Point& p, const Point& q, const Box&) {
    poll_cancel();
    if (shared.holds(p, 0) && deep_inside(p, b)) return true;
    if (distance(p, q) <= 20 * step) return false;
    const Point inwards = left_normal(unit(q - p)) * step;
    for (const double t : {0.1, 0.5, 0.9}) {
      const Point place = p + (q - p) * t + inwards;
      if (shared.holds(place, 0) && deep_inside(place, b)) return true;
    }
    return false;
  });
}

}  // namespace

Box box_of(const MultiPolygon& surface) {
  Box box;
  for (const Polygon& polygon : surface)
    for (const Point& p : polygon.front()) box.add(p);
  return box;
}

bool inside(const Point& p, const Polygon& polygon) {
  bool odd = false;
  for (const Ring& ring : polygon)
    for (std::size_t i = 1; i < ring.size(); ++i) {
      const Point &a = ring[i - 1], &b = ring[i];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
        odd = !odd;
    }
  return odd;
}

bool overlap(const MultiPolygon& a, const MultiPolygon& b) {
  const Box box_a = box_of(a), box_b = box_of(b);
  if (!box_a.meets(box_b, 0)) return false;
  Box shared;
  shared.min_x = std::max(box_a.min_x, box_b.min_x);
  shared.min_y = std::max(box_a.min_y, box_b.min_y);
  shared.max_x = std::min(box_a.max_x, box_b.max_x);
  shared.max_y = std::min(box_a.max_y, box_b.max_y);
  const bool crossing = any_segment(a, shared, [&](const Point& p, const Point& q, const Box& box) {
    return any_segment(b, box, [&](const Point& r, const Point& s, const Box&) {
      return cross_deeply(p, q, r, s);
    });
  });
  return crossing || reaches_into(a, b, shared) || reaches_into(b, a, shared);
}

}  // namespace streetgen
