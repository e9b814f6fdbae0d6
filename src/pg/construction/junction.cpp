// streetgen._group_junctions: which nodes are one junction, a row for each node and each edge.
#include <algorithm>
#include <string>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "frame/composite_rows.hpp"
#include "streetgen/junction.hpp"
#include "value/control_rows.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <funcapi.h>
#include <utils/builtins.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {
namespace {

struct EdgeRows {
  int count;
  Column edge_id, axis_id, start_abscissa, end_abscissa, from_node, to_node, geom;
  Column along, against, name, crossed, on_ring, by_hand, importance, width, width_end;
};

EdgeRows take_edges(FunctionCallInfo fcinfo, int argument) {
  const Rows edges = rows(fcinfo, argument, "edges");
  return {edges.count,
          column(edges, "edge_id", INT8OID),
          column(edges, "axis_id", INT8OID),
          column(edges, "start_abscissa", FLOAT8OID),
          column(edges, "end_abscissa", FLOAT8OID),
          column(edges, "from_node", INT8OID),
          column(edges, "to_node", INT8OID),
          column(edges, "geom", BYTEAOID),
          column(edges, "along", BOOLOID),
          column(edges, "against", BOOLOID),
          column(edges, "name", INT8OID),
          column(edges, "crossed", BOOLOID),
          column(edges, "on_ring", BOOLOID),
          column_or_null(edges, "by_hand", BOOLOID),
          column(edges, "importance", INT4OID),
          column(edges, "width", FLOAT8OID),
          column(edges, "width_end", FLOAT8OID)};
}

constexpr int columns = 9;

struct FoundJunctions {
  std::vector<std::int64_t> node_ids;
  JunctionNetwork network;
  JunctionGroups groups;
};

void read_nodes(const EdgeRows& rows, FoundJunctions& found) {
  for (int i = 0; i < rows.count; ++i) {
    found.node_ids.push_back(DatumGetInt64(rows.from_node.values[i]));
    found.node_ids.push_back(DatumGetInt64(rows.to_node.values[i]));
  }
  // The first node of a junction is that of the smallest id.
  std::sort(found.node_ids.begin(), found.node_ids.end());
  found.node_ids.erase(std::unique(found.node_ids.begin(), found.node_ids.end()),
                       found.node_ids.end());
  found.network.nodes.resize(found.node_ids.size());
}

void read_edges(const EdgeRows& rows, FoundJunctions& found) {
  const auto index = [&](const Column& column, int row) {
    const std::int64_t id = DatumGetInt64(column.values[row]);
    return static_cast<int>(std::lower_bound(found.node_ids.begin(), found.node_ids.end(), id) -
                            found.node_ids.begin());
  };
  for (int i = 0; i < rows.count; ++i) {
    JunctionEdge edge;
    edge.axis_id = DatumGetInt64(rows.axis_id.values[i]);
    edge.start_abscissa = DatumGetFloat8(rows.start_abscissa.values[i]);
    edge.end_abscissa = DatumGetFloat8(rows.end_abscissa.values[i]);
    edge.line = read_line(bytes_of(rows.geom.values[i]), "the geometry of an edge").line;
    edge.from_node = index(rows.from_node, i);
    edge.to_node = index(rows.to_node, i);
    found.network.nodes[edge.from_node] = edge.line.front();
    found.network.nodes[edge.to_node] = edge.line.back();
    edge.along = DatumGetBool(rows.along.values[i]);
    edge.against = DatumGetBool(rows.against.values[i]);
    edge.name = DatumGetInt64(rows.name.values[i]);
    edge.crossed = DatumGetBool(rows.crossed.values[i]);
    edge.on_ring = DatumGetBool(rows.on_ring.values[i]);
    if (!rows.by_hand.nulls[i]) edge.by_hand = DatumGetBool(rows.by_hand.values[i]);
    edge.importance = DatumGetInt32(rows.importance.values[i]);
    edge.width = DatumGetFloat8(rows.width.values[i]);
    edge.width_end = DatumGetFloat8(rows.width_end.values[i]);
    found.network.edges.push_back(std::move(edge));
  }
}

Datum control_datum(const std::optional<ControlKind>& kind, bool* null) {
  *null = !kind;
  return kind ? CStringGetTextDatum(control_kind_name(*kind)) : Datum(0);
}

// node_id, edge_id, junction_id, chain, role, parted, control_from, control_to, control
void give(const FoundJunctions& found, const EdgeRows& rows, ReturnSetInfo* result) {
  Datum values[columns];
  bool nulls[columns];
  for (std::size_t n = 0; n < found.node_ids.size(); ++n) {
    std::fill_n(nulls, columns, true);
    nulls[0] = nulls[2] = nulls[3] = false;
    values[0] = Int64GetDatum(found.node_ids[n]);
    values[2] = Int64GetDatum(found.node_ids[found.groups.of_node[n]]);
    values[3] = Int64GetDatum(found.node_ids[found.groups.chain_of_node[n]]);
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
  for (int e = 0; e < rows.count; ++e) {
    std::fill_n(nulls, columns, false);
    const JunctionEdge& edge = found.network.edges[e];
    nulls[0] = nulls[3] = nulls[8] = true;
    values[1] = rows.edge_id.values[e];
    values[2] = Int64GetDatum(found.node_ids[found.groups.of_node[edge.from_node]]);
    nulls[2] = nulls[4] = found.groups.roles[e] == EdgeRole::outside;
    if (!nulls[4]) values[4] = CStringGetTextDatum(edge_role_name(found.groups.roles[e]));
    values[5] = BoolGetDatum(found.groups.parted[e]);
    values[6] = control_datum(found.groups.controls[2 * e], &nulls[6]);
    values[7] = control_datum(found.groups.controls[2 * e + 1], &nulls[7]);
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
  for (std::size_t c = 0; c < found.groups.served.size(); ++c) {
    const int node = found.groups.served[c];
    if (node < 0) continue;
    std::fill_n(nulls, columns, true);
    nulls[2] = nulls[8] = false;
    values[2] = Int64GetDatum(found.node_ids[found.groups.of_node[node]]);
    values[8] = Int64GetDatum(static_cast<std::int64_t>(c + 1));
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_group_junctions) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const EdgeRows edges = take_edges(fcinfo, 0);
  const ControlRows controls = take_controls(fcinfo, 1);
  const double gap = PG_GETARG_FLOAT8(2), extent = PG_GETARG_FLOAT8(3);
  const double control_distance = PG_GETARG_FLOAT8(4), queue = PG_GETARG_FLOAT8(5);
  InitMaterializedSRF(fcinfo, 0);
  Slot<FoundJunctions>* slot = make_slot<FoundJunctions>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new FoundJunctions;
    FoundJunctions& found = *slot->value;
    read_nodes(edges, found);
    read_edges(edges, found);
    found.network.controls = read_controls(controls);
    found.groups =
        group_junctions(found.network, {in_range(gap, 0, 1000, "junction_gap"),
                                        in_range(extent, 0, 10000, "junction_extent"),
                                        {in_range(control_distance, 0, 1000, "control_distance"),
                                         in_range(queue, 0, 1000, "queue_length")}});
  });
  report(outcome);
  give(*slot->value, edges, reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo));
  return Datum(0);
}
