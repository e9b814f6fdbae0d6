// The borders of a roadway beside its axis, from node to node.
#pragma once

#include "layout/layout.hpp"

namespace streetgen {

// Half widths of an edge with all that widens its roadway: merging lanes, changes of width that go
// on within the section, and those between the limits of two edges. A border that turns round a
// corner goes on as it was before the corner. Abscissas are metres along the edge. None where the
// roadway is as wide as the axis says.
WidthProfile section_borders(const Layout& layout, int e);

}  // namespace streetgen
