#pragma once

#include "streetgen/geometry.hpp"

namespace streetgen {

// A ring of these points without repeated ones; empty when fewer than three remain.
Ring closed(Ring ring);

// Whether each ring has three corners or more, ends where it begins and is finite.
bool has_closed_rings(const MultiPolygon& surface);

}  // namespace streetgen
