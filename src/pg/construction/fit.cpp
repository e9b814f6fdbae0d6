// streetgen._fit_streets, streetgen._taken_observations: streets fitted to observations.
#include "streetgen/fit.hpp"

#include <cmath>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "value/given_rows.hpp"
#include "value/line_array.hpp"
#include "value/value_array.hpp"

extern "C" {
#include <utils/builtins.h>
}

namespace {

using namespace streetgen;
using namespace streetgen::pg;

struct GivenFit {
  LineArray lines;
  ValueArray widths, lanes, moves;
  ValueArray stretch_axes, stretches, nodes;
  ValueArray kinds, relations, x, y, confidence, weight, width;
  ValueArray rules;
  std::string_view loss;
};

constexpr int numbers_of_axis = 5;     // width, width_end, offset, sidewalks left and right
constexpr int numbers_of_stretch = 4;  // start, end, from, to
constexpr int numbers_of_rules = 17;   // in the order of rules_of

GivenFit take_fit(FunctionCallInfo fcinfo) {
  GivenFit given;
  given.lines = take_lines(PG_GETARG_ARRAYTYPE_P(0), "lines");
  given.widths = take_values(fcinfo, 1, FLOAT8OID, numbers_of_axis * given.lines.count, "widths");
  given.lanes = take_values(fcinfo, 2, INT4OID, given.lines.count, "lanes");
  given.moves = take_values(fcinfo, 3, BOOLOID, given.lines.count, "moves");
  given.stretch_axes = take_values(fcinfo, 4, INT4OID, any_count, "stretch_axes");
  given.stretches =
      take_values(fcinfo, 5, FLOAT8OID, numbers_of_stretch * given.stretch_axes.count, "stretches");
  given.nodes = take_values(fcinfo, 6, INT8OID, 2 * given.stretch_axes.count, "nodes");
  given.kinds = take_values(fcinfo, 7, INT4OID, any_count, "kinds");
  given.relations = take_values(fcinfo, 8, INT4OID, given.kinds.count, "relations");
  given.x = take_values(fcinfo, 9, FLOAT8OID, given.kinds.count, "x");
  given.y = take_values(fcinfo, 10, FLOAT8OID, given.kinds.count, "y");
  given.confidence = take_values(fcinfo, 11, FLOAT8OID, given.kinds.count, "confidence");
  given.weight = take_values(fcinfo, 12, FLOAT8OID, given.kinds.count, "weight");
  given.width = take_values(fcinfo, 13, FLOAT8OID, given.kinds.count, "width");
  given.rules = take_values(fcinfo, 14, FLOAT8OID, numbers_of_rules, "rules");
  given.loss = bytes_of(PG_GETARG_DATUM(15));
  return given;
}

std::vector<FitAxis> axes_of(const GivenFit& given, Form* form) {
  std::vector<FitAxis> axes;
  for (Line& line : read_lines(given.lines, "axis", form)) {
    const Datum* numbers = given.widths.values + numbers_of_axis * axes.size();
    FitAxis axis;
    axis.width_start = DatumGetFloat8(numbers[0]);
    axis.width_end = DatumGetFloat8(numbers[1]);
    axis.roadway_offset = DatumGetFloat8(numbers[2]);
    axis.sidewalk_left = DatumGetFloat8(numbers[3]);
    axis.sidewalk_right = DatumGetFloat8(numbers[4]);
    axis.lanes = std::max(1, DatumGetInt32(given.lanes.values[axes.size()]));
    axis.moves = DatumGetBool(given.moves.values[axes.size()]);
    axis.line = std::move(line);
    axes.push_back(std::move(axis));
  }
  for (int i = 0; i < given.stretch_axes.count; ++i) {
    const int axis = DatumGetInt32(given.stretch_axes.values[i]) - 1;
    if (axis < 0 || axis >= given.lines.count)
      throw Error(ErrorKind::invalid_input, "a stretch is of no axis");
    const Datum* metres = given.stretches.values + numbers_of_stretch * i;
    axes[axis].stretches.push_back({DatumGetFloat8(metres[0]), DatumGetFloat8(metres[1]),
                                    DatumGetFloat8(metres[2]), DatumGetFloat8(metres[3]),
                                    DatumGetInt64(given.nodes.values[2 * i]),
                                    DatumGetInt64(given.nodes.values[2 * i + 1])});
  }
  return axes;
}

std::vector<Observation> observations_of(const GivenFit& given) {
  std::vector<Observation> observations;
  observations.reserve(given.kinds.count);
  for (int i = 0; i < given.kinds.count; ++i) {
    const auto number = [&](const ValueArray& array) { return DatumGetFloat8(array.values[i]); };
    Observation one;
    one.place = {number(given.x), number(given.y), 0};
    one.kind = static_cast<ObservationKind>(DatumGetInt32(given.kinds.values[i]));
    one.relation = static_cast<ObservationRelation>(DatumGetInt32(given.relations.values[i]));
    one.confidence = number(given.confidence);
    one.weight = number(given.weight);
    one.width = number(given.width);
    observations.push_back(one);
  }
  return observations;
}

FitRules rules_of(const GivenFit& given) {
  const auto number = [&](int i) { return DatumGetFloat8(given.rules.values[i]); };
  FitRules rules;
  rules.axes_move = number(0) != 0;
  rules.scale = number(1);
  rules.observation = number(2);
  rules.observed_width = number(3);
  rules.object = number(4);
  rules.width = number(5);
  rules.origin = number(6);
  rules.spacing = number(7);
  rules.angle = number(8);
  rules.reach = number(9);
  rules.width_change = number(10);
  rules.move = number(11);
  rules.width_least = number(12);
  rules.width_greatest = number(13);
  rules.piece = number(14);
  rules.object_margin = number(15);
  rules.iterations = static_cast<int>(number(16));
  rules.loss = word_of<FitLoss>(
      std::string(given.loss), "fit_loss",
      {{"cauchy", FitLoss::cauchy}, {"soft_l1", FitLoss::soft_l1}, {"squares", FitLoss::squares}});
  return rules;
}

void put_number(double value, Datum& datum, bool& null) {
  null = std::isnan(value);
  datum = Float8GetDatum(value);
}

const char* fate_name(ObservationFate fate) {
  switch (fate) {
    case ObservationFate::taken:
      return "taken";
    case ObservationFate::at_junction:
      return "at junction";
    case ObservationFate::not_sure:
      return "not sure";
    case ObservationFate::no_street:
      break;
  }
  return "no street";
}

}  // namespace

