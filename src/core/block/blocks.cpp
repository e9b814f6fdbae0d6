#include "streetgen/block.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "block/block_ground.hpp"
#include "block/block_kind.hpp"
#include "block/face_index.hpp"
#include "block/kerb_loop.hpp"
#include "geometry/box.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "network/face.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/progress.hpp"
#include "support/disjoint_sets.hpp"

namespace streetgen {

namespace {

// Whether the roadway of the level ends there, so that ground lies on the axis beyond.
bool bares_axis(const Kerb& kerb) {
  return kerb.method == Method::level_change || kerb.side == KerbSide::across_start ||
         kerb.side == KerbSide::across_end;
}

class BlockFinder {
 public:
  explicit BlockFinder(const BlocksInput& input)
      : input_(input),
        found_(find_faces({input.edges.begin(), input.edges.end()})),
        faces_(static_cast<int>(found_.faces.size())),
        index_(found_, input.edges.size()),
        kerbs_(kerb_loops(input.kerbs)),
        kept_(2 * input.edges.size()),
        loops_of_(faces_),
        lacks_kerbs_(faces_),
        part_of_(faces_),
        has_kerb_(input.edges.size()),
        has_end_(input.edges.size()) {
    for (const EdgeSide& side : input.kept) kept_[2 * side.edge + !side.left].push_back(side);
    for (const Kerb& kerb : input.kerbs)
      if (kerb.edge >= 0) {
        has_kerb_[kerb.edge] = true;
        if (bares_axis(kerb)) has_end_[kerb.edge] = true;
      }
  }

  Blocks find() {
    place_kerbs();
    spread_bare();
    divide_ground();
    Blocks out;
    for (int f = 0; f < faces_; ++f) {
      poll_cancel();
      tell_progress("blocks", f, faces_);
      const auto& rings = found_.faces[f].rings;
      if (std::none_of(rings.begin(), rings.end(), [&](const FaceRing& r) { return stays(r); }))
        out.blocks.push_back(block(f));
    }
    decide_by_hand(out.blocks);
    for (const FaceRing& ring : found_.outside)
      for (const EdgeSide& side : ring.sides)
        if (!stays(side)) out.outside.push_back(side);
    return out;
  }

 private:
  bool stays(const EdgeSide& side) const {
    const double middle = (side.start + side.end) / 2;
    const auto& kept = kept_[2 * side.edge + !side.left];
    return std::any_of(kept.begin(), kept.end(),
                       [&](const EdgeSide& k) { return k.start < middle && middle < k.end; });
  }
  bool stays(const FaceRing& ring) const {
    return std::any_of(ring.sides.begin(), ring.sides.end(),
                       [&](const EdgeSide& side) { return stays(side); });
  }

  void add_along(const Line& line, std::set<int>& faces) {
    for (std::size_t i = 1; i < line.size(); ++i) index_.add_along(line[i - 1], line[i], faces);
  }

  // The faces in which a ring of kerbs lies; among them may be the outside.
  std::set<int> faces_of(const std::vector<int>& kerbs) {
    std::set<int> faces;
    if (std::any_of(kerbs.begin(), kerbs.end(),
                    [&](int k) { return bares_axis(input_.kerbs[k]); })) {
      for (const int k : kerbs) add_along(input_.kerbs[k].line, faces);
      return faces;
    }
    std::vector<int> untold;
    for (const int k : kerbs) {
      if (const std::optional<int> face = index_.beside(input_.kerbs[k]))
        faces.insert(*face);
      else
        untold.push_back(k);
    }
    // A contested kerb may pass an axis whose street has no ground there.
    for (const int k : untold) add_along(input_.kerbs[k].line, faces);
    return faces;
  }

  void place_kerbs() {
    for (const int k : kerbs_.loose)
      for (const int face : faces_of({k}))
        if (face >= 0) lacks_kerbs_[face] = true;
    for (const KerbLoop& loop : kerbs_.loops) {
      poll_cancel();
      const std::set<int> faces = faces_of(loop.kerbs);
      for (const int face : faces) {
        if (face < 0) continue;
        loops_of_[face].push_back(&loop);
        part_of_.join(face, *faces.rbegin());
        if (faces.size() > 1) bare_.insert(face);
      }
    }
  }

