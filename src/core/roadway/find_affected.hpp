// What a change asks for: the edges and nodes whose rows may become others.
#pragma once

#include <vector>

#include "roadway/layout.hpp"

namespace streetgen {

// An axis that did not change, of which edges get another course.
struct Turned {
  std::vector<int> edges;
  std::vector<const FormerSurface*> surfaces;  // that they and their nodes had before
};

// By edge and node: those whose surface may get another shape from the axes about it. What is asked
// beyond these only meets ground that others give up; its surface before the change is known.
struct Moved {
  std::vector<bool> edges, nodes;
  std::vector<const FormerSurface*> sections, intersections;  // nullptr: none, or it moved
  std::vector<const FormerSurface*> given_up{};               // of those that moved or are gone
  std::vector<Turned> turned{};
};

// Marks the asked edges and nodes. `former` outlives what it gives.
Moved ask_around_changes(Layout& layout, const Former& former);

}  // namespace streetgen
