#include "mesh/axis_height.hpp"

#include <algorithm>
#include <tuple>

#include "geometry/polyline.hpp"
#include "geometry/space.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

constexpr double first_reach = 0.1;  // metres: most places lie in a roadway
constexpr double last_reach = 1e6;   // metres: beyond it every axis is asked
constexpr double as_near = 1e-6;     // metres
constexpr double at_border = 0.01;   // metres: a vertex of the kerb lies in its roadway

}  // namespace

AxisHeight::AxisHeight(const std::vector<HeightAxis>& axes) {
  for (const HeightAxis& axis : axes)
    for (std::size_t i = 1; i < axis.line.size(); ++i)
      levels_[axis.level].segments.push_back(
          {axis.line[i - 1], axis.line[i], axis.half_width, i == 1, i + 1 == axis.line.size()});
  for (auto& [level, known] : levels_) {
    std::vector<Box> boxes;
    for (const Segment& segment : known.segments)
      boxes.push_back(box_of(segment.from, segment.to).grown(segment.half_width + at_border));
    known.index = BoxIndex(boxes);
  }
}

AxisHeight::Sight AxisHeight::sight(const Segment& segment, const Point& place) {
  const auto& [from, to, half_width, first, last] = segment;
  const Point along = to - from, off = place - from;
  const double metres = norm(along), at = metres > 0 ? dot(off, along) / metres : 0;
  const double share = metres > 0 ? std::clamp(at / metres, 0.0, 1.0) : 0;
  const double apart = distance(place, from + along * share);
  // A roadway ends across its axis.
  const bool before = (first && at < -at_border) || (last && at > metres + at_border);
  return {before ? apart : std::max(0.0, apart - half_width - at_border), apart,
          from.z + (to.z - from.z) * share};
}

AxisHeight::Sight AxisHeight::nearest(const Point& place, int level) const {
  const auto known = levels_.find(level);
  if (known == levels_.end()) return {};
  const std::vector<Segment>& segments = known->second.segments;
  Sight best{infinite, infinite, 0};
  const auto order = [](const Sight& s) { return std::tie(s.beyond, s.distance, s.height); };
  const auto ask = [&](int index) {
    const Sight own = sight(segments[index], place);
    if (order(own) < order(best)) best = own;
  };
  for (double reach = first_reach; reach < last_reach; reach *= 4) {
    known->second.index.each_near(box_of(place, place), reach, ask);
    if (best.beyond <= reach) return best;
  }
  for (std::size_t i = 0; i < segments.size(); ++i) ask(static_cast<int>(i));
  return best;
}

Point AxisHeight::normal(const Point& place, int level) const {
  const Point up{0, 0, 1};
  const auto known = levels_.find(level);
  if (known == levels_.end()) return up;
  const Sight best = nearest(place, level);
  Point sum{};
  // In the order of the axes, so that the sum is the same whoever asks.
  for (const int index : known->second.index.near(box_of(place, place), best.beyond + as_near)) {
    const Segment& segment = known->second.segments[index];
    const Sight own = sight(segment, place);
    if (own.beyond > best.beyond + as_near || own.distance > best.distance + as_near) continue;
    const Point along = segment.to - segment.from;
    const double metres = norm(along);
    if (metres == 0) continue;
    const double slope = along.z / metres;
    sum = sum + space::unit({-slope * along.x / metres, -slope * along.y / metres, 1});
  }
  return space::norm(sum) > 0 ? space::unit(sum) : up;
}

}  // namespace streetgen