  // A face without kerbs may be ground all over where the roadway of a street about it ends on
  // the way, or no street about it has kerbs. Then the axes bound what lies across, too.
  void spread_bare() {
    for (int f = 0; f < faces_; ++f) {
      const auto& rings = found_.faces[f].rings;
      if (!loops_of_[f].empty() || has_roadway(rings.front())) continue;
      bare_.insert(f);
      for (const int other : index_.across(f)) {
        bare_.insert(other);
        part_of_.join(other, f);
      }
    }
  }
  bool has_roadway(const FaceRing& ring) const {
    const auto any_of = [&](const std::vector<bool>& edges) {
      return std::any_of(ring.sides.begin(), ring.sides.end(),
                         [&](const EdgeSide& side) { return edges[side.edge]; });
    };
    return any_of(has_kerb_) && !any_of(has_end_);
  }

  // A loop that lies in several faces has a street without roadway between them.
  void divide_ground() {
    std::map<int, std::vector<int>> groups;
    for (const int face : bare_) groups[part_of_.of(face)].push_back(face);
    for (const auto& [first, members] : groups) {
      std::vector<const Face*> faces;
      for (const int face : members) faces.push_back(&found_.faces[face]);
      std::vector<MultiPolygon> grounds = ground_of(faces, kerbs_.loops);
      for (std::size_t i = 0; i < members.size(); ++i) divided_[members[i]] = std::move(grounds[i]);
    }
  }

  Block block(int f) {
    Block block;
    block.has_all_kerbs = !lacks_kerbs_[f];
    int number = 0;
    for (const FaceRing& ring : found_.faces[f].rings) {
      ++number;
      for (const EdgeSide& side : ring.sides) block.sides.push_back({side, number});
    }
    bool fallback = lacks_kerbs_[f];
    if (const auto divided = divided_.find(f); divided != divided_.end()) {
      block.surface = std::move(divided->second);
      block.method = Method::axis_bound;
      block.has_all_kerbs = false;
    } else {
      FaceGround ground = ground_of(loops_of_[f]);
      fallback = fallback || ground.by_faces;
      block.surface = std::move(ground.surface);
    }
    if (fallback)
      block.method = Method::robust_fallback;
    else if (block.surface.empty())
      block.method = Method::covered;
    block.kind = kind_of(block.surface, input_.settings, within_ring(found_.faces[f]));
    return block;
  }

  // Whether all edges about the face are parts of roundabouts.
  bool within_ring(const Face& face) const {
    const auto& sides = face.rings.front().sides;
    return !input_.on_rings.empty() &&
           std::all_of(sides.begin(), sides.end(),
                       [&](const EdgeSide& side) { return input_.on_rings[side.edge]; });
  }

  void decide_by_hand(std::vector<Block>& blocks) const {
    if (input_.overrides.empty()) return;
    std::vector<Box> boxes;
    for (const Block& block : blocks) boxes.push_back(box_of(block.surface));
    const BoxIndex index(boxes);
    for (const BlockOverride& by_hand : input_.overrides)
      index.each_near(box_of(by_hand.place, by_hand.place), 0, [&](int b) {
        if (inside(by_hand.place, blocks[b].surface)) blocks[b].kind = by_hand.kind;
      });
  }

  const BlocksInput& input_;
  const NetworkFaces found_;
  const int faces_;
  FaceIndex index_;
  const KerbLoops kerbs_;
  std::vector<std::vector<EdgeSide>> kept_;  // twice the edge, and 1 more on its right
  std::vector<std::vector<const KerbLoop*>> loops_of_;
  std::vector<bool> lacks_kerbs_;
  Groups part_of_;
  std::set<int> bare_;                    // beside a street without roadway
  std::map<int, MultiPolygon> divided_;   // their ground
  std::vector<bool> has_kerb_, has_end_;  // by edge: any kerb, and one where the roadway ends
};

}  // namespace

Blocks blocks(const BlocksInput& input) { return BlockFinder(input).find(); }

}  // namespace streetgen
