#include "roadway/section_borders.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "layout/width_transition.hpp"

namespace streetgen {

namespace {

// One kerb changes from limit to limit, the other one may step at the node.
std::vector<WidthProfile::Place> transition_places(const Layout& layout, const Junction& junction,
                                                   const EdgeEnd& end) {
  const bool is_from = slot(end) == slot(junction.ends[junction.transition_from()]);
  const EdgeEnd& beyond = junction.ends[slot(end) == slot(junction.ends[0]) ? 1 : 0];
  const Arm &arm = layout.arm(end), &other = layout.arm(beyond);
  const double total = arm.limit + other.limit;
  const double step = step_length(arm.limit, other.limit);
  // Left and right are those of the transition, which comes in along its first arm.
  const auto steps = [&](int side) {
    const TransitionKind kind = junction.transition->kind;
    const bool on_left = (side > 0) != is_from;
    return step > 0 && kind != TransitionKind::symmetric &&
           (kind == TransitionKind::left) != on_left;
  };
  const auto half = [&](double abscissa, int side) {
    const double own = half_at(arm, arm.limit, side), its = half_at(other, other.limit, -side);
    const double share =
        steps(side) ? std::max(0.0, 0.5 - abscissa / step) : (arm.limit - abscissa) / total;
    return own + (its - own) * share;
  };
  std::vector<WidthProfile::Place> places;
  for (const double abscissa : {0.0, step / 2, arm.limit})
    places.push_back({abscissa, half(abscissa, +1), half(abscissa, -1)});
  return places;
}

// From the node to the limit, seen from the node; none where nothing changes there.
std::vector<WidthProfile::Place> places_before_limit(const Layout& layout, const EdgeEnd& end) {
  const Junction& junction = layout.junction_of(end);
  if (junction.dead_end() || junction.straight || layout.arm(end).limit <= 0) return {};
  if (junction.transition) return transition_places(layout, junction, end);
  const auto at = std::find_if(junction.ends.begin(), junction.ends.end(),
                               [&](const EdgeEnd& other) { return slot(other) == slot(end); });
  std::vector<Arm> arms;
  for (const EdgeEnd& other : junction.ends) arms.push_back(layout.arm(other));
  return tapered(arms, junction.gaps, static_cast<std::size_t>(at - junction.ends.begin())).places;
}

}  // namespace

WidthProfile section_borders(const Layout& layout, int e) {
  if (limits_crossed(layout.streets, e)) return {};
  const Arm& arm = layout.arms[2 * e];
  const WidthProfile& own = layout.streets.roadways[e].profile;
  const std::vector<WidthProfile::Place> start = places_before_limit(layout, {e, true}),
                                         end = places_before_limit(layout, {e, false});
  if (own.empty() && start.empty() && end.empty()) return {};
  const double total = length(arm.line);
  const double from = layout.streets.limits[2 * e].abscissa,
               to = layout.streets.limits[2 * e + 1].abscissa;
  const auto plain = [&](double abscissa) -> WidthProfile::Place {
    if (!own.empty()) return own.at(abscissa);
    return {abscissa, half_at(arm, abscissa, +1), half_at(arm, abscissa, -1)};
  };
  std::vector<WidthProfile::Place> places = start;
  if (start.empty()) places = {plain(0), plain(from)};
  for (const WidthProfile::Place& place : own.places)
    if (place.abscissa > from && place.abscissa < to) places.push_back(place);
  if (end.empty()) {
    places.push_back(plain(to));
    places.push_back(plain(total));
  }
  for (auto place = end.rbegin(); place != end.rend(); ++place)
    places.push_back({total - place->abscissa, place->right, place->left});
  WidthProfile borders;
  for (const WidthProfile::Place& place : places)
    if (borders.empty() || place.abscissa > borders.places.back().abscissa + coordinate_margin)
      borders.places.push_back(place);
  return borders;
}

}  // namespace streetgen
