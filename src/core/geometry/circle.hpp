// A circle in the plane.
#pragma once

#include "streetgen/geometry.hpp"

namespace streetgen {

struct Circle {
  Point centre;
  double radius = 0;  // metres
};

}  // namespace streetgen
