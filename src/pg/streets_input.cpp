#include "streets_input.hpp"

#include <map>
#include <string>
#include <unordered_set>
#include <utility>

#include "argument.hpp"
#include "lane_text.hpp"
#include "wkb.hpp"

namespace streetgen::pg {

namespace {

ReadLine line_of(std::string_view wkb, const std::string& what, int srid) {
  const ReadLine read = read_line(wkb, what);
  if (read.srid != srid)
    throw Error(ErrorKind::invalid_input, what + " has SRID " + std::to_string(read.srid) +
                                              ", expected " + std::to_string(srid));
  return read;
}

TransitionKind transition_kind_of(const char* word) {
  return word_of<TransitionKind>(word, "transition_kind",
                                 {{"symmetric", TransitionKind::symmetric},
                                  {"left", TransitionKind::left},
                                  {"right", TransitionKind::right}});
}

bool is_start(Datum which, const char* of) {
  return word_of<bool>(text_of(which), of, {{"start", true}, {"end", false}});
}

// Its own transitions, by axis and whether at the axis' start.
std::map<std::pair<std::int64_t, bool>, Transition> transitions_of(const StreetsCall& call) {
  std::map<std::pair<std::int64_t, bool>, Transition> transitions;
  for (int i = 0; i < call.transition_count; ++i) {
    const std::int64_t axis_id = DatumGetInt64(call.transition_axis[i]);
    const bool start = is_start(call.transition_which[i], "transition end");
    const double length = in_range(DatumGetFloat8(call.transition_length_of[i]), 0, 1000,
                                   "transition length of axis " + std::to_string(axis_id));
    transitions[{axis_id, start}] = {
        transition_kind_of(text_of(call.transition_kind_of[i]).c_str()), length};
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
  for (int i = 0; i < call.count; ++i) {
    StreetAxis axis;
    axis.axis_id = DatumGetInt64(call.axis_id[i]);
    const std::string of_axis = " of axis " + std::to_string(axis.axis_id);
    if (!seen.insert(axis.axis_id).second)
      throw Error(ErrorKind::invalid_input,
                  "axis " + std::to_string(axis.axis_id) + " stands more than once in the list");
    const ReadLine read = line_of(bytes_of(call.geom[i]), "the geometry" + of_axis, call.srid);
    *has_z = *has_z || read.has_z;
    axis.line = read.line;
    axis.width = in_range(DatumGetFloat8(call.width[i]), 1e-3, 200, "width" + of_axis);
    axis.width_end = in_range(DatumGetFloat8(call.width_end[i]), 1e-3, 200, "width_end" + of_axis);
    axis.radius = in_range(DatumGetFloat8(call.radius[i]), 0, 1000, "radius" + of_axis);
    axis.importance = DatumGetInt32(call.importance[i]);
    axis.level = DatumGetInt32(call.level[i]);
    axis.speed = in_range(DatumGetFloat8(call.speed[i]), 0, 1000, "speed" + of_axis);
    axis.changed = DatumGetBool(call.changed[i]);
    axis.beside = DatumGetBool(call.beside[i]);
    axis.outer = DatumGetBool(call.outer[i]);
    axis.transition_start = own(axis.axis_id, true);
    axis.transition_end = own(axis.axis_id, false);
    axes.push_back(std::move(axis));
  }
  return axes;
}

// streetgen._default_setting() has the range of each; here stands what the core can bear.
StreetSettings settings_of(const StreetsCall& call) {
  const auto measure = [](double value, const std::string& name, double low = 0) {
    return in_range(value, low, 1000, "setting " + name);
  };
  StreetSettings settings;
  settings.tolerance = measure(call.tolerance, "tolerance", 1e-6);
  settings.crossing = word_of<Crossing>(call.crossing, "crossing",
                                        {{"over", Crossing::over}, {"split", Crossing::split}});
  settings.max_arc_distance = measure(call.max_arc_distance, "max_arc_distance");
  settings.radius_minimal = measure(call.radius_minimal, "radius_minimal");
  settings.transition = {transition_kind_of(call.transition_kind),
                         measure(call.transition_length, "transition_length")};
  settings.radius_rule = word_of<RadiusRule>(
      call.radius_rule, "radius_rule",
      {{"min", RadiusRule::min}, {"max", RadiusRule::max}, {"mean", RadiusRule::mean}});
  settings.round_dead_ends = call.round_dead_ends;
  settings.max_hole_area = measure(call.max_hole_area, "max_hole_area");
  settings.reach = measure(call.reach, "reach");
  settings.short_axis =
      word_of<ShortAxis>(call.short_axis, "short_axis",
                         {{"reduce", ShortAxis::reduce}, {"follow", ShortAxis::follow}});
  return settings;
}

std::vector<LanesOfAxis> lanes_of(const StreetsCall& call) {
  const KindWidths defaults{
      in_range(call.cycle_lane_width, 0, 1000, "setting cycle_lane_width"),
      in_range(call.parking_lane_width, 0, 1000, "setting parking_lane_width")};
  std::vector<LanesOfAxis> axes;
  for (int i = 0; i < call.count; ++i) {
    const std::int64_t axis_id = DatumGetInt64(call.axis_id[i]);
    const std::string of_axis = " of axis " + std::to_string(axis_id);
    const auto read = [&](Datum* count, Datum* kinds, Datum* widths, Datum* turns) {
      const int lanes =
          static_cast<int>(in_range(DatumGetInt32(count[i]), 0, 100, "lanes" + of_axis));
      return read_lanes(lanes, text_of(kinds[i]), text_of(widths[i]), text_of(turns[i]), defaults,
                        of_axis);
    };
    axes.push_back(
        {axis_id,
         {read(call.lanes_forward, call.kind_forward, call.lane_width_forward, call.turn_forward),
          read(call.lanes_backward, call.kind_backward, call.lane_width_backward,
               call.turn_backward)}});
  }
  return axes;
}

StreetOverrides street_overrides_of(const StreetsCall& call) {
  StreetOverrides overrides;
  for (int i = 0; i < call.limit_count; ++i)
    overrides.limits.push_back(
        {DatumGetInt64(call.limit_axis[i]),
         finite(DatumGetFloat8(call.limit_abscissa[i]), "abscissa of a section limit override"),
         is_start(call.limit_which[i], "end of a section limit override")});
  for (int i = 0; i < call.corner_count; ++i)
    overrides.corners.push_back(
        {{finite(DatumGetFloat8(call.corner_x[i]), "x of a corner override"),
          finite(DatumGetFloat8(call.corner_y[i]), "y of a corner override"), 0},
         DatumGetInt64(call.corner_a[i]),
         DatumGetInt64(call.corner_b[i]),
         in_range(DatumGetFloat8(call.corner_radius[i]), 0, 1000, "radius of a corner override")});
  return overrides;
}

std::vector<LaneOverride> lane_overrides_of(const StreetsCall& call) {
  using Direction = LaneOverride::Direction;
  std::vector<LaneOverride> overrides;
  for (int i = 0; i < call.override_count; ++i) {
    LaneOverride put{
        DatumGetInt64(call.override_axis[i]), DatumGetFloat8(call.override_abscissa[i]),
        DatumGetInt32(call.override_ordinality[i]),
        word_of<Direction>(text_of(call.override_direction[i]), "direction of a lane override",
                           {{"as_is", Direction::as_is},
                            {"along", Direction::along},
                            {"against", Direction::against}}),
        in_range(DatumGetFloat8(call.override_width[i]), 0, 200, "width of a lane override")};
    const std::string_view line = bytes_of(call.override_line[i]);
    if (!line.empty())
      put.line = line_of(line, "the line of a lane override of axis " + std::to_string(put.axis_id),
                         call.srid)
                     .line;
    overrides.push_back(std::move(put));
  }
  return overrides;
}

LaneSettings lane_settings_of(const StreetsCall& call) {
  LaneSettings settings =
      read_lane_settings(call.lane_order, call.driving_side, call.lane_width_minimal);
  settings.edge_lines = call.edge_lines;
  return settings;
}

std::vector<TurnRestriction> restrictions_of(const StreetsCall& call) {
  std::vector<TurnRestriction> restrictions;
  for (int i = 0; i < call.restriction_count; ++i) {
    TurnRestriction restriction;
    restriction.from_axis = DatumGetInt64(call.restriction_from[i]);
    restriction.to_axis = DatumGetInt64(call.restriction_to[i]);
    restriction.via = {finite(DatumGetFloat8(call.restriction_x[i]), "x of a turn restriction"),
                       finite(DatumGetFloat8(call.restriction_y[i]), "y of a turn restriction"), 0};
    restriction.only = word_of<bool>(text_of(call.restriction_kind[i]),
                                     "kind of a turn restriction", {{"no", false}, {"only", true}});
    using OfTurn = std::optional<Turn>;
    restriction.turn =
        word_of<OfTurn>(text_of(call.restriction_turn[i]), "turn of a turn restriction",
                        {{"", OfTurn()},
                         {turn_name(Turn::through), OfTurn(Turn::through)},
                         {turn_name(Turn::left), OfTurn(Turn::left)},
                         {turn_name(Turn::right), OfTurn(Turn::right)},
                         {turn_name(Turn::u_turn), OfTurn(Turn::u_turn)}});
    restrictions.push_back(restriction);
  }
  return restrictions;
}

InterconnectionSettings interconnection_settings_of(const StreetsCall& call) {
  InterconnectionSettings settings;
  settings.u_turn = call.u_turn;
  settings.rule =
      word_of<TrajectoryRule>(call.trajectory, "trajectory",
                              {{"bezier", TrajectoryRule::bezier}, {"arcs", TrajectoryRule::arcs}});
  settings.tolerance =
      in_range(call.trajectory_tolerance, 1e-3, 1000, "setting trajectory_tolerance");
  settings.least_radius = in_range(call.trajectory_radius, 0, 1000, "setting trajectory_radius");
  settings.node_tolerance = call.tolerance;
  return settings;
}

Former former_of(const StreetsCall& call) {
  Former former;
  for (int i = 0; i < call.former_edge_count; ++i)
    former.edges.push_back({DatumGetInt64(call.former_axis[i]),
                            read_line(bytes_of(call.former_geom[i]), "a former edge").line,
                            {DatumGetFloat8(call.former_limits[0][i]),
                             DatumGetFloat8(call.former_limits[1][i]),
                             DatumGetFloat8(call.former_limits[2][i]),
                             DatumGetFloat8(call.former_limits[3][i])}});
  for (int i = 0; i < call.former_place_count; ++i)
    former.places.push_back({{finite(DatumGetFloat8(call.former_x[i]), "x of a former place"),
                              finite(DatumGetFloat8(call.former_y[i]), "y of a former place"), 0},
                             DatumGetBool(call.former_met[i])});
  return former;
}

}  // namespace

StreetsInput read_input(const StreetsCall& call) {
  StreetsInput input;
  input.srid = call.srid;
  input.axes = axes_of(call, &input.has_z);
  input.settings = settings_of(call);
  input.former = former_of(call);
  input.lanes = lanes_of(call);
  input.overrides = street_overrides_of(call);
  input.lane_overrides = lane_overrides_of(call);
  input.lane_settings = lane_settings_of(call);
  input.restrictions = restrictions_of(call);
  input.interconnection_settings = interconnection_settings_of(call);
  return input;
}

}  // namespace streetgen::pg
