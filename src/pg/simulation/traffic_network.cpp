// streetgen._traffic_network: the network of links from rows of a model.
#include "streetgen/traffic_network.hpp"

#include <string>
#include <unordered_map>
#include <utility>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "frame/composite_rows.hpp"
#include "simulation/car_rows.hpp"
#include "simulation/network_bytes.hpp"
#include "value/lane_text.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <catalog/pg_type.h>
}

namespace streetgen::pg {
namespace {

struct NetworkCall {
  struct {
    int count;
    Column edge_id, geom, widest;
  } edges;
  struct {
    int count;
    Column link_id, edge_id, along, starts, ends, stop, width, speed, traffic, from_node, to_node,
        junction_id, other_way, geom;
  } lanes;
  struct {
    int count;
    Column link_id, lane_in, lane_out, width, traffic, turn, rank, importance, precedence, junction_id,
        controller_id, geom;
  } movements;
  struct {
    int count;
    Column link_id, beside, at_left, may_change, opposite, starts, ends;
  } beside;
  struct {
    int count;
    Column link_id, since, aspect;
  } aspects;
  struct {
    int count;
    Column controller_id, cycle, start_offset;
  } plans;
  bool left_hand;
};

void take(FunctionCallInfo fcinfo, NetworkCall* call) {
  const Rows edges = rows(fcinfo, 0, "edges");
  call->edges = {edges.count, column(edges, "edge_id", INT8OID), column(edges, "geom", BYTEAOID),
                 column(edges, "widest", FLOAT8OID)};
  const Rows lanes = rows(fcinfo, 1, "lanes");
  call->lanes = {lanes.count,
                 column(lanes, "link_id", INT8OID),
                 column(lanes, "edge_id", INT8OID),
                 column(lanes, "along", BOOLOID),
                 column(lanes, "starts", FLOAT8OID),
                 column(lanes, "ends", FLOAT8OID),
                 column(lanes, "stop", FLOAT8OID),
                 column(lanes, "width", FLOAT8OID),
                 column(lanes, "speed", FLOAT8OID),
                 column_or_null(lanes, "traffic", TEXTOID),
                 column(lanes, "from_node", INT8OID),
                 column(lanes, "to_node", INT8OID),
                 column_or_null(lanes, "junction_id", INT8OID),
                 column_or_null(lanes, "other_way", INT8OID),
                 column(lanes, "geom", BYTEAOID)};
  const Rows movements = rows(fcinfo, 2, "movements");
  call->movements = {movements.count,
                     column(movements, "link_id", INT8OID),
                     column(movements, "lane_in", INT8OID),
                     column(movements, "lane_out", INT8OID),
                     column(movements, "width", FLOAT8OID),
                     column_or_null(movements, "traffic", TEXTOID),
                     column(movements, "turn", TEXTOID),
                     column(movements, "rank", INT4OID),
                     column(movements, "importance", INT4OID),
                     column(movements, "precedence", INT4OID),
                     column_or_null(movements, "junction_id", INT8OID),
                     column_or_null(movements, "controller_id", INT8OID),
                     column(movements, "geom", BYTEAOID)};
  const Rows beside = rows(fcinfo, 3, "neighbours");
  call->beside = {beside.count,
                  column(beside, "link_id", INT8OID),
                  column(beside, "beside", INT8OID),
                  column(beside, "at_left", BOOLOID),
                  column(beside, "may_change", BOOLOID),
                  column(beside, "opposite", BOOLOID),
                  column(beside, "starts", FLOAT8OID),
                  column(beside, "ends", FLOAT8OID)};
  const Rows aspects = rows(fcinfo, 4, "aspects");
  call->aspects = {aspects.count, column(aspects, "link_id", INT8OID),
                   column(aspects, "since", FLOAT8OID), column(aspects, "aspect", TEXTOID)};
  const Rows plans = rows(fcinfo, 5, "plans");
  call->plans = {plans.count, column(plans, "controller_id", INT8OID),
                 column(plans, "cycle", FLOAT8OID), column(plans, "start_offset", FLOAT8OID)};
  call->left_hand = PG_GETARG_BOOL(6);
}

std::int64_t key_of(const Column& column, int row) {
  return column.nulls[row] ? 0 : DatumGetInt64(column.values[row]);
}

double measure(const Column& column, int row, double low, double high, const std::string& name) {
  return in_range(DatumGetFloat8(column.values[row]), low, high, name);
}

// Who may drive where the lanes are for some alone; all where nothing is said.
std::uint8_t traffic_of(const Column& column, int row, const std::string& name) {
  if (column.nulls[row]) return traffic::all;
  std::uint8_t who = 0;
  for (const LaneKind kind : read_kinds(text_of(column.values[row]), name)) switch (kind) {
      case LaneKind::bus: who |= traffic::bus; break;
      case LaneKind::carpool: who |= traffic::carpool | traffic::bus; break;
      case LaneKind::cycle: who |= traffic::cycle; break;
      default: who |= traffic::all;
    }
  return who;
}

constexpr double farthest = 1e7;  // metres

std::vector<TrafficEdge> edges_of(const NetworkCall& call,
                                  std::unordered_map<std::int64_t, int>* numbers) {
  std::vector<TrafficEdge> edges;
  const auto& rows = call.edges;
  for (int i = 0; i < rows.count; ++i) {
    const std::int64_t key = DatumGetInt64(rows.edge_id.values[i]);
    const std::string of_edge = " of edge " + std::to_string(key);
    ReadLine read = read_line(bytes_of(rows.geom.values[i]), "the line" + of_edge);
    numbers->emplace(key, static_cast<int>(edges.size()));
    edges.push_back({std::move(read.line), read.has_z,
                     measure(rows.widest, i, 0, 1000, "the widest offset" + of_edge)});
  }
  return edges;
}

TrafficLink lane_of(const NetworkCall& call, int i,
                    const std::unordered_map<std::int64_t, int>& edges) {
  const auto& rows = call.lanes;
  TrafficLink link;
  link.link_id = DatumGetInt64(rows.link_id.values[i]);
  const std::string of_link = " of link " + std::to_string(link.link_id);
  link.line = read_line(bytes_of(rows.geom.values[i]), "the line" + of_link).line;
  link.width = measure(rows.width, i, 1e-3, 1000, "the width" + of_link);
  link.speed = measure(rows.speed, i, 0, 1000, "the speed" + of_link) * kmh;
  link.traffic = traffic_of(rows.traffic, i, "the traffic" + of_link);
  link.from_node = key_of(rows.from_node, i);
  link.to_node = key_of(rows.to_node, i);
  link.junction = key_of(rows.junction_id, i);
  const auto edge = edges.find(DatumGetInt64(rows.edge_id.values[i]));
  link.edge = edge == edges.end() ? -1 : edge->second;
  link.along = DatumGetBool(rows.along.values[i]);
  link.first = measure(rows.starts, i, -farthest, farthest, "the start" + of_link);
  link.last = measure(rows.ends, i, -farthest, farthest, "the end" + of_link);
  link.other_way = key_of(rows.other_way, i);
  link.stop = measure(rows.stop, i, 0, farthest, "the stop line" + of_link);
  return link;
}

TrafficLink movement_of(const NetworkCall& call, int i) {
  const auto& rows = call.movements;
  TrafficLink link;
  link.movement = true;
  link.link_id = DatumGetInt64(rows.link_id.values[i]);
  const std::string of_link = " of link " + std::to_string(link.link_id);
  link.line = read_vertices(bytes_of(rows.geom.values[i]), "the line" + of_link);
  link.width = measure(rows.width, i, 1e-3, 1000, "the width" + of_link);
  link.traffic = traffic_of(rows.traffic, i, "the traffic" + of_link);
  link.turn = word_of<Turn>(text_of(rows.turn.values[i]), "the turn" + of_link,
                            {{"through", Turn::through},
                             {"left", Turn::left},
                             {"right", Turn::right},
                             {"u_turn", Turn::u_turn}});
  link.rank = DatumGetInt32(rows.rank.values[i]);
  link.importance = DatumGetInt32(rows.importance.values[i]);
  link.precedence = DatumGetInt32(rows.precedence.values[i]);
  link.lane_in = key_of(rows.lane_in, i);
  link.lane_out = key_of(rows.lane_out, i);
  link.junction = key_of(rows.junction_id, i);
  link.controller = key_of(rows.controller_id, i);
  return link;
}

Aspect aspect_of(const std::string& word) {
  return word_of<Aspect>(word, "aspect", {{"red", Aspect::red},
                                          {"amber", Aspect::amber},
                                          {"permitted", Aspect::permitted},
                                          {"protected", Aspect::protected_green}});
}

TrafficSource source_of(const NetworkCall& call) {
  TrafficSource source;
  source.left_hand = call.left_hand;
  std::unordered_map<std::int64_t, int> edges;
  source.edges = edges_of(call, &edges);
  for (int i = 0; i < call.lanes.count; ++i) source.links.push_back(lane_of(call, i, edges));
  std::unordered_map<std::int64_t, int> movements;
  for (int i = 0; i < call.movements.count; ++i) {
    movements.emplace(DatumGetInt64(call.movements.link_id.values[i]),
                      static_cast<int>(source.links.size()));
    source.links.push_back(movement_of(call, i));
  }
  for (int i = 0; i < call.beside.count; ++i)
    source.beside.push_back({key_of(call.beside.link_id, i), key_of(call.beside.beside, i),
                             DatumGetBool(call.beside.at_left.values[i]),
                             DatumGetBool(call.beside.may_change.values[i]),
                             DatumGetBool(call.beside.opposite.values[i]),
                             measure(call.beside.starts, i, -farthest, farthest, "a start"),
                             measure(call.beside.ends, i, -farthest, farthest, "an end")});
  for (int i = 0; i < call.aspects.count; ++i) {
    const auto movement = movements.find(key_of(call.aspects.link_id, i));
    if (movement == movements.end()) continue;
    source.links[movement->second].aspects.push_back(
        {static_cast<float>(measure(call.aspects.since, i, 0, 1e6, "the time of an aspect")),
         aspect_of(text_of(call.aspects.aspect.values[i]))});
  }
  for (int i = 0; i < call.plans.count; ++i)
    source.plans.push_back(
        {key_of(call.plans.controller_id, i),
         static_cast<float>(measure(call.plans.cycle, i, 1e-3, 1e6, "a cycle")),
         static_cast<float>(measure(call.plans.start_offset, i, -1e6, 1e6, "an offset"))});
  return source;
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_traffic_network) {
  using namespace streetgen;
  using namespace streetgen::pg;
  NetworkCall call;
  take(fcinfo, &call);
  auto* slot = make_slot<std::string>(CurrentMemoryContext);
  const Outcome outcome = compute(
      [&] { slot->value = new std::string(network_bytes(traffic_network(source_of(call)))); });
  report(outcome);
  return bytes_datum(*slot->value);
}
