// Changes of width that go on within sections.
#pragma once

#include "layout/layout.hpp"

namespace streetgen {

// Where three edges and more meet and a kerb goes on nearly straight with another width, the kerb
// is linear on the length of a change of width, half of it on each edge, cut at 0.4 of the edge.
// It is as wide as its edges from there on, however far their limits are. What of it lies beyond a
// limit becomes the profile of the section, and the limit stays where it is: its border line ends
// on the kerb. Where another street goes on straighter it ends at the limits.
void taper_sections(Layout& layout);

}  // namespace streetgen
