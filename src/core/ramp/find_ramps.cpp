#include "ramp/find_ramps.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "layout/node_corner.hpp"
#include "layout/width_transition.hpp"
#include "ramp/highway.hpp"

namespace streetgen {

namespace {

constexpr double fast = 80;         // km/h, of a highway without a class
constexpr double friction = 0.35;   // to the side, that a driver bears on a ramp
constexpr double gravity = 9.81;    // m/s2
constexpr double farthest = 200;    // metres from the node where a link is beside its lane
constexpr double margin = 0.01;     // metres
constexpr double no_turn = 1e-9;    // radians
constexpr int tries = 6;            // of radii of the outer kerb, each half of the last
constexpr double tangent_step = 5;  // metres
// A longer tangent ends where the link turns by 45 degrees off the highway.
const double least_along = std::cos(M_PI / 4 + same_angle);
constexpr double most_of_highway = 1.0 / 3;  // of an edge, that becomes a ramp's intersection
constexpr double least_link = 1;             // metres that stay between the limits of a link

// How traffic uses the end of an edge.
struct RampLeg {
  EdgeEnd end;
  const RampAxis* axis = nullptr;
  RampEdgeLanes lanes{};
  Point direction;  // away from the node
  double speed = 0;

  const RampLanes& coming() const { return end.at_start ? lanes.against : lanes.along; }
  const RampLanes& leaving() const { return end.at_start ? lanes.along : lanes.against; }
  bool one_way() const { return (coming().count > 0) != (leaving().count > 0); }
};

class Finder {
 public:
  Finder(Layout& layout, const RampRules& rules) : layout_(layout), rules_(rules) {
    for (const RampAxis& axis : rules.axes)
      if (axis.part != RampPart::none) by_id_.emplace(axis.axis_id, &axis);
  }

  void run() {
    for (int n = 0; n < static_cast<int>(layout_.junctions.size()); ++n)
      if (layout_.junctions[n].ends.size() == 3)
        if (const auto ramp = ramp_at(n)) {
          layout_.junctions[n].ramp = static_cast<int>(layout_.streets.ramps.size());
          layout_.streets.ramps.push_back(*ramp);
        }
  }

 private:
  std::optional<Ramp> ramp_at(int node) const {
    std::vector<RampLeg> legs;
    for (const EdgeEnd& end : layout_.junctions[node].ends) {
      const auto found = by_id_.find(layout_.axis_of(end.edge).axis_id);
      if (found == by_id_.end()) return std::nullopt;
      const RampEdgeLanes lanes = rules_.lanes_of(layout_.streets.network.edges[end.edge]);
      if (lanes.both_ways) return std::nullopt;
      const Line& line = layout_.arm(end).line;
      const Point far = position_at(line, std::min(highway_look, length(line))).point;
      legs.push_back(
          {end, found->second, lanes, unit(far - line.front()), layout_.axis_of(end.edge).speed});
    }
    const int link = link_of(legs);
    if (link < 0 || !legs[link].one_way()) return std::nullopt;
    const RampLeg &one = legs[(link + 1) % 3], &other = legs[(link + 2) % 3];
    if (one.end.edge == other.end.edge || one.end.edge == legs[link].end.edge ||
        other.end.edge == legs[link].end.edge ||
        dot(one.direction, other.direction) > -highway_straightest)
      return std::nullopt;
    // A ramp lies beside the arm by which its traffic would come, or go, on the highway.
    const bool one_beside =
        dot(legs[link].direction, one.direction) > dot(legs[link].direction, other.direction);
    return ramp_of(node, legs[link], one_beside ? one : other, one_beside ? other : one);
  }

  static int link_of(const std::vector<RampLeg>& legs) {
    int link = -1, links = 0, unclassed = 0;
    double speed = 0;
    for (int i = 0; i < 3; ++i) {
      if (legs[i].axis->part == RampPart::link) link = i, ++links;
      if (legs[i].axis->part == RampPart::unclassed) ++unclassed;
      speed = std::max(speed, legs[i].speed);
    }
    if (links == 1 && unclassed == 0) return link;
    if (unclassed < 3 || speed < fast) return -1;
    // Opposite to neither of the others.
    const auto bend = [&](int i) {
      return dot(legs[(i + 1) % 3].direction, legs[(i + 2) % 3].direction);
    };
    return bend(0) < bend(1) ? (bend(0) < bend(2) ? 0 : 2) : (bend(1) < bend(2) ? 1 : 2);
  }

