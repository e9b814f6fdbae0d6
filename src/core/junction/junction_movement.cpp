#include "streetgen/junction_movement.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <tuple>

#include "geometry/polyline.hpp"
#include "interconnection/guided_path.hpp"
#include "interconnection/junction_route.hpp"
#include "interconnection/kerb_clear_path.hpp"
#include "interconnection/movement_angle.hpp"
#include "interconnection/path_choice.hpp"
#include "interconnection/plausibility.hpp"
#include "interconnection/taut_path.hpp"
#include "interconnection/turn.hpp"
#include "interconnection/turning_back.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double lead_length = 0.1;   // metres
constexpr double widest_guided = 40;  // metres, of the arcs of a path that follows edges inside

// The lanes of a leg, indices into JunctionPlace::lanes.
struct LegLanes {
  std::vector<int> in, out;
};

class Across {
 public:
  Across(const JunctionPlace& place, const InterconnectionSettings& settings)
      : place_(place),
        settings_(settings),
        lanes_(place.legs.size()),
        kerbs_(place.surface, borders(place)) {
    for (int i = 0; i < static_cast<int>(place.lanes.size()); ++i) {
      LegLanes& leg = lanes_[place.lanes[i].leg];
      (place.lanes[i].comes_in ? leg.in : leg.out).push_back(i);
    }
  }

  std::vector<JunctionMovement> run() {
    if (pairs() > settings_.most) return {};
    std::vector<Leg> ends;
    for (std::size_t leg = 0; leg < place_.legs.size(); ++leg) ends.push_back(ends_of(leg));
    std::vector<Movement> movements;
    std::vector<std::vector<JunctionMovement>> drawn;
    for (int from = 0; from < static_cast<int>(place_.legs.size()); ++from) {
      if (lanes_[from].in.empty()) continue;
      const std::vector<Way> ways = ways_from(from);
      for (int to = 0; to < static_cast<int>(place_.legs.size()); ++to) {
        if (lanes_[to].out.empty() || to_itself(from, to) || !ways[to].route) continue;
        poll_cancel();
        const bool back = turns_back(ends, from, to);
        Movement movement{
            from, to, back && !by_an_opening(ends, *ways[to].route), ways[to].restricted, 0, {},
            {},   {}};
        drawn.push_back(draw(ends, *ways[to].route, movement, back));
        movements.push_back(std::move(movement));
      }
    }
    choose_lanes(ends, movements, settings_.driving_side);
    for (std::size_t m = 0; m < movements.size(); ++m) keep_clear(ends, movements[m], drawn[m]);
    return with_verdicts(movements, drawn);
  }

 private:
  static std::vector<Line> borders(const JunctionPlace& place) {
    std::vector<Line> lines;
    for (const JunctionLeg& leg : place.legs) lines.push_back(leg.border_line);
    return lines;
  }

  std::size_t pairs() const {
    std::size_t in = 0, out = 0;
    for (const LegLanes& leg : lanes_) {
      in += leg.in.size();
      out += leg.out.size();
    }
    return in * out;
  }

  // To a leg: by where, and whose traffic may not.
  struct Way {
    std::optional<JunctionRoute> route;
    LaneKinds restricted;
  };

  // The way of general traffic, else of such that some restriction excepts, else by forbidden
  // turns.
  std::vector<Way> ways_from(int leg) const {
    std::vector<Way> ways(place_.legs.size());
    const bool bound =
        !place_.restrictions.empty() || !place_.way_restrictions.empty() ||
        std::any_of(place_.inner.begin(), place_.inner.end(), [](const InnerEdge& edge) {
          return of_some_alone(edge.along) || of_some_alone(edge.against);
        });
    if (bound)
      for (const LaneKind kind :
           {LaneKind::general, LaneKind::bus, LaneKind::carpool, LaneKind::cycle})
        take_ways(JunctionRoutes(place_, settings_.node_tolerance, kind).from(leg), kind, ways);
    take_ways(JunctionRoutes(place_, settings_.node_tolerance, std::nullopt).from(leg), {}, ways);
    return ways;
  }

  static void take_ways(std::vector<std::optional<JunctionRoute>> routes,
                        std::optional<LaneKind> kind, std::vector<Way>& ways) {
    for (std::size_t to = 0; to < ways.size(); ++to) {
      if (kind && !routes[to]) ways[to].restricted.set(index_of(*kind));
      if (!ways[to].route) ways[to].route = std::move(routes[to]);
    }
  }

