#include "mesh/axis_height.hpp"

#include <algorithm>
#include <limits>

#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

constexpr double first_reach = 8;   // metres: axes are mostly nearer to their border
constexpr double last_reach = 1e6;  // metres: beyond it every axis is asked

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

double AxisHeight::at(const Point& place, int level) const {
  const auto known = levels_.find(level);
  if (known == levels_.end()) return 0;
  const std::vector<Segment>& segments = known->second.segments;
  double least = std::numeric_limits<double>::infinity(), height = 0;
  const auto ask = [&](int index) {
    const Point &from = segments[index].from, &to = segments[index].to;
    const Point along = to - from, off = place - from;
    const double square = dot(along, along);
    const double share = square > 0 ? std::clamp(dot(off, along) / square, 0.0, 1.0) : 0;
    const double apart = distance(place, from + along * share);
    const double z = from.z + (to.z - from.z) * share;
    if (apart > least || (apart == least && z >= height)) return;
    least = apart;
    height = z;
  };
  for (double reach = first_reach; reach < last_reach; reach *= 4) {
    known->second.index.each_near(box_of(place, place), reach, ask);
    if (least <= reach) return height;
  }
  for (std::size_t i = 0; i < segments.size(); ++i) ask(static_cast<int>(i));
  return height;
}

}  // namespace streetgen
