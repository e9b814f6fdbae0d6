#include "block/face_index.hpp"

#include <algorithm>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

// The sides of its edge that a kerb lies on: both at the start or the end of a section.
struct OnSides {
  bool left, right;
};
OnSides sides_of(KerbSide side) {
  switch (side) {
    case KerbSide::left:
    case KerbSide::corner_at_start:
      return {true, false};
    case KerbSide::right:
    case KerbSide::corner_at_end:
      return {false, true};
    case KerbSide::start:
    case KerbSide::end:
      return {true, true};
    case KerbSide::across_start:
    case KerbSide::across_end:
      break;
  }
  return {false, false};
}

}  // namespace

FaceIndex::FaceIndex(const NetworkFaces& found, std::size_t edges)
    : faces_(found.faces), beside_(2 * edges, none) {
  std::vector<Box> boxes(faces_.size());
  for (int f = 0; f < static_cast<int>(faces_.size()); ++f) {
    for (const Point& p : faces_[f].rings.front().line) boxes[f].add(p);
    for (const FaceRing& ring : faces_[f].rings) lie_beside(ring.sides, f);
  }
  for (const FaceRing& ring : found.outside) lie_beside(ring.sides, outside);
  index_ = BoxIndex(boxes);
}

void FaceIndex::lie_beside(const std::vector<EdgeSide>& sides, int face) {
  for (const EdgeSide& side : sides) {
    int& beside = beside_[2 * side.edge + !side.left];
    beside = beside == none || beside == face ? face : several;
  }
}

std::optional<int> FaceIndex::beside(const Kerb& kerb) const {
  if (kerb.edge < 0 || kerb.method == Method::contested || kerb.method == Method::level_change)
    return std::nullopt;
  const OnSides sides = sides_of(kerb.side);
  const int left = beside_[2 * kerb.edge], right = beside_[2 * kerb.edge + 1];
  const int face = sides.left ? left : sides.right ? right : none;
  if (face < outside || (sides.left && sides.right && left != right)) return std::nullopt;
  return face;
}

const PreparedSurface& FaceIndex::prepared(int face) {
  const auto found = prepared_.find(face);
  if (found != prepared_.end()) return found->second;
  Polygon rings;
  for (const FaceRing& ring : faces_[face].rings) rings.push_back(ring.line);
  MultiPolygon& kept = rings_[face] = {std::move(rings)};
  return prepared_.emplace(face, PreparedSurface(kept)).first->second;
}

void FaceIndex::add_along(const Point& from, const Point& to, std::set<int>& faces) {
  const std::vector<int> near = index_.near(box_of(from, to), 0);
  std::vector<double> at{0, 1};
  for (const int face : near) prepared(face).cut(from, to, at);
  std::sort(at.begin(), at.end());
  const double size = distance(from, to);
  for (std::size_t i = 1; i < at.size(); ++i) {
    if ((at[i] - at[i - 1]) * size <= same_place) continue;
    const Point middle = from + (to - from) * ((at[i - 1] + at[i]) / 2);
    const auto holds = [&](int face) { return prepared(face).holds(middle); };
    const auto face = std::find_if(near.begin(), near.end(), holds);
    faces.insert(face == near.end() ? outside : *face);
  }
}

std::set<int> FaceIndex::across(int face) const {
  std::set<int> edges, others;
  for (const FaceRing& ring : faces_[face].rings)
    for (const EdgeSide& side : ring.sides) edges.insert(side.edge);
  for (int other = 0; other < static_cast<int>(faces_.size()); ++other)
    for (const FaceRing& ring : faces_[other].rings)
      for (const EdgeSide& side : ring.sides)
        if (other != face && edges.count(side.edge) > 0) others.insert(other);
  return others;
}

}  // namespace streetgen
