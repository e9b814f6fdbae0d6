// Slits between streets that run beside each other are roadway, and the ends of notches.
#pragma once

#include <vector>

#include "ownership/claim.hpp"
#include "ownership/hole.hpp"

namespace streetgen {

// Ground between two surfaces of one level whose sides run nearly parallel and no more than `width`
// metres apart, outside of all surfaces. Surfaces that share an edge leave none. Where the borders
// of the intersections of two neighbours cross, the notch up to an arc of `radius` metres; 0: none.
// Only slits beside a wanted claim are found, of 0.01 m2 and more, and of each what no hole and no
// other slit fills. With a slit goes ground under `least_island` m2 that it closes.
std::vector<Hole> slits_between(const std::vector<Claim>& claims, const std::vector<Hole>& holes,
                                double width, double radius, double least_island);

}  // namespace streetgen
