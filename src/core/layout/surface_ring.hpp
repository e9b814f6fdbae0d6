// Rings put together piece by piece, and what holds when that fails.
#pragma once

#include <vector>

#include "geometry/geos.hpp"
#include "layout/arm.hpp"
#include "layout/course.hpp"
#include "layout/parting.hpp"
#include "streetgen/geometry.hpp"
#include "streetgen/width_profile.hpp"

namespace streetgen {

// Between the kerbs that leave `crossing` (left of a, right of b) and the arc of `corner`.
Polygon cusp(const Course& a, const Course& b, const CornerArc& crossing, const CornerArc& corner);

struct Built {
  MultiPolygon surface;
  bool by_union = false;
};

// The part of one axis between two abscissas; its ends are the given borders (left, right). As wide
// as the profile says, or where that is empty as the arm; beside other sections up to what parts
// them.
Built build_section(Geos& geos, const Arm& arm, const WidthProfile& profile, double start,
                    double end, const Line& start_border, const Line& end_border,
                    const SectionPartings& partings);

// gaps[i] lies between arms[i] and arms[i + 1], arms counter-clockwise.
Built build_intersection(Geos& geos, const std::vector<Arm>& arms, const std::vector<Gap>& gaps);

// The half widths of arm i from its node to its limit; none where neither kerb tapers
// and nothing parts its section from another.
WidthProfile tapered(const std::vector<Arm>& arms, const std::vector<Gap>& gaps, std::size_t i);

}  // namespace streetgen
