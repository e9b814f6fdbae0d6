// streetgen._profiles: heights along edges that pass over and under each other.
#include "streetgen/profile.hpp"

#include <string>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "value/line_array.hpp"
#include "value/value_array.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <funcapi.h>
#include <utils/builtins.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {
namespace {

struct ProfilesCall {
  LineArray lines;
  ValueArray from_nodes, to_nodes, grades, radii;
  ValueArray greatest, rises, ends_from, ends_to;
  ValueArray above, at_above, below, at_below, clearances, sinks;
  ValueArray by_hand, at_hand, heights;
  ProfileRules rules;
  int srid;
};

ProfilesCall take(FunctionCallInfo fcinfo) {
  ProfilesCall call;
  call.lines = take_lines(PG_GETARG_ARRAYTYPE_P(0), "lines");
  const int edges = call.lines.count;
  call.from_nodes = take_values(fcinfo, 1, INT8OID, edges, "from_nodes");
  call.to_nodes = take_values(fcinfo, 2, INT8OID, edges, "to_nodes");
  call.grades = take_values(fcinfo, 3, FLOAT8OID, edges, "grades");
  call.radii = take_values(fcinfo, 4, FLOAT8OID, edges, "radii");
  call.greatest = take_values(fcinfo, 5, FLOAT8OID, edges, "grades_greatest");
  call.rises = take_values(fcinfo, 6, FLOAT8OID, edges, "rises");
  call.ends_from = take_values(fcinfo, 7, BOOLOID, edges, "ends_from");
  call.ends_to = take_values(fcinfo, 8, BOOLOID, edges, "ends_to");
  call.above = take_values(fcinfo, 9, INT4OID, any_count, "above");
  const int lifts = call.above.count;
  call.at_above = take_values(fcinfo, 10, FLOAT8OID, lifts, "at_above");
  call.below = take_values(fcinfo, 11, INT4OID, lifts, "below");
  call.at_below = take_values(fcinfo, 12, FLOAT8OID, lifts, "at_below");
  call.clearances = take_values(fcinfo, 13, FLOAT8OID, lifts, "clearances");
  call.sinks = take_values(fcinfo, 14, BOOLOID, lifts, "sinks");
  call.by_hand = take_values(fcinfo, 15, INT4OID, any_count, "by_hand");
  const int heights = call.by_hand.count;
  call.at_hand = take_values(fcinfo, 16, FLOAT8OID, heights, "at_hand");
  call.heights = take_values(fcinfo, 17, FLOAT8OID, heights, "heights");
  call.rules = {PG_GETARG_FLOAT8(18), PG_GETARG_FLOAT8(19)};
  call.srid = PG_GETARG_INT32(20);
  return call;
}

std::vector<ProfileEdge> edges_of(const ProfilesCall& call) {
  std::vector<ProfileEdge> edges;
  for (Line& line : read_lines(call.lines, "line", nullptr)) {
    const std::size_t i = edges.size();
    edges.push_back({DatumGetInt64(call.from_nodes.values[i]),
                     DatumGetInt64(call.to_nodes.values[i]), std::move(line),
                     in_range(DatumGetFloat8(call.grades.values[i]), 1e-6, 10, "grade"),
                     in_range(DatumGetFloat8(call.radii.values[i]), 0, 1e9, "radius"),
                     in_range(DatumGetFloat8(call.greatest.values[i]), 0, 10, "grade_greatest"),
                     in_range(DatumGetFloat8(call.rises.values[i]), -1000, 1000, "rise"),
                     DatumGetBool(call.ends_from.values[i]), DatumGetBool(call.ends_to.values[i])});
  }
  return edges;
}

// An edge by its number from 1.
int edge_of(Datum number, int count, const char* name) {
  return static_cast<int>(in_range(DatumGetInt32(number), 1, count, name)) - 1;
}

std::vector<ProfileLift> lifts_of(const ProfilesCall& call) {
  std::vector<ProfileLift> lifts;
  for (int i = 0; i < call.above.count; ++i)
    lifts.push_back({edge_of(call.above.values[i], call.lines.count, "above"),
                     finite(DatumGetFloat8(call.at_above.values[i]), "at_above"),
                     edge_of(call.below.values[i], call.lines.count, "below"),
                     finite(DatumGetFloat8(call.at_below.values[i]), "at_below"),
                     in_range(DatumGetFloat8(call.clearances.values[i]), 0, 1000, "clearance"),
                     DatumGetBool(call.sinks.values[i])});
  return lifts;
}

std::vector<ProfileHeight> heights_of(const ProfilesCall& call) {
  std::vector<ProfileHeight> heights;
  for (int i = 0; i < call.by_hand.count; ++i)
    heights.push_back({edge_of(call.by_hand.values[i], call.lines.count, "by_hand"),
                       finite(DatumGetFloat8(call.at_hand.values[i]), "at_hand"),
                       finite(DatumGetFloat8(call.heights.values[i]), "heights")});
  return heights;
}

ProfileRules rules_of(const ProfilesCall& call) {
  return {in_range(call.rules.level_length, 0, 1e9, "level_length"),
          in_range(call.rules.plateau, 0, 1e9, "plateau")};
}

const char* profile_method_name(ProfileMethod method) {
  switch (method) {
    case ProfileMethod::ground:
      return "ground";
    case ProfileMethod::lifted:
      return "lifted";
    case ProfileMethod::sunk:
      return "sunk";
  }
  return "";
}

struct Written {
  std::string line;
  double grade;
  const char* method;
  bool tied_from, tied_to;
};

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_profiles) {
  using namespace streetgen;
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, 0);
  const ProfilesCall call = take(fcinfo);
  Slot<std::vector<Written>>* slot = make_slot<std::vector<Written>>(CurrentMemoryContext);
  report(compute([&] {
    slot->value = new std::vector<Written>;
    for (const Profile& profile :
         profiles(edges_of(call), lifts_of(call), heights_of(call), rules_of(call)).edges)
      slot->value->push_back({write_line(profile.line, {call.srid, true}), profile.grade,
                              profile_method_name(profile.method), profile.tied_from,
                              profile.tied_to});
  }));
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  int number = 0;
  for (const Written& written : *slot->value) {
    Datum values[6] = {Int32GetDatum(++number),         bytes_datum(written.line),
                       Float8GetDatum(written.grade),   CStringGetTextDatum(written.method),
                       BoolGetDatum(written.tied_from), BoolGetDatum(written.tied_to)};
    bool nulls[6] = {};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
    pfree(DatumGetPointer(values[1]));
  }
  PG_RETURN_NULL();
}
