#include "roadway/street_face.hpp"

#include <algorithm>

#include "geometry/closed_ring.hpp"
#include "geometry/polyline.hpp"
#include "geometry/ring_simplicity.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

std::size_t index_of(const Layout& layout, int node, const EdgeEnd& end) {
  const auto& ends = layout.junctions[node].ends;
  std::size_t i = 0;
  while (slot(ends[i]) != slot(end)) ++i;
  return i;
}

// The corner at the far end of a corner's first street, on the same face.
CornerPlace onwards(const Layout& layout, const CornerPlace& corner) {
  const EdgeEnd& end = layout.junctions[corner.node].ends[corner.gap];
  const int node = far_node(layout, end);
  const std::size_t count = layout.junctions[node].ends.size();
  return {node, (index_of(layout, node, {end.edge, !end.at_start}) + count - 1) % count};
}

// At the far end of its second one.
CornerPlace backwards(const Layout& layout, const CornerPlace& corner) {
  const EdgeEnd& end = layout.junctions[corner.node].next(corner.gap);
  const int node = far_node(layout, end);
  return {node, index_of(layout, node, {end.edge, !end.at_start})};
}

// Whether all of a side of a face lies within reach of a node.
bool is_near(const Layout& layout, int node, const EdgeEnd& end) {
  const Point& from = layout.streets.network.nodes[node].point;
  const Line& line = layout.arm(end).line;
  return std::all_of(line.begin(), line.end(),
                     [&](const Point& p) { return distance(from, p) <= layout.settings.reach; });
}

// Of a side: each segment lies within reach of one of the other side, whose distance is greatest at
// an end.
bool is_near_side(const Layout& layout, const EdgeEnd& from, const EdgeEnd& end) {
  const Line &own = layout.arm(from).line, &line = layout.arm(end).line;
  const double reach = layout.settings.reach;
  for (std::size_t i = 1; i < line.size(); ++i) {
    bool near = false;
    for (std::size_t k = 1; k < own.size() && !near; ++k)
      near = distance_to_segment(line[i - 1], own[k - 1], own[k]) <= reach &&
             distance_to_segment(line[i], own[k - 1], own[k]) <= reach;
    if (!near) return false;
  }
  return true;
}

class Faces {
 public:
  explicit Faces(Layout& layout) : layout_(layout) {
    for (const Junction& junction : layout.junctions) seen_.emplace_back(junction.ends.size());
  }

  std::vector<StreetFace> small() {
    std::vector<StreetFace> found;
    for (int n = 0; n < static_cast<int>(seen_.size()); ++n) {
      poll_cancel();
      for (std::size_t i = 0; i < seen_[n].size(); ++i) {
        look_about({n, i});
        if (seen_[n][i]) continue;
        StreetFace face = face_about(layout_, {n, i});
        for (const FaceSide& side : face) seen_[side.corner.node][side.corner.gap] = true;
        if (is_small(face)) found.push_back(std::move(face));
      }
    }
    return found;
  }

 private:
  // The nodes on both sides of a face that may once have been small, or become so.
  void look_about(const CornerPlace& corner) {
    auto& followed = layout_.junctions[corner.node].followed;
    CornerPlace at = corner;
    do {
      if (!is_near(layout_, corner.node, layout_.junctions[at.node].ends[at.gap])) break;
      at = onwards(layout_, at);
      followed.push_back(at.node);
    } while (!(at == corner));
    at = corner;
    do {
      if (!is_near(layout_, corner.node, layout_.junctions[at.node].next(at.gap))) break;
      at = backwards(layout_, at);
      followed.push_back(at.node);
    } while (!(at == corner));
  }

  bool is_small(const StreetFace& face) const {
    const Ring ring = ring_of(layout_, face);
    const double size = ring.empty() ? 0 : signed_area(ring);
    return size > 0 && size < layout_.settings.island_area &&
           (on_one_level(layout_, face) || simple({{ring}}).value_or(false));
  }

  Layout& layout_;
  std::vector<std::vector<bool>> seen_;
};

}  // namespace

