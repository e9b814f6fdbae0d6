#include "network/walk.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/polyline.hpp"
#include "network/leaving_order.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

double heading(const Network& network, const EdgeEnd& end, double at) {
  const Edge& edge = network.edges[end.edge];
  const double size = length(edge.line), along = std::min(at, size);
  const Point to = position_at(edge.line, end.at_start ? along : size - along).point -
                   (end.at_start ? edge.line.front() : edge.line.back());
  return std::atan2(to.y, to.x);
}

std::vector<EdgeEnd> counter_clockwise(const Network& network, const std::vector<EdgeEnd>& ends) {
  std::vector<EdgeEnd> sorted;
  for (const std::size_t i : leaving_order(
           ends.size(), [&](std::size_t i, double at) { return heading(network, ends[i], at); },
           [&](std::size_t i, std::size_t j) { return slot(ends[i]) < slot(ends[j]); }))
    sorted.push_back(ends[i]);
  return sorted;
}

// By the slot of the end by which a walk comes to a node: the end by which it leaves.
std::vector<EdgeEnd> leftmost_ways(const Network& network, const std::vector<bool>& counted) {
  std::vector<std::vector<EdgeEnd>> ends(network.nodes.size());
  for (int e = 0; e < static_cast<int>(network.edges.size()); ++e) {
    if (!counted[e]) continue;
    ends[network.edges[e].from_node].push_back({e, true});
    ends[network.edges[e].to_node].push_back({e, false});
  }
  std::vector<EdgeEnd> next(2 * network.edges.size());
  for (const std::vector<EdgeEnd>& about : ends) {
    poll_cancel();
    const std::vector<EdgeEnd> order = counter_clockwise(network, about);
    for (std::size_t i = 0; i < order.size(); ++i)
      next[slot(order[(i + 1) % order.size()])] = order[i];
  }
  return next;
}

}  // namespace

std::vector<Walk> walks(const Network& network, const std::function<bool(const Edge&)>& counts) {
  std::vector<bool> counted;
  for (const Edge& edge : network.edges) counted.push_back(counts(edge));
  const std::vector<EdgeEnd> next = leftmost_ways(network, counted);
  std::vector<bool> walked(next.size());
  std::vector<Walk> found;
  for (int s = 0; s < static_cast<int>(next.size()); ++s) {
    if (walked[s] || !counted[s / 2]) continue;
    poll_cancel();
    Walk walk;
    for (EdgeEnd step{s / 2, s % 2 == 0}; !walked[slot(step)];
         step = next[slot({step.edge, !step.at_start})]) {
      walked[slot(step)] = true;
      walk.push_back(step);
    }
    found.push_back(std::move(walk));
  }
  return found;
}

}  // namespace streetgen
