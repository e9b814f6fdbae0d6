#include "geometry/fit_circle.hpp"

#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

Point mean(const Point* points, std::size_t count) {
  Point sum;
  for (std::size_t i = 0; i < count; ++i) sum = sum + (points[i] - points[0]);
  return planar(points[0] + sum * (1.0 / count));
}

// The normal equations of two unknowns, row by row.
class NormalEquations {
 public:
  void add(const Point& row, double value) {
    xx_ += row.x * row.x, xy_ += row.x * row.y, yy_ += row.y * row.y;
    right_ = right_ + row * value;
  }
  std::optional<Point> solution() const {
    const double determinant = xx_ * yy_ - xy_ * xy_;
    if (!(determinant > straight_sine * xx_ * yy_)) return std::nullopt;
    return Point{(yy_ * right_.x - xy_ * right_.y) / determinant,
                 (xx_ * right_.y - xy_ * right_.x) / determinant, 0};
  }

 private:
  double xx_ = 0, xy_ = 0, yy_ = 0;
  Point right_;
};

double mean_distance(const Point* points, std::size_t count, const Point& centre) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += distance(points[i], centre);
  return sum / count;
}

// The least squares of powers, which is linear in the centre.
std::optional<Point> algebraic_centre(const Point* points, std::size_t count) {
  const Point middle = mean(points, count);
  double power = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Point out = points[i] - middle;
    power += dot(out, out) / count;
  }
  NormalEquations equations;
  for (std::size_t i = 0; i < count; ++i) {
    const Point out = planar(points[i] - middle);
    equations.add(out, (dot(out, out) - power) / 2);
  }
  const auto centre = equations.solution();
  return centre ? std::optional(middle + *centre) : std::nullopt;
}

// A step of Gauss and Newton for the least squares of distances; the radius is their mean.
std::optional<Point> step_from(const Point* points, std::size_t count, const Point& centre) {
  Point heading;
  for (std::size_t i = 0; i < count; ++i) heading = heading + unit(points[i] - centre);
  heading = heading * (1.0 / count);
  const double radius = mean_distance(points, count, centre);
  NormalEquations equations;
  for (std::size_t i = 0; i < count; ++i)
    equations.add(unit(points[i] - centre) - heading, distance(points[i], centre) - radius);
  return equations.solution();
}

}  // namespace

std::optional<Circle> fit_circle(const Point* points, std::size_t count) {
  if (count < 3) return std::nullopt;
  std::optional<Point> centre = algebraic_centre(points, count);
  if (!centre) return std::nullopt;
  for (int step = 0; count > 3 && step < 20; ++step) {
    const auto change = step_from(points, count, *centre);
    if (!change || !std::isfinite(norm(*change))) break;
    *centre = *centre + *change;
    if (norm(*change) < same_place) break;
  }
  const double radius = mean_distance(points, count, *centre);
  if (!std::isfinite(radius)) return std::nullopt;
  return Circle{planar(*centre), radius};
}

}  // namespace streetgen
