#include "geometry/prepared_surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/box_hierarchy.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

bool cross_deeply(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point u = b - a, v = d - c;
  const double nu = norm(u), nv = norm(v);
  const double o1 = cross(u, c - a), o2 = cross(u, d - a);
  if (o1 * o2 >= 0 || std::min(std::abs(o1), std::abs(o2)) <= same_place * nu) return false;
  const double o3 = cross(v, a - c), o4 = cross(v, b - c);
  return o3 * o4 < 0 && std::min(std::abs(o3), std::abs(o4)) > same_place * nv;
}

// Whether the segment from a to b passes the height of p on its right, or else not there.
bool passes(const Point& p, const Point& a, const Point& b, bool right = true) {
  return (a.y > p.y) != (b.y > p.y) &&
         (p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) == right;
}

}  // namespace

// The segments of a surface's rings.
class PreparedSurface::Boundary {
 public:
  explicit Boundary(const MultiPolygon& surface) {
    std::size_t count = 0;
    for (const Polygon& polygon : surface)
      for (const Ring& ring : polygon) count += ring.size();
    starts_.reserve(count);
    std::vector<Box> boxes;
    boxes.reserve(count + count / 4);
    for (const Polygon& polygon : surface)
      for (const Ring& ring : polygon)
        for (std::size_t i = 1; i < ring.size(); ++i) {
          starts_.push_back(&ring[i - 1]);
          boxes.push_back(streetgen::box_of(ring[i - 1], ring[i]));
          if (i + 1 == ring.size()) ends_.push_back(starts_.size());
        }
    boxes_ = BoxHierarchy(std::move(boxes));
  }

  // Whether the rings pass the height of p an odd number of times on its right, or else on its
  // left.
  bool passes_oddly(const Point& p, const Box& way, bool right) const {
    bool odd = false;
    boxes_.each_but(
        way.grown(same_place),
        [&](std::size_t first, std::size_t end, const Box& all) {
          // All on that side: it passes as odd as it starts and ends on different sides of the
          // height.
          if (right ? all.min_x <= p.x : all.max_x >= p.x) return false;
          if (ends_.size() > 1 && *std::upper_bound(ends_.begin(), ends_.end(), first) < end)
            return false;
          odd ^= (starts_[first][0].y > p.y) != (starts_[end - 1][1].y > p.y);
          return true;
        },
        [&](std::size_t i) { odd ^= passes(p, starts_[i][0], starts_[i][1], right); });
    return odd;
  }

  // Whether `holds` is true of any segment that comes near the box.
  template <class Holds>
  bool any(const Box& within, Holds holds) const {
    return boxes_.any_near(within, same_place, [&](std::size_t i) {
      return holds(starts_[i][0], starts_[i][1], boxes_[i]);
    });
  }

 private:
  std::vector<const Point*> starts_;  // the end of each follows in its ring
  std::vector<std::size_t> ends_;     // of rings
  BoxHierarchy boxes_;
};

PreparedSurface::PreparedSurface(const MultiPolygon& surface)
    : surface_(&surface), box_(streetgen::box_of(surface)) {}
PreparedSurface::PreparedSurface(PreparedSurface&&) noexcept = default;
PreparedSurface::~PreparedSurface() = default;

const PreparedSurface::Boundary& PreparedSurface::boundary() const {
  if (!boundary_) boundary_ = std::make_unique<Boundary>(*surface_);
  return *boundary_;
}

bool PreparedSurface::holds(const Point& p) const {
  if (!box_.holds(p, 0)) return false;
  // Rings pass a height an even number of times: as odd on one side as on the other.
  const bool right = box_.max_x - p.x < p.x - box_.min_x;
  Box way = box_of(p, p);
  (right ? way.max_x : way.min_x) = right ? box_.max_x : box_.min_x;
  return boundary().passes_oddly(p, way, right);
}

bool PreparedSurface::reaches(const Point& p) const { return holds(p) || has_on_boundary(p); }

bool PreparedSurface::has_on_boundary(const Point& p) const {
  return boundary().any(box_of(p, p), [&](const Point& a, const Point& b, const Box&) {
    return distance_to_segment(p, a, b) <= same_place;
  });
}

