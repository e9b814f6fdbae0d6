#include "fit/residual.hpp"

#include <cmath>

namespace streetgen {

namespace {

constexpr double full_turn = 6.283185307179586;

// Adds the slopes by the vertices of the segment: those of the offset from it, and those of the
// abscissa, times what a metre of each changes.
void depend_on_vertices(const FittedCourse& fitted, const Course& course, const FitMatch& match,
                        double by_offset, double by_abscissa, Residual& residual) {
  const CourseVertex &from = course.vertices[match.segment],
                     &to = course.vertices[match.segment + 1];
  if (from.x == not_free && to.x == not_free) return;
  const Point along =
      planar(fitted.vertex(match.segment + 1)) - planar(fitted.vertex(match.segment));
  const Point across = match.normal * match.offset;
  const bool clamped = match.along == 0 || match.along == 1;
  const double stretched =
      clamped ? 0 : by_abscissa * (to.abscissa - from.abscissa) / dot(along, along);
  const auto depend = [&](int x, double share, const Point& by_share) {
    if (x == not_free) return;
    const Point slope = match.normal * (-by_offset * share) + by_share * stretched;
    residual.depends(x, slope.x);
    residual.depends(x + 1, slope.y);
  };
  depend(from.x, 1 - match.along, along * (match.along - 1) - across);
  depend(to.x, match.along, across - along * match.along);
}

// Adds the slope of a width at an abscissa.
void depend_on_width(const Course& course, double abscissa, double factor, Residual& residual) {
  const double share = abscissa / course.total;
  if (course.width_end == course.width_start) return residual.depends(course.width_start, factor);
  residual.depends(course.width_start, factor * (1 - share));
  residual.depends(course.width_end, factor * share);
}

// The border between two of at least two equally wide lanes that is nearest to an offset: its share
// of the width, from the right kerb.
double nearest_border(const FittedCourse& fitted, int lanes, const FitMatch& match) {
  const double width = fitted.width(match.abscissa);
  const double share = (match.offset - fitted.offset() + width / 2) / width;
  return std::clamp(std::round(share * lanes), 1.0, lanes - 1.0) / lanes;
}

// The loss of a kind with its factor begins at as many metres as that of a kerb.
double scale_of(double factor, double scale, const FitRules& rules) {
  return factor > 0 && rules.observation > 0 ? scale * factor / rules.observation : scale;
}

struct Turn {
  double angle;
  Point slopes[3];  // by each of three vertices
};

// The angle at the middle one of three vertices.
Turn turn_at(const Point& a, const Point& b, const Point& c) {
  const Point before = b - a, behind = c - b;
  const Point by_before = left_normal(before) * (1 / dot(before, before));
  const Point by_behind = left_normal(behind) * (1 / dot(behind, behind));
  return {std::atan2(cross(before, behind), dot(before, behind)),
          {by_before, (by_before + by_behind) * -1, by_behind}};
}

}  // namespace

bool residual_of(const Observation& observation, const FitMatch& match, const FitAxis& axis,
                 const Course& course, const std::vector<double>& values, const FitRules& rules,
                 double scale, Residual& residual) {
  if (match.axis < 0 || observation.kind == ObservationKind::sidewalk_back) return false;
  const FittedCourse fitted(axis, course, values);
  // Metres that the width grows by in each metre along the axis.
  const double taper = (fitted.width_end() - fitted.width_start()) / course.total;
  residual.count = 0;
  residual.weight = observation.weight;
  residual.loss = {rules.loss, scale};
  if (observation.kind == ObservationKind::width) {
    const double factor = observation.confidence * rules.observed_width;
    residual.loss.scale = scale_of(rules.observed_width, scale, rules);
    residual.value = factor * (fitted.width(match.abscissa) - observation.width);
    depend_on_width(course, match.abscissa, factor, residual);
    depend_on_vertices(fitted, course, match, 0, factor * taper, residual);
    return true;
  }
  const bool object = observation.kind == ObservationKind::object;
  const double factor = observation.confidence * (object ? rules.object : rules.observation);
  if (object) residual.loss.scale = scale_of(rules.object, scale, rules);
  if (observation.kind == ObservationKind::marking) {
    const double share = nearest_border(fitted, axis.lanes, match) - 0.5;
    residual.value =
        factor * (match.offset - fitted.offset() - share * fitted.width(match.abscissa));
    residual.depends(course.offset, -factor);
    depend_on_width(course, match.abscissa, -factor * share, residual);
    depend_on_vertices(fitted, course, match, factor, -factor * share * taper, residual);
    return true;
  }
  double beyond = match.side * match.offset - fitted.to_kerb(match.abscissa, match.side);
  if (object && observation.relation == ObservationRelation::in)
    beyond = std::max(0.0, beyond + rules.object_margin);
  if (object && observation.relation == ObservationRelation::out)
    beyond = std::min(0.0, beyond - rules.object_margin);
  if (object && beyond == 0 && observation.relation != ObservationRelation::border) return false;
  residual.value = factor * beyond;
  residual.depends(course.offset, -factor * match.side);
  depend_on_width(course, match.abscissa, -factor / 2, residual);
  depend_on_vertices(fitted, course, match, factor * match.side, -factor / 2 * taper, residual);
  return true;
}

Residual spacing_residual(const FitAxis& axis, const Course& course, std::size_t segment,
                          const std::vector<double>& values, const FitRules& rules) {
  const FittedCourse fitted(axis, course, values);
  const CourseVertex &from = course.vertices[segment], &to = course.vertices[segment + 1];
  const Point along = fitted.vertex(segment + 1) - fitted.vertex(segment);
  Residual residual;
  residual.loss = {FitLoss::soft_l1, rules.scale};
  residual.value = rules.spacing * (norm(along) - distance(from.origin, to.origin));
  const Point slope = unit(along) * rules.spacing;
  if (to.x != not_free) {
    residual.depends(to.x, slope.x);
    residual.depends(to.x + 1, slope.y);
  }
  if (from.x != not_free) {
    residual.depends(from.x, -slope.x);
    residual.depends(from.x + 1, -slope.y);
  }
  return residual;
}

Residual angle_residual(const FitAxis& axis, const Course& course, std::size_t vertex,
                        const std::vector<double>& values, const FitRules& rules) {
  const FittedCourse fitted(axis, course, values);
  const auto& vertices = course.vertices;
  const Turn turn =
      turn_at(fitted.vertex(vertex - 1), fitted.vertex(vertex), fitted.vertex(vertex + 1));
  const double before =
      turn_at(vertices[vertex - 1].origin, vertices[vertex].origin, vertices[vertex + 1].origin)
          .angle;
  Residual residual;
  residual.loss = {FitLoss::soft_l1, rules.scale};
  residual.value = rules.angle * std::remainder(turn.angle - before, full_turn);
  for (std::size_t i = 0; i < 3; ++i) {
    const int x = vertices[vertex + i - 1].x;
    if (x == not_free) continue;
    residual.depends(x, rules.angle * turn.slopes[i].x);
    residual.depends(x + 1, rules.angle * turn.slopes[i].y);
  }
  return residual;
}

}  // namespace streetgen
