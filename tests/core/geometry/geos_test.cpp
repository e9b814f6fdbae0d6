#include "geometry/geos.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace streetgen {
namespace geos_test {

const Ring square{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}};
const Ring hole{{1, 1}, {1, 2}, {2, 2}, {1, 1}};
const Ring open{{3, 3}, {3, 4}, {4, 4}, {4, 3}};

// The leak checker of the sanitized build fails it where a part made before is lost.
TEST(Geos, KeepsNothingOfASurfaceThatFailsHalfWay) {
  Geos geos;
  EXPECT_THROW(geos.polygon({square, hole, open}), std::runtime_error);
  EXPECT_THROW(geos.surface({{square, hole}, {open}}), std::runtime_error);
}

}  // namespace geos_test
}  // namespace streetgen
