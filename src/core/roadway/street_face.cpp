#include "roadway/street_face.hpp"

#include "geometry/closed_ring.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

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
        StreetFace face = face_from({n, i});
        for (const FaceSide& side : face) seen_[side.corner.node][side.corner.gap] = true;
        if (is_small(face)) found.push_back(std::move(face));
      }
    }
    return found;
  }

 private:
  std::size_t index_of(int node, const EdgeEnd& end) const {
    const auto& ends = layout_.junctions[node].ends;
    std::size_t i = 0;
    while (slot(ends[i]) != slot(end)) ++i;
    return i;
  }

  // The corner at the far end of a corner's first street, on the same face.
  CornerPlace onwards(const CornerPlace& corner) const {
    const EdgeEnd& end = layout_.junctions[corner.node].ends[corner.gap];
    const int node = far_node(layout_, end);
    const std::size_t count = layout_.junctions[node].ends.size();
    return {node, (index_of(node, {end.edge, !end.at_start}) + count - 1) % count};
  }

  // At the far end of its second one.
  CornerPlace backwards(const CornerPlace& corner) const {
    const EdgeEnd& end = layout_.junctions[corner.node].next(corner.gap);
    const int node = far_node(layout_, end);
    return {node, index_of(node, {end.edge, !end.at_start})};
  }

  double length_of(const EdgeEnd& end) const { return length(layout_.arm(end).line); }

  // The nodes on both sides of a face that may once have been small, or become so.
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
  StreetFace face_from(const CornerPlace& start) const {
    StreetFace face;
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

  bool is_small(const StreetFace& face) const {
    const Ring ring = ring_of(layout_, face);
    const double size = ring.empty() ? 0 : signed_area(ring);
    return size > 0 && size < layout_.settings.island_area;
  }

  Layout& layout_;
  std::vector<std::vector<bool>> seen_;
};

std::optional<CornerArc> kerb_crossing(const Layout& layout, const CornerPlace& corner) {
  const Junction& junction = layout.junctions[corner.node];
  return corner_arc(course_of(layout.arm(junction.ends[corner.gap]), +1),
                    course_of(layout.arm(junction.next(corner.gap)), -1), 0);
}

}  // namespace

std::vector<StreetFace> small_faces(Layout& layout) { return Faces(layout).small(); }

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
