#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/polyline.hpp"
#include "lane/lane_wishes.hpp"
#include "streetgen/interconnection.hpp"
#include "truths.hpp"

namespace streetgen::fuzz {

namespace {

struct TurnsAsked {
  std::vector<LanesOfAxis> axes;
  std::vector<TurnRestriction> restrictions;
  InterconnectionSettings settings;
};

std::vector<LaneWish> random_lanes(Random& random) {
  std::vector<LaneWish> lanes(random.below(5));
  for (LaneWish& lane : lanes) {
    if (random.one_in(4))
      lane.kind =
          random.of(std::vector<LaneKind>{LaneKind::bus, LaneKind::cycle, LaneKind::parking});
    if (random.one_in(3)) lane.turns = random.below(1024);
  }
  return lanes;
}

TurnsAsked random_traffic(Random& random, const Town& town) {
  TurnsAsked asked;
  for (const StreetAxis& axis : town.axes) {
    asked.axes.push_back({axis.axis_id,
                          {random_lanes(random), random_lanes(random),
                           random.one_in(3) ? random_lanes(random) : std::vector<LaneWish>{}}});
    if (!random.one_in(5)) continue;
    const StreetAxis& to = random.of(town.axes);
    asked.restrictions.push_back(
        {axis.axis_id, to.axis_id, axis.line.back(), random.one_in(2),
         random.one_in(2) ? std::optional<Turn>(Turn::left) : std::nullopt,
         random.one_in(3) ? std::vector<LaneKind>{LaneKind::bus} : std::vector<LaneKind>{}});
  }
  asked.settings.u_turn = random.one_in(3);
  if (random.one_in(3)) asked.settings.rule = TrajectoryRule::arcs;
  asked.settings.least_radius = random.one_in(3) ? 0 : random.scaled(0.1, 20);
  asked.settings.tolerance = random.scaled(0.001, 1);
  return asked;
}

// By node, what comes in and what goes out, as (edge, lane); of both directions at both ends.
struct NodeLanes {
  std::vector<std::pair<int, int>> in, out;
};

std::map<int, NodeLanes> lanes_of_nodes(const Network& network, const std::vector<Lane>& lanes) {
  std::map<int, NodeLanes> nodes;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const Lane& lane = lanes[i];
    if (lane.kind == LaneKind::parking) continue;
    const Edge& edge = network.edges[lane.edge];
    const std::pair<int, int> entry{lane.edge, static_cast<int>(i)};
    for (const bool along : {true, false}) {
      if (!lane.both_ways && lane.along_axis != along) continue;
      nodes[along ? edge.to_node : edge.from_node].in.push_back(entry);
      nodes[along ? edge.from_node : edge.to_node].out.push_back(entry);
    }
  }
  return nodes;
}

void find_missing(const Network& network, const std::vector<Lane>& lanes, bool u_turn,
                  const std::vector<Interconnection>& pairs, Faults& faults) {
  std::size_t expected = 0;
  for (const auto& [node, of_node] : lanes_of_nodes(network, lanes))
    for (const auto& in : of_node.in)
      for (const auto& out : of_node.out)
        if (u_turn || in.first != out.first) ++expected;
  if (pairs.size() != expected)
    faults.push_back(std::to_string(pairs.size()) + " pairs of " + std::to_string(expected));
}

void find_unsound(const std::vector<Lane>& lanes, const std::vector<Interconnection>& pairs,
                  Faults& faults) {
  for (const Interconnection& pair : pairs) {
    const std::string name =
        " from lane " + std::to_string(pair.lane_in) + " to " + std::to_string(pair.lane_out);
    const Lane &in = lanes[pair.lane_in], &out = lanes[pair.lane_out];
    if ((!in.both_ways && pair.along_in != in.along_axis) ||
        (!out.both_ways && pair.along_out != out.along_axis))
      faults.push_back("a path against its lane" + name);
    const Point start = pair.along_in ? in.line.back() : in.line.front();
    const Point end = pair.along_out ? out.line.front() : out.line.back();
    if (distance(pair.line.front(), start) > 0 || distance(pair.line.back(), end) > 0)
      faults.push_back("a path off its lanes" + name);
    for (const Point& p : pair.line)
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
        faults.push_back("a path that is not finite" + name);
        break;
      }
    if (!(pair.angle > -180 && pair.angle <= 180))
      faults.push_back("an angle of " + std::to_string(pair.angle) + name);
    if (pair.plausible && pair.reason != Reason::lane_order && pair.reason != Reason::turn_lanes &&
        pair.reason != Reason::only_way && pair.reason != Reason::look_ahead &&
        pair.reason != Reason::not_drivable && pair.reason != Reason::traffic)
      faults.push_back(std::string("plausible by ") + reason_name(pair.reason) + name);
    // Whether those can drive it whom a restriction excepts is not asked.
    if (pair.plausible && pair.reason != Reason::not_drivable && pair.reason != Reason::traffic &&
        sharpest_turn(pair.line) > 30)
      faults.push_back("a path with a corner of " + std::to_string(sharpest_turn(pair.line)) +
                       name);
  }
}

