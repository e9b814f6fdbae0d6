#include "roadway/island.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/box.hpp"
#include "geometry/closed_ring.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/tolerance.hpp"
#include "layout/surface_ring.hpp"
#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

constexpr double least_room = 1;     // metres, the radius of a disc
constexpr double fine_enough = 0.2;  // metres between places that are tried
constexpr double most_paved = 0.15;  // of the ground between the kerbs

// Axes of a face's own, so that what is tried on it turns with it.
struct Frame {
  Point origin, along;

  Point seen(const Point& p) const { return {dot(p - origin, along), cross(along, p - origin), 0}; }
  Point place(const Point& p) const { return origin + along * p.x + left_normal(along) * p.y; }
};

// Along the greatest spread of the ring; of one as wide in all directions along its longest side.
Frame frame_of(const Ring& ring) {
  constexpr double as_wide = 1e-6;
  Frame frame{ring.front(), {1, 0, 0}};
  double all = 0, longest = 0;
  Point sum;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const Point side = ring[i] - ring[i - 1];
    const double size = norm(side);
    all += size;
    sum = sum + ((ring[i] + ring[i - 1]) * 0.5 - ring.front()) * size;
    if (size <= longest + same_place) continue;
    longest = size;
    frame.along = unit(side);
  }
  frame.origin = ring.front() + sum * (1 / all);
  double apart = 0, twice = 0, spread = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const Point off = (ring[i] + ring[i - 1]) * 0.5 - frame.origin;
    const double size = distance(ring[i], ring[i - 1]);
    apart += (off.x * off.x - off.y * off.y) * size;
    twice += 2 * off.x * off.y * size;
    spread += dot(off, off) * size;
  }
  if (std::hypot(apart, twice) < as_wide * spread) return frame;
  const double angle = std::atan2(twice, apart) / 2;
  frame.along = {std::cos(angle), std::sin(angle), 0};
  return frame;
}

class Islands {
 public:
  Islands(const Layout& layout, const SolvedCorners& corners)
      : layout_(layout), corners_(corners) {}

  bool swallowed(const StreetFace& face) const {
    const Ring ring = ring_of(layout_, face);
    const Frame frame = frame_of(ring);
    Box box;
    for (const Point& p : ring) box.add(frame.seen(p));
    if (!has_room(face, {ring}, {}, frame, box)) return false;
    const KerbCrossings crossings = kerb_crossings(layout_, face);
    const std::vector<Polygon> paved = fillets(face, crossings);
    if (paved.empty()) return false;
    if (!has_room(face, {ring}, paved, frame, box)) return true;
    const double ground = ground_within(face, crossings);
    return ground > 0 && area_of(paved) > most_paved * ground;
  }

  bool leave_hole(const StreetFace& face) const {
    const KerbCrossings crossings = kerb_crossings(layout_, face);
    const double ground = ground_within(face, crossings);
    return ground > 0 &&
           ground - area_of(fillets(face, crossings)) < layout_.settings.least_island();
  }

 private:
  double half_of(const FaceSide& side) const {
    const Arm& arm = layout_.arm(side.end);
    return std::max(arm.start_to(+1), arm.end_to(+1));
  }

  static double area_of(const std::vector<Polygon>& fillets) {
    double all = 0;
    for (const Polygon& fillet : fillets) all += std::abs(signed_area(fillet.front()));
    return all;
  }

  // The area between the kerbs, from crossing to crossing; 0 where kerbs leave none.  Along a side
  // whose crossings pass each other the kerb leads back.
  double ground_within(const StreetFace& face, const KerbCrossings& crossings) const {
    Ring ring;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto &from = crossings[i], &to = crossings[(i + 1) % face.size()];
      if (!from || !to) return 0;
      const Arm& arm = layout_.arm(face[i].end);
      const Line kerb =
          kerb_line(course_of(arm, +1), from->abscissa_a, length(arm.line) - to->abscissa_b, +1)
              .line;
      ring.insert(ring.end(), kerb.begin(), kerb.end());
    }
    ring = closed(std::move(ring));
    return ring.empty() ? 0 : signed_area(ring);
  }

  // What the fillets pave from the crossing of the kerbs on.
  std::vector<Polygon> fillets(const StreetFace& face, const KerbCrossings& crossings) const {
    std::vector<Polygon> paved;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const FaceSide& side = face[i];
      const auto& at_node = corners_[side.corner.node];
      if (at_node.empty()) continue;
      const Gap& gap = at_node[side.corner.gap].gap;
      if (!gap.beyond.empty()) paved.push_back(gap.beyond);
      if (!gap.meets || gap.corner.radius <= 0) continue;
      if (!crossings[i]) continue;
      const Junction& junction = layout_.junctions[side.corner.node];
      const Course a = course_of(layout_.arm(side.end), +1),
                   b = course_of(layout_.arm(junction.next(side.corner.gap)), -1);
      Polygon ground = cusp(a, b, *crossings[i], gap.corner);
      if (!ground.empty()) paved.push_back(std::move(ground));
    }
    return paved;
  }

  // How far the nearest kerb or fillet is, negative on the roadway.
  double clearance(const StreetFace& face, const Polygon& ground, const std::vector<Polygon>& paved,
                   const Point& p) const {
    if (!inside(p, ground)) return -distance_to_line(p, ground.front());
    double least = infinite;
    for (const FaceSide& side : face)
      least = std::min(least, distance_to_line(p, layout_.arm(side.end).line) - half_of(side));
    for (const Polygon& fillet : paved) {
      const double off = distance_to_line(p, fillet.front());
      least = std::min(least, inside(p, fillet) ? -off : off);
    }
    return least;
  }

  bool has_room(const StreetFace& face, const Polygon& ground, const std::vector<Polygon>& paved,
                const Frame& frame, const Box& box) const {
    const Point middle{(box.min_x + box.max_x) / 2, (box.min_y + box.max_y) / 2, 0};
    const double clear = clearance(face, ground, paved, frame.place(middle));
    if (clear >= least_room) return true;
    const double half_x = (box.max_x - box.min_x) / 2, half_y = (box.max_y - box.min_y) / 2;
    const double farthest = std::hypot(half_x, half_y);
    if (clear + farthest < least_room || farthest < fine_enough) return false;
    const auto part = [&](double x, double y) {
      Box quarter;
      quarter.add(middle);
      quarter.add({middle.x + x * half_x, middle.y + y * half_y, 0});
      return has_room(face, ground, paved, frame, quarter);
    };
    return part(-1, -1) || part(1, -1) || part(-1, 1) || part(1, 1);
  }

  const Layout& layout_;
  const SolvedCorners& corners_;
};

}  // namespace

bool leaves_hole(const Layout& layout, const SolvedCorners& corners, const StreetFace& face) {
  return face.size() > 1 && Islands(layout, corners).leave_hole(face);
}

bool swallowed_island(const Layout& layout, const SolvedCorners& corners, const StreetFace& face) {
  return face.size() > 1 && Islands(layout, corners).swallowed(face);
}

}  // namespace streetgen
