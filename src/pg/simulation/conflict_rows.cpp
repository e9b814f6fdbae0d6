// streetgen._link_conflict_rows: the conflicts of a network.
#include <vector>

#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "simulation/network_bytes.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/traffic.hpp"
#include "value/given_rows.hpp"

extern "C" {
#include <utils/builtins.h>
}

namespace streetgen::pg {
namespace {

struct ConflictRow {
  std::int64_t link_id, other_id;
  LinkConflict conflict;
};

// Each pair twice, by links.
std::vector<ConflictRow> conflicts_of(const TrafficNetwork& network) {
  std::vector<ConflictRow> found;
  for (int i = 0; i < network.size(); ++i) {
    if (i % 1024 == 0) poll_cancel();
    for (const LinkConflict& conflict : network.conflicts.of(i))
      found.push_back({network.links[i].link_id, network.links[conflict.link].link_id, conflict});
  }
  return found;
}

const char* precedence_word(Precedence precedence) {
  switch (precedence) {
    case Precedence::goes_first: return "goes_first";
    case Precedence::gives_way: return "gives_way";
    case Precedence::by_signal: return "by_signal";
    default: return "by_arrival";
  }
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_link_conflict_rows) {
  using namespace streetgen;
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, 0);
  const std::string_view bytes = take_bytes(fcinfo, 0);
  auto* slot = make_slot<std::vector<ConflictRow>>(CurrentMemoryContext);
  report(compute(
      [&] { slot->value = new std::vector<ConflictRow>(conflicts_of(read_network(bytes))); }));
  put_rows(fcinfo, *slot->value, [](const ConflictRow& row, ReturnSetInfo* result) {
    const LinkConflict& found = row.conflict;
    Datum values[] = {Int64GetDatum(row.link_id),      Int64GetDatum(row.other_id),
                      CStringGetTextDatum(precedence_word(found.precedence)),
                      Float8GetDatum(found.from),      Float8GetDatum(found.to),
                      Float8GetDatum(found.other_from), Float8GetDatum(found.other_to)};
    bool nulls[7] = {false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  });
  PG_RETURN_NULL();
}
