#include "streetgen/interconnection.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "geometry/polyline.hpp"
#include "interconnection/kerb_clear_path.hpp"
#include "interconnection/movement_angle.hpp"
#include "interconnection/next_junction.hpp"
#include "interconnection/node_restrictions.hpp"
#include "interconnection/path_choice.hpp"
#include "interconnection/plausibility.hpp"
#include "interconnection/taut_path.hpp"
#include "interconnection/turn.hpp"
#include "interconnection/turning_back.hpp"
#include "lane/lane_extent.hpp"
#include "roundabout/circulation.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/progress.hpp"

namespace streetgen {

namespace {

constexpr double same_direction = 1e-3;   // radians
constexpr double finest_turn = 0.1;       // degrees between chords of a ramp
constexpr double outset_reach = 3;        // metres, over which a street leaves its node
constexpr double course_reach = 10;       // metres, over which it has its course
constexpr double finer_than_a_turn = 50;  // chords of a ramp past kerbs leave its arcs so much less

// From the place of the first point to the next place; zero where there is none.
template <class At>
Point leaving(At first, At end) {
  const auto next =
      std::find_if(first, end, [&](const Point& p) { return distance(p, *first) > 0; });
  return next == end ? Point{} : unit(*next - *first);
}

struct LaneRange {
  std::size_t first = 0, count = 0;
};

// Numbers of lanes with which an edge comes to a node.
struct EdgeEnds {
  std::size_t in = 0, out = 0;
};

// A leg of the node, with the lanes behind each of its ends.
struct NodeLeg {
  int edge = 0;
  bool at_start = true;
  std::vector<int> in, out;  // indices of lanes, from left to right in their driving direction
};

class InterconnectionBuilder {
 public:
  InterconnectionBuilder(const Streets& streets, const std::vector<StreetAxis>& axes,
                         const std::vector<Lane>& lanes,
                         const std::vector<TurnRestriction>& restrictions,
                         const InterconnectionSettings& settings,
                         const std::vector<Circulation>& circulations, const WishedLanes& wished)
      : streets_(streets),
        lanes_(lanes),
        settings_(settings),
        circulations_(circulations),
        wished_(wished),
        restrictions_(streets.network, restrictions, settings.node_tolerance) {
    for (const StreetAxis& axis : axes) axes_.emplace(axis.axis_id, &axis);
    for (const Ramp& ramp : streets.ramps) ramps_.emplace(ramp.node, &ramp);
    const auto& edges = streets.network.edges;
    of_edge_.resize(edges.size());
    for (std::size_t i = 0; i < lanes.size(); ++i) {
      LaneRange& own = of_edge_[lanes[i].edge];
      if (own.count++ == 0) own.first = i;
    }
    legs_.resize(streets.network.nodes.size());
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
      legs_[edges[e].from_node].push_back(leg_of(e, true));
      legs_[edges[e].to_node].push_back(leg_of(e, false));
    }
  }

  std::vector<Interconnection> run() {
    for (int n = 0; n < static_cast<int>(legs_.size()); ++n) {
      if (!streets_.affected_nodes[n]) continue;
      poll_cancel();
      tell_progress("interconnections", n, legs_.size());
      join(n);
    }
    return std::move(out_);
  }

 private:
  std::int64_t axis_of(const NodeLeg& leg) const {
    return streets_.network.edges[leg.edge].axis_id;
  }

  NodeLeg leg_of(int edge, bool at_start) const {
    NodeLeg leg{edge, at_start, {}, {}};
    const LaneRange& own = of_edge_[edge];
    for (std::size_t i = own.first; i < own.first + own.count; ++i) {
      const Lane& lane = lanes_[i];
      if (!carries_traffic(lane.kind) || !lane.reaches(at_start)) continue;
      if (lane.both_ways || lane.along_axis == at_start) leg.out.push_back(static_cast<int>(i));
      if (lane.both_ways || lane.along_axis != at_start) leg.in.push_back(static_cast<int>(i));
    }
    // Positions run from the left kerb in the direction of the axis.
    std::reverse((at_start ? leg.in : leg.out).begin(), (at_start ? leg.in : leg.out).end());
    return leg;
  }

