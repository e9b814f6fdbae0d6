// Smooth courses of links: straight lines and arcs without a kink.
#pragma once

#include <optional>
#include <vector>

#include "streetgen/plan_view.hpp"

namespace streetgen {

// The course along the middle of a lane.  Its ends have the headings that are given, else those of
// the line.
std::vector<PlanPiece> lane_course(const Line& lane, const ChainEnds& ends);

// The course of a movement from the end of a lane's course to the beginning of another one.  No
// piece: both are one place.
std::vector<PlanPiece> movement_course(const Line& path, const std::vector<PlanPiece>& lane_in,
                                       const std::vector<PlanPiece>& lane_out, double width);

// Metres.  The tightest bend, as a metre of the course turns; none: all is straight.  A kink of a
// few centimetres between lanes that touch is none that a car brakes for.
std::optional<double> tightest_radius(const std::vector<PlanPiece>& course);

}  // namespace streetgen
