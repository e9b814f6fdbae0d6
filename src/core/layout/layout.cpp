#include "layout/layout.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "geometry/polyline.hpp"
#include "layout/node_corner.hpp"
#include "layout/round_rings.hpp"
#include "layout/smooth_edges.hpp"
#include "streetgen/kerbs_by_area.hpp"
#include "streetgen/street_network.hpp"

namespace streetgen {

namespace {

// Lengths that differ by noise are equal: the bounds lie beside whole and half millimetres, which
// are drawn.
std::int64_t millimetres(double metres) { return std::llround(1000 * metres + 0.1137); }

}  // namespace

Layout::Layout(const std::vector<StreetAxis>& all, const StreetSettings& wanted,
               const std::vector<RoadOverride>& overrides)
    : settings(wanted) {
  std::unordered_map<std::int64_t, const StreetAxis*> by_id;
  for (const StreetAxis& axis : all) by_id.emplace(axis.axis_id, &axis);
  streets.network = 
      street_network(all, settings.tolerance, settings.crossing, settings.controls);
  if (settings.smoothing)
    smooth_edges(streets.network, *settings.smoothing, overrides);
  else
    round_rings(streets.network, all, settings.ring_shift);
  for (const Edge& edge : streets.network.edges) axes.push_back(by_id.at(edge.axis_id));
  streets.roadways.reserve(axes.size());
  arms.reserve(2 * axes.size());
  junctions.resize(streets.network.nodes.size());
  for (int e = 0; e < static_cast<int>(axes.size()); ++e) add_arms(e);
  sort_ends();
}

void Layout::add_arms(int e) {
  const Edge& edge = streets.network.edges[e];
  const StreetAxis& axis = axis_of(e);
  const double total = length(axis.line);
  axis_lengths.push_back(millimetres(total));
  const auto half = [&](double abscissa) {
    const double share = total > 0 ? std::clamp(abscissa / total, 0.0, 1.0) : 0;
    return (axis.width + (axis.width_end - axis.width) * share) / 2;
  };
  const double start = half(edge.start_abscissa), end = half(edge.end_abscissa);
  streets.roadways.push_back({2 * start, 2 * end, axis.importance, axis.roadway_offset});
  Line line = distinct(planar(edge.line));
  Line back = reversed(line);
  arms.push_back({std::move(line), start, end});
  arms.push_back({std::move(back), end, start});
  if (!axis.area.empty())
    arms[2 * e].widest = arms[2 * e + 1].widest = std::max(start, end) + area_beyond_kerb;
  arms[2 * e].roadway_offset = axis.roadway_offset;
  arms[2 * e + 1].roadway_offset = -axis.roadway_offset;
  junctions[edge.from_node].ends.push_back({e, true});
  junctions[edge.to_node].ends.push_back({e, false});
}

void Layout::sort_ends() {
  // The order about a node keeps this one between ways that are alike in all that it looks at.
  const auto first = [&](const EdgeEnd& a, const EdgeEnd& b) {
    const auto rank = [&](const EdgeEnd& end) {
      return std::pair(axis_of(end.edge).importance, -axis_lengths[end.edge]);
    };
    return rank(a) < rank(b);
  };
  for (int n = 0; n < static_cast<int>(junctions.size()); ++n) {
    std::stable_sort(junctions[n].ends.begin(), junctions[n].ends.end(), first);
    std::vector<EdgeEnd> sorted;
    for (const std::size_t i : counter_clockwise(arms_of(n)))
      sorted.push_back(junctions[n].ends[i]);
    junctions[n].ends = std::move(sorted);
  }
}

std::vector<Arm> Layout::arms_of(int node) const {
  std::vector<Arm> about;
  about.reserve(junctions[node].ends.size());
  for (const EdgeEnd& end : junctions[node].ends) about.push_back(arm(end));
  return about;
}

int Layout::level_of(int node) const {
  std::map<int, int> count;
  for (const EdgeEnd& end : junctions[node].ends) ++count[streets.network.edges[end.edge].level];
  return std::max_element(count.begin(), count.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

bool Layout::outer(int node) const {
  const auto& ends = junctions[node].ends;
  return std::all_of(ends.begin(), ends.end(),
                     [&](const EdgeEnd& end) { return axis_of(end.edge).outer; });
}

bool Layout::meets_outer(int node) const {
  const auto& ends = junctions[node].ends;
  return std::any_of(ends.begin(), ends.end(),
                     [&](const EdgeEnd& end) { return axis_of(end.edge).outer; });
}

}  // namespace streetgen