  // The place on the axis of its edge where the lane ends.
  double end_abscissa(const Lane& lane, bool at_front) const {
    const LaneExtent reach = lane_extent(streets_, lane.edge);
    const Roadway& roadway = streets_.roadways[lane.edge];
    const double half = (at_front ? roadway.width : roadway.width_end) / 2;
    const double aside = (lane.axis_offset - roadway.roadway_offset) / half;
    return (at_front ? reach.from : reach.to) + aside * streets_.limits[2 * lane.edge].askew;
  }

  // The direction of the lane in the point order of the axis.  The axis gives it, so that it does
  // not depend on where the lane's far end lies, unless a bend left the lane another last segment.
  Point direction_at(const Lane& lane, bool at_front) const {
    const Line& axis = streets_.network.edges[lane.edge].line;
    const Roadway& roadway = streets_.roadways[lane.edge];
    const double total = length(axis), widening = (roadway.width_end - roadway.width) / total;
    const double share = (lane.axis_offset - roadway.roadway_offset) /
                         (roadway.width + widening * end_abscissa(lane, true));
    const Point along = position_at(axis, end_abscissa(lane, at_front)).direction;
    const Point direction = unit(along + left_normal(along) * (share * widening));
    const Point own = at_front ? leaving(lane.line.begin(), lane.line.end())
                               : leaving(lane.line.rbegin(), lane.line.rend()) * -1;
    return norm(own) == 0 || norm(own - direction) < same_direction ? direction : own;
  }

  // Whether traffic runs along the axis there.
  static bool runs_along(const NodeLeg& leg, bool comes_in) { return leg.at_start != comes_in; }

  LaneEnd end_of(int index, const NodeLeg& leg, bool comes_in) const {
    const Lane& lane = lanes_[index];
    // Whoever merges drives as on any lane.
    const LaneKind kind = lane.kind == LaneKind::merging ? LaneKind::general : lane.kind;
    LaneEnd end{kind, lane.turns, {}, {}};
    end.place = planar(leg.at_start ? lane.line.front() : lane.line.back());
    end.direction = direction_at(lane, leg.at_start) * (runs_along(leg, comes_in) ? 1 : -1);
    const Edge& edge = streets_.network.edges[lane.edge];
    const Point node =
        planar(streets_.network.nodes[leg.at_start ? edge.from_node : edge.to_node].point);
    end.aside = cross(end.direction, end.place - node);
    end.middle = lane.middle;
    return end;
  }

  LaneToNode to_node(int index, const LaneEnd& end, const NodeLeg& leg, bool comes_in,
                     int border) const {
    const Lane& lane = lanes_[index];
    const Roadway& roadway = streets_.roadways[leg.edge];
    LaneToNode out{end, {}, border};
    out.line = lane_to_node(streets_.network.edges[leg.edge].line, roadway,
                            end_abscissa(lane, leg.at_start), end.place, leg.at_start);
    if (!comes_in) out.end.direction = end.direction * -1;
    return out;
  }

  Kerbs kerbs_of(int node) const {
    std::vector<Line> borders;
    for (const NodeLeg& leg : legs_[node])
      borders.push_back(streets_.limits[2 * leg.edge + (leg.at_start ? 0 : 1)].border_line);
    const auto found = std::lower_bound(
        streets_.intersections.begin(), streets_.intersections.end(), node,
        [](const Intersection& intersection, int wanted) { return intersection.node < wanted; });
    const bool there = found != streets_.intersections.end() && found->node == node;
    return Kerbs(there ? found->surface : MultiPolygon{}, borders);
  }

