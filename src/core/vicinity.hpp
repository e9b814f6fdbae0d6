// Which surfaces take part in what the asked ones become, told before any is built.
#pragma once

#include <vector>

#include "overlap.hpp"
#include "ring.hpp"

namespace streetgen {

// A box that holds the section between two abscissas, round ends included.
Box section_extent(const Arm& arm, double start, double end);

// A box that holds the intersection; gaps[i] lies between arms[i] and arms[i + 1], none at a dead
// end.
Box intersection_extent(const std::vector<Arm>& arms, const std::vector<Gap>& gaps);

// Of each extent how far it is from the asked ones: 0 is asked, 1 may share ground with these, 2
// may border on a hole beside those, 3 may share ground with these, `far_away` neither.
constexpr int last_ring = 3;
constexpr int far_away = last_ring + 1;
std::vector<int> rings(const std::vector<Box>& extents, const std::vector<bool>& asked);

}  // namespace streetgen
