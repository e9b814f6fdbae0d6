#include "network/control_reach.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "support/infinite.hpp"

namespace streetgen {

namespace {

using Direction = ControlPoint::Direction;

constexpr double least_room = 5;  // metres from a dead end, for what stops at signals

// Whether it tells traffic to stop or to wait, wherever it does so.
bool stops(ControlKind kind) {
  return kind == ControlKind::signals || kind == ControlKind::stop || kind == ControlKind::yield;
}

// The middle between two places, or the crossing between them that is nearest to it.
double place_among(const std::vector<double>& crossings, double first, double last) {
  const double middle = (first + last) / 2;
  double place = middle, least = infinite;
  for (const double crossing : crossings) {
    const double off = std::abs(crossing - middle);
    if (crossing < first - on_node || crossing > last + on_node || off >= least) continue;
    place = std::clamp(crossing, first, last);
    least = off;
  }
  return place;
}

}  // namespace

ControlReach::ControlReach(const Network& network, std::vector<EdgeWays> ways,
                           const ControlRules& rules)
    : edges_(network.edges), ways_(std::move(ways)), rules_(rules), slots_(network.nodes.size()) {
  for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
    of_axis_[edges_[e].axis_id].push_back(e);
    slots_[edges_[e].from_node].push_back(2 * e);
    slots_[edges_[e].to_node].push_back(2 * e + 1);
  }
}

const std::vector<int>& ControlReach::edges_of(std::int64_t axis_id) const {
  static const std::vector<int> none;
  const auto found = of_axis_.find(axis_id);
  return found == of_axis_.end() ? none : found->second;
}

std::vector<ControlReach::Place> ControlReach::places_of(const ControlPoint& point) const {
  std::vector<Place> places;
  for (const int e : edges_of(point.axis_id)) {
    const Place place{e, point.abscissa - edges_[e].start_abscissa,
                      edges_[e].end_abscissa - point.abscissa};
    if (place.to_start >= -on_node && place.to_end >= -on_node) places.push_back(place);
  }
  // One place, but for a node, which all edges there name alike.
  if (places.size() > 1) {
    const auto inside = std::find_if(places.begin(), places.end(), [](const Place& place) {
      return place.to_start > on_node && place.to_end > on_node;
    });
    if (inside != places.end()) places = {*inside};
  }
  return places;
}

std::optional<ControlReach::Ahead> ControlReach::junction_ahead(int edge, bool along, double metres,
                                                                double farthest) const {
  int slot = 2 * edge + (along ? 1 : 0);
  while (metres <= farthest) {
    const std::vector<int>& slots = slots_[node_of(slot)];
    if (slots.size() > 2) return Ahead{slot, metres};
    if (slots.size() < 2) return std::nullopt;
    const int next = slots[0] == slot ? slots[1] : slots[0];
    if (next / 2 == edge) return std::nullopt;  // round a loop
    metres += edges_[next / 2].end_abscissa - edges_[next / 2].start_abscissa;
    slot = next ^ 1;
  }
  return std::nullopt;
}

// By ways along the edge (false: against it), of those to which the point speaks.
std::vector<bool> ControlReach::ways_spoken_to(const ControlPoint& point,
                                               const Place& place) const {
  switch (point.direction) {
    case Direction::along:
      return {true};
    case Direction::against:
      return {false};
    case Direction::both:
      return {true, false};
    case Direction::unknown:
      break;
  }
  const EdgeWays& ways = ways_[place.edge];
  if (ways.along != ways.against) return {ways.along};
  const auto metres_to = [&](bool along) {
    const auto found =
        junction_ahead(place.edge, along, along ? place.to_end : place.to_start, rules_.farthest);
    return found ? found->metres : infinite;
  };
  const double ahead = metres_to(true), behind = metres_to(false);
  if (std::isfinite(ahead) || std::isfinite(behind)) return {ahead <= behind};
  return {true, false};
}

void ControlReach::add_on_junction(const ControlPoint& point, int slot,
                                   ControlledEnds& found) const {
  const bool at_end = slot % 2 == 1;
  const bool comes_by = point.direction == (at_end ? Direction::along : Direction::against);
  const bool leaves_by = point.direction == (at_end ? Direction::against : Direction::along);
  if (comes_by) found.slots.push_back(slot);
  if (comes_by || leaves_by) return;
  const std::vector<int>& all = slots_at(node_of(slot));
  found.slots.insert(found.slots.end(), all.begin(), all.end());
  found.junction = node_of(slot);
}