// Where a pair is allowed from a lane, one is plausible.  So is one to an edge that pairs are allowed
// to, but where marks of lanes lead none there.  Not each lane out is reached: lanes keep their
// order.  Bus and cycle lanes may meet in vain, and from a lane in the middle nobody may turn off.
void find_dead(const std::vector<Lane>& lanes, const std::vector<Interconnection>& pairs,
               Faults& faults) {
  std::map<std::pair<int, bool>, bool> spreads, reached;
  for (const Interconnection& pair : pairs) {
    const LaneKind in = lanes[pair.lane_in].kind, out = lanes[pair.lane_out].kind;
    const bool fits = leads_as(in) == leads_as(out) || leads_as(in) == LaneKind::general ||
                      leads_as(out) == LaneKind::general;
    const bool middle = lanes[pair.lane_in].middle || lanes[pair.lane_out].middle;
    const std::pair<int, bool> edge(lanes[pair.lane_out].edge, pair.along_out);
    if (pair.plausible || pair.reason == Reason::turn_lanes) reached[edge] = true;
    if (pair.reason == Reason::restriction || !fits || middle) continue;
    spreads[{pair.lane_in, pair.along_in}] |= pair.plausible;
    if (lanes[pair.lane_in].edge != lanes[pair.lane_out].edge) reached[edge] |= pair.plausible;
  }
  for (const auto& [lane, holds] : spreads)
    if (!holds) faults.push_back("lane " + std::to_string(lane.first) + " leads nowhere");
  for (const auto& [edge, holds] : reached)
    if (!holds) faults.push_back("edge " + std::to_string(edge.first) + " is not reached");
}

bool same(const Interconnection& a, const Interconnection& b) {
  return a.node == b.node && a.lane_in == b.lane_in && a.lane_out == b.lane_out &&
         a.along_in == b.along_in && a.along_out == b.along_out && a.plausible == b.plausible &&
         a.reason == b.reason && a.angle == b.angle && a.line.size() == b.line.size();
}

}  // namespace

Faults interconnection_faults(const Made& made) {
  Faults faults;
  Random random(made.seed);
  TurnsAsked asked = random_traffic(random, made.town);
  const std::vector<Lane> all = lanes(made.streets, asked.axes, {}, {}).lanes;
  const LaneWishes wishes(asked.axes, {}, {}, {});
  std::vector<StreetAxis> axes = made.town.axes;
  const auto run = [&] {
    return interconnections(made.streets, axes, all, asked.restrictions, asked.settings, {},
                            [&](const Edge& edge) { return wishes.of(edge).lanes; });
  };
  const std::vector<Interconnection> pairs = run();
  find_missing(made.streets.network, all, asked.settings.u_turn, pairs, faults);
  find_unsound(all, pairs, faults);
  find_dead(all, pairs, faults);
  std::reverse(axes.begin(), axes.end());
  std::reverse(asked.restrictions.begin(), asked.restrictions.end());
  const std::vector<Interconnection> again = run();
  if (!std::equal(pairs.begin(), pairs.end(), again.begin(), again.end(), same))
    faults.push_back("another order of the axes gives other interconnections");
  return faults;
}

}  // namespace streetgen::fuzz
