// streetgen._junction_movements: the paths across junctions of several nodes, a row each.
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "frame/composite_rows.hpp"
#include "streetgen/junction_movement.hpp"
#include "value/lane_text.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <funcapi.h>
#include <utils/array.h>
#include <utils/builtins.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {
namespace {

struct MovementCall {
  struct {
    int count;
    Column junction_id, surface;
  } grounds;
  struct {
    int count;
    Column junction_id, edge_id, at_start, axis_id, node_id, importance, speed, on_ring;
    Column border_line;
  } legs;
  struct {
    int count;
    Column junction_id, edge_id, at_start, lane_id, comes_in, along_axis, kind, turn, geom;
  } lanes;
  struct {
    int count;
    Column junction_id, edge_id, axis_id, from_node, to_node, along, against, offset_along;
    Column offset_against, geom;
  } inner;
  struct {
    int count;
    Column junction_id, interconnection_id, lane_in, lane_out, along_in, along_out, plausible;
  } steps;
  struct {
    int count;
    Column junction_id, from_axis, to_axis, x, y, kind, turn, except_kinds;
  } restrictions;
  struct {
    int count;
    Column junction_id, turn_restriction_id, from_axis, to_axis, edge_id, kind, except_kinds;
  } way_restrictions;
};

void take(FunctionCallInfo fcinfo, MovementCall* call) {
  const Rows grounds = rows(fcinfo, 0, "grounds of junctions");
  call->grounds = {grounds.count, column(grounds, "junction_id", INT8OID),
                   column(grounds, "surface", BYTEAOID)};
  const Rows legs = rows(fcinfo, 1, "legs of junctions");
  call->legs = {legs.count,
                column(legs, "junction_id", INT8OID),
                column(legs, "edge_id", INT8OID),
                column(legs, "at_start", BOOLOID),
                column(legs, "axis_id", INT8OID),
                column(legs, "node_id", INT8OID),
                column(legs, "importance", INT4OID),
                column(legs, "speed", FLOAT8OID),
                column(legs, "on_ring", BOOLOID),
                column(legs, "border_line", BYTEAOID)};
  const Rows lanes = rows(fcinfo, 2, "lanes of junctions");
  call->lanes = {lanes.count,
                 column(lanes, "junction_id", INT8OID),
                 column(lanes, "edge_id", INT8OID),
                 column(lanes, "at_start", BOOLOID),
                 column(lanes, "lane_id", INT8OID),
                 column(lanes, "comes_in", BOOLOID),
                 column(lanes, "along_axis", BOOLOID),
                 column(lanes, "kind", TEXTOID),
                 column_or_null(lanes, "turn", TEXTOID),
                 column(lanes, "geom", BYTEAOID)};
  const Rows inner = rows(fcinfo, 3, "edges inside junctions");
  call->inner = {inner.count,
                 column(inner, "junction_id", INT8OID),
                 column(inner, "edge_id", INT8OID),
                 column(inner, "axis_id", INT8OID),
                 column(inner, "from_node", INT8OID),
                 column(inner, "to_node", INT8OID),
                 column_or_null(inner, "along", TEXTOID),
                 column_or_null(inner, "against", TEXTOID),
                 column(inner, "offset_along", FLOAT8OID),
                 column(inner, "offset_against", FLOAT8OID),
                 column(inner, "geom", BYTEAOID)};
  const Rows steps = rows(fcinfo, 4, "paths at nodes of junctions");
  call->steps = {steps.count,
                 column(steps, "junction_id", INT8OID),
                 column(steps, "interconnection_id", INT8OID),
                 column(steps, "lane_in", INT8OID),
                 column(steps, "lane_out", INT8OID),
                 column(steps, "along_in", BOOLOID),
                 column(steps, "along_out", BOOLOID),
                 column(steps, "plausible", BOOLOID)};
  const Rows restrictions = rows(fcinfo, 5, "turn restrictions");
  call->restrictions = {restrictions.count,
                        column(restrictions, "junction_id", INT8OID),
                        column(restrictions, "from_axis", INT8OID),
                        column(restrictions, "to_axis", INT8OID),
                        column(restrictions, "x", FLOAT8OID),
                        column(restrictions, "y", FLOAT8OID),
                        column(restrictions, "kind", TEXTOID),
                        column_or_null(restrictions, "turn", TEXTOID),
                        column_or_null(restrictions, "except_kinds", TEXTOID)};
  const Rows ways = rows(fcinfo, 6, "turn restrictions via edges");
  call->way_restrictions = {ways.count,
                            column(ways, "junction_id", INT8OID),
                            column(ways, "turn_restriction_id", INT8OID),
                            column(ways, "from_axis", INT8OID),
                            column(ways, "to_axis", INT8OID),
                            column(ways, "edge_id", INT8OID),
                            column(ways, "kind", TEXTOID),
                            column_or_null(ways, "except_kinds", TEXTOID)};
}

// A junction as it is read, with the numbers by which its rows name each other.
struct ReadPlace {
  JunctionPlace place;
  std::unordered_map<std::int64_t, int> nodes;
  std::map<std::pair<std::int64_t, bool>, int> legs;
  std::unordered_map<std::int64_t, int> edges;