  std::optional<Ramp> ramp_of(int node, const RampLeg& link, const RampLeg& beside,
                              const RampLeg& away) const {
    if (dot(link.direction, beside.direction) < steepest_ramp) return std::nullopt;
    Ramp ramp;
    ramp.node = node;
    ramp.on = link.coming().count > 0;
    const RampLeg &before = ramp.on ? beside : away, &after = ramp.on ? away : beside;
    const RampLanes &in = before.coming(), &out = after.leaving();
    const RampLanes& own = ramp.on ? link.coming() : link.leaving();
    if (in.count == 0 || out.count == 0) return std::nullopt;
    const Point with_traffic = unit(after.direction - before.direction);
    ramp.side = cross(with_traffic, link.direction) > 0 ? +1 : -1;
    const bool two_ways = before.leaving().count > 0 || after.coming().count > 0;
    if (two_ways && ramp.side != rules_.outer_side) return std::nullopt;
    ramp.link = link.end.edge;
    ramp.link_at_start = link.end.at_start;
    ramp.before = before.end.edge;
    ramp.before_at_start = before.end.at_start;
    ramp.after = after.end.edge;
    ramp.after_at_start = after.end.at_start;
    ramp.lanes_before = in.count;
    ramp.lanes_ramp = own.count;
    ramp.lanes_after = out.count;
    const int parting = ramp.on ? 0 : ramp.side > 0 ? in.parting_left : in.parting_right;
    const int lacking =
        ramp.on ? in.count + own.count - out.count : out.count + own.count - in.count - parting;
    const bool counted = link.axis->counted && before.axis->counted && after.axis->counted;
    ramp.missing = counted ? std::clamp(lacking, 0, own.count) : 0;
    ramp.merging_width = ramp.missing * (ramp.on ? after : before).lanes.lane_width;
    ramp.tangent = rules_.tangent;
    ramp.length = rules_.merging_length;
    decide(ramp);
    if (ramp.length <= 0) ramp.missing = 0, ramp.merging_width = 0;
    ramp.taper = std::clamp(taper_length(ramp.merging_width, std::max(before.speed, after.speed),
                                         layout_.settings.taper_ratio),
                            least_taper, longest_taper);
    return ramp;
  }

  void decide(Ramp& ramp) const {
    const Edge& link = layout_.streets.network.edges[ramp.link];
    const double middle = (link.start_abscissa + link.end_abscissa) / 2;
    for (const RampOverride& put : rules_.overrides) {
      if (put.axis_id != link.axis_id || (put.abscissa <= middle) != ramp.link_at_start ||
          put.abscissa < link.start_abscissa || put.abscissa > link.end_abscissa)
        continue;
      ramp.tangent = put.tangent.value_or(ramp.tangent);
      ramp.length = put.length.value_or(ramp.length);
      ramp.by_hand = true;
    }
  }

