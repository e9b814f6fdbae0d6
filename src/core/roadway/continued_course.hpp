// The axes that go on from one another, where a corner finds no place on its own two.
#pragma once

#include <vector>

#include "layout/course.hpp"
#include "layout/layout.hpp"

namespace streetgen {

// From a node along the edge that leaves it by `end`, and on up to the reach from the node: at each
// further node along the same street, the axis of the same level and width that turns least within
// the widest bend; where there is none, along the axis on which the kerb of that side goes on
// unbroken. The further nodes are added to `looked_at`.
Course continued_course(const Layout& layout, const EdgeEnd& end, int side,
                        std::vector<int>& looked_at);

}  // namespace streetgen
