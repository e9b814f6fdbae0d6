#include "mesh/kerb_face.hpp"
#include "support/infinite.hpp"

#include <algorithm>
#include <map>

namespace streetgen {

KerbFaces::KerbFaces(const BorderNet& net, const std::vector<const MeshedSurface*>& surfaces)
    : net_(net), surfaces_(surfaces), foot_(net.side_count(), infinite) {
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    for (const int side : net.sides(i)) foot_[side] = std::min(foot_[side], surfaces[i]->raised);
}

std::vector<Triangle> KerbFaces::faces(std::size_t surface,
                                       const std::vector<Triangle>& ground) const {
  const double top = surfaces_[surface]->raised;
  std::map<BorderNet::Segment, double> feet;
  for (const int side : net_.sides(surface)) {
    if (foot_[side] >= top) continue;
    const std::vector<int> vertices = net_.along(side);
    for (std::size_t i = 1; i < vertices.size(); ++i)
      feet[std::minmax(vertices[i - 1], vertices[i])] = foot_[side];
  }
  std::vector<Triangle> faces;
  if (feet.empty()) return faces;
  // The surface lies to the left of the sides of its triangles, the lower one to the right.
  for (const Triangle& triangle : ground)
    for (std::size_t k = 0; k < 3; ++k) {
      const Point &a = triangle[k], &b = triangle[(k + 1) % 3];
      const auto known = feet.find(std::minmax(net_.known_vertex(a), net_.known_vertex(b)));
      if (known == feet.end()) continue;
      const double foot = known->second;
      const Point low{b.x, b.y, foot}, high{b.x, b.y, top};
      faces.push_back({{{a.x, a.y, foot}, low, high}});
      faces.push_back({{{a.x, a.y, foot}, high, {a.x, a.y, top}}});
    }
  return faces;
}

}  // namespace streetgen