  bool to_itself(int from, int to) const {
    return !settings_.u_turn && (from == to || place_.legs[from].edge == place_.legs[to].edge);
  }

  // Whether edges inside that lead to nothing else join the two carriageways: an opening in the
  // median, which is meant for those who turn back.
  bool by_an_opening(const std::vector<Leg>& ends, const JunctionRoute& route) const {
    if (route.empty()) return false;
    std::vector<int> edges, nodes;
    for (const RoutePiece& piece : route) {
      const InnerEdge& edge = place_.inner[piece.inner];
      edges.push_back(piece.inner);
      nodes.insert(nodes.end(), {edge.from_node, edge.to_node});
    }
    const auto passed = [&](int node) {
      return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
    };
    for (int e = 0; e < static_cast<int>(place_.inner.size()); ++e)
      if (std::find(edges.begin(), edges.end(), e) == edges.end() &&
          (passed(place_.inner[e].from_node) || passed(place_.inner[e].to_node)))
        return false;
    for (std::size_t leg = 0; leg < ends.size(); ++leg)
      if (passed(place_.legs[leg].node) && !comes_alone(ends[leg]) && !goes_alone(ends[leg]))
        return false;
    return true;
  }

  LaneEnd end_of(int index) const {
    const JunctionLane& lane = place_.lanes[index];
    const Line& line = lane.line;
    LaneEnd end{lane.kind, lane.turns, {}, {}};
    if (lane.comes_in) {
      end.place = planar(line.back());
      end.direction = unit(planar(line.back()) - planar(line[line.size() - 2]));
    } else {
      end.place = planar(line.front());
      end.direction = unit(planar(line[1]) - planar(line.front()));
    }
    return end;
  }

  Leg ends_of(std::size_t leg) const {
    Leg ends;
    for (const int lane : lanes_[leg].in) ends.in.push_back(end_of(lane));
    for (const int lane : lanes_[leg].out) ends.out.push_back(end_of(lane));
    for (const std::vector<LaneEnd>* lanes : {&ends.in, &ends.out}) {
      if (lanes->empty()) continue;
      ends.course = lanes->front().direction * (lanes == &ends.in ? -1 : 1);
      ends.outset = ends.course;
      ends.stand = lanes->front().place;
    }
    ends.importance = place_.legs[leg].importance;
    ends.on_ring = place_.legs[leg].on_ring;
    return ends;
  }

  std::vector<JunctionMovement> draw(const std::vector<Leg>& ends, const JunctionRoute& route,
                                     Movement& movement, bool back) const {
    const double side = movement_angle(ends[movement.from], ends[movement.to]);
    const JunctionLeg &from = place_.legs[movement.from], &to = place_.legs[movement.to];
    movement.least_radius = speed_radius(std::min(from.speed, to.speed));
    std::vector<JunctionMovement> pairs;
    for (std::size_t i = 0; i < ends[movement.from].in.size(); ++i)
      for (std::size_t o = 0; o < ends[movement.to].out.size(); ++o) {
        const LaneEnd &in = ends[movement.from].in[i], &out = ends[movement.to].out[o];
        JunctionMovement pair;
        pair.lane_in = lanes_[movement.from].in[i];
        pair.lane_out = lanes_[movement.to].out[o];
        pair.angle = rounded_degrees(turn_angle(in.direction, out.direction));
        pair.turn = turn_called(back, pair.angle, side);
        pair.line = path_between(route, in, out, movement.from, movement.to);
        pair.interconnections = steps_between(pair.lane_in, pair.lane_out);
        movement.radius.push_back(quarter_radius(pair.line));
        movement.drivable.push_back(drivable(pair.line));
        pairs.push_back(std::move(pair));
      }
    return pairs;
  }

  // The first that is clear of the kerbs and drivable: a curve, one that follows the edges inside
  // ever closer, arcs; else the first that is clear, else the first, or the closest where that is
  // shorter.
  Line path_between(const JunctionRoute& route, const LaneEnd& in, const LaneEnd& out, int from,
                    int to) const {
    const Line lane_in{in.place - in.direction, in.place},
        lane_out{out.place, out.place + out.direction};
    const auto curve = [&](TrajectoryRule rule) {
      Trajectory path = tangent_trajectory(lane_in, lane_out, rule, settings_.tolerance);
      lead(path.line, in, out);
      return path;
    };
    const auto guided = [&](double widest) {
      return Trajectory{{}, guided_path(place_, route, in, out, widest, settings_.tolerance)};
    };
    PathChoice choice(kerbs_, from, to, false);
    if (choice.offer(curve(settings_.rule)) || choice.offer(guided(widest_guided)) ||
        choice.offer(guided(widest_guided / 2)) || choice.offer(guided(widest_guided / 4)) ||
        choice.offer(curve(TrajectoryRule::arcs)))
      return choice.best().line;
    const Trajectory closest = guided(car_radius * 2);
    choice.offer(closest);
    Line line = choice.best().line;
    // A wide curve may lead far astray where all cross a kerb.
    return choice.clear() || length(line) <= length(closest.line) ? line : closest.line;
  }

