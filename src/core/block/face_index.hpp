// The face of a network in which a place or a kerb lies.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "geometry/box_index.hpp"
#include "geometry/prepared_surface.hpp"
#include "network/face.hpp"
#include "streetgen/kerb.hpp"

namespace streetgen {

// The faces must outlive it unchanged.
class FaceIndex {
 public:
  FaceIndex(const NetworkFaces& found, std::size_t edges);

  static constexpr int outside = -1;

  // The face beside the side of an edge that the kerb belongs to. None where there are several
  // such faces, where the side is not told, or where others contest the kerb: it may lie beyond.
  std::optional<int> beside(const Kerb& kerb) const;
  // Adds the faces that hold part of a segment, longer than a micrometre, and maybe the outside.
  void add_along(const Point& from, const Point& to, std::set<int>& faces);
  // The faces that share an edge with a face; looked for among all.
  std::set<int> across(int face) const;

 private:
  void lie_beside(const std::vector<EdgeSide>& sides, int face);
  const PreparedSurface& prepared(int face);

  static constexpr int none = -2, several = -3;
  const std::vector<Face>& faces_;
  std::vector<int> beside_;  // twice the edge, and 1 more on its right: the one face there
  BoxIndex index_;
  std::map<int, MultiPolygon> rings_;        // of faces that were asked
  std::map<int, PreparedSurface> prepared_;  // the same
};

}  // namespace streetgen