  Leg ends_of(const NodeLeg& leg) const {
    Leg ends;
    for (const int lane : leg.in) ends.in.push_back(end_of(lane, leg, true));
    for (const int lane : leg.out) ends.out.push_back(end_of(lane, leg, false));
    const Line& line = streets_.network.edges[leg.edge].line;
    const double total = length(line);
    const auto at = [&](double reach) {
      reach = std::min(reach, total);
      return planar(position_at(line, leg.at_start ? reach : total - reach).point);
    };
    ends.stand = at(course_reach);
    ends.course = unit(ends.stand - at(0));
    ends.outset = unit(at(outset_reach) - at(0));
    ends.importance = axes_.at(axis_of(leg))->importance;
    ends.on_ring = circulations_.of(streets_.network.edges[leg.edge]) != nullptr;
    return ends;
  }

  std::size_t pairs_at(const std::vector<NodeLeg>& legs) const {
    std::size_t in = 0, out = 0, on_one_edge = 0;
    std::unordered_map<int, EdgeEnds> of_edge;
    for (const NodeLeg& leg : legs) {
      in += leg.in.size();
      out += leg.out.size();
      of_edge[leg.edge].in += leg.in.size();
      of_edge[leg.edge].out += leg.out.size();
    }
    for (const auto& [edge, ends] : of_edge) on_one_edge += ends.in * ends.out;
    return in * out - (settings_.u_turn ? 0 : on_one_edge);
  }

  void join(int node) {
    const std::vector<NodeLeg>& legs = legs_[node];
    if (pairs_at(legs) > settings_.most) return;
    std::vector<Leg> ends;
    for (const NodeLeg& leg : legs) ends.push_back(ends_of(leg));
    std::vector<Movement> movements;
    for (std::size_t a = 0; a < legs.size(); ++a)
      for (std::size_t b = 0; b < legs.size(); ++b) {
        if (legs[a].in.empty() || legs[b].out.empty()) continue;
        if (legs[a].edge == legs[b].edge && !settings_.u_turn) continue;
        const int from = static_cast<int>(a), to = static_cast<int>(b);
        movements.push_back({from, to, turns_back(ends, from, to), {}, 0, {}, {}, {}});
      }
    if (movements.empty()) return;
    const Kerbs kerbs = kerbs_of(node);
    std::vector<std::vector<Interconnection>> pairs;
    for (Movement& movement : movements) pairs.push_back(draw(node, ends, kerbs, movement));
    restrictions_.mark(node, axes_of(legs), ends, movements);
    for (std::size_t leg = 0; leg < legs.size(); ++leg) foresee(legs[leg], ends[leg].out);
    choose_lanes(ends, movements, settings_.driving_side);
    const std::size_t first = out_.size();
    for (std::size_t m = 0; m < movements.size(); ++m)
      for (std::size_t p = 0; p < pairs[m].size(); ++p) {
        pairs[m][p].plausible = movements[m].verdicts[p].plausible;
        pairs[m][p].reason = movements[m].verdicts[p].reason;
        pairs[m][p].traffic = traffic_of(movements[m].verdicts[p], lanes_[pairs[m][p].lane_in].kind,
                                         lanes_[pairs[m][p].lane_out].kind);
        out_.push_back(std::move(pairs[m][p]));
      }
    const auto place = [](const Interconnection& i) {
      return std::make_tuple(i.lane_in, i.lane_out, i.along_in, i.along_out);
    };
    std::sort(
        out_.begin() + first, out_.end(),
        [&](const Interconnection& a, const Interconnection& b) { return place(a) < place(b); });
  }

