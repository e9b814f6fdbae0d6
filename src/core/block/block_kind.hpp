// The kind of block that a piece of ground is.
#pragma once

#include "streetgen/block.hpp"

namespace streetgen {

BlockKind kind_of(const MultiPolygon& surface, const BlockSettings& settings, bool within_ring);

}  // namespace streetgen
