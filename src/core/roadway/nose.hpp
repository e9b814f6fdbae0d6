// The end of a median: the corner between kerbs that run nearly parallel.
#pragma once

#include <optional>

#include "layout/course.hpp"
#include "layout/node_corner.hpp"
#include "streetgen/street.hpp"

namespace streetgen {

// In the place of a corner between kerbs that run nearly parallel where they cross or at its arc,
// by less than 20 degrees, or that follows its streets, if it paves more than the settings let it
// or its wanted arc lies too far away: the one of the largest radius that does neither, or of half
// median_width_minimal where none does. The courses start at the node; none where the corner may
// stay as it is, or where the kerbs cross nowhere.
std::optional<SolvedCorner> nose(const Course& a, const Course& b, const SolvedCorner& corner,
                                 const CornerWish& wish, const StreetSettings& settings);

}  // namespace streetgen
