#pragma once

#include "streetgen/geometry.hpp"

namespace streetgen {

// A ring of these points without repeated ones; empty when fewer than three remain.
Ring closed(Ring ring);

}  // namespace streetgen
