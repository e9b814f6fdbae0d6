#include "roadway/settle_limits.hpp"

#include <algorithm>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "roadway/node_corner.hpp"

namespace streetgen {

namespace {

constexpr double least_section = 1e-3;  // metres between two limits that did not cross

void settle_edge(Layout& layout, int e, const LimitsByHand& by_hand) {
  Arm &start = layout.arms[2 * e], &end = layout.arms[2 * e + 1];
  const auto &put_start = by_hand[2 * e], &put_end = by_hand[2 * e + 1];
  const double total = length(start.line);
  if (put_start) start.limit = *put_start;
  if (put_end) end.limit = *put_end;
  const double wanted_start = start.limit, wanted_end = end.limit;
  const bool crossed = start.limit + end.limit > total - least_section;
  const bool one_yields = crossed && put_start.has_value() != put_end.has_value();
  if (one_yields) {
    (put_start ? end : start).limit = total - (put_start ? start : end).limit;
  } else if (crossed) {
    const double sum = start.limit + end.limit;
    start.limit = sum > 0 ? total * start.limit / sum : total / 2;
    end.limit = total - start.limit;
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
  start.border = border_across(start, start.limit);
  end.border = crossed ? Line{start.border[1], start.border[0]} : border_across(end, end.limit);
  for (const bool at_start : {true, false}) {
    SectionLimit limit;
    limit.edge = e;
    limit.at_start = at_start;
    limit.wanted_abscissa = at_start ? wanted_start : total - wanted_end;
    limit.abscissa = at_start ? start.limit : total - end.limit;
    limit.point = position_at(layout.streets.network.edges[e].line, limit.abscissa).point;
    const bool put = (at_start ? put_start : put_end).has_value();
    limit.method = crossed && !(one_yields && put) ? Method::crossed_limits
                   : put                           ? Method::by_hand
                                                   : Method::hypothesis;
    layout.streets.limits.push_back(limit);
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
  layout.streets.limits.reserve(layout.arms.size());
  for (int e = 0; e < static_cast<int>(layout.axes.size()); ++e) settle_edge(layout, e, by_hand);
  join_borders(layout);
  for (SectionLimit& limit : layout.streets.limits) {
    const Line& border = layout.arm({limit.edge, limit.at_start}).border;
    limit.border_line = limit.at_start ? border : Line{border[1], border[0]};
  }
}

}  // namespace streetgen
