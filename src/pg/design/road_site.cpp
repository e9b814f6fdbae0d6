#include "design/road_site.hpp"

#include <algorithm>

#include "value/wkb.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <executor/executor.h>
#include <utils/array.h>
#include <utils/lsyscache.h>
}

namespace streetgen::pg {
namespace {

SiteArgument::Column take_attribute(HeapTupleHeader row, int attribute, unsigned element) {
  bool is_null = false;
  const Datum value = GetAttributeByNum(row, static_cast<AttrNumber>(attribute), &is_null);
  return is_null ? SiteArgument::Column{} : take_column(value, element);
}

// Cells of zones: a river of a few metres counts, and a country stays in memory.
constexpr double zone_cell = 5;

ZoneGrid read_zones(const SiteArgument& argument) {
  std::vector<ZoneClass> classes;
  for (int i = 0; i < argument.class_costs.count; ++i)
    classes.push_back({DatumGetFloat8(argument.class_costs.values[i]),
                       static_cast<Passage>(
                           static_cast<int>(DatumGetFloat8(argument.class_passages.values[i])))});
  std::vector<Zone> zones;
  for (int i = 0; i < argument.zone_surfaces.count; ++i)
    zones.push_back(
        {read_surface(bytes_of(argument.zone_surfaces.values[i]), "zone " + std::to_string(i + 1)),
         static_cast<int>(DatumGetFloat8(argument.zone_classes.values[i]))});
  return ZoneGrid(zones, std::move(classes), zone_cell);
}

}  // namespace

SiteArgument::Column take_column(Datum array, unsigned element) {
  SiteArgument::Column column;
  int16 length;
  bool by_value;
  char align;
  get_typlenbyvalalign(element, &length, &by_value, &align);
  bool* nulls = nullptr;
  deconstruct_array(DatumGetArrayTypeP(array), element, length, by_value, align, &column.values,
                    &nulls, &column.count);
  for (int i = 0; i < column.count; ++i) {
    if (nulls[i])
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED),
                      errmsg("element %d of the site of a road is NULL", i + 1)));
    if (length == -1) column.values[i] = PointerGetDatum(PG_DETOAST_DATUM_PACKED(column.values[i]));
  }
  return column;
}

SiteArgument take_site(FunctionCallInfo fcinfo, int argument) {
  HeapTupleHeader row = PG_GETARG_HEAPTUPLEHEADER(argument);
  return {take_attribute(row, 1, BYTEAOID),  take_attribute(row, 2, BYTEAOID),
          take_attribute(row, 3, FLOAT8OID), take_attribute(row, 4, FLOAT8OID),
          take_attribute(row, 5, FLOAT8OID), take_attribute(row, 6, TEXTOID),
          take_attribute(row, 7, FLOAT8OID)};
}

Terrain read_terrain(const SiteArgument::Column& tiles) {
  std::vector<HeightTile> read;
  for (int i = 0; i < tiles.count; ++i) read.push_back(read_height_tile(bytes_of(tiles.values[i])));
  return Terrain::of(read);
}

DesignRules read_rules(const SiteArgument& argument) {
  DesignRules rules;
  for (int i = 0; i < argument.rule_names.count && i < argument.rule_values.count; ++i)
    set_design_rule(rules, text_of(argument.rule_names.values[i]),
                    DatumGetFloat8(argument.rule_values.values[i]));
  return rules;
}

std::unique_ptr<ReadSite> read_site(const SiteArgument& argument) {
  return std::make_unique<ReadSite>(
      ReadSite{read_terrain(argument.tiles), read_zones(argument), read_rules(argument)});
}

}  // namespace streetgen::pg
