// What a change asks for: the edges and nodes whose rows may become others.
#pragma once

#include <vector>

#include "layout.hpp"

namespace streetgen {

// By edge and node: whether the axes about it may give its surface another shape. What is asked
// beyond these only meets ground that others give up.
struct Moved {
  std::vector<bool> edges, nodes;
};

// Marks the asked edges and nodes.
Moved ask_around_changes(Layout& layout, const Former& former);

}  // namespace streetgen
