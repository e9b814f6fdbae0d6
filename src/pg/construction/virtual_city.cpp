// streetgen._virtual_city: the axes of a virtual city, a row each; its options and its density.
#include "streetgen/virtual_city.hpp"

#include <string>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
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

CityOptions read_options(const OptionValues& given) {
  CityOptions options;
  for (int i = 0; i < given.count;) {
    const std::string name = text_of(given.names[i]);
    std::vector<double> values;
    for (; i < given.count && text_of(given.names[i]) == name; ++i)
      values.push_back(DatumGetFloat8(given.values[i]));
    set_city_option(options, name, values);
  }
  return options;
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

struct City {
  std::vector<CityAxis> axes;
  std::string line;  // of the axis that is being given
};

}  // namespace
}  // namespace streetgen::pg

using namespace streetgen;
using namespace streetgen::pg;

STREETGEN_FUNCTION(streetgen_virtual_city) {
  const int srid = PG_GETARG_INT32(0);
  const CityExtent extent = take_extent(fcinfo, 1);
  const int64 seed = PG_GETARG_INT64(5);
  const OptionValues given = take_options(fcinfo, 6);
  InitMaterializedSRF(fcinfo, 0);
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  Slot<City>* city = make_slot<City>(CurrentMemoryContext);
  report(compute([&] {
    city->value = new City;
    city->value->axes = virtual_city(extent, seed, read_options(given));
  }));
  MemoryContext row = AllocSetContextCreate(CurrentMemoryContext, "axis", ALLOCSET_DEFAULT_SIZES);
  for (std::size_t i = 0; i < city->value->axes.size(); ++i) {
    CHECK_FOR_INTERRUPTS();
    const CityAxis& axis = city->value->axes[i];
    report(compute([&] { city->value->line = write_line(axis.line, {srid, false}); }));
    MemoryContextReset(row);
    MemoryContext before = MemoryContextSwitchTo(row);
    Datum values[7] = {bytes_datum(city->value->line),
                       Float8GetDatum(axis.width),
                       Int32GetDatum(axis.lane_count),
                       Int32GetDatum(axis.importance),
                       CStringGetTextDatum(axis.name.c_str()),
                       CStringGetTextDatum(direction_name(axis.direction)),
                       Float8GetDatum(axis.speed)};
    bool nulls[7] = {false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
    MemoryContextSwitchTo(before);
  }
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
    density = city_density(at, extent, read_options(given));
  }));
  PG_RETURN_FLOAT8(density);
}

STREETGEN_FUNCTION(streetgen_city_options) {
  InitMaterializedSRF(fcinfo, 0);
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  struct Row {
    const CityOption* option;
    std::vector<double> value;
  };
  Slot<std::vector<Row>>* rows = make_slot<std::vector<Row>>(CurrentMemoryContext);
  report(compute([&] {
    rows->value = new std::vector<Row>;
    for (const CityOption& option : city_options())
      rows->value->push_back({&option, city_option(CityOptions{}, option)});
  }));
  for (std::size_t i = 0; i < rows->value->size(); ++i) {
    const Row& row = (*rows->value)[i];
    auto* numbers = static_cast<Datum*>(palloc(row.value.size() * sizeof(Datum)));
    for (std::size_t k = 0; k < row.value.size(); ++k) numbers[k] = Float8GetDatum(row.value[k]);
    Datum values[6] = {CStringGetTextDatum(row.option->name),
                       PointerGetDatum(construct_array(numbers, static_cast<int>(row.value.size()),
                                                       FLOAT8OID, 8, true, 'd')),
                       CStringGetTextDatum(row.option->unit),
                       CStringGetTextDatum(row.option->description),
                       Float8GetDatum(row.option->low),
                       Float8GetDatum(row.option->high)};
    bool nulls[6] = {false, false, row.option->unit[0] == '\0', false, false, false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
  PG_RETURN_NULL();
}
