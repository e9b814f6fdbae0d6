// Is what was computed sound?  Answers that are quick where it is; who gets another asks closer.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// A single ring that does not meet itself, and nothing comes near to it.
bool surely_valid(const MultiPolygon& surface);

// Deeper than a micrometre.
bool share_ground(const MultiPolygon& a, const MultiPolygon& b);

// Whether all of the line lies on one or another of the surfaces, within a micrometre.
bool lies_on(const Line& line, const std::vector<MultiPolygon>& surfaces);

}  // namespace streetgen
