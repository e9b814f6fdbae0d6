#include "lane/waiting_place.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

// Metres.
constexpr double nearer = 0.5;       // from place to place
constexpr double exactly = 1e-7;     // that a place is found
constexpr double first_metres = 10;  // of an arm that gives its direction
constexpr double least_room = 1;     // of the lane behind its line

const double same_course = std::cos(M_PI / 6);  // arms nearer in direction go on side by side

// The first metres of a line have this direction.
Point direction_of(const Line& line) {
  return unit(planar(position_at(line, first_metres).point - line.front()));
}

}  // namespace

WaitingPlaces::WaitingPlaces(const Streets& streets, const LaneWishes& wishes, double before_kerb)
    : streets_(streets),
      clear_(before_kerb + stop_line_width / 2),
      ends_(streets.network.nodes.size()) {
  const std::vector<Edge>& edges = streets.network.edges;
  for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
    on_ring_.push_back(wishes.on_ring(edges[e]));
    ends_[edges[e].from_node].push_back(2 * e);
    ends_[edges[e].to_node].push_back(2 * e + 1);
  }
}

bool WaitingPlaces::enters_ring(int edge, bool at_start) const {
  const Edge& own = streets_.network.edges[edge];
  const std::vector<int>& ends = ends_[at_start ? own.from_node : own.to_node];
  return !on_ring_[edge] &&
         std::any_of(ends.begin(), ends.end(), [&](int slot) { return on_ring_[slot / 2]; });
}

WaitingPlaces::Arm WaitingPlaces::arm_of(int edge, bool at_start, double reach) const {
  const Edge& found = streets_.network.edges[edge];
  const Roadway& roadway = streets_.roadways[edge];
  const double total = length(found.line);
  const double most = found.from_node == found.to_node ? total / 2 : total;
  const double width = at_start ? roadway.width : roadway.width_end,
               width_there = at_start ? roadway.width_end : roadway.width;
  Arm arm;
  arm.line = at_start ? substring(found.line, 0, std::min(most, reach))
                      : substring(found.line, total, total - std::min(most, reach));
  arm.line = distinct(planar(std::move(arm.line)));
  arm.half = width / 2;
  arm.widens = total > 0 ? (width_there - width) / 2 / total : 0;
  arm.offset = at_start ? roadway.roadway_offset : -roadway.roadway_offset;
  return arm;
}

std::vector<WaitingPlaces::Arm> WaitingPlaces::arms_before(int edge, bool at_start,
                                                           double reach) const {
  const Edge& own = streets_.network.edges[edge];
  const bool at_ring = enters_ring(edge, at_start);
  const Point outwards = direction_of(arm_of(edge, at_start, reach).line);
  std::vector<Arm> arms;
  for (const int slot : ends_[at_start ? own.from_node : own.to_node]) {
    if (slot == 2 * edge + (at_start ? 0 : 1) || (at_ring && !on_ring_[slot / 2])) continue;
    Arm arm = arm_of(slot / 2, slot % 2 == 0, reach);
    if (arm.line.size() < 2) continue;
    const double same_way = dot(direction_of(arm.line), outwards);
    if (!at_ring && same_way < -same_course) continue;
    arm.across = at_ring || same_way < same_course;
    arms.push_back(std::move(arm));
  }
  for (Arm& arm : arms)
    arm.goes_on = at_ring || std::any_of(arms.begin(), arms.end(), [&](const Arm& other) {
                    return dot(direction_of(arm.line), direction_of(other.line)) < -same_course;
                  });
  return arms;
}

bool WaitingPlaces::Arm::covers(const Point& place) const {
  double before = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point &from = line[i - 1], along = line[i] - from;
    const double size = norm(along), t = dot(place - from, along) / (size * size);
    const bool behind_all = i + 1 == line.size() && t > 1, ahead_of_all = i == 1 && t < 0;
    if (!behind_all && (across || !ahead_of_all)) {
      const double within = std::clamp(t, 0.0, 1.0);
      const double to_left = cross(along, place - from) > 0 ? offset : -offset;
      const double reach = half + widens * (before + within * size) + to_left;
      if (distance(place, from + along * within) < reach) return true;
    }
    before += size;
  }
  return false;
}

std::optional<WaitingPlaces::Place> WaitingPlaces::before_roadway(const LaneStrip& strip,
                                                                  const Lane& lane, bool at_start,
                                                                  bool limits_crossed) const {
  const double total = length(strip.axis), lane_length = length(lane.line);
  const double limit = at_start ? strip.from : total - strip.to;
  const auto leftwards = [&](double away) {
    return left_normal(local_direction(strip.axis, at_start ? away : total - away));
  };
  const Point end = at_start ? lane.line.front() : lane.line.back();
  const auto on_axis = [&](double away) {
    return planar(position_at(strip.axis, at_start ? away : total - away).point);
  };
  const double offset = dot(end - on_axis(limit), leftwards(limit));
  const auto place_at = [&](double away) -> Place {
    if (away <= limit || limits_crossed) {
      const Point left = leftwards(away);
      return {on_axis(away) + left * offset, left * -1};
    }
    const double on_lane = at_start ? away - limit : lane_length - (away - limit);
    return {planar(position_at(lane.line, on_lane).point),
            left_normal(local_direction(lane.line, on_lane)) * -1};
  };
  const double shared = streets_.limits[2 * lane.edge + (at_start ? 0 : 1)].shared;
  const double farthest =
      limits_crossed ? total : limit + std::min(shared, std::max(0.0, lane_length - least_room));
  const std::vector<Arm> arms = arms_before(lane.edge, at_start, farthest + 2 * first_metres);
  const auto own = [&](const Place& place, double away) {
    const Point half = place.rightwards * (lane.width / 2);
    return std::none_of(arms.begin(), arms.end(), [&](const Arm& arm) {
      return arm.covers(place.middle - half) || arm.covers(place.middle) ||
             arm.covers(place.middle + half) ||
             (arm.across && !arm.goes_on && arm.covers(on_axis(away)));
    });
  };
  double away = farthest;
  while (limits_crossed && away > 0 && !own(place_at(away), away)) away -= nearer;
  const double first = away;
  if (first < 0 || !own(place_at(first), first)) return std::nullopt;
  double taken = first;
  while (taken > 0 && own(place_at(taken), taken)) {
    away = taken;
    taken = std::max(0.0, taken - nearer);
  }
  if (own(place_at(taken), taken)) return std::nullopt;
  while (away - taken > exactly) {
    const double middle = (away + taken) / 2;
    (own(place_at(middle), middle) ? away : taken) = middle;
  }
  return place_at(std::min(first, away + clear_));
}

}  // namespace streetgen
