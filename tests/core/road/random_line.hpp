// Random polylines, and the heading of a direction against another.
#pragma once

#include <cmath>
#include <random>

#include "geometry/space.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

struct LineWish {
  int points = 8;
  double sharpest = 2.6;  // greatest turn, radians
  double slope = 0;       // greatest rise / run
  bool onwards = false;   // turned from one direction by no more than the sharpest
};

// Steps of one to two hundred metres.
inline Line random_line(std::mt19937& random, LineWish wish = {}) {
  std::uniform_real_distribution<double> share(-1, 1);
  Line line{{10 * share(random), 10 * share(random), 0}};
  const double first = M_PI * share(random);
  double heading = first;
  for (int i = 1; i < wish.points; ++i) {
    const double step = std::exp(2.65 + 2.65 * share(random));
    const Point& from = line.back();
    line.push_back({from.x + step * std::cos(heading), from.y + step * std::sin(heading),
                    from.z + step * wish.slope * share(random)});
    heading = (wish.onwards ? first : heading) + wish.sharpest * share(random);
  }
  return line;
}

inline double angle_between(const Point& a, const Point& b) {
  return std::atan2(space::norm(space::cross(a, b)), space::dot(a, b));
}

}  // namespace streetgen
