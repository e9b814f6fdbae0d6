// A part of a road, with its lanes.
#include <algorithm>
#include <cstddef>
#include <vector>

#include "lane/lane_limit.hpp"
#include "streetgen/road_lanes.hpp"

namespace streetgen {

namespace {

// The pieces of a chain from one station to another.
std::vector<PlanPiece> chain_part(const std::vector<PlanPiece>& chain, double from, double to) {
  std::vector<PlanPiece> part;
  for (const PlanPiece& piece : chain) {
    const double first = std::max(from, piece.s), last = std::min(to, piece.s + piece.length);
    if (last <= first) continue;
    const double change = (piece.curvature_end - piece.curvature) / piece.length;
    PlanPiece cut;
    cut.s = first - from;
    cut.start = place_at(std::vector<PlanPiece>{piece}, first);
    cut.length = last - first;
    cut.curvature = piece.curvature + change * (first - piece.s);
    cut.curvature_end = piece.curvature + change * (last - piece.s);
    part.push_back(cut);
  }
  return part;
}

// The value of a border at a station.
double value_at(const std::vector<double>& stations, const std::vector<double>& border, double s) {
  const auto behind = std::upper_bound(stations.begin() + 1, stations.end() - 1, s);
  const std::size_t k = behind - stations.begin();
  const double share = (s - stations[k - 1]) / (stations[k] - stations[k - 1]);
  return border[k - 1] + (border[k] - border[k - 1]) * share;
}

}  // namespace

RoadLanes road_part(const RoadLanes& road, double from, double to) {
  RoadLanes part;
  part.chain = chain_part(road.chain, from, to);
  if (part.chain.empty()) return {};
  part.stations.push_back(0);
  for (const double s : road.stations)
    if (s > from && s < to) part.stations.push_back(s - from);
  part.stations.push_back(to - from);
  for (const auto& border : road.borders) {
    part.borders.emplace_back();
    for (const double s : part.stations)
      part.borders.back().push_back(value_at(road.stations, border, s + from));
  }
  for (std::size_t p = 0; p + 1 < part.borders.size(); ++p) {
    part.starts.push_back(lane_limit(part, p, true));
    part.ends.push_back(lane_limit(part, p, false));
  }
  return part;
}

}  // namespace streetgen
