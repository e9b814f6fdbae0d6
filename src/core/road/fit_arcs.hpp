// Arcs fitted to a path, whose ends and headings at them are known.
#pragma once

#include <optional>
#include <vector>

#include "road/arc_chain.hpp"
#include "road/path_guide.hpp"

namespace streetgen {

struct FittedArcs {
  std::vector<ChainArc> arcs;
  // The greatest share of what the guide allows.  Over one: an arc leaves it, or is too sharp.
  double worst = 0;
};

// Arcs that lead from one place of the guide to the other, found from those that are given, by the
// least squares of Gauss, Newton, Levenberg and Marquardt with the ends as constraints.  Points
// that lie farther off weigh more from round to round.  None where the arcs come to no end.
std::optional<FittedArcs> fit_arcs(const PathGuide& guide, std::vector<ChainArc> arcs);

// The one arc that leads there.  None where it arrives with another heading.
std::optional<FittedArcs> fit_one_arc(const PathGuide& guide);

}  // namespace streetgen
