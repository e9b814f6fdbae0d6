// What must hold after each step of the pipeline.  Builds with STREETGEN_INVARIANTS (the Debug and
// the sanitized one) check it; in others each check is empty.
#pragma once

#include "streetgen/street_model.hpp"

namespace streetgen {

#ifdef STREETGEN_INVARIANTS
// Each check throws std::logic_error with a sentence that names the broken rule and its row.

// Edges start and end at their nodes, and abscissas grow along each axis.
void check_network(const Network& network);
// Corners name edges that touch their node, and arcs lie on circles of their radius.
void check_corners(const Streets& streets);
// Every edge has two limits on it, and the first does not lie behind the second.
void check_limits(const Streets& streets);
// Surfaces belong to affected edges and nodes, and their rings are closed and finite.
void check_surfaces(const Streets& streets);
// Kerbs have a line, and the parts of each side are numbered from 1 without a gap.
void check_kerbs(const Streets& streets);
// Lanes are numbered from 1 on every edge without a gap, and each has a line.
void check_lanes(const Streets& streets, const Lanes& lanes);
// Every path joins two lanes that touch its node, and starts and ends at an end of each.
void check_interconnections(const StreetModel& model);
#else
inline void check_network(const Network&) {}
inline void check_corners(const Streets&) {}
inline void check_limits(const Streets&) {}
inline void check_surfaces(const Streets&) {}
inline void check_kerbs(const Streets&) {}
inline void check_lanes(const Streets&, const Lanes&) {}
inline void check_interconnections(const StreetModel&) {}
#endif

}  // namespace streetgen
