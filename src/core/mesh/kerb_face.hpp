// Kerbs of a mesh: what closes the step between a raised surface and a lower neighbour.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/border_net.hpp"
#include "streetgen/surface_mesh.hpp"

namespace streetgen {

// The surfaces are those of the net, in their order. Both must outlive it.
class KerbFaces {
 public:
  KerbFaces(const BorderNet& net, const std::vector<const MeshedSurface*>& surfaces);

  // The upright triangles along the sides that a surface shares with lower ones, seen from these,
  // from the triangles of the surface. z is metres above the height of the place.
  std::vector<Triangle> faces(std::size_t surface, const std::vector<Triangle>& ground) const;

 private:
  const BorderNet& net_;
  const std::vector<const MeshedSurface*>& surfaces_;
  // The height by which the lowest surface beside each side is raised.
  std::vector<double> foot_;
};

}  // namespace streetgen
