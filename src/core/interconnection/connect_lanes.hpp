// Lane by lane: which lane of a way's approach goes on to which of its goals.
#pragma once

#include "interconnection/way.hpp"

namespace streetgen {

// Makes pairs plausible without crossing: the lanes go on to the goals of the way in their order,
// the outermost twice.
void connect_lanes(const Ways& of_node, Way way, const Group& lanes, Reason reason);

}  // namespace streetgen
