// The edges and nodes that a change affects: those whose rows may become others.
#pragma once

#include <vector>

#include "layout/layout.hpp"

namespace streetgen {

// An axis that did not change, of which edges get another course.
struct Turned {
  std::vector<int> edges;
  std::vector<const FormerSurface*> surfaces;  // that they and their nodes had before
};

// What a surface was that moved or is gone.
struct GivenUp {
  const FormerSurface* surface;
  bool of_changed;  // of an axis that changed, or a node that it met
};

// By edge and node: those whose surface may get another shape from the axes about it. An edge or
// node that is affected beyond these only meets ground that others give up; its surface before the
// change is known.
struct Affected {
  std::vector<bool> edges, nodes;
  std::vector<const FormerSurface*> sections, intersections;  // nullptr: none, or it moved
  std::vector<bool> beside;  // by edge: the ground beside it is of another kind
  std::vector<GivenUp> given_up{};
  std::vector<Turned> turned{};
};

// Marks the affected edges and nodes in `layout.streets`. `former` must outlive the result.
Affected find_affected(Layout& layout, const Former& former, const LeadsOn& leads_on = {});

}  // namespace streetgen
