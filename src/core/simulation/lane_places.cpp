#include "simulation/lane_places.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

double height_at(const Line& line, double abscissa) {
  const LinePosition place = position_at(line, abscissa);
  const Point &a = line[place.segment], &b = line[place.segment + 1];
  const double whole = distance(a, b);
  return whole == 0 ? a.z : a.z + (b.z - a.z) * distance(a, place.point) / whole;
}

// Sorted, each place once.
std::vector<double> ascending(std::vector<double> places) {
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

}  // namespace

LanePlaces::LanePlaces(const TrafficEdge& edge, const TrafficLink& lane)
    : measures_(lane_measures(edge.line, lane.along ? lane.line : reversed(lane.line), edge.widest,
                              lane.first, lane.last)),
      along_(lane.along),
      length_(length(lane.line)) {}

double LanePlaces::on_link(double abscissa) const {
  const double metres = measure_at(measures_.on_axis, measures_.on_lane, abscissa);
  return along_ ? metres : length_ - metres;
}

std::vector<LinkBeside> stretches_beside(const TrafficBeside& beside, const LanePlaces& lane,
                                         const LanePlaces& other, int other_link) {
  std::vector<double> places{beside.from, beside.to};
  for (const LanePlaces* one : {&lane, &other})
    for (const double at : one->breaks())
      if (at > beside.from && at < beside.to) places.push_back(at);
  places = ascending(std::move(places));
  std::vector<LinkBeside> stretches;
  for (std::size_t i = 1; i < places.size(); ++i) {
    LinkBeside stretch;
    stretch.link = other_link;
    stretch.left = beside.left;
    stretch.may_change = beside.may_change;
    stretch.opposite = beside.opposite;
    double from = lane.on_link(places[i - 1]), to = lane.on_link(places[i]);
    double other_from = other.on_link(places[i - 1]), other_to = other.on_link(places[i]);
    if (from > to) std::swap(from, to), std::swap(other_from, other_to);
    if (from == to) continue;
    stretch.from = from, stretch.to = to;
    stretch.other_from = other_from, stretch.other_to = other_to;
    stretches.push_back(stretch);
  }
  std::sort(stretches.begin(), stretches.end(),
            [](const LinkBeside& a, const LinkBeside& b) { return a.from < b.from; });
  return stretches;
}

std::vector<LinkHeight> lane_heights(const TrafficEdge& edge, const TrafficLink& lane,
                                     const LanePlaces& places) {
  if (!edge.has_heights) return {};
  std::vector<double> at{lane.first, lane.last};
  double abscissa = 0;
  for (std::size_t i = 1; i < edge.line.size(); ++i) {
    abscissa += distance(edge.line[i - 1], edge.line[i]);
    if (abscissa > lane.first && abscissa < lane.last) at.push_back(abscissa);
  }
  std::vector<LinkHeight> heights;
  for (const double place : ascending(std::move(at)))
    heights.push_back({static_cast<float>(places.on_link(place)),
                       static_cast<float>(height_at(edge.line, place))});
  if (!lane.along) std::reverse(heights.begin(), heights.end());
  return heights;
}

}  // namespace streetgen
