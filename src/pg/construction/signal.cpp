// streetgen.signal_phases and streetgen.signal_pairs: the states of a signal program; and the times
// between greens.
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
  Column importance, flow, precedence;
  Numbers *conflicts, *reaches, *walks, *walk_seconds, *walk_reaches;
};

// An array of each row; NULL: none. `size` and `by_value` are those of the type of its elements.
Numbers* arrays(const Rows& rows, const char* name, Oid array_type, Oid type, int size) {
  const Column column = column_or_null(rows, name, array_type);
  Numbers* taken = static_cast<Numbers*>(palloc0(sizeof(Numbers) * Max(rows.count, 1)));
  for (int row = 0; row < rows.count; ++row) {
    if (column.nulls[row]) continue;
    ArrayType* array = DatumGetArrayTypeP(column.values[row]);
    if (array_contains_nulls(array))
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED),
                      errmsg("one of the %s is NULL in row %d of the movements", name, row + 1)));
    deconstruct_array(array, type, size, true, size == 8 ? TYPALIGN_DOUBLE : TYPALIGN_INT,
                      &taken[row].values, nullptr, &taken[row].count);
  }
  return taken;
}

// Arrays beside each other have one length.
void require_as_many(const Numbers* a, const Numbers* b, int count, const char* what) {
  for (int row = 0; row < count; ++row)
    if (b[row].count != a[row].count && b[row].count != 0)
      ereport(ERROR, (errcode(ERRCODE_INVALID_PARAMETER_VALUE),
                      errmsg("row %d of the movements has %d %s and %d numbers beside them",
                             row + 1, a[row].count, what, b[row].count)));
}

RequestRows take_requests(FunctionCallInfo fcinfo) {
  const Rows requests = rows(fcinfo, 0, "movements");
  const auto numbers = [&](const char* name) {
    return arrays(requests, name, INT4ARRAYOID, INT4OID, sizeof(int32));
  };
  const auto metres = [&](const char* name) {
    return arrays(requests, name, FLOAT8ARRAYOID, FLOAT8OID, sizeof(float8));
  };
  const RequestRows taken = {requests.count,
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
                             column_or_null(requests, "precedence", INT4OID),
                             numbers("conflicts"),
                             metres("reaches"),
                             numbers("walks"),
                             metres("walk_seconds"),
                             metres("walk_reaches")};
  require_as_many(taken.conflicts, taken.reaches, taken.count, "conflicts");
  require_as_many(taken.walks, taken.walk_seconds, taken.count, "walks");
  require_as_many(taken.walks, taken.walk_reaches, taken.count, "walks");
  return taken;
}

double number_beside(const Numbers& numbers, int k, double otherwise) {
  return k < numbers.count ? DatumGetFloat8(numbers.values[k]) : otherwise;
}

SignalRequest::Turn turn_of(const RequestRows& rows, int i) {
  using Turn = SignalRequest::Turn;
  return word_of<Turn>(text_of(rows.turn.values[i]), "turn of a movement",
                       {{"through", Turn::through},
                        {"left", Turn::left},
                        {"right", Turn::right},
                        {"u_turn", Turn::u_turn}});
}

// Who says nothing of where it meets others may meet them anywhere.
void read_meetings(const RequestRows& rows, int i, SignalRequest& request) {
  for (int k = 0; k < rows.conflicts[i].count; ++k)
    request.conflicts.push_back({DatumGetInt32(rows.conflicts[i].values[k]) - 1,
                                 number_beside(rows.reaches[i], k, request.length)});
  for (int k = 0; k < rows.walks[i].count; ++k)
    request.walks.push_back({DatumGetInt32(rows.walks[i].values[k]) - 1,
                             number_beside(rows.walk_seconds[i], k, 0),
                             number_beside(rows.walk_reaches[i], k, request.length)});
}

std::vector<SignalRequest> read_requests(const RequestRows& rows) {
  std::vector<SignalRequest> requests;
  for (int i = 0; i < rows.count; ++i) {
    SignalRequest request;
    request.approach = DatumGetInt64(rows.approach.values[i]);
    request.exit = DatumGetInt64(rows.exit.values[i]);
    request.lane = DatumGetInt64(rows.lane_in.values[i]);
    request.turn = turn_of(rows, i);
    request.length = DatumGetFloat8(rows.length.values[i]);
    request.speed = DatumGetFloat8(rows.speed.values[i]);
    request.lanes = DatumGetInt32(rows.lanes.values[i]);
    request.importance = DatumGetInt32(rows.importance.values[i]);
    if (!rows.flow.nulls[i]) request.flow = DatumGetFloat8(rows.flow.values[i]);
    request.precedence = rows.precedence.nulls[i] ? i : DatumGetInt32(rows.precedence.values[i]);
    read_meetings(rows, i, request);
    requests.push_back(std::move(request));
  }
  return requests;
}

// cycle, all_red, step, walk, importance, turn_phases: arguments 1 to 6; NULL turn_phases: by lanes
// and speed.
SignalRules read_rules(FunctionCallInfo fcinfo) {
  SignalRules rules;
  rules.longest_cycle = PG_GETARG_FLOAT8(1);
  rules.longest_all_red = PG_GETARG_FLOAT8(2);
  rules.step = PG_GETARG_FLOAT8(3);
  rules.shortest_walk = PG_GETARG_FLOAT8(4);
  rules.least_importance = PG_GETARG_INT32(5);
  if (!PG_ARGISNULL(6)) rules.turn_phases = PG_GETARG_BOOL(6);
  return rules;
}

const char* kind_name(SignalKind kind) {
  switch (kind) {
    case SignalKind::green:
      return "green";
    case SignalKind::amber:
      return "amber";
    case SignalKind::all_red:
      return "all_red";
    case SignalKind::walk:
      return "walk";
  }
  return "";
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

// ends, begins, ends_on_foot, begins_on_foot, seconds
void give(const std::vector<Intergreen>& intergreens, const RequestRows&, ReturnSetInfo* result) {
  for (const Intergreen& i : intergreens) {
    Datum values[5] = {Int32GetDatum(i.ends + 1), Int32GetDatum(i.begins + 1),
                       BoolGetDatum(i.ends_on_foot), BoolGetDatum(i.begins_on_foot),
                       Float8GetDatum(i.seconds)};
    bool nulls[5] = {};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
}

void require_rules(FunctionCallInfo fcinfo) {
  for (int i = 1; i <= 5; ++i)
    if (PG_ARGISNULL(i))
      ereport(ERROR,
              (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED),
               errmsg("cycle, all_red, step, walk or importance of a signal program is NULL")));
}

template <typename Row>
Datum answer(FunctionCallInfo fcinfo,
             std::vector<Row> (*program)(const std::vector<SignalRequest>&, const SignalRules&)) {
  InitMaterializedSRF(fcinfo, 0);
  if (PG_ARGISNULL(0)) PG_RETURN_NULL();
  require_rules(fcinfo);
  const RequestRows rows = take_requests(fcinfo);
  const SignalRules rules = read_rules(fcinfo);
  Slot<std::vector<Row>>* slot = make_slot<std::vector<Row>>(CurrentMemoryContext);
  report(compute([&] { slot->value = new std::vector<Row>(program(read_requests(rows), rules)); }));
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

STREETGEN_FUNCTION(streetgen_intergreens) {
  return streetgen::pg::answer(fcinfo, streetgen::intergreens);
}