  int edge(std::int64_t id) {
    return edges.emplace(id, static_cast<int>(edges.size())).first->second;
  }
  int node(std::int64_t id) {
    const auto [found, fresh] = nodes.emplace(id, static_cast<int>(nodes.size()));
    if (fresh) place.nodes.emplace_back();
    return found->second;
  }
};

using Places = std::map<std::int64_t, ReadPlace>;

std::int64_t id(const Column& column, int row) { return DatumGetInt64(column.values[row]); }
bool flag(const Column& column, int row) { return DatumGetBool(column.values[row]); }
Line line_of(const Column& column, int row, const char* what) {
  return read_line(bytes_of(column.values[row]), what).line;
}

void read_legs(const MovementCall& call, Places& places) {
  for (int i = 0; i < call.legs.count; ++i) {
    ReadPlace& read = places[id(call.legs.junction_id, i)];
    const std::int64_t edge = id(call.legs.edge_id, i);
    JunctionLeg leg;
    leg.axis_id = id(call.legs.axis_id, i);
    leg.edge = read.edge(edge);
    leg.node = read.node(id(call.legs.node_id, i));
    leg.importance = DatumGetInt32(call.legs.importance.values[i]);
    leg.speed = in_range(DatumGetFloat8(call.legs.speed.values[i]), 0, 1000, "speed");
    leg.on_ring = flag(call.legs.on_ring, i);
    leg.border_line = line_of(call.legs.border_line, i, "a border line");
    read.legs[{edge, flag(call.legs.at_start, i)}] = static_cast<int>(read.place.legs.size());
    read.place.legs.push_back(std::move(leg));
  }
}

void read_lanes(const MovementCall& call, Places& places) {
  const auto& rows = call.lanes;
  for (int i = 0; i < rows.count; ++i) {
    ReadPlace& read = places[id(rows.junction_id, i)];
    const auto leg = read.legs.find({id(rows.edge_id, i), flag(rows.at_start, i)});
    if (leg == read.legs.end()) continue;
    JunctionLane lane;
    lane.lane_id = id(rows.lane_id, i);
    lane.leg = leg->second;
    lane.comes_in = flag(rows.comes_in, i);
    lane.along_axis = flag(rows.along_axis, i);
    const std::vector<LaneWish> wish =
        pg::read_lanes(1, text_of(rows.kind.values[i]), "",
                       rows.turn.nulls[i] ? "" : text_of(rows.turn.values[i]), {}, " of a lane");
    lane.kind = wish.front().kind;
    lane.turns = wish.front().turns;
    lane.line = line_of(rows.geom, i, "a lane");
    read.place.lanes.push_back(std::move(lane));
  }
}

LaneKinds kinds_of(const Column& column, int row) {
  LaneKinds kinds;
  if (column.nulls[row]) return kinds;
  for (const LaneKind kind : read_kinds(text_of(column.values[row]), "lane of an edge"))
    kinds.set(index_of(leads_as(kind)));
  return kinds;
}

void read_inner(const MovementCall& call, Places& places) {
  const auto& rows = call.inner;
  for (int i = 0; i < rows.count; ++i) {
    ReadPlace& read = places[id(rows.junction_id, i)];
    InnerEdge edge;
    edge.axis_id = id(rows.axis_id, i);
    edge.edge = read.edge(id(rows.edge_id, i));
    edge.from_node = read.node(id(rows.from_node, i));
    edge.to_node = read.node(id(rows.to_node, i));
    edge.along = kinds_of(rows.along, i);
    edge.against = kinds_of(rows.against, i);
    edge.offset_along = finite(DatumGetFloat8(rows.offset_along.values[i]), "offset of a lane");
    edge.offset_against = finite(DatumGetFloat8(rows.offset_against.values[i]), "offset of a lane");
    edge.line = line_of(rows.geom, i, "an edge");
    read.place.nodes[edge.from_node] = edge.line.front();
    read.place.nodes[edge.to_node] = edge.line.back();
    read.place.inner.push_back(std::move(edge));
  }
}

void read_steps(const MovementCall& call, Places& places) {
  const auto& rows = call.steps;
  for (int i = 0; i < rows.count; ++i)
    places[id(rows.junction_id, i)].place.steps.push_back(
        {id(rows.interconnection_id, i), id(rows.lane_in, i), id(rows.lane_out, i),
         flag(rows.along_in, i), flag(rows.along_out, i), flag(rows.plausible, i)});
}

std::vector<LaneKind> exceptions(const Column& column, int row) {
  return column.nulls[row] ? std::vector<LaneKind>{}
                           : read_kinds(text_of(column.values[row]), "exception");
}

void read_restrictions(const MovementCall& call, Places& places) {
  const auto& rows = call.restrictions;
  for (int i = 0; i < rows.count; ++i) {
    TurnRestriction restriction;
    restriction.from_axis = id(rows.from_axis, i);
    restriction.to_axis = id(rows.to_axis, i);
    restriction.via = {finite(DatumGetFloat8(rows.x.values[i]), "x of a turn restriction"),
                       finite(DatumGetFloat8(rows.y.values[i]), "y of a turn restriction"), 0};
    restriction.only = text_of(rows.kind.values[i]) == "only";
    if (!rows.turn.nulls[i]) restriction.turn = read_turn(text_of(rows.turn.values[i]));
    restriction.except = exceptions(rows.except_kinds, i);
    places[id(rows.junction_id, i)].place.restrictions.push_back(std::move(restriction));
  }
}

// A row for each edge, those of one restriction after each other.
void read_way_restrictions(const MovementCall& call, Places& places) {
  const auto& rows = call.way_restrictions;
  for (int i = 0; i < rows.count; ++i) {
    ReadPlace& read = places[id(rows.junction_id, i)];
    const bool goes_on = i > 0 && id(rows.junction_id, i) == id(rows.junction_id, i - 1) &&
                         id(rows.turn_restriction_id, i) == id(rows.turn_restriction_id, i - 1);
    if (!goes_on)
      read.place.way_restrictions.push_back({id(rows.from_axis, i),
                                             id(rows.to_axis, i),
                                             {},
                                             text_of(rows.kind.values[i]) == "only",
                                             exceptions(rows.except_kinds, i)});
    read.place.way_restrictions.back().via.push_back(read.edge(id(rows.edge_id, i)));
  }
}

struct FoundMovements {
  std::vector<std::int64_t> junctions, lanes_in, lanes_out;
  std::vector<bool> along_in, along_out;
  std::vector<JunctionMovement> movements;
  std::vector<std::string> lines;
};

void compute_movements(const MovementCall& call, const InterconnectionSettings& settings, int srid,
                       FoundMovements& found) {
  Places places;
  read_legs(call, places);
  read_lanes(call, places);
  read_inner(call, places);
  read_steps(call, places);
  read_restrictions(call, places);
  read_way_restrictions(call, places);
  for (int i = 0; i < call.grounds.count; ++i)
    places[id(call.grounds.junction_id, i)].place.surface =
        read_surface(bytes_of(call.grounds.surface.values[i]), "the ground of a junction");
  for (auto& [junction, read] : places)
    for (JunctionMovement& movement : junction_movements(read.place, settings)) {
      const JunctionLane &in = read.place.lanes[movement.lane_in],
                         &out = read.place.lanes[movement.lane_out];
      found.junctions.push_back(junction);
      found.lanes_in.push_back(in.lane_id);
      found.lanes_out.push_back(out.lane_id);
      found.along_in.push_back(in.along_axis);
      found.along_out.push_back(out.along_axis);
      found.lines.push_back(write_line(movement.line, {srid, false}));
      found.movements.push_back(std::move(movement));
    }
}

Datum ids_datum(const std::vector<std::int64_t>& ids) {
  auto* values = static_cast<Datum*>(palloc(sizeof(Datum) * (ids.size() + 1)));
  for (std::size_t i = 0; i < ids.size(); ++i) values[i] = Int64GetDatum(ids[i]);
  return PointerGetDatum(construct_array(values, static_cast<int>(ids.size()), INT8OID, 8,
                                         FLOAT8PASSBYVAL, TYPALIGN_DOUBLE));
}

void give(const FoundMovements& found, ReturnSetInfo* result) {
  for (std::size_t i = 0; i < found.movements.size(); ++i) {
    const JunctionMovement& movement = found.movements[i];
    const Datum values[12] = {Int64GetDatum(found.junctions[i]),
                              Int64GetDatum(found.lanes_in[i]),
                              Int64GetDatum(found.lanes_out[i]),
                              BoolGetDatum(found.along_in[i]),
                              BoolGetDatum(found.along_out[i]),
                              CStringGetTextDatum(turn_name(movement.turn)),
                              Float8GetDatum(movement.angle),
                              BoolGetDatum(movement.plausible),
                              CStringGetTextDatum(reason_name(movement.reason)),
                              CStringGetTextDatum(kinds_text(movement.traffic).c_str()),
                              ids_datum(movement.interconnections),
                              bytes_datum(found.lines[i])};
    bool nulls[12] = {false};
    nulls[9] = !of_some_alone(movement.traffic);
    tuplestore_putvalues(result->setResult, result->setDesc, const_cast<Datum*>(values), nulls);
  }
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_junction_movements) {
  using namespace streetgen;
  using namespace streetgen::pg;
  MovementCall call;
  take(fcinfo, &call);
  const int srid = PG_GETARG_INT32(7);
  InterconnectionSettings settings;
  settings.u_turn = PG_GETARG_BOOL(8);
  settings.rule = PG_GETARG_BOOL(9) ? TrajectoryRule::arcs : TrajectoryRule::bezier;
  settings.tolerance = PG_GETARG_FLOAT8(10);
  settings.node_tolerance = PG_GETARG_FLOAT8(11);
  settings.most = static_cast<std::size_t>(PG_GETARG_INT32(12));
  settings.driving_side = PG_GETARG_BOOL(13) ? DrivingSide::left : DrivingSide::right;
  InitMaterializedSRF(fcinfo, 0);
  Slot<FoundMovements>* slot = make_slot<FoundMovements>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new FoundMovements;
    in_range(settings.tolerance, 1e-3, 1000, "trajectory_tolerance");
    compute_movements(call, settings, srid, *slot->value);
  });
  report(outcome);
  give(*slot->value, reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo));
  return Datum(0);
}
