// Axes with lanes that meet, and what joins their lanes, for tests of interconnections.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/prepared_surface.hpp"
#include "streetgen/interconnection.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {

// An axis with its lanes, each list from left to right in its driving direction.
struct LanedAxis {
  std::int64_t id = 0;
  Line line;
  std::vector<LaneWish> forward, backward;
  double width = 0;
  double speed = 50;
  int both_ways = 0;  // lanes
  double offset = 0;  // of the roadway, metres to the left of the axis
};

inline std::vector<LaneWish> general(int count, unsigned turns = 0) {
  LaneWish lane;
  lane.turns = turns;
  return std::vector<LaneWish>(count, lane);
}

inline LanedAxis road(std::int64_t id, const Line& line, int forward, int backward) {
  return {id, line, general(forward), general(backward), 3.5 * (forward + backward), 50};
}

// One lane that both directions use.
inline LanedAxis narrow(std::int64_t id, const Line& line) {
  return {id, line, {}, {}, 3.5, 50, 1};
}

class JoinedTown {
 public:
  explicit JoinedTown(const std::vector<LanedAxis>& roads, double radius = 8,
                      DrivingSide side = DrivingSide::right) {
    std::vector<LanesOfAxis> wishes;
    for (const LanedAxis& r : roads) {
      axes_.push_back({r.id, r.line, 0, r.width, r.width, radius, 5, r.speed});
      axes_.back().roadway_offset = r.offset;
      wishes.push_back({r.id, {r.forward, r.backward, general(r.both_ways)}});
    }
    streets_ = streets(axes_, {});
    LaneSettings settings;
    settings.driving_side = side;
    lanes_ = streetgen::lanes(streets_, wishes, {}, settings).lanes;
  }

  std::vector<Interconnection> join(const std::vector<TurnRestriction>& restrictions = {},
                                    const InterconnectionSettings& settings = {},
                                    const std::vector<Circulation>& circulations = {}) const {
    return interconnections(streets_, axes_, lanes_, restrictions, settings, circulations);
  }

  const Lane& lane(int index) const { return lanes_[index]; }
  int lane_count() const { return static_cast<int>(lanes_.size()); }
  // Whether the point lies on the roadway.
  bool holds(const Point& p) const {
    const auto on = [&](const MultiPolygon& surface) {
      return std::any_of(surface.begin(), surface.end(),
                         [&](const Polygon& polygon) { return inside(p, polygon); });
    };
    return std::any_of(streets_.sections.begin(), streets_.sections.end(),
                       [&](const Section& section) { return on(section.surface); }) ||
           std::any_of(streets_.intersections.begin(), streets_.intersections.end(),
                       [&](const Intersection& i) { return on(i.surface); });
  }
  std::int64_t axis_of(int lane) const { return streets_.network.edges[lanes_[lane].edge].axis_id; }
  // From 1, from left to right in the driving direction.
  int rank(int index) const {
    int rank = 1;
    for (const Lane& other : lanes_)
      if (other.edge == lanes_[index].edge && other.along_axis == lanes_[index].along_axis &&
          (lanes_[index].along_axis ? other.position < lanes_[index].position
                                    : other.position > lanes_[index].position))
        ++rank;
    return rank;
  }

 private:
  std::vector<StreetAxis> axes_;
  Streets streets_;
  std::vector<Lane> lanes_;
};

// What goes on plausibly from axis to axis, as pairs of ranks.
using Ranks = std::set<std::pair<int, int>>;
inline Ranks plausible(const JoinedTown& town, const std::vector<Interconnection>& all,
                       std::int64_t from, std::int64_t to) {
  Ranks found;
  for (const Interconnection& i : all)
    if (i.plausible && town.axis_of(i.lane_in) == from && town.axis_of(i.lane_out) == to)
      found.insert({town.rank(i.lane_in), town.rank(i.lane_out)});
  return found;
}

inline std::set<std::string> reasons(const JoinedTown& town,
                                     const std::vector<Interconnection>& all, std::int64_t from,
                                     std::int64_t to) {
  std::set<std::string> found;
  for (const Interconnection& i : all)
    if (town.axis_of(i.lane_in) == from && town.axis_of(i.lane_out) == to)
      found.insert(reason_name(i.reason));
  return found;
}

// West, south, east, north of (0, 0): all drawn towards it.
inline const Line west{{-100, 0, 0}, {0, 0, 0}}, south{{0, -100, 0}, {0, 0, 0}},
    east{{100, 0, 0}, {0, 0, 0}}, north{{0, 100, 0}, {0, 0, 0}};

inline JoinedTown crossing(int lanes, double radius = 8) {
  return JoinedTown({road(1, west, lanes, lanes), road(2, south, lanes, lanes),
                     road(3, east, lanes, lanes), road(4, north, lanes, lanes)},
                    radius);
}

// Random stars of streets, some of them one-way.
class LanedStar {
 public:
  explicit LanedStar(unsigned seed) : random_(seed) {}
  std::vector<LanedAxis> roads() {
    std::vector<LanedAxis> out;
    const int count = 3 + pick(3);
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * M_PI * (i + 0.6 * pick(100) / 100) / count;
      const Line line{{0, 0, 0}, {150 * std::cos(angle), 150 * std::sin(angle), 0}};
      int forward = pick(4), backward = pick(4);
      if (i == 0) forward = 1 + pick(3);
      if (i == 1) backward = 1 + pick(3);
      if (forward + backward == 0) forward = 1;
      out.push_back(road(i + 1, line, forward, backward));
    }
    return out;
  }

 private:
  int pick(int n) { return static_cast<int>(random_() % n); }
  std::mt19937 random_;
};

}  // namespace streetgen
