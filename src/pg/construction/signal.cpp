// streetgen.signal_phases and streetgen.signal_pairs: the states of a signal program.
#include "streetgen/signal.hpp"

#include <cstdint>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "frame/composite_rows.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <funcapi.h>
#include <utils/array.h>
#include <utils/builtins.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {
namespace {

struct Numbers {
  Datum* values;
  int count;
};

struct RequestRows {
  int count;
  Column lane_in, lane_out, along_in, along_out, approach, exit, turn, length, speed, lanes;
  Column importance, flow, walk_in, walk_out;
  Numbers* conflicts;
};

RequestRows take_requests(FunctionCallInfo fcinfo) {
  const Rows requests = rows(fcinfo, 0, "movements");
  RequestRows taken = {requests.count,
                       column(requests, "lane_in", INT8OID),
                       column(requests, "lane_out", INT8OID),
                       column(requests, "along_in", BOOLOID),
                       column(requests, "along_out", BOOLOID),
                       column(requests, "approach", INT8OID),
                       column(requests, "exit", INT8OID),
                       column(requests, "turn", TEXTOID),
                       column(requests, "length", FLOAT8OID),
                       column(requests, "speed", FLOAT8OID),
                       column(requests, "lanes", INT4OID),
                       column(requests, "importance", INT4OID),
                       column_or_null(requests, "flow", FLOAT8OID),
                       column_or_null(requests, "walk_in", FLOAT8OID),
                       column_or_null(requests, "walk_out", FLOAT8OID),
                       nullptr};
  const Column conflicts = column_or_null(requests, "conflicts", INT4ARRAYOID);
  taken.conflicts = static_cast<Numbers*>(palloc0(sizeof(Numbers) * Max(taken.count, 1)));
  for (int row = 0; row < taken.count; ++row) {
    if (conflicts.nulls[row]) continue;
    ArrayType* array = DatumGetArrayTypeP(conflicts.values[row]);
    if (array_contains_nulls(array))
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED),
                      errmsg("a conflict is NULL in row %d of the movements", row + 1)));
    deconstruct_array(array, INT4OID, sizeof(int32), true, TYPALIGN_INT,
                      &taken.conflicts[row].values, nullptr, &taken.conflicts[row].count);
  }
  return taken;
}

std::vector<SignalRequest> read_requests(const RequestRows& rows) {
  using Turn = SignalRequest::Turn;
  std::vector<SignalRequest> requests;
  for (int i = 0; i < rows.count; ++i) {
    SignalRequest request;
    request.approach = DatumGetInt64(rows.approach.values[i]);
    request.exit = DatumGetInt64(rows.exit.values[i]);
    request.turn = word_of<Turn>(text_of(rows.turn.values[i]), "turn of a movement",
                                 {{"through", Turn::through},
                                  {"left", Turn::left},
                                  {"right", Turn::right},
                                  {"u_turn", Turn::u_turn}});
    request.length = DatumGetFloat8(rows.length.values[i]);
    request.speed = DatumGetFloat8(rows.speed.values[i]);
    request.lanes = DatumGetInt32(rows.lanes.values[i]);
    request.importance = DatumGetInt32(rows.importance.values[i]);
    if (!rows.flow.nulls[i]) request.flow = DatumGetFloat8(rows.flow.values[i]);
    if (!rows.walk_in.nulls[i]) request.walk_in = DatumGetFloat8(rows.walk_in.values[i]);
    if (!rows.walk_out.nulls[i]) request.walk_out = DatumGetFloat8(rows.walk_out.values[i]);
    for (int k = 0; k < rows.conflicts[i].count; ++k)
      request.conflicts.push_back(DatumGetInt32(rows.conflicts[i].values[k]) - 1);
    requests.push_back(std::move(request));
  }
  return requests;
}

const char* kind_name(SignalKind kind) {
  return kind == SignalKind::green ? "green" : kind == SignalKind::amber ? "amber" : "all_red";
}

// ordinality, duration, kind, lane_in, lane_out, along_in, along_out, right_of_way
void give(const std::vector<SignalState>& states, const RequestRows& rows, ReturnSetInfo* result) {
  for (std::size_t s = 0; s < states.size(); ++s) {
    Datum values[8] = {Int32GetDatum(static_cast<int32>(s + 1)), Float8GetDatum(states[s].duration),
                       CStringGetTextDatum(kind_name(states[s].kind))};
    bool nulls[8] = {false, false, false, true, true, true, true, true};
    if (states[s].greens.empty())
      tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
    for (const SignalState::Green& green : states[s].greens) {
      const int i = green.movement;
      const Datum movement[5] = {
          rows.lane_in.values[i], rows.lane_out.values[i], rows.along_in.values[i],
          rows.along_out.values[i],
          CStringGetTextDatum(green.right_of_way == RightOfWay::permit ? "permitted"
                                                                       : "protected")};
      for (int k = 0; k < 5; ++k) {
        values[3 + k] = movement[k];
        nulls[3 + k] = false;
      }
      tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
    }
  }
}

Datum answer(FunctionCallInfo fcinfo,
             std::vector<SignalState> (*program)(const std::vector<SignalRequest>&)) {
  InitMaterializedSRF(fcinfo, 0);
  const RequestRows rows = take_requests(fcinfo);
  Slot<std::vector<SignalState>>* slot = make_slot<std::vector<SignalState>>(CurrentMemoryContext);
  report(
      compute([&] { slot->value = new std::vector<SignalState>(program(read_requests(rows))); }));
  give(*slot->value, rows, reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo));
  PG_RETURN_NULL();
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_signal_phases) {
  return streetgen::pg::answer(fcinfo, streetgen::signal_phases);
}

STREETGEN_FUNCTION(streetgen_signal_pairs) {
  return streetgen::pg::answer(fcinfo, streetgen::signal_pairs);
}