  // Which ways of the next junction lanes serve that leave by a leg.
  void foresee(const NodeLeg& leg, std::vector<LaneEnd>& out) const {
    const Edge& edge = streets_.network.edges[leg.edge];
    const SectionLimit *start = &streets_.limits[2 * leg.edge], *end = start + 1;
    if (!wished_ || end->abscissa - start->abscissa >= settings_.look_ahead ||
        !leave_choice(wished_(edge), leg.at_start))
      return;
    const int next = leg.at_start ? edge.to_node : edge.from_node;
    const std::vector<NodeLeg>& there = legs_[next];
    std::vector<Leg> legs;
    int from = 0;
    for (const NodeLeg& other : there) {
      const Edge& its = streets_.network.edges[other.edge];
      const bool same = other.edge == leg.edge && other.at_start != leg.at_start;
      if (same) from = static_cast<int>(legs.size());
      legs.push_back(foreseen_leg(its, other.at_start, wished_(its)));
      legs.back().importance = axes_.at(axis_of(other))->importance;
      legs.back().on_ring = circulations_.of(its) != nullptr;
    }
    // Marks come to the lanes of the edge from elsewhere too.
    std::vector<LaneEnd>& in = legs[from].in;
    if (in.size() != out.size()) return;
    for (std::size_t i = 0; i < in.size(); ++i) {
      in[i].turns = out[i].turns;
      in[i].middle = out[i].middle;
    }
    std::vector<Movement> movements = foreseen_movements(legs, from);
    restrictions_.mark(next, axes_of(there), legs, movements);
    const std::vector<unsigned> served =
        served_ahead(legs, from, movements, settings_.driving_side);
    for (std::size_t i = 0; i < out.size(); ++i) out[i].ahead = served[i];
  }

  // Tangent to both lanes along arcs, in chords that turn too little to be felt.
  Trajectory ramp_path(const LaneToNode& in, const LaneToNode& out) const {
    const auto by = [&](double tolerance) {
      return tangent_trajectory({in.end.place - in.end.direction, in.end.place},
                                {out.end.place, out.end.place - out.end.direction},
                                TrajectoryRule::arcs, tolerance);
    };
    Trajectory path = by(settings_.tolerance);
    // A chord leaves its arc by the square of its turn.
    const double coarse = sharpest_turn(path.line) / finest_turn;
    return coarse > 1 ? by(settings_.tolerance / (coarse * coarse)) : path;
  }

  // Tangent to both lanes, past the kerbs that arcs would cross.
  std::optional<Trajectory> ramp_past_kerbs(const LaneToNode& in, const LaneToNode& out,
                                            const Kerbs& kerbs) const {
    LaneEnd onwards = out.end;
    onwards.direction = onwards.direction * -1;
    auto line = taut_path({}, kerbs, in.border, out.border, in.end, onwards,
                          settings_.tolerance / finer_than_a_turn);
    if (!line) return std::nullopt;
    return Trajectory{ramp_path(in, out).control, std::move(*line)};
  }

  // The ramp of a node whose link is one of two edges there; none otherwise.
  const Ramp* ramp_of(int node, int from, int to) const {
    const auto found = ramps_.find(node);
    if (found == ramps_.end()) return nullptr;
    const int link = found->second->link;
    return link == from || link == to ? found->second : nullptr;
  }

  // The widest path that the rule gives, clear of the kerbs and without a corner; else a path that
  // turns later, or one of arcs.
  Trajectory path_between(int node, const LaneToNode& in, const LaneToNode& out, const Kerbs& kerbs,
                          bool on_ramp) const {
    const TrajectoryRule rule = settings_.rule, arcs = TrajectoryRule::arcs;
    const auto direct = [&](TrajectoryRule by, double radius) {
      return trajectory({in.end.place - in.end.direction, in.end.place},
                        {out.end.place, out.end.place - out.end.direction},
                        streets_.network.nodes[node].point, by, settings_.tolerance, radius);
    };
    const auto late = [&](TrajectoryRule by) {
      return late_turn(in, out, by, settings_.tolerance, kerbs);
    };
    const bool papers = rule == TrajectoryRule::bezier && settings_.least_radius == 0;
    PathChoice choice(kerbs, in.border, out.border, papers);
    // Both directions lead to the node.  A link bends on behind it; who turns back is on no ramp.
    if (on_ramp && dot(in.end.direction, out.end.direction) < 0 &&
        (choice.offer(ramp_path(in, out)) || choice.offer(ramp_past_kerbs(in, out, kerbs))))
      return choice.best();
    if (papers) {
      if (!choice.offer(direct(rule, 0))) choice.offer(late(rule));
      return choice.best();
    }
    choice.offer(direct(rule, settings_.least_radius)) ||
        choice.offer(direct(rule, std::min(settings_.least_radius, car_radius))) ||
        choice.offer(late(rule)) || choice.offer(direct(arcs, 0)) || choice.offer(late(arcs));
    return choice.best();
  }

