// Small holes between surfaces that tile are roadway.
#pragma once

#include <utility>
#include <vector>

#include "geometry/geos.hpp"
#include "ownership/claim.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

struct Hole {
  Ring ring;
  std::vector<int> around;  // the claims near it
};

// Metres from the ground that two disputing surfaces share: a hole farther away is not looked for.
constexpr double hole_extent = 20;

// Holes under `max_area` square metres in the union of a level's surfaces; gaps of a micrometre
// count as closed. Only surfaces in a dispute and those within `hole_extent` of it that share an
// edge with them are looked at, and those on a loop or on two edges between the same nodes:
// elsewhere there is no such hole. Only holes beside a wanted claim are found.
std::vector<Hole> holes_between(const std::vector<Claim>& claims,
                                const std::vector<std::pair<int, int>>& disputes, double max_area);

// Each hole goes to the surface with the longest border on it; ties: the smaller (axis_id,
// order_key).
void give_holes(Geos& geos, std::vector<Claim>& claims, const std::vector<Hole>& holes);

}  // namespace streetgen
