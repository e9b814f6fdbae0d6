// streetgen._roads: the roads that edges make.
#include "streetgen/road.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "frame/argument.hpp"
#include "frame/composite_rows.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <funcapi.h>
#include <utils/array.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {
namespace {

struct RoadsCall {
  int count = 0;
  Column edge_id, axis_id, from_node, to_node, level, start_abscissa, end_abscissa, line;
  int branching_count = 0;
  Datum* branching = nullptr;
  double shift = 0;
  int bend_count = 0;
  Column bend_axis, bend_abscissa, bend_radius;
};

RoadsCall take_call(FunctionCallInfo fcinfo) {
  RoadsCall call;
  const Rows parts = rows(fcinfo, 0, "parts of roads");
  call.count = parts.count;
  call.edge_id = column(parts, "edge_id", INT8OID);
  call.axis_id = column(parts, "axis_id", INT8OID);
  call.from_node = column(parts, "from_node", INT8OID);
  call.to_node = column(parts, "to_node", INT8OID);
  call.level = column(parts, "level", INT4OID);
  call.start_abscissa = column(parts, "start_abscissa", FLOAT8OID);
  call.end_abscissa = column(parts, "end_abscissa", FLOAT8OID);
  call.line = column(parts, "line", BYTEAOID);
  bool* nulls;
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(1), INT8OID, 8, true, TYPALIGN_DOUBLE, &call.branching,
                    &nulls, &call.branching_count);
  call.shift = PG_GETARG_FLOAT8(2);
  const Rows bends = rows(fcinfo, 3, "bends");
  call.bend_count = bends.count;
  call.bend_axis = column(bends, "axis_id", INT8OID);
  call.bend_abscissa = column(bends, "abscissa", FLOAT8OID);
  call.bend_radius = column(bends, "radius", FLOAT8OID);
  return call;
}

// The edges in the order of a network, with the ids of its edges and nodes.
struct GivenNetwork {
  Network network;
  std::vector<std::int64_t> edge_ids, node_ids;
  std::vector<bool> branching;
  Form form;
};

void put_line(Edge& edge, CurvedLine curve) {
  edge.line.push_back(curve.front().arc.start);
  bool curved = false;
  for (const RingPiece& piece : curve) {
    edge.line.push_back(piece.arc.end);
    curved = curved || piece.curved;
  }
  if (curved) edge.curve = std::move(curve);
}