std::vector<StreetFace> small_faces(Layout& layout) { return Faces(layout).small(); }

CornerPlace corner_beside(const Layout& layout, const EdgeEnd& end) {
  const Edge& edge = layout.streets.network.edges[end.edge];
  const int node = end.at_start ? edge.from_node : edge.to_node;
  return {node, index_of(layout, node, end)};
}

FaceSide side_after(const Layout& layout, const FaceSide& side) {
  const CornerPlace corner = onwards(layout, side.corner);
  return {layout.junctions[corner.node].ends[corner.gap], corner};
}

FaceSide side_before(const Layout& layout, const FaceSide& side) {
  const CornerPlace corner = backwards(layout, side.corner);
  return {layout.junctions[corner.node].ends[corner.gap], corner};
}

StreetFace face_about(const Layout& layout, const CornerPlace& start) {
  StreetFace face;
  CornerPlace at = start;
  do {
    const EdgeEnd& end = layout.junctions[at.node].ends[at.gap];
    if (!is_near(layout, start.node, end)) return {};
    face.push_back({end, at});
    at = onwards(layout, at);
  } while (!(at == start));
  for (const FaceSide& from : face)
    for (const FaceSide& side : face)
      if (!is_near(layout, from.corner.node, side.end)) return {};
  return face;
}

StreetFace face_beside(const Layout& layout, const CornerPlace& start) {
  StreetFace face;
  const EdgeEnd& first = layout.junctions[start.node].ends[start.gap];
  CornerPlace at = start;
  do {
    const EdgeEnd& end = layout.junctions[at.node].ends[at.gap];
    if (!is_near_side(layout, first, end)) return {};
    face.push_back({end, at});
    at = onwards(layout, at);
  } while (!(at == start));
  return face;
}

bool on_one_level(const Layout& layout, const StreetFace& face) {
  const auto& edges = layout.streets.network.edges;
  return std::all_of(face.begin(), face.end(), [&](const FaceSide& side) {
    return edges[side.end.edge].level == edges[face.front().end.edge].level;
  });
}

Corner& corner_row(Layout& layout, const CornerPlace& corner) {
  std::vector<Corner>& rows = layout.streets.corners;
  const auto first =
      std::lower_bound(rows.begin(), rows.end(), corner.node,
                       [](const Corner& row, int wanted) { return row.node < wanted; });
  return first[corner.gap];
}

int far_node(const Layout& layout, const EdgeEnd& end) {
  const Edge& edge = layout.streets.network.edges[end.edge];
  return end.at_start ? edge.to_node : edge.from_node;
}

Ring ring_of(const Layout& layout, const StreetFace& face) {
  Ring ring;
  for (const FaceSide& side : face) {
    const Line& line = layout.arm(side.end).line;
    ring.insert(ring.end(), line.begin(), line.end());
  }
  return closed(std::move(ring));
}

std::optional<CornerArc> kerb_crossing(const Layout& layout, const CornerPlace& corner) {
  const Junction& junction = layout.junctions[corner.node];
  return corner_arc(course_of(layout.arm(junction.ends[corner.gap]), +1),
                    course_of(layout.arm(junction.next(corner.gap)), -1), 0);
}

KerbCrossings kerb_crossings(const Layout& layout, const StreetFace& face) {
  KerbCrossings crossings;
  for (const FaceSide& side : face) crossings.push_back(kerb_crossing(layout, side.corner));
  return crossings;
}

std::vector<KerbStretch> kerbs_about(const Layout& layout, const StreetFace& face,
                                     const KerbCrossings& crossings) {
  std::vector<KerbStretch> stretches;
  for (std::size_t i = 0; i < face.size(); ++i) {
    const auto &from = crossings[i], &to = crossings[(i + 1) % face.size()];
    if (!from || !to) return {};
    const double until = length(layout.arm(face[i].end).line) - to->abscissa_b;
    if (from->abscissa_a >= until) return {};
    stretches.push_back({from->abscissa_a, until});
  }
  return stretches;
}

}  // namespace streetgen