  // A path over a kerb goes the shortest way past it instead, if there is one.
  void keep_clear(const std::vector<Leg>& ends, const Movement& movement,
                  std::vector<JunctionMovement>& pairs) const {
    const int from = movement.from, to = movement.to;
    const std::size_t outs = ends[to].out.size();
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      if (!movement.verdicts[p].plausible || !kerbs_.stop(pairs[p].line, from, to)) continue;
      auto path = taut_path(place_, kerbs_, from, to, ends[from].in[p / outs],
                            ends[to].out[p % outs], settings_.tolerance);
      if (path) pairs[p].line = std::move(*path);
    }
  }

  // Chords leave their curve by an angle: at its ends the path goes on as the lanes do.
  static void lead(Line& path, const LaneEnd& in, const LaneEnd& out) {
    const double reach = std::min(lead_length, length(path) / 20);
    path.insert(path.begin() + 1, in.place + in.direction * reach);
    path.insert(path.end() - 1, out.place - out.direction * reach);
  }

  using LaneState = std::pair<std::int64_t, bool>;

  // The fewest paths at single nodes that lead from lane to lane; those that are plausible first.
  std::vector<std::int64_t> steps_between(int in, int out) const {
    const LaneState start{place_.lanes[in].lane_id, place_.lanes[in].along_axis};
    const LaneState goal{place_.lanes[out].lane_id, place_.lanes[out].along_axis};
    using Entry = std::tuple<int, int, LaneState>;
    std::map<LaneState, std::pair<LaneState, const LaneStep*>> before;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    std::map<LaneState, int> cost{{start, 0}};
    open.push({0, 0, start});
    int order = 0;
    while (!open.empty()) {
      const auto [spent, ignored, at] = open.top();
      open.pop();
      if (at == goal) break;
      if (spent > cost[at]) continue;
      for (const LaneStep& step : place_.steps) {
        if (LaneState{step.lane_in, step.along_in} != at) continue;
        const LaneState next{step.lane_out, step.along_out};
        const int reached = spent + (step.plausible ? 1 : 100);
        const auto known = cost.find(next);
        if (known != cost.end() && known->second <= reached) continue;
        cost[next] = reached;
        before[next] = {at, &step};
        open.push({reached, ++order, next});
      }
    }
    std::vector<std::int64_t> steps;
    if (before.count(goal) == 0) return steps;
    for (LaneState at = goal; at != start; at = before[at].first)
      steps.push_back(before[at].second->interconnection_id);
    std::reverse(steps.begin(), steps.end());
    return steps;
  }

  std::vector<JunctionMovement> with_verdicts(
      const std::vector<Movement>& movements,
      std::vector<std::vector<JunctionMovement>>& drawn) const {
    std::vector<JunctionMovement> out;
    for (std::size_t m = 0; m < movements.size(); ++m)
      for (std::size_t p = 0; p < drawn[m].size(); ++p) {
        drawn[m][p].plausible = movements[m].verdicts[p].plausible;
        drawn[m][p].reason = movements[m].verdicts[p].reason;
        drawn[m][p].traffic =
            traffic_of(movements[m].verdicts[p], place_.lanes[drawn[m][p].lane_in].kind,
                       place_.lanes[drawn[m][p].lane_out].kind);
        out.push_back(std::move(drawn[m][p]));
      }
    std::sort(out.begin(), out.end(), [](const JunctionMovement& a, const JunctionMovement& b) {
      return std::make_pair(a.lane_in, a.lane_out) < std::make_pair(b.lane_in, b.lane_out);
    });
    return out;
  }

  const JunctionPlace& place_;
  const InterconnectionSettings& settings_;
  std::vector<LegLanes> lanes_;  // by leg
  Kerbs kerbs_;
};

}  // namespace

std::vector<JunctionMovement> junction_movements(const JunctionPlace& place,
                                                 const InterconnectionSettings& settings) {
  return Across(place, settings).run();
}

}  // namespace streetgen
