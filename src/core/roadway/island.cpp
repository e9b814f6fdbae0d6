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

// A street along a face, and the corner that it leads away from.
struct FaceSide {
  EdgeEnd end;
  CornerPlace corner;
};

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

class Faces {
 public:
  Faces(Layout& layout, const SolvedCorners& corners) : layout_(layout), corners_(corners) {
    for (const Junction& junction : layout.junctions) seen_.emplace_back(junction.ends.size());
  }

  std::vector<CornerPlace> swallowed() {
    std::vector<CornerPlace> found;
    for (int n = 0; n < static_cast<int>(seen_.size()); ++n) {
      poll_cancel();
      for (std::size_t i = 0; i < seen_[n].size(); ++i) {
        look_about({n, i});
        if (seen_[n][i]) continue;
        const std::vector<FaceSide> face = face_from({n, i});
        for (const FaceSide& side : face) seen_[side.corner.node][side.corner.gap] = true;
        if (face.size() < 2 || !is_small(face) || !swallowed(face)) continue;
        for (const FaceSide& side : face) found.push_back(side.corner);
      }
    }
    return found;
  }

 private:
  int far_node(const EdgeEnd& end) const {
    const Edge& edge = layout_.streets.network.edges[end.edge];
    return end.at_start ? edge.to_node : edge.from_node;
  }

  std::size_t index_of(int node, const EdgeEnd& end) const {
    const auto& ends = layout_.junctions[node].ends;
    std::size_t i = 0;
    while (slot(ends[i]) != slot(end)) ++i;
    return i;
  }

  // The corner at the far end of a corner's first street, on the same face.
  CornerPlace onwards(const CornerPlace& corner) const {
    const EdgeEnd& end = layout_.junctions[corner.node].ends[corner.gap];
    const int node = far_node(end);
    const std::size_t count = layout_.junctions[node].ends.size();
    return {node, (index_of(node, {end.edge, !end.at_start}) + count - 1) % count};
  }

  // At the far end of its second one.
  CornerPlace backwards(const CornerPlace& corner) const {
    const EdgeEnd& end = layout_.junctions[corner.node].next(corner.gap);
    const int node = far_node(end);
    return {node, index_of(node, {end.edge, !end.at_start})};
  }

  double length_of(const EdgeEnd& end) const { return length(layout_.arm(end).line); }

  // The nodes on both sides of a face that may once have been an island, or become one.
  void look_about(const CornerPlace& corner) {
    auto& followed = layout_.junctions[corner.node].followed;
    const double reach = layout_.settings.reach;
    double about = 0;
    CornerPlace at = corner;
    do {
      about += length_of(layout_.junctions[at.node].ends[at.gap]);
      if (about > reach) break;
      at = onwards(at);
      followed.push_back(at.node);
    } while (!(at == corner));
    about = 0;
    at = corner;
    do {
      about += length_of(layout_.junctions[at.node].next(at.gap));
      if (about > reach) break;
      at = backwards(at);
      followed.push_back(at.node);
    } while (!(at == corner));
  }

  // Counter-clockwise about an inner face; none about a long one, or of several levels.
  std::vector<FaceSide> face_from(const CornerPlace& start) const {
    std::vector<FaceSide> face;
    const auto& edges = layout_.streets.network.edges;
    double about = 0;
    CornerPlace at = start;
    do {
      const EdgeEnd& end = layout_.junctions[at.node].ends[at.gap];
      about += length_of(end);
      if (about > 2 * layout_.settings.reach) return {};
      face.push_back({end, at});
      if (edges[end.edge].level != edges[face.front().end.edge].level) return {};
      at = onwards(at);
    } while (!(at == start));
    return face;
  }

  Ring ring_of(const std::vector<FaceSide>& face) const {
    Ring ring;
    for (const FaceSide& side : face) {
      const Line& line = layout_.arm(side.end).line;
      ring.insert(ring.end(), line.begin(), line.end());
    }
    return closed(std::move(ring));
  }

  double half_of(const FaceSide& side) const {
    const Arm& arm = layout_.arm(side.end);
    return std::max(arm.start_to(+1), arm.end_to(+1));
  }

  bool is_small(const std::vector<FaceSide>& face) const {
    const Ring ring = ring_of(face);
    const double size = ring.empty() ? 0 : signed_area(ring);
    return size > 0 && size < layout_.settings.island_area;
  }

  std::optional<CornerArc> crossing_at(const CornerPlace& corner) const {
    const Junction& junction = layout_.junctions[corner.node];
    return corner_arc(course_of(layout_.arm(junction.ends[corner.gap]), +1),
                      course_of(layout_.arm(junction.next(corner.gap)), -1), 0);
  }

  using Crossings = std::vector<std::optional<CornerArc>>;  // of kerbs, at the corners of a face

  Crossings crossings_of(const std::vector<FaceSide>& face) const {
    Crossings crossings;
    for (const FaceSide& side : face) crossings.push_back(crossing_at(side.corner));
    return crossings;
  }

  // The area between the kerbs, from crossing to crossing; 0 where kerbs leave none.
  double ground_within(const std::vector<FaceSide>& face, const Crossings& crossings) const {
    Ring ring;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto &from = crossings[i], &to = crossings[(i + 1) % face.size()];
      if (!from || !to) return 0;
      const Arm& arm = layout_.arm(face[i].end);
      const double until = length(arm.line) - to->abscissa_b;
      if (from->abscissa_a >= until) return 0;
      const Line kerb = kerb_line(course_of(arm, +1), from->abscissa_a, until, +1).line;
      ring.insert(ring.end(), kerb.begin(), kerb.end());
    }
    ring = closed(std::move(ring));
    return ring.empty() ? 0 : signed_area(ring);
  }

  // What the fillets pave from the crossing of the kerbs on.
  std::vector<Polygon> fillets(const std::vector<FaceSide>& face,
                               const Crossings& crossings) const {
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

  bool swallowed(const std::vector<FaceSide>& face) const {
    const Ring ring = ring_of(face);
    const Frame frame = frame_of(ring);
    Box box;
    for (const Point& p : ring) box.add(frame.seen(p));
    if (!has_room(face, {ring}, {}, frame, box)) return false;
    const Crossings crossings = crossings_of(face);
    const std::vector<Polygon> paved = fillets(face, crossings);
    if (paved.empty()) return false;
    if (!has_room(face, {ring}, paved, frame, box)) return true;
    double all = 0;
    for (const Polygon& fillet : paved) all += std::abs(signed_area(fillet.front()));
    const double ground = ground_within(face, crossings);
    return ground > 0 && all > most_paved * ground;
  }

  // How far the nearest kerb or fillet is, negative on the roadway.
  double clearance(const std::vector<FaceSide>& face, const Polygon& ground,
                   const std::vector<Polygon>& paved, const Point& p) const {
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

  bool has_room(const std::vector<FaceSide>& face, const Polygon& ground,
                const std::vector<Polygon>& paved, const Frame& frame, const Box& box) const {
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

  Layout& layout_;
  const SolvedCorners& corners_;
  std::vector<std::vector<bool>> seen_;
};

}  // namespace

std::vector<CornerPlace> swallowed_islands(Layout& layout, const SolvedCorners& corners) {
  return Faces(layout, corners).swallowed();
}

}  // namespace streetgen