Box PreparedSurface::box_within(const Box& box) const {
  Box held;
  boundary().any(box, [&](const Point& a, const Point& b, const Box&) {
    double first = 0, last = 1;
    const auto clip = [&](double from, double to, double least, double most) {
      if (from == to) return;
      const double t = (least - from) / (to - from), u = (most - from) / (to - from);
      first = std::max(first, std::min(t, u));
      last = std::min(last, std::max(t, u));
    };
    clip(a.x, b.x, box.min_x, box.max_x);
    clip(a.y, b.y, box.min_y, box.max_y);
    if (first > last) return false;
    held.add(a + (b - a) * first);
    held.add(a + (b - a) * last);
    return false;
  });
  for (const double x : {box.min_x, box.max_x})
    for (const double y : {box.min_y, box.max_y})
      if (holds({x, y, 0})) held.add({x, y, 0});
  return held.grown(same_place).shared_with(box);
}

bool PreparedSurface::comes_near(const Point& from, const Point& to) const {
  const Box box = box_of(from, to);
  if (!box_.meets(box, same_place)) return false;
  return boundary().any(box, [](const Point&, const Point&, const Box&) { return true; }) ||
         holds(from);
}

void PreparedSurface::cut(const Point& from, const Point& to, std::vector<double>& at) const {
  const Point along = to - from;
  const double square = dot(along, along), near = same_place * std::sqrt(square);
  const auto add = [&](double t) {
    if (t > 0 && t < 1) at.push_back(t);
  };
  boundary().any(box_of(from, to), [&](const Point& a, const Point& b, const Box&) {
    const double off_a = cross(along, a - from), off_b = cross(along, b - from);
    const bool touches_a = std::abs(off_a) <= near, touches_b = std::abs(off_b) <= near;
    // Noise tells no side of a vertex on the segment.
    if (touches_a) add(dot(a - from, along) / square);
    if (touches_b) add(dot(b - from, along) / square);
    if (touches_a || touches_b || off_a * off_b > 0) return false;
    add(dot(a + (b - a) * (off_a / (off_a - off_b)) - from, along) / square);
    return false;
  });
}

const Point* PreparedSurface::vertex_at(const Point& place) const {
  const Point* found = nullptr;
  boundary().any(box_of(place, place), [&](const Point& a, const Point&, const Box&) {
    if (distance(a, place) <= same_place) found = &a;
    return found != nullptr;
  });
  return found;
}

bool PreparedSurface::crosses(const PreparedSurface& other, const Box& shared) const {
  return boundary().any(shared, [&](const Point& p, const Point& q, const Box& box) {
    poll_cancel();
    return other.boundary().any(
        box, [&](const Point& r, const Point& s, const Box&) { return cross_deeply(p, q, r, s); });
  });
}

// A vertex, or a place just inside of the boundary, lies inside the other.
bool PreparedSurface::reaches_into(const PreparedSurface& other, const Box& shared) const {
  constexpr double step = 1e-4;
  return boundary().any(shared, [&](const Point& p, const Point& q, const Box&) {
    poll_cancel();
    if (shared.holds(p, 0) && other.holds_deeply(p)) return true;
    if (distance(p, q) <= 20 * step) return false;
    const Point inwards = left_normal(unit(q - p)) * step;
    for (const double t : {0.1, 0.5, 0.9}) {
      const Point place = p + (q - p) * t + inwards;
      if (shared.holds(place, 0) && other.holds_deeply(place)) return true;
    }
    return false;
  });
}

bool inside(const Point& p, const Polygon& polygon) {
  bool odd = false;
  for (const Ring& ring : polygon)
    for (std::size_t i = 1; i < ring.size(); ++i) odd ^= passes(p, ring[i - 1], ring[i]);
  return odd;
}

bool inside(const Point& p, const MultiPolygon& surface) {
  return std::any_of(surface.begin(), surface.end(),
                     [&](const Polygon& polygon) { return inside(p, polygon); });
}

bool overlap(const PreparedSurface& a, const PreparedSurface& b) {
  if (!a.box().meets(b.box())) return false;
  const Box shared = a.box().shared_with(b.box());
  return a.crosses(b, shared) || a.reaches_into(b, shared) || b.reaches_into(a, shared);
}

}  // namespace streetgen
