// The rows of streetgen._streets into the tuplestore of its call.
#include "streets_rows.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <utils/array.h>
#include <utils/builtins.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {

void give(const Rows& rows, ReturnSetInfo* result) {
  MemoryContext per_row =
      AllocSetContextCreate(CurrentMemoryContext, "streetgen row", ALLOCSET_DEFAULT_SIZES);
  for (const Row& row : rows) {
    MemoryContext outer = MemoryContextSwitchTo(per_row);
    Datum values[22];
    bool nulls[22] = {false};
    values[0] = CStringGetTextDatum(row.relation);
    values[1] = Int32GetDatum(row.row_index);
    values[2] = Int64GetDatum(row.axis_id);
    const int indices[4] = {row.node_a, row.node_b, row.edge_a, row.edge_b};
    for (int i = 0; i < 4; ++i) {
      values[3 + i] = Int32GetDatum(indices[i]);
      nulls[3 + i] = indices[i] < 0;
    }
    values[7] = BoolGetDatum(row.start_a);
    values[8] = BoolGetDatum(row.start_b);
    values[9] = Int32GetDatum(row.level);
    values[10] = Float8GetDatum(row.measure_1);
    values[11] = Float8GetDatum(row.measure_2);
    nulls[12] = row.geom_1.empty();
    if (!nulls[12]) values[12] = bytes_datum(row.geom_1);
    nulls[13] = row.geom_2.empty();
    if (!nulls[13]) values[13] = bytes_datum(row.geom_2);
    const int anchors = static_cast<int>(row.anchor_axis.size());
    auto* of_axes = static_cast<Datum*>(palloc(sizeof(Datum) * (anchors + 1)));
    auto* of_abscissas = static_cast<Datum*>(palloc(sizeof(Datum) * (anchors + 1)));
    for (int i = 0; i < anchors; ++i) {
      of_axes[i] = Int64GetDatum(row.anchor_axis[i]);
      if (!row.anchor_abscissa.empty()) of_abscissas[i] = Float8GetDatum(row.anchor_abscissa[i]);
    }
    values[14] = PointerGetDatum(construct_array(of_axes, anchors, INT8OID, 8, true, 'd'));
    values[15] = PointerGetDatum(construct_array(
        of_abscissas, row.anchor_abscissa.empty() ? 0 : anchors, FLOAT8OID, 8, true, 'd'));
    values[16] = CStringGetTextDatum(row.method);
    values[17] = Int32GetDatum(row.lane_position);
    nulls[17] = row.lane_position < 0;
    values[18] = Int32GetDatum(row.ordinality);
    nulls[18] = row.ordinality < 0;
    const std::string* words[3] = {&row.side, &row.kind, &row.turn};
    for (int i = 0; i < 3; ++i) {
      nulls[19 + i] = words[i]->empty();
      if (!nulls[19 + i]) values[19 + i] = CStringGetTextDatum(words[i]->c_str());
    }
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
    MemoryContextSwitchTo(outer);
    MemoryContextReset(per_row);
  }
  MemoryContextDelete(per_row);
}

}  // namespace streetgen::pg
