// The lanes of one approach: which of its ways each kind may take, and who turns off from the
// middle.
#pragma once

#include "interconnection/way.hpp"

namespace streetgen {

// Makes pairs of the lanes that come by a leg plausible, and says of the others why they are not.
void join_approach(const Ways& of_node, const Leg& leg);

}  // namespace streetgen