  std::vector<Interconnection> draw(int node, const std::vector<Leg>& ends, const Kerbs& kerbs,
                                    Movement& movement) const {
    const NodeLeg &from = legs_[node][movement.from], &to = legs_[node][movement.to];
    const Ramp* ramp = ramp_of(node, from.edge, to.edge);
    if (ramp != nullptr) movement.side = ramp->side;
    movement.least_radius =
        speed_radius(std::min(axes_.at(axis_of(from))->speed, axes_.at(axis_of(to))->speed));
    const double side = movement_angle(ends[movement.from], ends[movement.to]);
    std::vector<Interconnection> pairs;
    for (std::size_t i = 0; i < from.in.size(); ++i)
      for (std::size_t o = 0; o < to.out.size(); ++o) {
        const LaneEnd &in = ends[movement.from].in[i], &out = ends[movement.to].out[o];
        Interconnection pair;
        pair.node = node;
        pair.lane_in = from.in[i];
        pair.lane_out = to.out[o];
        pair.along_in = runs_along(from, true);
        pair.along_out = runs_along(to, false);
        pair.angle = rounded_degrees(turn_angle(in.direction, out.direction));
        pair.turn = turn_called(movement.turns_back, pair.angle, side);
        Trajectory path =
            path_between(node, to_node(from.in[i], in, from, true, movement.from),
                         to_node(to.out[o], out, to, false, movement.to), kerbs, ramp != nullptr);
        pair.control = path.control;
        pair.line = std::move(path.line);
        movement.radius.push_back(quarter_radius(pair.line));
        movement.drivable.push_back(drivable(pair.line));
        pairs.push_back(std::move(pair));
      }
    return pairs;
  }

  std::vector<std::int64_t> axes_of(const std::vector<NodeLeg>& legs) const {
    std::vector<std::int64_t> axes;
    for (const NodeLeg& leg : legs) axes.push_back(axis_of(leg));
    return axes;
  }

  const Streets& streets_;
  const std::vector<Lane>& lanes_;
  const InterconnectionSettings& settings_;
  const Circulations circulations_;
  const WishedLanes& wished_;
  std::unordered_map<std::int64_t, const StreetAxis*> axes_;
  std::unordered_map<int, const Ramp*> ramps_;  // by node
  std::vector<LaneRange> of_edge_;
  std::vector<std::vector<NodeLeg>> legs_;  // by node, in the order of edges
  const NodeRestrictions restrictions_;
  std::vector<Interconnection> out_;
};

}  // namespace

const char* turn_name(Turn turn) noexcept {
  switch (turn) {
    case Turn::through:
      return "through";
    case Turn::left:
      return "left";
    case Turn::right:
      return "right";
    case Turn::u_turn:
      return "u_turn";
  }
  return "";
}

const char* reason_name(Reason reason) noexcept {
  switch (reason) {
    case Reason::lane_order:
      return "lane_order";
    case Reason::turn_lanes:
      return "turn_lanes";
    case Reason::only_way:
      return "only_way";
    case Reason::restriction:
      return "restriction";
    case Reason::lane_kind:
      return "lane_kind";
    case Reason::look_ahead:
      return "look_ahead";
    case Reason::traffic:
      return "traffic";
    case Reason::u_turn:
      return "u_turn";
    case Reason::radius:
      return "radius";
    case Reason::ring:
      return "ring";
    case Reason::not_drivable:
      return "not_drivable";
  }
  return "";
}

std::vector<Interconnection> interconnections(
    const Streets& streets, const std::vector<StreetAxis>& axes, const std::vector<Lane>& lanes,
    const std::vector<TurnRestriction>& restrictions, const InterconnectionSettings& settings,
    const std::vector<Circulation>& circulations, const WishedLanes& wished) {
  return InterconnectionBuilder(streets, axes, lanes, restrictions, settings, circulations, wished)
      .run();
}

}  // namespace streetgen
