#include "fit/match.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/box_index.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/progress.hpp"

namespace streetgen {

namespace {

// The stretch whose section holds an abscissa; -1: none.
int section_at(const FitAxis& axis, double abscissa) {
  for (std::size_t i = 0; i < axis.stretches.size(); ++i)
    if (axis.stretches[i].from < abscissa && abscissa < axis.stretches[i].to)
      return static_cast<int>(i);
  return -1;
}

}  // namespace

FitMatcher::FitMatcher(const std::vector<FitAxis>& axes, const Unknowns& unknowns,
                       const std::vector<Observation>& observations, const FitRules& rules)
    : axes_(axes), unknowns_(unknowns), observations_(observations), rules_(rules) {
  std::vector<Box> boxes;
  double farthest = rules.width_greatest / 2;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const auto& vertices = unknowns.courses[a].vertices;
    farthest = std::max(farthest, std::max(axes[a].width_start, axes[a].width_end) / 2 +
                                      std::abs(axes[a].roadway_offset));
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      segments_.push_back({static_cast<int>(a), static_cast<int>(i - 1)});
      boxes.push_back(box_of(vertices[i - 1].origin, vertices[i].origin));
    }
  }
  const BoxIndex index(boxes);
  const double reach = rules.reach + farthest + (rules.axes_move ? 2 * rules.move : rules.move);
  first_near_.push_back(0);
  for (std::size_t i = 0; i < observations.size(); ++i) {
    poll_cancel();
    if (i % 4096 == 0) tell_progress("observations near streets", i, observations.size());
    const Point& place = observations[i].place;
    const bool counts = observations[i].confidence > 0;
    for (int segment : counts ? index.near(box_of(place, place), reach) : std::vector<int>{}) {
      const auto& vertices = unknowns.courses[segments_[segment].axis].vertices;
      const int at = segments_[segment].segment;
      if (distance_to_segment(place, vertices[at].origin, vertices[at + 1].origin) <= reach)
        near_.push_back(segment);
    }
    first_near_.push_back(near_.size());
  }
}

bool FitMatcher::place_at(const Point& place, const std::vector<double>& values,
                          const Segment& segment, FitMatch& match) const {
  const Course& course = unknowns_.courses[segment.axis];
  const FittedCourse fitted(axes_[segment.axis], course, values);
  const Point from = planar(fitted.vertex(segment.segment));
  const Point along = planar(fitted.vertex(segment.segment + 1)) - from;
  const double square = dot(along, along);
  if (square == 0) return false;
  match.axis = segment.axis;
  match.segment = segment.segment;
  match.along = std::clamp(dot(planar(place) - from, along) / square, 0.0, 1.0);
  const Point across = planar(place) - (from + along * match.along);
  match.side = cross(along, across) >= 0 ? 1 : -1;
  const double off = norm(across);
  match.normal = off > 1e-9 ? across * (match.side / off) : left_normal(unit(along));
  match.offset = match.side * off;
  const double start = course.vertices[segment.segment].abscissa;
  match.abscissa = start + (course.vertices[segment.segment + 1].abscissa - start) * match.along;
  return true;
}

double FitMatcher::score(const Observation& observation, const std::vector<double>& values,
                         const FitMatch& match) const {
  const FittedCourse fitted(axes_[match.axis], unknowns_.courses[match.axis], values);
  const double beyond = std::abs(match.offset) - fitted.to_kerb(match.abscissa, match.side);
  switch (observation.kind) {
    case ObservationKind::width:
    case ObservationKind::marking:
      return beyond > rules_.reach ? beyond : std::min(std::abs(match.offset) / 1e3, rules_.reach);
    case ObservationKind::sidewalk_back:
      return beyond < 0 ? rules_.reach + 1 - beyond : beyond;
    case ObservationKind::object:
      if (observation.relation == ObservationRelation::in) return std::max(beyond, 0.0);
      break;
    case ObservationKind::kerb:
      break;
  }
  return std::abs(beyond);
}

FitMatch FitMatcher::match(int observation, const std::vector<double>& values) const {
  const Observation& one = observations_[observation];
  FitMatch best;
  double least = rules_.reach;
  for (std::size_t i = first_near_[observation]; i < first_near_[observation + 1];) {
    // An axis has the place that is nearest, whatever its kerb: two segments reach far beside a
    // bend.
    FitMatch match, other;
    const int axis = segments_[near_[i]].axis;
    for (; i < first_near_[observation + 1] && segments_[near_[i]].axis == axis; ++i)
      if (place_at(one.place, values, segments_[near_[i]], other) &&
          (match.axis < 0 || std::abs(other.offset) < std::abs(match.offset)))
        match = other;
    if (match.axis < 0) continue;
    const double score = this->score(one, values, match);
    if (score > rules_.reach || (best.axis >= 0 && score >= least)) continue;
    match.stretch = section_at(axes_[match.axis], match.abscissa);
    if (match.stretch < 0) {
      best.at_junction = true;
      continue;
    }
    least = score;
    match.at_junction = best.at_junction;
    best = match;
  }
  // A street of one lane has no line between lanes.
  if (one.kind == ObservationKind::marking && best.axis >= 0 && axes_[best.axis].lanes < 2)
    return {};
  return best;
}

void FitMatcher::renew(int observation, const std::vector<double>& values, FitMatch& match) const {
  const int stretch = match.stretch;
  place_at(observations_[observation].place, values, {match.axis, match.segment}, match);
  match.stretch = stretch;
}

}  // namespace streetgen
