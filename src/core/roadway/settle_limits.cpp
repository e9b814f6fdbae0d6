#include "roadway/settle_limits.hpp"

#include <algorithm>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "layout/node_corner.hpp"
#include "ramp/merging_lanes.hpp"
#include "roadway/near_limits.hpp"
#include "roadway/section_taper.hpp"

namespace streetgen {

namespace {

constexpr double least_section = 1e-3;  // metres between two limits that did not cross
constexpr double most_askew = 1;        // metres along the street, for each of half its width
constexpr double most_of_room = 0.9;    // of the room before a limit, that its border line takes
constexpr double least_share = 0.1;  // of a kerb: a corner that asks for less asks for none of it

// A limit by hand parts the edges of a straight junction again.
void part_by_hand(Layout& layout, const LimitsByHand& by_hand) {
  for (Junction& junction : layout.junctions)
    for (const EdgeEnd& end : junction.ends)
      if (by_hand[slot(end)]) junction.straight = false;
}

// Across the mean direction of both edges of a straight junction, else across the arm's own.
Line border_of(const Layout& layout, int e, bool at_start) {
  const Arm& arm = layout.arm({e, at_start});
  const Edge& edge = layout.streets.network.edges[e];
  const Junction& junction = layout.junctions[at_start ? edge.from_node : edge.to_node];
  if (arm.askew != 0)
    return {border_across(arm, arm.limit_on(+1))[0], border_across(arm, arm.limit_on(-1))[1]};
  if (!junction.straight || arm.limit > 0) return border_across(arm, arm.limit);
  const EdgeEnd& first = junction.ends[0];
  const Arm &a = layout.arm(first), &b = layout.arm(junction.ends[1]);
  const Point along = unit(unit(a.line[1] - a.line[0]) - unit(b.line[1] - b.line[0]));
  const Point node = planar(a.line.front()), across = left_normal(along);
  const Point left = node + across * a.start_to(+1), right = node - across * a.start_to(-1);
  const bool is_first = slot(first) == slot({e, at_start});
  return is_first ? Line{left, right} : Line{right, left};
}

void settle_borders(Layout& layout, int e, bool crossed) {
  Arm &start = layout.arms[2 * e], &end = layout.arms[2 * e + 1];
  start.border = border_of(layout, e, true);
  end.border = border_of(layout, e, false);
  // Limits that cross meet in one border line, that of a straight junction where one lies there.
  if (crossed && end.limit > 0)
    end.border = {start.border[1], start.border[0]};
  else if (crossed)
    start.border = {end.border[1], end.border[0]};
}

// Where limits cross between two streets that come from opposite sides, each kerb is asked for by
// the corner of one of them alone: the border line lies askew, and leaves both room to turn.  As
// much as the street is wide is enough.
double askew_between(const Arm& start, const Arm& end) {
  const auto alone = [](double own, double other) { return own > 0 && other <= least_share * own; };
  const bool to_left =
      alone(start.asked_left, end.asked_right) && alone(end.asked_left, start.asked_right);
  const bool to_right =
      alone(start.asked_right, end.asked_left) && alone(end.asked_right, start.asked_left);
  if (to_left == to_right) return 0;
  const auto short_of = [&](const Arm& arm) {
    return std::max(arm.asked_left, arm.asked_right) - arm.limit;
  };
  const double half = std::min(half_at(start, start.limit, +1), half_at(start, start.limit, -1));
  const double room = std::min(start.limit, end.limit), enough = 2 * half;
  const double most = std::max(0.0, std::min({most_askew * half, most_of_room * room, enough - room,
                                              std::max(short_of(start), short_of(end))}));
  return to_left ? most : -most;
}

void settle_edge(Layout& layout, int e, const LimitsByHand& by_hand) {
  Arm &start = layout.arms[2 * e], &end = layout.arms[2 * e + 1];
  const auto &put_start = by_hand[2 * e], &put_end = by_hand[2 * e + 1];
  const double total = length(start.line);
  if (put_start) start.limit = *put_start;
  if (put_end) end.limit = *put_end;
  const double wanted_start = start.limit, wanted_end = end.limit;
  start.askew = end.askew = 0;
  const bool crossed = start.limit + end.limit > total - least_section;
  const bool one_yields = crossed && put_start.has_value() != put_end.has_value();
  if (one_yields) {
    (put_start ? end : start).limit = total - (put_start ? start : end).limit;
  } else if (crossed) {
    const double sum = start.limit + end.limit;
    start.limit = sum > 0 ? total * (start.limit / sum) : total / 2;  // exact where one is 0
    end.limit = total - start.limit;
    if (!put_start && !put_end) start.askew = end.askew = askew_between(start, end);
  } else {
    const auto clear = [](const Arm& arm, bool put) {
      return put || arm.limit <= 0 ? arm.limit : kerb_clear_limit(arm, arm.limit);
    };
    const double clear_start = clear(start, put_start.has_value());
    const double clear_end = clear(end, put_end.has_value());
    if (clear_start + clear_end < total - least_section) {
      start.limit = clear_start;
      end.limit = clear_end;
    }
  }
  settle_borders(layout, e, crossed);
  for (const bool at_start : {true, false}) {
    SectionLimit limit;
    limit.edge = e;
    limit.at_start = at_start;
    limit.wanted_abscissa = at_start ? wanted_start : total - wanted_end;
    limit.abscissa = at_start ? start.limit : total - end.limit;
    limit.askew = start.askew;
    limit.point = position_at(layout.streets.network.edges[e].line, limit.abscissa).point;
    const bool put = (at_start ? put_start : put_end).has_value();
    limit.method = crossed && !(one_yields && put) ? Method::crossed_limits
                   : put                           ? Method::by_hand
                                                   : Method::hypothesis;
    layout.streets.limits[slot({e, at_start})] = limit;
  }
}

// Border lines of neighbours that end on one kerb point end on the same.
void join_borders(Layout& layout) {
  for (const Junction& junction : layout.junctions)
    for (std::size_t i = 0; i < junction.ends.size(); ++i) {
      const EdgeEnd& next = junction.next(i);
      const Point& kerb = layout.arm(junction.ends[i]).border[0];
      Point& end = layout.arm(next).border[1];
      if (distance(kerb, end) > same_place) continue;
      end = kerb;
      if (limits_crossed(layout.streets, next.edge))
        layout.arm({next.edge, !next.at_start}).border[0] = kerb;
    }
}

}  // namespace

void settle_limits(Layout& layout, const LimitsByHand& by_hand) {
  layout.streets.limits.resize(layout.arms.size());
  std::vector<double> wanted;
  for (const Arm& arm : layout.arms) wanted.push_back(arm.limit);
  part_by_hand(layout, by_hand);
  for (int e = 0; e < static_cast<int>(layout.axes.size()); ++e) settle_edge(layout, e, by_hand);
  for (std::vector<bool> settled(layout.axes.size(), true);;) {
    const std::vector<int> moved = part_sections(layout, settled, wanted);
    if (moved.empty()) break;
    settled.assign(layout.axes.size(), false);
    for (const int e : moved) {
      for (const bool at_start : {true, false})
        layout.arm({e, at_start}).limit = wanted[slot({e, at_start})];
      settle_edge(layout, e, by_hand);
      settled[e] = true;
    }
  }
  settle_merging_lanes(layout);
  for (const MergingRun& run : layout.merging_runs)
    for (const EdgeEnd& end : run.edges)
      settle_borders(layout, end.edge, limits_crossed(layout.streets, end.edge));
  end_borders_on_partings(layout);
  taper_sections(layout);
  join_borders(layout);
  for (SectionLimit& limit : layout.streets.limits) {
    const Line& border = layout.arm({limit.edge, limit.at_start}).border;
    limit.border_line = limit.at_start ? border : Line{border[1], border[0]};
  }
}

}  // namespace streetgen
