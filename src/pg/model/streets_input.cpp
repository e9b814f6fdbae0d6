#include "model/streets_input.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "frame/argument.hpp"
#include "model/model_settings.hpp"
#include "value/control_rows.hpp"
#include "value/lane_text.hpp"
#include "value/wkb.hpp"

namespace streetgen::pg {

namespace {

ReadLine line_of(std::string_view wkb, const std::string& what, int srid) {
  const ReadLine read = read_line(wkb, what);
  if (read.srid != srid)
    throw Error(ErrorKind::invalid_input, what + " has SRID " + std::to_string(read.srid) +
                                              ", expected " + std::to_string(srid));
  return read;
}

bool is_start(Datum which, const char* of) {
  return word_of<bool>(text_of(which), of, {{"start", true}, {"end", false}});
}

std::string text_or_empty(const Column& column, int row) {
  return column.nulls[row] ? "" : text_of(column.values[row]);
}

// Its own transitions, by axis and whether at the axis' start.
std::map<std::pair<std::int64_t, bool>, Transition> transitions_of(const StreetsCall& call) {
  std::map<std::pair<std::int64_t, bool>, Transition> transitions;
  const auto& rows = call.transitions;
  for (int i = 0; i < rows.count; ++i) {
    const std::int64_t axis_id = DatumGetInt64(rows.axis_id.values[i]);
    const bool start = is_start(rows.which.values[i], "transition end");
    Transition& own = transitions[{axis_id, start}];
    own = {transition_kind_of(text_of(rows.kind.values[i]))};
    if (!rows.length.nulls[i])
      own.length = in_range(DatumGetFloat8(rows.length.values[i]), 0, 1000,
                            "transition length of axis " + std::to_string(axis_id));
  }
  return transitions;
}

std::vector<StreetAxis> axes_of(const StreetsCall& call, bool* has_z) {
  std::vector<StreetAxis> axes;
  std::unordered_set<std::int64_t> seen;
  const auto transitions = transitions_of(call);
  const auto own = [&](std::int64_t axis_id, bool at_start) {
    const auto found = transitions.find({axis_id, at_start});
    return found == transitions.end() ? std::nullopt : std::optional(found->second);
  };
  const auto& rows = call.axes;
  for (int i = 0; i < rows.count; ++i) {
    StreetAxis axis;
    axis.axis_id = DatumGetInt64(rows.axis_id.values[i]);
    const std::string of_axis = " of axis " + std::to_string(axis.axis_id);
    if (!seen.insert(axis.axis_id).second)
      throw Error(ErrorKind::invalid_input,
                  "axis " + std::to_string(axis.axis_id) + " stands more than once in the list");
    const ReadLine read =
        line_of(bytes_of(rows.geom.values[i]), "the geometry" + of_axis, call.srid);
    *has_z = *has_z || read.has_z;
    axis.line = read.line;
    const auto measure = [&](const Column& column, double low, double high, const char* name) {
      return in_range(DatumGetFloat8(column.values[i]), low, high, name + of_axis);
    };
    axis.width = measure(rows.width, 1e-3, 200, "width");
    axis.width_end = measure(rows.width_end, 1e-3, 200, "width_end");
    const double farthest = std::min(axis.width, axis.width_end) / 2;
    axis.roadway_offset = measure(rows.roadway_offset, -farthest, farthest, "roadway_offset");
    axis.radius = measure(rows.radius, 0, 1000, "radius");
    axis.importance = DatumGetInt32(rows.importance.values[i]);
    axis.level = DatumGetInt32(rows.level.values[i]);
    axis.speed = measure(rows.speed, 0, 1000, "speed");
    const auto leads = [&](const Column& lanes) {
      return DatumGetInt32(lanes.values[i]) + DatumGetInt32(rows.lanes_both.values[i]) > 0;
    };
    axis.leads_forward = leads(rows.lanes_forward);
    axis.leads_backward = leads(rows.lanes_backward);
    axis.on_ring = DatumGetBool(rows.on_ring.values[i]);
    axis.street = DatumGetInt64(rows.street.values[i]);
    axis.changed = DatumGetBool(rows.changed.values[i]);
    axis.outer = DatumGetBool(rows.outer_axis.values[i]);
    if (!rows.area.nulls[i])
      axis.area = read_surface(bytes_of(rows.area.values[i]), "the area" + of_axis);
    axis.transition_start = own(axis.axis_id, true);
    axis.transition_end = own(axis.axis_id, false);
    axes.push_back(std::move(axis));
  }
  return axes;
}

// What general lanes of an axis are, by who may drive there: "bus", or "bus|no" along and against.
struct Access {
  LaneKind forward = LaneKind::general, backward = LaneKind::general;
};

Access access_of(const std::string& text) {
  const std::size_t mark = text.find('|');
  if (mark == std::string::npos) return {lanes_for(text), lanes_for(text)};
  return {lanes_for(text.substr(0, mark)), lanes_for(text.substr(mark + 1))};
}

// Two who meet on the one lane of a street use all of the roadway.
void bound_lanes(double widest, AxisLanes& lanes) {
  if (lanes.forward.size() + lanes.backward.size() == 0 && lanes.both_ways.size() == 1) return;
  for (std::vector<LaneWish>* some : {&lanes.forward, &lanes.backward, &lanes.both_ways})
    for (LaneWish& lane : *some) lane.widest = widest;
}

// Where the model looks for rings itself, it says what yields to them.
std::vector<LanesOfAxis> lanes_of(const StreetsCall& call, const Settings& given,
                                  bool looks_for_rings) {
  const KindWidths defaults{given.measure("cycle_lane_width"), given.measure("parking_lane_width")};
  std::vector<LanesOfAxis> axes;
  const auto& rows = call.axes;
  for (int i = 0; i < rows.count; ++i) {
    const std::int64_t axis_id = DatumGetInt64(rows.axis_id.values[i]);
    const std::string of_axis = " of axis " + std::to_string(axis_id);
    const auto counted = [&](const Column& count) {
      return static_cast<int>(in_range(DatumGetInt32(count.values[i]), 0, 100, "lanes" + of_axis));
    };
    const Access access = access_of(text_or_empty(rows.access, i));
    const auto read = [&](const Column& count, const Column& kinds, const Column& widths,
                          const Column& turns, LaneKind general_as) {
      return read_lanes(counted(count), text_or_empty(kinds, i), text_or_empty(widths, i),
                        text_or_empty(turns, i), defaults, of_axis, general_as);
    };
    std::vector<LaneWish> both(counted(rows.lanes_both));
    for (LaneWish& lane : both)
      if (access.forward == access.backward) lane.kind = access.forward;
    AxisLanes lanes{read(rows.lanes_forward, rows.kind_forward, rows.lane_width_forward,
                         rows.turn_forward, access.forward),
                    read(rows.lanes_backward, rows.kind_backward, rows.lane_width_backward,
                         rows.turn_backward, access.backward),
                    std::move(both)};
    if (!rows.lane_width_maximal.nulls[i])
      bound_lanes(in_range(DatumGetFloat8(rows.lane_width_maximal.values[i]), 0.01, 1000,
                           "lane_width_maximal" + of_axis),
                  lanes);
    axes.push_back(
        {axis_id, std::move(lanes), !looks_for_rings && DatumGetBool(rows.on_ring.values[i])});
  }
  return axes;
}

Point place_of(const Column& x, const Column& y, int row, const std::string& of) {
  return {finite(DatumGetFloat8(x.values[row]), "x of " + of),
          finite(DatumGetFloat8(y.values[row]), "y of " + of), 0};
}

StreetOverrides street_overrides_of(const StreetsCall& call) {
  StreetOverrides overrides;
  const auto& limits = call.limits;
  for (int i = 0; i < limits.count; ++i)
    overrides.limits.push_back(
        {DatumGetInt64(limits.axis_id.values[i]),
         finite(DatumGetFloat8(limits.abscissa.values[i]), "abscissa of a section limit override"),
         is_start(limits.which.values[i], "end of a section limit override")});
  const auto& corners = call.corners;
  for (int i = 0; i < corners.count; ++i)
    overrides.corners.push_back({place_of(corners.x, corners.y, i, "a corner override"),
                                 DatumGetInt64(corners.axis_a.values[i]),
                                 DatumGetInt64(corners.axis_b.values[i]),
                                 in_range(DatumGetFloat8(corners.radius.values[i]), 0, 1000,
                                          "radius of a corner override")});
  const auto& bends = call.bends;
  for (int i = 0; i < bends.count; ++i)
    overrides.bends.push_back(
        {DatumGetInt64(bends.axis_id.values[i]),
         finite(DatumGetFloat8(bends.abscissa.values[i]), "abscissa of a road override"),
         in_range(DatumGetFloat8(bends.radius.values[i]), 0, 1e6, "radius of a road override")});
  return overrides;
}

std::vector<LaneOverride> lane_overrides_of(const StreetsCall& call) {
  using Direction = LaneOverride::Direction;
  std::vector<LaneOverride> overrides;
  const auto& rows = call.lanes;
  for (int i = 0; i < rows.count; ++i) {
    LaneOverride put;
    put.axis_id = DatumGetInt64(rows.axis_id.values[i]);
    put.abscissa = DatumGetFloat8(rows.abscissa.values[i]);
    put.ordinality = DatumGetInt32(rows.ordinality.values[i]);
    if (!rows.both_ways.nulls[i] && DatumGetBool(rows.both_ways.values[i]))
      put.direction = Direction::both;
    else if (!rows.along_axis.nulls[i])
      put.direction =
          DatumGetBool(rows.along_axis.values[i]) ? Direction::along : Direction::against;
    if (!rows.width.nulls[i])
      put.width =
          in_range(DatumGetFloat8(rows.width.values[i]), 0, 200, "width of a lane override");
    if (!rows.line.nulls[i])
      put.line =
          line_of(bytes_of(rows.line.values[i]),
                  "the line of a lane override of axis " + std::to_string(put.axis_id), call.srid)
              .line;
    overrides.push_back(std::move(put));
  }
  return overrides;
}

std::vector<Circulation> circulations_of(const StreetsCall& call) {
  std::vector<Circulation> circulations;
  const auto& rows = call.circulations;
  for (int i = 0; i < rows.count; ++i)
    circulations.push_back(
        {DatumGetInt64(rows.axis_id.values[i]),
         finite(DatumGetFloat8(rows.abscissa.values[i]), "abscissa of a circulation"),
         DatumGetBool(rows.along_axis.values[i]), DatumGetBool(rows.turned.values[i])});
  return circulations;
}

std::vector<TurnRestriction> restrictions_of(const StreetsCall& call) {
  std::vector<TurnRestriction> restrictions;
  const auto& rows = call.restrictions;
  for (int i = 0; i < rows.count; ++i) {
    TurnRestriction restriction;
    restriction.from_axis = DatumGetInt64(rows.from_axis.values[i]);
    restriction.to_axis = DatumGetInt64(rows.to_axis.values[i]);
    restriction.via = place_of(rows.x, rows.y, i, "a turn restriction");
    restriction.only = word_of<bool>(text_of(rows.kind.values[i]), "kind of a turn restriction",
                                     {{"no", false}, {"only", true}});
    if (!rows.turn.nulls[i]) restriction.turn = read_turn(text_of(rows.turn.values[i]));
    restriction.except =
        read_kinds(text_or_empty(rows.except_kinds, i), "exception of a turn restriction");
    restrictions.push_back(restriction);
  }
  return restrictions;
}

std::vector<OverpassOverride> overpass_overrides_of(const StreetsCall& call) {
  std::vector<OverpassOverride> overrides;
  const auto& rows = call.overpasses;
  for (int i = 0; i < rows.count; ++i) {
    OverpassOverride put{place_of(rows.x, rows.y, i, "an overpass override"),
                         DatumGetInt64(rows.axis_above.values[i]),
                         DatumGetInt64(rows.axis_below.values[i])};
    if (!rows.clearance.nulls[i])
      put.clearance =
          in_range(DatumGetFloat8(rows.clearance.values[i]), 0, 100, "clearance of an override");
    overrides.push_back(put);
  }
  return overrides;
}

RampRules ramps_of(const StreetsCall& call, const Settings& given) {
  RampRules rules;
  const auto& axes = call.ramp_axes;
  for (int i = 0; i < axes.count; ++i) {
    RampAxis axis;
    axis.axis_id = DatumGetInt64(axes.axis_id.values[i]);
    axis.part = word_of<RampPart>(text_of(axes.part.values[i]), "part of a ramp",
                                  {{"highway", RampPart::highway},
                                   {"link", RampPart::link},
                                   {"unclassed", RampPart::unclassed}});
    axis.counted = DatumGetBool(axes.counted.values[i]);
    rules.axes.push_back(axis);
  }
  const auto& rows = call.ramps;
  for (int i = 0; i < rows.count; ++i) {
    RampOverride put{
        DatumGetInt64(rows.axis_id.values[i]),
        finite(DatumGetFloat8(rows.abscissa.values[i]), "abscissa of a ramp override")};
    const auto measure = [&](const Column& column, const char* of) -> std::optional<double> {
      if (column.nulls[i]) return std::nullopt;
      return in_range(DatumGetFloat8(column.values[i]), 0, 1000, of);
    };
    put.tangent = measure(rows.tangent, "tangent of a ramp override");
    put.length = measure(rows.length, "length of a ramp override");
    rules.overrides.push_back(put);
  }
  rules.tangent = given.measure("ramp_tangent");
  rules.merging_length = given.measure("merging_length");
  return rules;
}

FormerSurface former_surface(const Column& surface, const Column& contested, const Column& level,
                             int row) {
  return {read_surface(bytes_of(surface.values[row]), "a former surface"),
          DatumGetBool(contested.values[row]), DatumGetInt32(level.values[row])};
}

// Numbers as float8send writes them, each eight bytes from the highest on.
std::vector<double> numbers_of(std::string_view bytes) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < 8; ++i)
      bits = bits << 8 | static_cast<unsigned char>(bytes[at + i]);
    double number = 0;
    std::memcpy(&number, &bits, sizeof number);
    numbers.push_back(number);
  }
  return numbers;
}