void ControlReach::add_on_road(const ControlPoint& point, const Place& place,
                               ControlledEnds& found) const {
  const std::vector<bool> ways = ways_spoken_to(point, place);
  for (const bool along : ways)
    if (const auto ahead =
            junction_ahead(place.edge, along, std::max(0.0, along ? place.to_end : place.to_start),
                           rules_.farthest))
      found.slots.push_back(ahead->slot);
  if (!found.slots.empty() || point.kind != ControlKind::signals) return;
  for (const bool along : ways)
    if (const auto behind =
            junction_ahead(place.edge, !along, std::max(0.0, along ? place.to_start : place.to_end),
                           std::min(rules_.queue, rules_.farthest)))
      found.slots.push_back(behind->slot);
  found.mid_block = found.slots.empty() && !has_end_near(place);
}

bool ControlReach::has_end_near(const Place& place) const {
  const auto is_end = [&](int node) { return slots_[node].size() < 2; };
  return (place.to_start < least_room && is_end(edges_[place.edge].from_node)) ||
         (place.to_end < least_room && is_end(edges_[place.edge].to_node));
}

void ControlReach::add_ends(const ControlPoint& point, const Place& place,
                            ControlledEnds& found) const {
  const bool at_node = std::min(place.to_start, place.to_end) <= on_node;
  const int slot = 2 * place.edge + (place.to_end < place.to_start ? 1 : 0);
  if (at_node && (is_junction(node_of(slot)) || !stops(point.kind)))
    add_on_junction(point, slot, found);
  else
    add_on_road(point, place, found);
}

ControlledEnds ControlReach::ends_of(const ControlPoint& point) const {
  ControlledEnds found;
  for (const Place& place : places_of(point)) {
    ControlledEnds there;
    add_ends(point, place, there);
    found.slots.insert(found.slots.end(), there.slots.begin(), there.slots.end());
    if (there.junction) found.junction = there.junction;
    found.mid_block = found.mid_block || there.mid_block;
  }
  std::sort(found.slots.begin(), found.slots.end());
  found.slots.erase(std::unique(found.slots.begin(), found.slots.end()), found.slots.end());
  found.mid_block = found.mid_block && found.slots.empty();
  return found;
}

std::vector<int> ControlReach::nodes_near(const ControlPoint& point) const {
  std::vector<int> nodes;
  for (const Place& place : places_of(point))
    for (const bool along : {true, false}) {
      int slot = 2 * place.edge + (along ? 1 : 0);
      double metres = along ? place.to_end : place.to_start;
      while (metres <= rules_.farthest) {
        nodes.push_back(node_of(slot));
        const std::vector<int>& slots = slots_at(node_of(slot));
        const int next = slots[0] == slot ? slots.back() : slots[0];
        if (slots.size() != 2 || next / 2 == place.edge) break;
        metres += edges_[next / 2].end_abscissa - edges_[next / 2].start_abscissa;
        slot = next ^ 1;
      }
    }
  return nodes;
}

std::vector<MidBlockSignals> ControlReach::mid_block_signals(
    const std::vector<ControlPoint>& points) const {
  std::map<std::int64_t, std::vector<std::pair<double, int>>> of_axis;
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
    if (points[i].kind == ControlKind::signals && ends_of(points[i]).mid_block)
      of_axis[points[i].axis_id].emplace_back(points[i].abscissa, i);
  if (of_axis.empty()) return {};
  std::map<std::int64_t, std::vector<double>> crossings;
  for (const ControlPoint& point : points)
    if (point.kind == ControlKind::pedestrian_crossing)
      crossings[point.axis_id].push_back(point.abscissa);
  std::vector<MidBlockSignals> found;
  for (auto& [axis_id, some] : of_axis) {
    std::sort(some.begin(), some.end());
    for (auto first = some.begin(); first != some.end();) {
      MidBlockSignals place{axis_id};
      auto last = first;
      for (; last != some.end() &&
             (last == first || last->first - std::prev(last)->first <= rules_.queue);
           ++last)
        place.points.push_back(last->second);
      place.abscissa = place_among(crossings[axis_id], first->first, std::prev(last)->first);
      found.push_back(std::move(place));
      first = last;
    }
  }
  return found;
}

}  // namespace streetgen
