#include "mesh/axis_height.hpp"

#include <algorithm>

#include "geometry/polyline.hpp"
#include "geometry/space.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

constexpr double first_reach = 8;   // metres: axes are mostly nearer to their border
constexpr double last_reach = 1e6;  // metres: beyond it every axis is asked
constexpr double as_near = 1e-6;    // metres

}  // namespace

AxisHeight::AxisHeight(const std::vector<HeightAxis>& axes) {
  for (const HeightAxis& axis : axes)
    for (std::size_t i = 1; i < axis.line.size(); ++i)
      levels_[axis.level].segments.push_back({axis.line[i - 1], axis.line[i]});
  for (auto& [level, known] : levels_) {
    std::vector<Box> boxes;
    for (const Segment& segment : known.segments) boxes.push_back(box_of(segment.from, segment.to));
    known.index = BoxIndex(boxes);
  }
}

AxisHeight::Sight AxisHeight::sight(const Segment& segment, const Point& place) {
  const auto& [from, to] = segment;
  const Point along = to - from, off = place - from;
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(off, along) / square, 0.0, 1.0) : 0;
  return {distance(place, from + along * share), from.z + (to.z - from.z) * share};
}

AxisHeight::Sight AxisHeight::nearest(const Point& place, int level) const {
  const auto known = levels_.find(level);
  if (known == levels_.end()) return {};
  const std::vector<Segment>& segments = known->second.segments;
  Sight best{infinite, 0};
  const auto ask = [&](int index) {
    const Sight own = sight(segments[index], place);
    if (own.distance > best.distance ||
        (own.distance == best.distance && own.height >= best.height))
      return;
    best = own;
  };
  for (double reach = first_reach; reach < last_reach; reach *= 4) {
    known->second.index.each_near(box_of(place, place), reach, ask);
    if (best.distance <= reach) return best;
  }
  for (std::size_t i = 0; i < segments.size(); ++i) ask(static_cast<int>(i));
  return best;
}

Point AxisHeight::normal(const Point& place, int level) const {
  const Point up{0, 0, 1};
  const auto known = levels_.find(level);
  if (known == levels_.end()) return up;
  const double reach = nearest(place, level).distance + as_near;
  Point sum{};
  // In the order of the axes, so that the sum is the same whoever asks.
  for (const int index : known->second.index.near(box_of(place, place), reach)) {
    const Segment& segment = known->second.segments[index];
    if (sight(segment, place).distance > reach) continue;
    const Point along = segment.to - segment.from;
    const double metres = norm(along);
    if (metres == 0) continue;
    const double slope = along.z / metres;
    sum = sum + space::unit({-slope * along.x / metres, -slope * along.y / metres, 1});
  }
  return space::norm(sum) > 0 ? space::unit(sum) : up;
}

}  // namespace streetgen
