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

constexpr double least_room = 5;    // metres from a dead end, for what stops at signals
constexpr double own_crossing = 5;  // metres from signals to the crossing that they are there for
constexpr double arm_reach = 20;    // metres from a node within which crossings are of its arms
constexpr double ring_entry = 5;    // metres before a ring's node, where its stop lines lie

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
                           const std::vector<ControlPoint>& points, const ControlRules& rules)
    : edges_(network.edges), ways_(std::move(ways)), rules_(rules), slots_(network.nodes.size()) {
  for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
    of_axis_[edges_[e].axis_id].push_back(e);
    slots_[edges_[e].from_node].push_back(2 * e);
    slots_[edges_[e].to_node].push_back(2 * e + 1);
  }
  for (const ControlPoint& point : points)
    if (point.kind == ControlKind::pedestrian_crossing)
      crossings_[point.axis_id].push_back(point.abscissa);
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
  std::vector<int> others;
  const auto add = [&](bool along, double farthest, bool comes) {
    const auto node = junction_ahead(
        place.edge, along, std::max(0.0, along ? place.to_end : place.to_start), farthest);
    if (!node) return;
    const bool its = is_of_junction(point, place, along, *node, comes);
    (its ? found.slots : others).push_back(node->slot);
  };
  for (const bool along : ways) add(along, rules_.farthest, true);
  if (!found.slots.empty() || point.kind != ControlKind::signals) return;
  for (const bool along : ways) add(!along, std::min(rules_.queue, rules_.farthest), false);
  if (!found.slots.empty()) return;
  found.mid_block = !has_end_near(place);
  found.slots = std::move(others);
}

// The crossing that signals are there for, metres along the axis.
std::optional<double> ControlReach::crossing_of(const ControlPoint& point) const {
  std::optional<double> found;
  const auto of_axis = crossings_.find(point.axis_id);
  if (of_axis == crossings_.end()) return found;
  const auto off = [&](double abscissa) { return std::abs(abscissa - point.abscissa); };
  for (const double abscissa : of_axis->second)
    if (off(abscissa) <= own_crossing && (!found || off(abscissa) < off(*found))) found = abscissa;
  return found;
}

// Whether a point speaks at a node to which one comes who goes along its edge or against it.
// `comes`: so goes the traffic to which it speaks.
bool ControlReach::is_of_junction(const ControlPoint& point, const Place& place, bool along,
                                  const Ahead& node, bool comes) const {
  if (point.kind != ControlKind::signals) return true;
  const std::optional<double> crossing = crossing_of(point);
  const std::vector<int>& slots = slots_[node_of(node.slot)];
  const bool ring =
      std::any_of(slots.begin(), slots.end(), [&](int slot) { return ways_[slot / 2].on_ring; });
  if (ring && !ways_[place.edge].on_ring) return comes && !crossing && node.metres <= ring_entry;
  if (!crossing) return true;
  const double nearer = along ? *crossing - point.abscissa : point.abscissa - *crossing;
  return node.metres - nearer <= arm_reach;
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
  bool of_junction = false;
  for (const Place& place : places_of(point)) {
    ControlledEnds there;
    add_ends(point, place, there);
    found.slots.insert(found.slots.end(), there.slots.begin(), there.slots.end());
    if (there.junction) found.junction = there.junction;
    found.mid_block = found.mid_block || there.mid_block;
    of_junction = of_junction || (!there.slots.empty() && !there.mid_block);
  }
  std::sort(found.slots.begin(), found.slots.end());
  found.slots.erase(std::unique(found.slots.begin(), found.slots.end()), found.slots.end());
  found.mid_block = found.mid_block && !of_junction;
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
  static const std::vector<double> none;
  std::vector<MidBlockSignals> found;
  for (auto& [axis_id, some] : of_axis) {
    const auto crossings = crossings_.find(axis_id);
    std::sort(some.begin(), some.end());
    for (auto first = some.begin(); first != some.end();) {
      MidBlockSignals place{axis_id};
      auto last = first;
      for (; last != some.end() && (last == first || last->first - first->first <= rules_.queue);
           ++last)
        place.points.push_back(last->second);
      place.abscissa = place_among(crossings == crossings_.end() ? none : crossings->second,
                                   first->first, std::prev(last)->first);
      found.push_back(std::move(place));
      first = last;
    }
  }
  return found;
}

}  // namespace streetgen
