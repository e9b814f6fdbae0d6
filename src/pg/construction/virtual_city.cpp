// streetgen._virtual_city and streetgen._two_towns: axes to order, a row each; options and density.
#include "streetgen/virtual_city.hpp"

#include <string>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "streetgen/two_towns.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <funcapi.h>
#include <utils/array.h>
#include <utils/builtins.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {
namespace {

// Options as they come: of each number the name of its option, those of one option in order.
struct OptionValues {
  int count;
  Datum* names;
  Datum* values;
};

OptionValues take_options(FunctionCallInfo fcinfo, int argument) {
  OptionValues options;
  int values;
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(argument), TEXTOID, -1, false, 'i', &options.names,
                    nullptr, &options.count);
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(argument + 1), FLOAT8OID, 8, true, 'd', &options.values,
                    nullptr, &values);
  if (values != options.count)
    ereport(ERROR, (errcode(ERRCODE_ARRAY_SUBSCRIPT_ERROR),
                    errmsg("%d values for %d names", values, options.count)));
  for (int i = 0; i < options.count; ++i)
    options.names[i] = PointerGetDatum(PG_DETOAST_DATUM_PACKED(options.names[i]));
  return options;
}

template <class Options>
Options read_options(const OptionValues& given, const std::vector<NumberOption<Options>>& known) {
  Options options;
  for (int i = 0; i < given.count;) {
    const std::string name = text_of(given.names[i]);
    std::vector<double> values;
    for (; i < given.count && text_of(given.names[i]) == name; ++i)
      values.push_back(DatumGetFloat8(given.values[i]));
    set_option(known, options, name, values);
  }
  return options;
}

CityOptions read_city_options(const OptionValues& given) {
  return read_options(given, city_options());
}

CityExtent take_extent(FunctionCallInfo fcinfo, int argument) {
  return {PG_GETARG_FLOAT8(argument), PG_GETARG_FLOAT8(argument + 1),
          PG_GETARG_FLOAT8(argument + 2), PG_GETARG_FLOAT8(argument + 3)};
}

const char* direction_name(CityDirection direction) {
  return direction == CityDirection::both     ? "both"
         : direction == CityDirection::direct ? "direct"
                                              : "reverse";
}

// The columns that only an axis of two towns has; a virtual city leaves them empty.
struct TownColumns {
  const char* kind = nullptr;
  bool bridge = false;
  bool built_up = false;
};
TownColumns town_columns(const CityAxis&) { return {}; }
TownColumns town_columns(const TownAxis& axis) {
  return {axis.kind.c_str(), axis.bridge, axis.built_up};
}

template <class Axis>
struct Axes {
  std::vector<Axis> axes;
  std::string line;  // of the axis that is being given
};

// A row for each axis that `draw` gives.
template <class Axis, class Draw>
void give_axes(FunctionCallInfo fcinfo, int srid, Draw draw) {
  InitMaterializedSRF(fcinfo, 0);
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  Slot<Axes<Axis>>* drawn = make_slot<Axes<Axis>>(CurrentMemoryContext);
  report(compute([&] {
    drawn->value = new Axes<Axis>;
    drawn->value->axes = draw();
  }));
  MemoryContext row = AllocSetContextCreate(CurrentMemoryContext, "axis", ALLOCSET_DEFAULT_SIZES);
  for (std::size_t i = 0; i < drawn->value->axes.size(); ++i) {
    CHECK_FOR_INTERRUPTS();
    const Axis& axis = drawn->value->axes[i];
    const TownColumns town = town_columns(axis);
    report(compute([&] { drawn->value->line = write_line(axis.line, {srid, false}); }));
    MemoryContextReset(row);
    MemoryContext before = MemoryContextSwitchTo(row);
    Datum values[10] = {bytes_datum(drawn->value->line),
                        Float8GetDatum(axis.width),
                        Int32GetDatum(axis.lane_count),
                        Int32GetDatum(axis.importance),
                        CStringGetTextDatum(axis.name.c_str()),
                        CStringGetTextDatum(direction_name(axis.direction)),
                        Float8GetDatum(axis.speed),
                        town.kind == nullptr ? Datum(0) : CStringGetTextDatum(town.kind),
                        BoolGetDatum(town.bridge),
                        BoolGetDatum(town.built_up)};
    bool nulls[10] = {};
    nulls[7] = town.kind == nullptr;
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
    MemoryContextSwitchTo(before);
  }
}

