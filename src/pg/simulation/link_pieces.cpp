// streetgen._link_pieces: the courses of the links of a network.
#include <string>
#include <vector>

#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "simulation/network_bytes.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/traffic.hpp"
#include "value/given_rows.hpp"

namespace streetgen::pg {
namespace {

struct PieceRow {
  std::int64_t link_id;
  LinkPiece piece;
  double end;  // metres along the course
};

std::vector<PieceRow> pieces_of(const TrafficNetwork& network) {
  std::vector<PieceRow> rows;
  for (int i = 0; i < network.size(); ++i) {
    poll_cancel();
    const Link& link = network.links[i];
    const auto pieces = network.pieces.of(i);
    for (int k = 0; k < pieces.size(); ++k)
      rows.push_back({link.link_id, pieces[k],
                      k + 1 < pieces.size() ? pieces[k + 1].metres : link.length * link.stretch});
  }
  return rows;
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_link_pieces) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const std::string_view bytes = take_bytes(fcinfo, 0);
  InitMaterializedSRF(fcinfo, 0);
  auto* slot = make_slot<std::vector<PieceRow>>(CurrentMemoryContext);
  report(compute(
      [&] { slot->value = new std::vector<PieceRow>(pieces_of(read_network(bytes))); }));
  put_rows(fcinfo, *slot->value, [](const PieceRow& row, ReturnSetInfo* result) {
    Datum values[] = {Int64GetDatum(row.link_id),      Float8GetDatum(row.piece.metres),
                      Float8GetDatum(row.end),         Float8GetDatum(row.piece.x),
                      Float8GetDatum(row.piece.y),     Float8GetDatum(row.piece.heading),
                      Float8GetDatum(row.piece.curvature)};
    bool nulls[7] = {false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  });
  PG_RETURN_NULL();
}
