// streetgen._network_cells: the links of a network in equal cells.
#include <string>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "simulation/network_bytes.hpp"
#include "streetgen/network_cells.hpp"
#include "value/given_rows.hpp"
#include "value/value_array.hpp"

namespace streetgen::pg {
namespace {

struct CellRow {
  std::int64_t cell_id, link_id;
  std::int32_t ordinality;
  double from, to;
  std::vector<std::int64_t> next, before;
  CellBeside left, right;
};

// Keys of cells count from 1.
std::vector<std::int64_t> keys_of(const RowsOf<std::int32_t>::List& cells) {
  std::vector<std::int64_t> keys;
  for (const std::int32_t cell : cells) keys.push_back(cell + std::int64_t{1});
  return keys;
}

std::vector<CellRow> rows_of(const TrafficNetwork& network, double size) {
  const NetworkCells cells = cells_of(network, size);
  std::vector<CellRow> rows;
  for (int i = 0; i < cells.first.back(); ++i) {
    const NetworkCell& cell = cells.cells[i];
    rows.push_back({i + std::int64_t{1}, network.links[cell.link].link_id,
                    i - cells.first[cell.link] + 1, cell.from, cell.to, keys_of(cells.next.of(i)),
                    keys_of(cells.before.of(i)), cells.left[i], cells.right[i]});
  }
  return rows;
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_cells) {
  using namespace streetgen;
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, 0);
  const std::string_view bytes = take_bytes(fcinfo, 0);
  const double size = PG_GETARG_FLOAT8(1);
  auto* slot = make_slot<std::vector<CellRow>>(CurrentMemoryContext);
  report(compute([&] {
    slot->value = new std::vector<CellRow>(rows_of(read_network(bytes), finite(size, "size")));
  }));
  put_rows(fcinfo, *slot->value, [](const CellRow& row, ReturnSetInfo* result) {
    Datum values[] = {Int64GetDatum(row.cell_id),
                      Int64GetDatum(row.link_id),
                      Int32GetDatum(row.ordinality),
                      Float8GetDatum(row.from),
                      Float8GetDatum(row.to),
                      bigints(row.next),
                      bigints(row.before),
                      Int64GetDatum(row.left.cell + std::int64_t{1}),
                      BoolGetDatum(row.left.may_change),
                      BoolGetDatum(row.left.opposite),
                      Int64GetDatum(row.right.cell + std::int64_t{1}),
                      BoolGetDatum(row.right.may_change),
                      BoolGetDatum(row.right.opposite)};
    bool nulls[13] = {false};
    nulls[7] = nulls[8] = nulls[9] = row.left.cell < 0;
    nulls[10] = nulls[11] = nulls[12] = row.right.cell < 0;
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  });
  PG_RETURN_NULL();
}
