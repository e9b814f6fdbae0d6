#include "design/link_graph.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {
namespace {

constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
// The first ellipse has room for about so many towns.
constexpr double first_towns = 3;

}  // namespace

LinkGraph::LinkGraph(const std::vector<Point>& places)
    : places_(places),
      grid_(places),
      linked_(places.size() * places.size(), false),
      neighbours_(places.size()),
      inside_(places.size(), false),
      so_far_(places.size(), infinite),
      before_(places.size(), nowhere) {}

void LinkGraph::put(std::size_t a, std::size_t b) {
  if (has(a, b)) return;
  linked_[a * places_.size() + b] = linked_[b * places_.size() + a] = true;
  neighbours_[a].push_back(b);
  neighbours_[b].push_back(a);
}

void LinkGraph::remove(std::size_t a, std::size_t b) {
  linked_[a * places_.size() + b] = linked_[b * places_.size() + a] = false;
}

double LinkGraph::length(std::size_t a, std::size_t b) const {
  return distance(places_[a], places_[b]);
}

TownWay LinkGraph::way_beside(std::size_t a, std::size_t b, double least) {
  const double straight = length(a, b);
  // The area of a thin ellipse: pi / 4 * straight * sqrt(2 * straight * detour).
  const double side = 4 * first_towns * grid_.room() / (M_PI * straight);
  double detour = std::max(least - straight, std::min(side * side / (2 * straight), straight));
  for (;;) {
    poll_cancel();
    // A little wider, so that a way of just that length lies within.
    const double sum = (straight + detour) * (1 + 1e-12);
    within_.clear();
    grid_.each_between(places_[a], places_[b], sum, [&](std::size_t i) { within_.push_back(i); });
    TownWay way = way_within(a, b);
    if (way.length <= sum || within_.size() == places_.size()) return way;
    detour *= 4;
  }
}

template <class Use>
void LinkGraph::each_neighbour(std::size_t town, Use use) {
  std::vector<std::size_t>& known = neighbours_[town];
  if (known.size() > within_.size()) {
    for (std::size_t i : within_)
      if (has(town, i)) use(i);
    return;
  }
  known.erase(
      std::remove_if(known.begin(), known.end(), [&](std::size_t i) { return !has(town, i); }),
      known.end());
  for (std::size_t i : known)
    if (inside_[i]) use(i);
}

// The shortest way over the towns in the ellipse, those first that lead straight on.
TownWay LinkGraph::way_within(std::size_t a, std::size_t b) {
  for (std::size_t i : within_) inside_[i] = true, so_far_[i] = infinite;
  queue_.clear();
  so_far_[a] = 0;
  queue_.push_back({length(a, b), a});
  while (!queue_.empty() && queue_.front().town != b) {
    std::pop_heap(queue_.begin(), queue_.end());
    const Reached at = queue_.back();
    queue_.pop_back();
    if (at.bound > so_far_[at.town] + length(at.town, b)) continue;
    each_neighbour(at.town, [&](std::size_t next) {
      if (at.town == a && next == b) return;
      const double reached = so_far_[at.town] + length(at.town, next);
      if (!(reached < so_far_[next])) return;
      so_far_[next] = reached;
      before_[next] = at.town;
      queue_.push_back({reached + length(next, b), next});
      std::push_heap(queue_.begin(), queue_.end());
    });
  }
  TownWay way;
  way.length = so_far_[b];
  if (way.length < infinite) {
    for (std::size_t i = b; i != a; i = before_[i]) way.towns.push_back(i);
    way.towns.push_back(a);
  }
  for (std::size_t i : within_) inside_[i] = false;
  return way;
}

LinkGraph::Ways LinkGraph::ways(std::size_t from) const {
  const std::size_t towns = places_.size();
  Ways ways{std::vector<double>(towns, infinite), std::vector<std::size_t>(towns, from)};
  std::vector<bool> settled(towns, false);
  ways.length[from] = 0;
  for (std::size_t round = 0; round < towns; ++round) {
    std::size_t next = nowhere;
    for (std::size_t i = 0; i < towns; ++i)
      if (!settled[i] && ways.length[i] < infinite &&
          (next == nowhere || ways.length[i] < ways.length[next]))
        next = i;
    if (next == nowhere) break;
    settled[next] = true;
    for (std::size_t i : neighbours_[next]) {
      if (!has(next, i)) continue;
      const double reached = ways.length[next] + length(next, i);
      if (reached < ways.length[i]) ways.length[i] = reached, ways.before[i] = next;
    }
  }
  return ways;
}

}  // namespace streetgen
