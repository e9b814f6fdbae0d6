#include "interconnection/only_way.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "interconnection/movement_angle.hpp"

namespace streetgen {

namespace {

constexpr double lane_weight = 10;  // degrees that a lane aside is worth
constexpr int alone = 10;           // lanes to what goes the same way, where nothing does

// Whether cars come to the pair and may not go on.
bool leaves_cars_behind(const Way& way, int in, int out) {
  return leads_as(way.from->in[in].kind) == LaneKind::general && !for_cars(way, in, out);
}

// Whether the lane takes the movement, to whichever lane.
bool takes(const Way& way, int in) {
  for (int o = 0; o < static_cast<int>(way.to->out.size()); ++o)
    if (way.at(in, o).plausible) return true;
  return false;
}

// What else goes the same way: its distance from the pair, in lanes, and whether it crosses it.
// Without any, the outermost lanes of the side to which one turns are the nearest.
struct Astray {
  int lanes = 0;
  bool crosses = false;
};

Astray astray(const Way& way, int in, int out) {
  const int n = static_cast<int>(way.from->in.size()), m = static_cast<int>(way.to->out.size());
  std::optional<int> nearest;
  bool crosses = false;
  for (int i = 0; i < n; ++i)
    for (int o = 0; o < m; ++o)
      if (way.at(i, o).plausible) {
        const int lanes = std::abs(i - in) + std::abs(o - out);
        nearest = std::min(nearest.value_or(lanes), lanes);
        crosses = crosses || (i - in) * (o - out) < 0;
      }
  if (nearest) return {*nearest, crosses};
  return {alone + (in_steps(way.angle) > 0 ? in + out : n - 1 - in + m - 1 - out), false};
}

// Whether the pair crosses what lanes beside it take to other streets.
bool crosses_lanes_beside(const Ways& of_node, const Way& way, int in) {
  if (!drives(way.from->in[in].kind)) return false;
  for (const Way& other : of_node) {
    const auto aside = in_steps(other.angle) - in_steps(way.angle);  // positive: to the left
    if (other.from != way.from || other.turns_back() || aside == 0) continue;
    for (int i = 0; i < static_cast<int>(way.from->in.size()); ++i)
      if (i != in && (i < in) == (aside < 0) && drives(way.from->in[i].kind) && takes(other, i))
        return true;
  }
  return false;
}

// The less, the likelier.  Of equals the first in the order of legs and lanes.
using Cost = std::tuple<bool, bool, bool, bool, bool, long long>;

Cost cost(const Ways& of_node, const Way& way, int in, int out) {
  const Verdict& verdict = way.at(in, out);
  const Astray beside = astray(way, in, out);
  return {verdict.reason == Reason::turn_lanes && !takes(way, in),
          way.turns_back(),
          leaves_cars_behind(way, in, out),
          beside.crosses || crosses_lanes_beside(of_node, way, in),
          way.tight(in, out),
          in_steps(std::abs(way.angle) + lane_weight * beside.lanes)};
}

bool may(const Way& way, int i, int o) {
  const LaneEnd &from = way.from->in[i], &to = way.to->out[o];
  const LaneKind in = leads_as(from.kind), out = leads_as(to.kind);
  return !way.forbidden(i, o) && !from.middle && !to.middle &&
         (in == out || in == LaneKind::general || out == LaneKind::general);
}

// Pairs that another kind of lane, or what is marked, would rule out are better than none.
template <class Wanted>
LikelyPair likeliest(const Ways& of_node, Wanted wanted) {
  LikelyPair best;
  Cost least;
  for (const Way& way : of_node)
    for (int i = 0; i < static_cast<int>(way.from->in.size()); ++i)
      for (int o = 0; o < static_cast<int>(way.to->out.size()); ++o) {
        if (!wanted(way, i, o) || !may(way, i, o)) continue;
        const Cost now = cost(of_node, way, i, o);
        if (best.verdict && !(now < least)) continue;
        best = {&way.at(i, o), !way.tight(i, o) && !way.turns_back()};
        least = now;
      }
  return best;
}

}  // namespace

LikelyPair likeliest_on(const Ways& of_node, const Leg& leg, int lane, bool cars) {
  return likeliest(of_node, [&](const Way& way, int in, int out) {
    return way.from == &leg && in == lane && (!cars || for_cars(way, in, out));
  });
}

LikelyPair likeliest_to(const Ways& of_node, const Leg& leg, int lane, bool cars) {
  return likeliest(of_node, [&](const Way& way, int in, int out) {
    return way.to == &leg && out == lane && way.from != &leg && (!cars || for_cars(way, in, out));
  });
}

bool leads_on(const Ways& of_node, const Leg& leg, int in, bool cars, const Verdict* besides) {
  for (const Way& way : of_node)
    if (way.from == &leg)
      for (int o = 0; o < static_cast<int>(way.to->out.size()); ++o)
        if (way.at(in, o).plausible && &way.at(in, o) != besides && (!cars || for_cars(way, in, o)))
          return true;
  return false;
}

bool reached(const Ways& of_node, const Leg& leg, int out, bool cars, const Verdict* besides) {
  for (const Way& way : of_node)
    if (way.to == &leg)
      for (int i = 0; i < static_cast<int>(way.from->in.size()); ++i)
        if (way.at(i, out).plausible && &way.at(i, out) != besides &&
            (!cars || for_cars(way, i, out)))
          return true;
  return false;
}

bool for_cars(const Way& way, int in, int out) {
  return leads_as(way.from->in[in].kind) == LaneKind::general &&
         leads_as(way.to->out[out].kind) == LaneKind::general;
}

void reach_every_lane(const Ways& of_node, const std::vector<Leg>& legs) {
  const auto add = [](const LikelyPair& pair) {
    if (pair.verdict) *pair.verdict = {true, Reason::only_way};
  };
  for (const Leg& leg : legs)
    for (int i = 0; i < static_cast<int>(leg.in.size()); ++i)
      if (!leg.in[i].middle && !leads_on(of_node, leg, i)) add(likeliest_on(of_node, leg, i));
  for (const Leg& leg : legs)
    for (int o = 0; o < static_cast<int>(leg.out.size()); ++o)
      if (!leg.out[o].middle && !reached(of_node, leg, o)) add(likeliest_to(of_node, leg, o));
}

}  // namespace streetgen
