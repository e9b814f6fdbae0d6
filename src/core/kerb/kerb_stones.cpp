#include "streetgen/kerb.hpp"
#include "streetgen/surface.hpp"

namespace streetgen {

MultiPolygon stones_of(const Kerb& kerb) {
  return offset_strip(kerb.line, kerb.stone_width, kerb.stone_width);
}

}  // namespace streetgen