STREETGEN_FUNCTION(streetgen_fit_streets) {
  InitMaterializedSRF(fcinfo, 0);
  const GivenFit given = take_fit(fcinfo);
  Form form;
  Slot<Fitted>* slot = make_slot<Fitted>(CurrentMemoryContext);
  report(compute([&] {
    slot->value =
        new Fitted(fit_streets(axes_of(given, &form), observations_of(given), rules_of(given)));
  }));
  const Fitted& fitted = *slot->value;
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  {
    Datum values[13] = {Int32GetDatum(0)};
    bool nulls[13] = {};
    for (int i = 1; i < 7; ++i) nulls[i] = true;
    values[7] = Int32GetDatum(fitted.used);
    put_number(fitted.before.mean, values[8], nulls[8]);
    put_number(fitted.after.mean, values[9], nulls[9]);
    put_number(fitted.before.median, values[10], nulls[10]);
    put_number(fitted.after.median, values[11], nulls[11]);
    values[12] = Int32GetDatum(fitted.iterations);
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
  int number = 0;
  put_rows(fcinfo, fitted.axes, [&](const FittedAxis& axis, ReturnSetInfo* rows) {
    Datum values[13] = {Int32GetDatum(++number),
                        line_datum(axis.line, form),
                        Float8GetDatum(axis.width_start),
                        Float8GetDatum(axis.width_end),
                        Float8GetDatum(axis.roadway_offset),
                        Float8GetDatum(axis.sidewalk_left),
                        Float8GetDatum(axis.sidewalk_right),
                        Int32GetDatum(axis.used)};
    bool nulls[13] = {};
    put_number(axis.before, values[8], nulls[8]);
    put_number(axis.after, values[9], nulls[9]);
    nulls[10] = nulls[11] = nulls[12] = true;
    tuplestore_putvalues(rows->setResult, rows->setDesc, values, nulls);
  });
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_taken_observations) {
  InitMaterializedSRF(fcinfo, 0);
  const GivenFit given = take_fit(fcinfo);
  Slot<std::vector<TakenObservation>>* slot =
      make_slot<std::vector<TakenObservation>>(CurrentMemoryContext);
  report(compute([&] {
    slot->value = new std::vector<TakenObservation>(
        taken_observations(axes_of(given, nullptr), observations_of(given), rules_of(given)));
  }));
  int number = 0;
  put_rows(fcinfo, *slot->value, [&](const TakenObservation& one, ReturnSetInfo* rows) {
    const bool none = one.fate != ObservationFate::taken;
    Datum values[7] = {
        Int32GetDatum(++number),      PointerGetDatum(cstring_to_text(fate_name(one.fate))),
        Int32GetDatum(one.axis + 1),  Int32GetDatum(one.stretch + 1),
        Float8GetDatum(one.abscissa), Float8GetDatum(one.offset),
        Float8GetDatum(one.off)};
    bool nulls[7] = {false, false, none, none, none, none, none};
    tuplestore_putvalues(rows->setResult, rows->setDesc, values, nulls);
  });
  PG_RETURN_NULL();
}
