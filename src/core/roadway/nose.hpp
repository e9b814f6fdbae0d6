// The end of a median: the corner between kerbs that run nearly parallel.
#pragma once

#include <optional>

#include "layout/course.hpp"
#include "layout/node_corner.hpp"
#include "streetgen/street.hpp"

namespace streetgen {

// Whether the corner is one between kerbs that run nearly parallel: at its arc they turn from one
// another by less than 20 degrees, or the corner follows its streets.
bool ends_a_median(const SolvedCorner& corner);

// In the place of a corner that paves more than the settings let it, or whose wanted arc lies too
// far away: the one of the largest radius that does neither, or of half median_width_minimal where
// none does. The courses start at the node; none where the corner may stay as it is, or where the
// kerbs cross nowhere.
std::optional<SolvedCorner> nose(const Course& a, const Course& b, const SolvedCorner& corner,
                                 const CornerWish& wish, const StreetSettings& settings);

}  // namespace streetgen
