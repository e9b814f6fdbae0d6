// Traffic that alone may go where others may not, and from which lanes it does.
#pragma once

#include "interconnection/movement.hpp"

namespace streetgen {

// Permission belongs to traffic and path: whoever may go where others may not does so from the
// lanes for all too, as though all might.
void let_in(const std::vector<Leg>& legs, std::vector<Movement>& movements, LaneKind kind);

}  // namespace streetgen
