#include "geometry/ring_simplicity.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double onwards = 0.01;  // cosine: a way that turns more may go back

struct RingSide {
  Point from, to, along;
  Box box;
  std::size_t place;     // along the rings, one after the other
  std::size_t follower;  // the place of the next one of its ring
};

// How far p lies left of the line of a side.
double left_of(const RingSide& side, const Point& p) { return cross(side.along, p - side.from); }

bool same_side(double a, double b) {
  return std::min(a, b) > sides_touch || std::max(a, b) < -sides_touch;
}

std::optional<bool> keep_apart(const RingSide& s, const RingSide& t) {
  const double t_from = left_of(s, t.from), t_to = left_of(s, t.to);
  if (same_side(t_from, t_to)) return true;
  const double s_from = left_of(t, s.from), s_to = left_of(t, s.to);
  if (same_side(s_from, s_to)) return true;
  if (same_side(t_from, -t_to) && same_side(s_from, -s_to)) return false;
  return std::nullopt;
}

// Of a side and the next: they turn, and not back.
bool turn(const RingSide& s, const RingSide& t) {
  return std::abs(left_of(s, t.to)) > sides_touch || dot(s.along, t.along) > 0;
}

// Whether t comes after the side that follows s, and all go on one way, so that however short that
// side is, no two of them meet but at their ends.
bool one_way(const std::vector<RingSide>& sides, const RingSide& s, const RingSide& t) {
  const RingSide& between = sides[s.follower];
  return between.follower == t.place && dot(s.along, between.along) > onwards &&
         dot(s.along, t.along) > onwards;
}

}  // namespace

std::optional<bool> simple(const MultiPolygon& surface) {
  std::vector<RingSide> sides;
  std::size_t count = 0;
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon) count += ring.size();
  sides.reserve(count);
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon) {
      const std::size_t first = sides.size();
      for (std::size_t i = 1; i < ring.size(); ++i)
        sides.push_back({ring[i - 1], ring[i], unit(ring[i] - ring[i - 1]),
                         box_of(ring[i - 1], ring[i]), sides.size(),
                         i + 1 < ring.size() ? sides.size() + 1 : first});
    }
  std::vector<std::pair<double, const RingSide*>> order;  // by their least x
  order.reserve(count);
  for (const RingSide& side : sides) order.emplace_back(side.box.min_x, &side);
  std::sort(order.begin(), order.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  struct Active {
    double max_x, min_y, max_y;
    const RingSide* side;
  };
  std::vector<Active> active;
  active.reserve(16);
  bool clear = true;
  for (const auto& [min_x, s] : order) {
    poll_cancel();
    const double low = s->box.min_y - sides_touch, high = s->box.max_y + sides_touch;
    for (std::size_t k = 0; k < active.size();) {
      if (active[k].max_x < min_x - sides_touch) {
        active[k] = active.back();
        active.pop_back();
        continue;
      }
      const Active& other = active[k++];
      if (other.min_y > high || other.max_y < low) continue;
      const RingSide* t = other.side;
      if (s->follower == t->place || t->follower == s->place) {
        clear = clear && (s->follower == t->place ? turn(*s, *t) : turn(*t, *s));
        continue;
      }
      const std::optional<bool> kept_apart = keep_apart(*s, *t);
      if (!kept_apart.value_or(true)) return false;
      clear = clear && (kept_apart || one_way(sides, *s, *t) || one_way(sides, *t, *s));
    }
    active.push_back({s->box.max_x, s->box.min_y, s->box.max_y, s});
  }
  return clear ? std::optional(true) : std::nullopt;
}

}  // namespace streetgen