WidthProfile borders_of(std::string_view bytes) {
  const std::vector<double> numbers = numbers_of(bytes);
  WidthProfile borders;
  for (std::size_t i = 0; i + 3 <= numbers.size(); i += 3)
    borders.places.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  return borders;
}

Beside beside_of(const std::string& word) {
  for (const Beside beside : {Beside::median, Beside::splitter, Beside::island})
    if (word == beside_name(beside)) return beside;
  return Beside::outer;
}

Former former_of(const StreetsCall& call) {
  Former former;
  const auto& edges = call.former_edges;
  for (int i = 0; i < edges.count; ++i) {
    const auto limit = [&](const Column& wanted, const Column& abscissa, const Column& border) {
      return FormerLimit{DatumGetFloat8(wanted.values[i]), DatumGetFloat8(abscissa.values[i]),
                         read_line(bytes_of(border.values[i]), "a former border line").line};
    };
    former.edges.push_back({DatumGetInt64(edges.axis_id.values[i]),
                            DatumGetFloat8(edges.start_abscissa.values[i]),
                            DatumGetFloat8(edges.end_abscissa.values[i]),
                            read_line(bytes_of(edges.geom.values[i]), "a former edge").line,
                            limit(edges.wanted_start, edges.start, edges.border_start),
                            limit(edges.wanted_end, edges.end, edges.border_end),
                            former_surface(edges.surface, edges.contested, edges.level, i),
                            borders_of(bytes_of(edges.borders.values[i])),
                            beside_of(text_of(edges.beside_left.values[i])),
                            beside_of(text_of(edges.beside_right.values[i])),
                            numbers_of(bytes_of(edges.median_left.values[i])),
                            numbers_of(bytes_of(edges.median_right.values[i]))});
  }
  const auto& nodes = call.former_nodes;
  for (int i = 0; i < nodes.count; ++i)
    former.nodes.push_back({place_of(nodes.x, nodes.y, i, "a former node"),
                            former_surface(nodes.surface, nodes.contested, nodes.level, i)});
  const auto& neighbours = call.neighbours;
  if (neighbours.known) former.neighbours.emplace();
  for (int i = 0; i < neighbours.count; ++i) {
    Neighbour neighbour;
    neighbour.nodes.push_back(place_of(neighbours.x, neighbours.y, i, "a neighbour"));
    if (!neighbours.x_end.nulls[i] && !neighbours.y_end.nulls[i])
      neighbour.nodes.push_back(place_of(neighbours.x_end, neighbours.y_end, i, "a neighbour"));
    neighbour.ground = read_surface(bytes_of(neighbours.surface.values[i]), "a neighbour");
    neighbour.level = DatumGetInt32(neighbours.level.values[i]);
    former.neighbours->push_back(std::move(neighbour));
  }
  former.may_spread = call.may_spread;
  return former;
}

