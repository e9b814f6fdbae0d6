// A line and a curve at each of its vertices become elements.
#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/polyline.hpp"
#include "streetgen/alignment.hpp"
#include "streetgen/error.hpp"

namespace streetgen {
namespace {

// A shorter element is none; coordinates of a projection are rounded to about this.
constexpr double least_element = 1e-9;

[[noreturn]] void refuse_point(std::size_t i, const std::string& what, const std::string& hint) {
  throw Error(ErrorKind::invalid_input, "point " + std::to_string(i + 1) + what, hint);
}

// A side of the line: its direction and length.
struct Side {
  Point direction;
  double heading = 0, length = 0;
};

std::vector<Side> sides_of(const Line& line) {
  std::vector<Side> sides;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double x = line[i].x - line[i - 1].x, y = line[i].y - line[i - 1].y;
    const double length = std::hypot(x, y);
    if (!(length > least_element))
      refuse_point(i, " repeats the one before it", "Leave one of both out.");
    sides.push_back({{x / length, y / length, 0}, std::atan2(y, x), length});
  }
  return sides;
}

double turn_between(const Side& a, const Side& b) {
  return std::atan2(a.direction.x * b.direction.y - a.direction.y * b.direction.x,
                    a.direction.x * b.direction.x + a.direction.y * b.direction.y);
}

void check_curve(std::size_t i, const VertexCurve& curve, double deflection) {
  for (double value : {curve.radius, curve.clothoid_in, curve.clothoid_out})
    if (!(value >= 0 && value <= 1e7))
      refuse_point(i, " has a radius or clothoid of " + text_of(value),
                   "Expected 0 to 10000000 m.");
  if (curve.radius > 0 && deflection > M_PI - 1e-6)
    refuse_point(i, " turns straight back, where no curve fits", "Give it radius 0, or move it.");
}

class AlignmentBuilder {
 public:
  // Gives the place at its end.
  AlignmentPlace add(const AlignmentPlace& from, double length, double to_curvature) {
    if (length <= least_element) return from;
    AlignmentElement element{abscissa_, from.point,     from.heading,
                             length,    from.curvature, to_curvature};
    abscissa_ += length;
    elements_.push_back(element);
    return element_place(element, length);
  }
  std::vector<AlignmentElement> take() { return std::move(elements_); }

 private:
  std::vector<AlignmentElement> elements_;
  double abscissa_ = 0;
};

void add_curve(AlignmentBuilder& builder, const Point& vertex, const Side& in, double turn,
               const VertexCurve& curve, const CurveShape& shape) {
  const double sign = turn > 0 ? 1 : -1;
  // Sums are taken from the vertex, so that large coordinates cost no digits.
  AlignmentPlace place{{vertex.x - shape.tangent_in * in.direction.x,
                        vertex.y - shape.tangent_in * in.direction.y, 0},
                       in.heading,
                       0};
  const double curvature = sign / curve.radius;
  if (shape.length_in > least_element) place = builder.add(place, shape.length_in, curvature);
  place.curvature = curvature;
  if (shape.arc > least_element) place = builder.add(place, shape.arc, curvature);
  if (shape.length_out > least_element) builder.add(place, shape.length_out, 0);
}

}  // namespace

std::vector<AlignmentElement> horizontal_alignment(const Line& line,
                                                   const std::vector<VertexCurve>& curves) {
  if (line.size() < 2) throw Error(ErrorKind::invalid_input, "the line has less than two points");
  if (curves.size() != line.size())
    throw Error(
        ErrorKind::invalid_input,
        std::to_string(curves.size()) + " curves for " + std::to_string(line.size()) + " points",
        "Expected one for each point; those of the ends mean nothing.");
  const std::vector<Side> sides = sides_of(line);
  std::vector<double> turns(line.size(), 0);
  std::vector<CurveShape> shapes(line.size());
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    turns[i] = turn_between(sides[i - 1], sides[i]);
    check_curve(i, curves[i], std::abs(turns[i]));
    // A turn that moves nothing by more than the least element has no curve.
    if (std::abs(turns[i]) * std::min(sides[i - 1].length, sides[i].length) > least_element)
      shapes[i] = curve_shape(std::abs(turns[i]), curves[i]);
  }
  AlignmentBuilder builder;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Side& side = sides[i];
    const double straight = side.length - shapes[i].tangent_out - shapes[i + 1].tangent_in;
    if (straight < -1e-6)
      refuse_point(i + 1,
                   ": the curves at both ends of the side before it need " +
                       text_of(side.length - straight) + " m, but it has " + text_of(side.length),
                   "Make the radii or clothoids smaller, or move the points apart.");
    const double from = shapes[i].tangent_out;
    builder.add({{line[i].x + from * side.direction.x, line[i].y + from * side.direction.y, 0},
                 side.heading,
                 0},
                straight, 0);
    if (shapes[i + 1].tangent_in > 0)
      add_curve(builder, line[i + 1], side, turns[i + 1], curves[i + 1], shapes[i + 1]);
  }
  return builder.take();
}

double alignment_length(const std::vector<AlignmentElement>& elements) {
  return elements.empty() ? 0 : elements.back().abscissa + elements.back().length;
}

AlignmentPlace alignment_place(const std::vector<AlignmentElement>& elements, double abscissa) {
  if (elements.empty()) throw Error(ErrorKind::invalid_input, "the alignment has no elements");
  const auto after =
      std::upper_bound(elements.begin(), elements.end(), abscissa,
                       [](double s, const AlignmentElement& e) { return s < e.abscissa; });
  const AlignmentElement& element = after == elements.begin() ? elements.front() : after[-1];
  return element_place(element, std::clamp(abscissa - element.abscissa, 0.0, element.length));
}

std::vector<double> chord_abscissas(const std::vector<AlignmentElement>& elements,
                                    double tolerance) {
  if (!(tolerance >= 1e-5 && tolerance <= 100))
    throw Error(ErrorKind::invalid_input, "tolerance is " + text_of(tolerance) + " m",
                "Expected 1e-5 to 100.");
  std::vector<double> abscissas;
  for (const AlignmentElement& element : elements) {
    const double a = std::abs(element.curvature_start), b = std::abs(element.curvature_end);
    // A chord of length c leaves a curve by c^2 k / 8; along a clothoid chords grow as 1 / sqrt k.
    const auto count_to = [&](double k) { return 2.0 / 3 * std::pow(k, 1.5); };
    const double rate = element.length > 0 ? std::abs(b - a) / element.length : 0;
    const bool bends_one_way = element.curvature_start * element.curvature_end >= 0;
    const double densest = std::max(a, b) * element.length * element.length / 8 / tolerance;
    const double chords = rate > 0 && bends_one_way ? std::abs(count_to(b) - count_to(a)) / rate /
                                                          std::sqrt(8 * tolerance) * 1.1
                                                    : std::sqrt(densest);
    const int parts = std::max(1, static_cast<int>(std::ceil(chords - 1e-9)));
    for (int i = 0; i < parts; ++i) {
      double share = static_cast<double>(i) / parts;
      if (rate > 0 && bends_one_way) {
        const double k =
            std::pow(std::pow(a, 1.5) + share * (std::pow(b, 1.5) - std::pow(a, 1.5)), 2.0 / 3);
        share = (k - a) / (b - a);
      }
      abscissas.push_back(element.abscissa + share * element.length);
    }
  }
  abscissas.push_back(alignment_length(elements));
  return abscissas;
}

}  // namespace streetgen
