// Lanes that lead where their traffic turns at a junction too near to change lanes before it.
#pragma once

#include "interconnection/way.hpp"

namespace streetgen {

// Where no lane that a way reaches serves what others of its street serve at the next junction, one
// of its lanes leads to such a lane too.  It crosses no path of its own movement, nor one of a
// street that goes on there as straight.
void look_ahead(const Ways& of_node);

}  // namespace streetgen
