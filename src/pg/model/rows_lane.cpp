// The rows of subject lane.
#include <utility>

#include "model/row_value.hpp"
#include "model/streets_give.hpp"
#include "value/lane_text.hpp"

namespace streetgen::pg {

namespace {

using Computed = const ComputedStreets&;

const char* separator_kind_name(SeparatorKind kind) {
  switch (kind) {
    case SeparatorKind::centre:
      return "centre";
    case SeparatorKind::same_direction:
      return "same_direction";
    case SeparatorKind::edge:
      return "edge";
  }
  return "";
}

const char* marking_kind_name(MarkingKind kind) {
  switch (kind) {
    case MarkingKind::stop:
      return "stop";
    case MarkingKind::yield:
      return "yield";
    case MarkingKind::arrow:
      return "arrow";
  }
  return "";
}

bool fill_lane(const ComputedStreets& computed, const Named& named, std::size_t i, Row& row) {
  const Lane& lane = computed.lanes.lanes[i];
  const std::int64_t edge = named.edges[lane.edge];
  if (edge == 0) return false;
  Value turn;
  if (lane.turns != 0) turn = turn_text(lane.turns);
  const Edge& of = computed.streets.network.edges[lane.edge];
  const auto along = [&](const std::optional<double>& place) {
    return place ? Value(of.start_abscissa + *place) : Value();
  };
  return put(row, edge, of.axis_id, lane.ordinality, lane.position, name(lane_side_name(lane.side)),
             lane.along_axis, lane.both_ways, name(lane_kind_name(lane.kind)), lane.width,
             lane.axis_offset, std::move(turn), Geometry{stored_line(lane.line, flat(computed))},
             Geometry{stored_surface(lane.surface, flat(computed))}, name(method_name(lane.method)),
             along(lane.start), along(lane.end), borders_value(lane.borders));
}

bool fill_lane_separator(const ComputedStreets& computed, const Named& named, std::size_t i,
                         Row& row) {
  const LaneSeparator& separator = computed.lanes.separators[i];
  const std::int64_t edge = named.edges[separator.edge];
  return edge > 0 &&
         put(row, edge, separator.position, name(separator_kind_name(separator.kind)),
             separator.dashed, separator.leftwards, separator.rightwards, separator.axis_offset,
             Geometry{stored_line(separator.line, flat(computed))},
             Geometry{stored_surface(paint_of(separator), flat(computed))});
}

bool fill_marking(const ComputedStreets& computed, const Named& named, std::size_t i, Row& row) {
  const Marking& marking = computed.lanes.markings[i];
  const std::int64_t edge = named.edges[marking.edge];
  return edge > 0 && put(row, edge, marking.position, marking.along_axis, named.nodes[marking.node],
                         name(marking_kind_name(marking.kind)),
                         Geometry{stored_line(marking.line, flat(computed))},
                         Geometry{stored_surface(marking.surface, flat(computed))});
}

const Table lane_table{[](Computed c) { return c.lanes.lanes.size(); }, fill_lane,
                       [](ComputedStreets& c) { release(c.lanes.lanes); }};
const Table lane_separator_table{[](Computed c) { return c.lanes.separators.size(); },
                                 fill_lane_separator,
                                 [](ComputedStreets& c) { release(c.lanes.separators); }};
const Table marking_table{[](Computed c) { return c.lanes.markings.size(); }, fill_marking,
                          [](ComputedStreets& c) { release(c.lanes.markings); }};

}  // namespace

STREETGEN_TABLE(lane, &Named::edges)
STREETGEN_TABLE(lane_separator, &Named::edges)
STREETGEN_TABLE(marking, &Named::nodes, &Named::edges)

}  // namespace streetgen::pg
