#include "height/bridge_ground.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"
#include "support/disjoint_sets.hpp"

namespace streetgen {

namespace {

constexpr double free_end = 10;  // metres at each end of a bridge that need not be clear

class Bridges {
 public:
  Bridges(const std::vector<ProfileEdge>& edges, const std::vector<ProfileLift>& lifts)
      : edges_(edges),
        length_(edges.size()),
        whole_(static_cast<int>(edges.size())),
        whole_length_(edges.size()),
        crosses_(edges.size()) {
    for (int e = 0; e < whole_.size(); ++e) {
      if (edges[e].rise == 0) continue;
      length_[e] = length(edges[e].line);
      if (!edges[e].ends_from) led_on_[edges[e].from_node].push_back(e);
      if (!edges[e].ends_to) led_on_[edges[e].to_node].push_back(e);
    }
    for (const auto& [node, around] : led_on_) {
      for (const int e : around) whole_.join(e, around.front());
      ends_[node] = ends_from(node);
      poll_cancel();
    }
    for (int e = 0; e < whole_.size(); ++e) whole_length_[whole_.of(e)] += length_[e];
    for (const ProfileLift& lift : lifts)
      for (const int e : {lift.above, lift.below})
        if ((e == lift.above) == (edges[e].rise > 0)) crosses_[whole_.of(e)] = true;
  }

  HeightLine ground(int e) const {
    const ProfileEdge& edge = edges_[e];
    const HeightLine ground = heights_of(edge.line);
    if (edge.rise == 0) return kinks_of(ground);
    const double from =
        edge.ends_from ? ground.front().z : between_ends(edge.from_node, ground.front().z);
    const double to = edge.ends_to ? ground.back().z : between_ends(edge.to_node, ground.back().z);
    return {{0, from}, {ground.back().at, to}};
  }

  // Metres from that end of the edge to where the bridge ends, infinite: nowhere.
  double to_end(int e, bool at_start) const {
    const ProfileEdge& edge = edges_[e];
    if (at_start ? edge.ends_from : edge.ends_to) return 0;
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [metres, z] : ends_.at(at_start ? edge.from_node : edge.to_node))
      least = std::min(least, metres);
    return least;
  }

  // May the whole bridge stay level with the ground, if one that is shorter may?
  bool may_be_level(int e, double level_length) {
    const int whole = whole_.of(e);
    return !crosses_[whole] && whole_length_[whole] < level_length;
  }

 private:
  struct End {
    double metres, z;
  };
  using Reached = std::pair<double, std::int64_t>;  // metres, node

  // The shortest way to each end of the bridge.
  std::vector<End> ends_from(std::int64_t start) const {
    std::map<std::int64_t, double> reached;
    std::map<std::pair<int, bool>, End> ends;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
    open.push({0, start});
    while (!open.empty()) {
      const auto [metres, node] = open.top();
      open.pop();
      if (!reached.try_emplace(node, metres).second) continue;
      for (const int e : led_on_.at(node)) {
        const ProfileEdge& edge = edges_[e];
        for (const bool to_start : {true, false}) {
          const bool leads_there = to_start ? edge.to_node == node && !edge.ends_to
                                            : edge.from_node == node && !edge.ends_from;
          if (!leads_there) continue;
          const double there = metres + length_[e];
          if (!(to_start ? edge.ends_from : edge.ends_to))
            open.push({there, to_start ? edge.from_node : edge.to_node});
          else
            ends.try_emplace({e, to_start},
                             End{there, to_start ? edge.line.front().z : edge.line.back().z});
        }
      }
    }
    std::vector<End> all;
    for (const auto& [place, end] : ends) all.push_back(end);
    return all;
  }

  // The height lies evenly between two ends; of more ends the nearer ones count for more.
  double between_ends(std::int64_t node, double otherwise) const {
    double sum = 0, weights = 0;
    for (const End& end : ends_.at(node)) {
      const double weight = 1 / std::max(end.metres, same_place);
      sum += weight * end.z;
      weights += weight;
    }
    return weights > 0 ? sum / weights : otherwise;
  }

  const std::vector<ProfileEdge>& edges_;
  std::vector<double> length_;  // of bridges, metres
  Groups whole_;                // bridges that lead each other on are one
  std::vector<double> whole_length_;
  std::vector<bool> crosses_;                        // does the whole bridge cross a road?
  std::map<std::int64_t, std::vector<int>> led_on_;  // bridges at a node where none of them ends
  std::map<std::int64_t, std::vector<End>> ends_;    // of the whole bridge, from such a node
};

ClearStretch clear_stretch(const Bridges& bridges, const ProfileEdge& edge, int e) {
  ClearStretch clear{e, edge.rise < 0, {}, true, true};
  const HeightLine beneath = heights_of(edge.line);
  const double length = beneath.back().at;
  const double from = std::max(0.0, free_end - bridges.to_end(e, true));
  const double to = length - std::max(0.0, free_end - bridges.to_end(e, false));
  if (to - from <= same_place) return clear;
  clear.falls_from = from > 0, clear.falls_to = to < length;
  clear.bound.push_back({from, height_at(beneath, from) + edge.rise});
  for (const HeightPoint& point : beneath)
    if (point.at > from + same_place && point.at < to - same_place)
      clear.bound.push_back({point.at, point.z + edge.rise});
  clear.bound.push_back({to, height_at(beneath, to) + edge.rise});
  return clear;
}

}  // namespace

BridgeGround ground_with_bridges(const std::vector<ProfileEdge>& edges,
                                 const std::vector<ProfileLift>& lifts, double level_length) {
  Bridges bridges(edges, lifts);
  BridgeGround all;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const int edge = static_cast<int>(e);
    all.ground.push_back(bridges.ground(edge));
    if (edges[e].rise == 0) continue;
    if (bridges.may_be_level(edge, level_length)) continue;
    if (ClearStretch clear = clear_stretch(bridges, edges[e], edge); !clear.bound.empty())
      all.clear.push_back(std::move(clear));
  }
  return all;
}

}  // namespace streetgen