  Layout& layout_;
  const RampRules& rules_;
  std::unordered_map<std::int64_t, const RampAxis*> by_id_;
};

// Metres along the link from its node to where its middle lies beside the node as far as the
// outermost lane of the highway, which runs straight on there; none where it does not within 200 m.
std::optional<double> beside_lane(const Layout& layout, const Ramp& ramp) {
  const Arm& link = layout.arm({ramp.link, ramp.link_at_start});
  const Arm& highway = layout.arm({ramp.merging_edge(), ramp.merging_at_start()});
  // Before an off-ramp the arm points against the traffic.
  const int side = ramp.on ? ramp.side : -ramp.side;
  const double wanted = highway.start_to(side) - link.half_start;
  const Point node = planar(highway.line.front());
  const Point aside = left_normal(position_at(highway.line, 0).direction) * side;
  double before = 0, abscissa = 0;
  for (std::size_t i = 1; i < link.line.size() && abscissa < farthest; ++i) {
    const double step = distance(link.line[i - 1], link.line[i]);
    const double offset = dot(planar(link.line[i]) - node, aside);
    if (offset >= wanted && offset > before)
      return abscissa + step * std::max(wanted - before, 0.0) / (offset - before);
    before = offset;
    abscissa += step;
  }
  return std::nullopt;
}

// How a link bends into the outermost lane of its highway.
struct Bend {
  double beside = 0;   // metres along the link to where it begins, were it not round
  double tangent = 0;  // metres before and behind
  double radius = 0;   // of the middle of the link
  bool parts = true;   // whether the link comes out of the lane at all
};

// The tangent as wanted, and longer where the speed of the link asks for a greater radius; of those
// that are too short for it the one of the greatest radius.  `least` is the limit of the link
// without the bend.
Bend bend_of(const Layout& layout, const Ramp& ramp, double least) {
  const Arm& link = layout.arm({ramp.link, ramp.link_at_start});
  const Arm& highway = layout.arm({ramp.merging_edge(), ramp.merging_at_start()});
  const Point along = position_at(highway.line, 0).direction;
  const double speed = layout.axis_of(ramp.link).speed / 3.6;
  const double wanted = speed * speed / (friction * gravity);
  const double longest = std::max(ramp.tangent, layout.settings.reach);
  const std::optional<double> found = beside_lane(layout, ramp);
  const double beside = found.value_or(0);
  Bend best{beside, ramp.tangent, 0, found.has_value()};
  for (double tangent = ramp.tangent; tangent <= longest; tangent += tangent_step) {
    // A limit at a vertex leaves along the piece behind it, whatever rounding says.
    const Point leaves =
        position_at(link.line, std::max(least, beside + tangent) + margin).direction;
    if (tangent > ramp.tangent && -dot(leaves, along) < least_along) break;
    const double turn = std::atan2(std::abs(cross(leaves, along)), -dot(leaves, along));
    const double radius = tangent / std::tan(std::max(turn, no_turn) / 2);
    if (radius <= best.radius) continue;
    best.radius = radius;
    best.tangent = tangent;
    if (radius >= wanted) break;
  }
  return best;
}

// How far the flat end of a link lies beyond its node, along the highway.
double flat_end(const Arm& link, const Arm& highway) {
  const Point along = position_at(highway.line, 0).direction;
  const Point aside = left_normal(position_at(link.line, 0).direction) * link.half_start;
  return std::abs(dot(aside, along)) + margin;
}

}  // namespace

void find_ramps(Layout& layout, const RampRules& rules) {
  if (rules.axes.empty()) return;
  Finder(layout, rules).run();
}

RampCorner ramp_corner(const Layout& layout, const Junction& junction, std::size_t gap) {
  if (junction.ramp < 0) return RampCorner::none;
  const Ramp& ramp = layout.streets.ramps[junction.ramp];
  const int a = junction.ends[gap].edge, b = junction.next(gap).edge;
  if (a != ramp.link && b != ramp.link) return RampCorner::none;
  const bool merging = a == ramp.merging_edge() || b == ramp.merging_edge();
  return merging ? RampCorner::outer : RampCorner::nose;
}

double room_on_link(const Layout& layout, const Ramp& ramp, double far_limit) {
  const Edge& link = layout.streets.network.edges[ramp.link];
  const double total = length(layout.arm({ramp.link, ramp.link_at_start}).line);
  const Junction& other = layout.junctions[ramp.link_at_start ? link.to_node : link.from_node];
  const bool shared = other.ramp >= 0 && layout.streets.ramps[other.ramp].link == ramp.link;
  return (shared ? std::min(total / 2, total - far_limit) : total - far_limit) - least_link;
}

std::optional<CornerArc> outer_kerb(const Layout& layout, const Junction& junction, std::size_t gap,
                                    double nose_limit, double room) {
  const Ramp& ramp = layout.streets.ramps[junction.ramp];
  const EdgeEnd &a = junction.ends[gap], &b = junction.next(gap);
  const Arm &arm_a = layout.arm(a), &arm_b = layout.arm(b);
  const Bend bend = bend_of(layout, ramp, nose_limit);
  const double most = std::min(room, bend.beside + bend.tangent + tangent_step);
  const auto fits = [&](const std::optional<CornerArc>& arc) {
    if (!arc) return false;
    const double on_link = a.edge == ramp.link ? arc->abscissa_a : arc->abscissa_b;
    return on_link > 0 && on_link < most;
  };
  double radius = bend.radius - layout.arm({ramp.link, ramp.link_at_start}).half_start;
  for (int i = 0; i < tries && radius > 0; ++i, radius /= 2) {
    const auto arc = corner_behind(arm_a, arm_b, radius);
    if (fits(arc)) return arc;
  }
  const auto sharp = corner_behind(arm_a, arm_b, 0);
  return fits(sharp) ? sharp : std::nullopt;
}

void extend_limits(Layout& layout) {
  std::vector<std::pair<EdgeEnd, double>> limits;
  for (Ramp& ramp : layout.streets.ramps) {
    const EdgeEnd link{ramp.link, ramp.link_at_start};
    const EdgeEnd highway{ramp.merging_edge(), ramp.merging_at_start()};
    const EdgeEnd far{ramp.link, !ramp.link_at_start};
    const double room = room_on_link(layout, ramp, layout.arm(far).limit);
    const Bend bend = bend_of(layout, ramp, layout.arm(link).limit);
    ramp.short_link = !bend.parts || bend.beside + ramp.tangent > room;
    limits.push_back({link, std::min(bend.beside + bend.tangent, room)});
    limits.push_back({highway, std::min(std::max(bend.tangent - bend.beside,
                                                 flat_end(layout.arm(link), layout.arm(highway))),
                                        length(layout.arm(highway).line) * most_of_highway)});
  }
  for (const auto& [end, limit] : limits) {
    Arm& arm = layout.arm(end);
    arm.limit = std::max(arm.limit, limit);
  }
}

}  // namespace streetgen
