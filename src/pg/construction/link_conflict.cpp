// streetgen._link_conflicts: which movements of a junction need the same ground, and who gives way.
#include "streetgen/link_conflict.hpp"

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "value/given_rows.hpp"
#include "value/value_array.hpp"

extern "C" {
#include <utils/builtins.h>
}

namespace {

using namespace streetgen;
using namespace streetgen::pg;

struct GivenMovements {
  ValueArray junctions, lanes_in, lanes_out, along_in, along_out;
  ValueArray lengths, widths, turns, ranks, importances, precedences;
  ValueArray protected_states, permitted_states, pieces;
  ValueArray s, x, y, heading, curvature;
};

GivenMovements take_movements(FunctionCallInfo fcinfo) {
  GivenMovements given;
  given.junctions = take_values(fcinfo, 0, INT8OID, any_count, "junctions");
  const int count = given.junctions.count;
  given.lanes_in = take_values(fcinfo, 1, INT8OID, count, "lanes_in");
  given.lanes_out = take_values(fcinfo, 2, INT8OID, count, "lanes_out");
  given.along_in = take_values(fcinfo, 3, BOOLOID, count, "along_in");
  given.along_out = take_values(fcinfo, 4, BOOLOID, count, "along_out");
  given.lengths = take_values(fcinfo, 5, FLOAT8OID, count, "lengths");
  given.widths = take_values(fcinfo, 6, FLOAT8OID, count, "widths");
  given.turns = take_values(fcinfo, 7, INT4OID, count, "turns");
  given.ranks = take_values(fcinfo, 8, INT4OID, count, "ranks");
  given.importances = take_values(fcinfo, 9, INT4OID, count, "importances");
  given.precedences = take_values(fcinfo, 10, INT4OID, count, "precedences");
  given.protected_states = take_values(fcinfo, 11, INT8OID, count, "protected_states");
  given.permitted_states = take_values(fcinfo, 12, INT8OID, count, "permitted_states");
  given.pieces = take_values(fcinfo, 13, INT4OID, count, "pieces");
  given.s = take_values(fcinfo, 14, FLOAT8OID, any_count, "s");
  given.x = take_values(fcinfo, 15, FLOAT8OID, given.s.count, "x");
  given.y = take_values(fcinfo, 16, FLOAT8OID, given.s.count, "y");
  given.heading = take_values(fcinfo, 17, FLOAT8OID, given.s.count, "heading");
  given.curvature = take_values(fcinfo, 18, FLOAT8OID, given.s.count, "curvature");
  return given;
}

Turn turn_of(int number) {
  constexpr Turn turns[] = {Turn::through, Turn::left, Turn::right, Turn::u_turn};
  return turns[static_cast<int>(in_range(number, 0, 3, "turns"))];
}

std::vector<ConflictMovement> movements_of(const GivenMovements& given) {
  std::vector<ConflictMovement> movements(given.junctions.count);
  int piece = 0;
  for (int i = 0; i < given.junctions.count; ++i) {
    ConflictMovement& m = movements[i];
    m.junction = DatumGetInt64(given.junctions.values[i]);
    m.lane_in = DatumGetInt64(given.lanes_in.values[i]);
    m.lane_out = DatumGetInt64(given.lanes_out.values[i]);
    m.along_in = DatumGetBool(given.along_in.values[i]);
    m.along_out = DatumGetBool(given.along_out.values[i]);
    m.length = DatumGetFloat8(given.lengths.values[i]);
    m.width = DatumGetFloat8(given.widths.values[i]);
    m.turn = turn_of(DatumGetInt32(given.turns.values[i]));
    m.rank = DatumGetInt32(given.ranks.values[i]);
    m.importance = DatumGetInt32(given.importances.values[i]);
    m.precedence = DatumGetInt32(given.precedences.values[i]);
    m.protected_states =
        static_cast<std::uint64_t>(DatumGetInt64(given.protected_states.values[i]));
    m.permitted_states =
        static_cast<std::uint64_t>(DatumGetInt64(given.permitted_states.values[i]));
    const int count = static_cast<int>(
        in_range(DatumGetInt32(given.pieces.values[i]), 0, given.s.count - piece, "pieces"));
    for (const int end = piece + count; piece < end; ++piece)
      m.course.push_back(
          {DatumGetFloat8(given.s.values[piece]), DatumGetFloat8(given.x.values[piece]),
           DatumGetFloat8(given.y.values[piece]), DatumGetFloat8(given.heading.values[piece]),
           DatumGetFloat8(given.curvature.values[piece])});
  }
  return movements;
}

const char* word_of(ConflictKind kind) {
  return kind == ConflictKind::crossing  ? "crossing"
         : kind == ConflictKind::merging ? "merging"
                                         : "opposing";
}

const char* word_of(Precedence precedence) {
  switch (precedence) {
    case Precedence::goes_first:
      return "goes_first";
    case Precedence::gives_way:
      return "gives_way";
    case Precedence::by_signal:
      return "by_signal";
    default:
      return "by_arrival";
  }
}

}  // namespace

STREETGEN_FUNCTION(streetgen_link_conflicts) {
  InitMaterializedSRF(fcinfo, 0);
  const GivenMovements given = take_movements(fcinfo);
  const bool left_hand = PG_GETARG_BOOL(19);
  Slot<std::vector<MovementConflict>>* slot =
      make_slot<std::vector<MovementConflict>>(CurrentMemoryContext);
  report(compute([&] {
    slot->value = new std::vector<MovementConflict>(link_conflicts(movements_of(given), left_hand));
  }));
  put_rows(fcinfo, *slot->value, [&](const MovementConflict& found, ReturnSetInfo* result) {
    Datum values[8] = {
        Int32GetDatum(found.first + 1),           Int32GetDatum(found.second + 1),
        CStringGetTextDatum(word_of(found.kind)), CStringGetTextDatum(word_of(found.precedence)),
        Float8GetDatum(found.first_from),         Float8GetDatum(found.first_to),
        Float8GetDatum(found.second_from),        Float8GetDatum(found.second_to)};
    bool nulls[8] = {};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  });
  PG_RETURN_NULL();
}
