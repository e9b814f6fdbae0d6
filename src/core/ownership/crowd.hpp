// Ground that very many surfaces claim is shared out by rank, square by square: at a cost that
// grows with their number, not with the number of their pairs.
#pragma once

#include <functional>
#include <map>
#include <vector>

#include "geometry/geos.hpp"
#include "geometry/prepared_surface.hpp"
#include "ownership/claim.hpp"

namespace streetgen {

// A square of a fixed grid, and what comes into it, ascending.
struct Crowd {
  Box square;
  std::vector<int> members;
};

// The squares into which more than `most` of those come that have the boxes. `comes_into` is asked
// where the boxes alone do not tell.
std::vector<Crowd> crowds(const std::vector<Box>& boxes, std::size_t most,
                          const std::function<bool(int, const Box&)>& comes_into);

// Of each claim that comes into a crowd the ground that is left of it: in the square of a crowd a
// place is the first one's of those that claim it and tile, in the order of `before`.
std::map<int, MultiPolygon> left_by_crowds(Geos& geos, const std::vector<Claim>& claims,
                                           std::size_t most);

}  // namespace streetgen
