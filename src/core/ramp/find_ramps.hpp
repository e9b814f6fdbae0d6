// Ramps of a network, and the room that they take on its arms.
#pragma once

#include "layout/layout.hpp"

namespace streetgen {

// Fills Streets::ramps.
void find_ramps(Layout& layout, const RampRules& rules);

// What a gap of a junction is at a ramp: the nose between the link and the highway beside it, or
// the outer side, where the kerb of the link goes on as that of the highway.
enum class RampCorner { none, nose, outer };
RampCorner ramp_corner(const Layout& layout, const Junction& junction, std::size_t gap);

// The outer kerb of a ramp, with the bend of the link: the highway runs straight on behind its node
// there. None where the link does not come beside the highway within the room on it. nose_limit:
// where the nose ends on the link, metres from the node, as the room.
std::optional<CornerArc> outer_kerb(const Layout& layout, const Junction& junction, std::size_t gap,
                                    double nose_limit, double room);

// How far the intersection of a ramp may reach along its link, whose other end has that limit; half
// of it where that is a ramp too.
double room_on_link(const Layout& layout, const Ramp& ramp, double far_limit);

// Once corners are known: the intersection of a ramp goes as far along link and highway as the bend
// from the one into the other.
void extend_limits(Layout& layout);

}  // namespace streetgen