GivenNetwork network_of(const RoadsCall& call) {
  GivenNetwork given;
  std::unordered_map<std::int64_t, int> numbers;
  const auto number_of = [&](std::int64_t node) {
    const auto [place, is_new] = numbers.try_emplace(node, static_cast<int>(numbers.size()));
    if (is_new) given.node_ids.push_back(node);
    return place->second;
  };
  std::vector<int> order(call.count);
  for (int i = 0; i < call.count; ++i) order[i] = i;
  const auto key = [&](int i) {
    return std::pair(DatumGetInt64(call.axis_id.values[i]),
                     DatumGetFloat8(call.start_abscissa.values[i]));
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
  for (const int i : order) {
    given.edge_ids.push_back(DatumGetInt64(call.edge_id.values[i]));
    Edge edge;
    edge.axis_id = DatumGetInt64(call.axis_id.values[i]);
    edge.from_node = number_of(DatumGetInt64(call.from_node.values[i]));
    edge.to_node = number_of(DatumGetInt64(call.to_node.values[i]));
    edge.level = DatumGetInt32(call.level.values[i]);
    edge.start_abscissa = finite(DatumGetFloat8(call.start_abscissa.values[i]), "start_abscissa");
    edge.end_abscissa = finite(DatumGetFloat8(call.end_abscissa.values[i]), "end_abscissa");
    const ReadCurve read = read_curve(bytes_of(call.line.values[i]),
                                      "the line of edge " + std::to_string(given.edge_ids.back()));
    given.form = {read.srid, false};
    put_line(edge, read.curve);
    given.network.edges.push_back(std::move(edge));
  }
  given.network.nodes.resize(numbers.size());
  given.branching.resize(numbers.size());
  for (int i = 0; i < call.branching_count; ++i) {
    const auto found = numbers.find(DatumGetInt64(call.branching[i]));
    if (found != numbers.end()) given.branching[found->second] = true;
  }
  return given;
}

struct RoadRow {
  std::int64_t from_node, to_node;
  bool closed;
  double length;
  std::string wkb;
  std::vector<std::int64_t> edges;  // negative: it runs against the road
  std::vector<double> starts;
};

std::vector<RoadRow> road_rows(const RoadsCall& call) {
  const GivenNetwork given = network_of(call);
  std::vector<RoadOverride> overrides;
  for (int i = 0; i < call.bend_count; ++i)
    overrides.push_back({DatumGetInt64(call.bend_axis.values[i]),
                         finite(DatumGetFloat8(call.bend_abscissa.values[i]), "abscissa"),
                         in_range(DatumGetFloat8(call.bend_radius.values[i]), 0, 1e6, "radius")});
  std::vector<RoadRow> found;
  for (const Road& road :
       roads(given.network, given.branching, in_range(call.shift, 1e-3, 100, "shift"), overrides)) {
    RoadRow row{given.node_ids[road.from_node],
                given.node_ids[road.to_node],
                road.closed,
                road.length,
                write_curve(road.curve, given.form),
                {},
                {}};
    for (const RoadMember& member : road.members) {
      const std::int64_t edge = given.edge_ids[member.edge];
      row.edges.push_back(member.along ? edge : -edge);
      row.starts.push_back(member.start_abscissa);
    }
    found.push_back(std::move(row));
  }
  return found;
}

void give(const std::vector<RoadRow>& found, ReturnSetInfo* result) {
  MemoryContext per_row =
      AllocSetContextCreate(CurrentMemoryContext, "streetgen road", ALLOCSET_DEFAULT_SIZES);
  for (std::size_t i = 0; i < found.size(); ++i) {
    CHECK_FOR_INTERRUPTS();
    MemoryContext outer = MemoryContextSwitchTo(per_row);
    const RoadRow& row = found[i];
    const int count = static_cast<int>(row.edges.size());
    auto* edges = static_cast<Datum*>(palloc(sizeof(Datum) * count));
    auto* starts = static_cast<Datum*>(palloc(sizeof(Datum) * count));
    for (int k = 0; k < count; ++k) {
      edges[k] = Int64GetDatum(row.edges[k]);
      starts[k] = Float8GetDatum(row.starts[k]);
    }
    Datum values[8] = {
        Int32GetDatum(static_cast<std::int32_t>(i) + 1),
        Int64GetDatum(row.from_node),
        Int64GetDatum(row.to_node),
        BoolGetDatum(row.closed),
        Float8GetDatum(row.length),
        bytes_datum(row.wkb),
        PointerGetDatum(construct_array(edges, count, INT8OID, 8, true, TYPALIGN_DOUBLE)),
        PointerGetDatum(construct_array(starts, count, FLOAT8OID, 8, true, TYPALIGN_DOUBLE))};
    bool nulls[8] = {false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
    MemoryContextSwitchTo(outer);
    MemoryContextReset(per_row);
  }
  MemoryContextDelete(per_row);
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_roads) {
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, 0);
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  if (PG_ARGISNULL(0) || PG_ARGISNULL(1) || PG_ARGISNULL(2)) return 0;
  const RoadsCall call = take_call(fcinfo);
  Slot<std::vector<RoadRow>>* slot = make_slot<std::vector<RoadRow>>(CurrentMemoryContext);
  const Outcome outcome = compute([&] { slot->value = new std::vector<RoadRow>(road_rows(call)); });
  report(outcome);
  give(*slot->value, result);
  return 0;
}