// A row for each option with its default.
template <class Options>
void give_options(FunctionCallInfo fcinfo, const std::vector<NumberOption<Options>>& (*list)()) {
  InitMaterializedSRF(fcinfo, 0);
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  struct Row {
    const NumberOption<Options>* option;
    std::vector<double> value;
  };
  Slot<std::vector<Row>>* rows = make_slot<std::vector<Row>>(CurrentMemoryContext);
  report(compute([&] {
    rows->value = new std::vector<Row>;
    for (const NumberOption<Options>& option : list())
      rows->value->push_back({&option, option.of(Options{})});
  }));
  for (std::size_t i = 0; i < rows->value->size(); ++i) {
    const NumberOption<Options>& option = *(*rows->value)[i].option;
    const std::vector<double>& value = (*rows->value)[i].value;
    auto* numbers = static_cast<Datum*>(palloc(value.size() * sizeof(Datum)));
    for (std::size_t k = 0; k < value.size(); ++k) numbers[k] = Float8GetDatum(value[k]);
    Datum values[6] = {CStringGetTextDatum(option.name),
                       PointerGetDatum(construct_array(numbers, static_cast<int>(value.size()),
                                                       FLOAT8OID, 8, true, 'd')),
                       CStringGetTextDatum(option.unit),
                       CStringGetTextDatum(option.description),
                       Float8GetDatum(option.range.low),
                       Float8GetDatum(option.range.high)};
    bool nulls[6] = {false, false, option.unit[0] == '\0', false, false, false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
}

}  // namespace
}  // namespace streetgen::pg

using namespace streetgen;
using namespace streetgen::pg;

STREETGEN_FUNCTION(streetgen_virtual_city) {
  const CityExtent extent = take_extent(fcinfo, 1);
  const int64 seed = PG_GETARG_INT64(5);
  const OptionValues given = take_options(fcinfo, 6);
  give_axes<CityAxis>(fcinfo, PG_GETARG_INT32(0),
                      [&] { return virtual_city(extent, seed, read_city_options(given)); });
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_two_towns) {
  const double x = PG_GETARG_FLOAT8(1), y = PG_GETARG_FLOAT8(2);
  const int64 seed = PG_GETARG_INT64(3);
  const bool keeps_left = PG_GETARG_BOOL(4);
  const OptionValues given = take_options(fcinfo, 5);
  give_axes<TownAxis>(fcinfo, PG_GETARG_INT32(0), [&] {
    return two_towns(x, y, seed, keeps_left, read_options(given, two_towns_options()));
  });
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_city_density) {
  const Point at{PG_GETARG_FLOAT8(0), PG_GETARG_FLOAT8(1), 0};
  const CityExtent extent = take_extent(fcinfo, 2);
  const OptionValues given = take_options(fcinfo, 6);
  double density = 0;
  report(compute([&] {
    in_range(extent.width, 1e-3, 1e6, "width");
    in_range(extent.height, 1e-3, 1e6, "height");
    finite(at.x - extent.x, "x");
    finite(at.y - extent.y, "y");
    density = city_density(at, extent, read_city_options(given));
  }));
  PG_RETURN_FLOAT8(density);
}

STREETGEN_FUNCTION(streetgen_city_options) {
  give_options(fcinfo, city_options);
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_two_towns_options) {
  give_options(fcinfo, two_towns_options);
  PG_RETURN_NULL();
}