void give_controls(const std::vector<ControlPoint>& controls, std::vector<StreetAxis>& axes) {
  std::unordered_map<std::int64_t, StreetAxis*> by_id;
  for (StreetAxis& axis : axes) by_id.emplace(axis.axis_id, &axis);
  for (const ControlPoint& control : controls)
    if (const auto found = by_id.find(control.axis_id); found != by_id.end())
      found->second->controls.push_back(control);
}

}  // namespace

StreetsInput read_input(const StreetsCall& call) {
  const Settings settings(call);
  StreetsInput input;
  input.srid = call.srid;
  input.model.subjects = {call.subjects.words, call.subjects.words + call.subjects.count};
  input.model.axes = axes_of(call, &input.has_z);
  input.model.settings = street_settings_of(settings);
  input.model.former = former_of(call);
  input.model.lanes = lanes_of(call, settings, input.model.subjects.count("roundabout") > 0);
  input.model.overrides = street_overrides_of(call);
  for (int i = 0; i < call.marked_before.count; ++i)
    input.model.marked_before.insert(DatumGetInt64(call.marked_before.axis_id.values[i]));
  input.model.lane_overrides = lane_overrides_of(call);
  input.model.lane_settings = lane_settings_of(settings);
  input.model.controls = read_controls(call.controls);
  give_controls(input.model.controls, input.model.axes);
  input.model.paint = read_paint(call.paint);
  input.model.circulations = circulations_of(call);
  input.model.ramps = ramps_of(call, settings);
  input.model.restrictions = restrictions_of(call);
  input.model.interconnection_settings = interconnection_settings_of(settings);
  input.model.overpass_overrides = overpass_overrides_of(call);
  input.model.clearance = settings.measure("clearance", 0, 100);
  return input;
}

}  // namespace streetgen::pg
