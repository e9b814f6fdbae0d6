// streetgen._built_walks, streetgen._walk_network, streetgen._walks_over_area,
// streetgen._walk_parts: the network on foot.
#include "streetgen/walk_network.hpp"

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "value/given_rows.hpp"
#include "value/line_array.hpp"
#include "value/value_array.hpp"
#include "value/wkb.hpp"

namespace {

using namespace streetgen;
using namespace streetgen::pg;

// The index behind a number that counts from 1; 0 is none.
int index_of(Datum number, int count, const char* name) {
  const int index = DatumGetInt32(number) - 1;
  if (index < -1 || index >= count)
    throw Error(ErrorKind::invalid_input, std::string(name) + " has a number beyond the last");
  return index;
}

struct GivenKerbs {
  LineArray kerbs, streets;
  ValueArray offsets, leads_on;
  ValueArray mapped, mapped_from, mapped_to;
  ValueArray arrives, leaves, arm_streets;
};

std::vector<WalkedKerb> kerbs_of(const GivenKerbs& given) {
  std::vector<WalkedKerb> kerbs;
  for (Line& line : read_lines(given.kerbs, "kerb", nullptr)) {
    WalkedKerb kerb;
    kerb.offset = in_range(DatumGetFloat8(given.offsets.values[kerbs.size()]), 0, 50, "offset");
    kerb.leads_on = DatumGetBool(given.leads_on.values[kerbs.size()]);
    kerb.line = std::move(line);
    kerbs.push_back(std::move(kerb));
  }
  for (int i = 0; i < given.mapped.count; ++i) {
    const int kerb = index_of(given.mapped.values[i], given.kerbs.count, "mapped");
    if (kerb < 0) throw Error(ErrorKind::invalid_input, "mapped has a stretch of no kerb");
    kerbs[kerb].mapped.push_back(
        {DatumGetFloat8(given.mapped_from.values[i]), DatumGetFloat8(given.mapped_to.values[i])});
  }
  return kerbs;
}

std::vector<CrossedArm> arms_of(const GivenKerbs& given) {
  const std::vector<Line> streets = read_lines(given.streets, "street", nullptr);
  std::vector<CrossedArm> arms;
  for (int i = 0; i < given.arrives.count; ++i) {
    const int street = index_of(given.arm_streets.values[i], given.streets.count, "arm_streets");
    arms.push_back({index_of(given.arrives.values[i], given.kerbs.count, "arrives"),
                    index_of(given.leaves.values[i], given.kerbs.count, "leaves"),
                    street < 0 ? Line{} : streets[street]});
  }
  return arms;
}

struct GivenLines {
  LineArray lines;
  ValueArray levels, mapped;
  ValueArray reach_start, reach_end, excess_start, excess_end;
};

std::vector<WalkLine> lines_of(const GivenLines& given) {
  std::vector<WalkLine> lines;
  const auto metres = [&](const ValueArray& array, const char* name) {
    return in_range(DatumGetFloat8(array.values[lines.size()]), 0, 1000, name);
  };
  for (Line& points : read_lines(given.lines, "line", nullptr)) {
    WalkLine line;
    line.level = DatumGetInt32(given.levels.values[lines.size()]);
    line.mapped = DatumGetBool(given.mapped.values[lines.size()]);
    line.reach_start = metres(given.reach_start, "reach_start");
    line.reach_end = metres(given.reach_end, "reach_end");
    line.excess_start = metres(given.excess_start, "excess_start");
    line.excess_end = metres(given.excess_end, "excess_end");
    line.line = std::move(points);
    lines.push_back(std::move(line));
  }
  return lines;
}

struct GivenArea {
  std::string_view area;
  ValueArray x, y;
  ValueArray from, to, metres;
};

std::vector<AreaWalk> area_walks_of(const GivenArea& given, double detour) {
  std::vector<Point> places;
  for (int i = 0; i < given.x.count; ++i)
    places.push_back({in_range(DatumGetFloat8(given.x.values[i]), -1e12, 1e12, "x"),
                      in_range(DatumGetFloat8(given.y.values[i]), -1e12, 1e12, "y")});
  std::vector<AreaWalk> there;
  for (int i = 0; i < given.from.count; ++i) {
    const int from = index_of(given.from.values[i], given.x.count, "from_places");
    const int to = index_of(given.to.values[i], given.x.count, "to_places");
    if (from < 0 || to < 0) throw Error(ErrorKind::invalid_input, "a walk is of no place");
    there.push_back(
        {from, to, {}, in_range(DatumGetFloat8(given.metres.values[i]), 0, 1e7, "metres")});
  }
  return walks_over_area(read_surface(given.area, "area"), places, there,
                         in_range(detour, 1, 100, "detour"));
}

}  // namespace

STREETGEN_FUNCTION(streetgen_built_walks) {
  InitMaterializedSRF(fcinfo, 0);
  GivenKerbs given;
  given.kerbs = take_lines(PG_GETARG_ARRAYTYPE_P(0), "kerbs");
  given.offsets = take_values(fcinfo, 1, FLOAT8OID, given.kerbs.count, "offsets");
  given.leads_on = take_values(fcinfo, 2, BOOLOID, given.kerbs.count, "leads_on");
  given.mapped = take_values(fcinfo, 3, INT4OID, any_count, "mapped");
  given.mapped_from = take_values(fcinfo, 4, FLOAT8OID, given.mapped.count, "mapped_from");
  given.mapped_to = take_values(fcinfo, 5, FLOAT8OID, given.mapped.count, "mapped_to");
  given.arrives = take_values(fcinfo, 6, INT4OID, any_count, "arrives");
  given.leaves = take_values(fcinfo, 7, INT4OID, given.arrives.count, "leaves");
  given.arm_streets = take_values(fcinfo, 8, INT4OID, given.arrives.count, "arm_streets");
  given.streets = take_lines(PG_GETARG_ARRAYTYPE_P(9), "streets");
  const int srid = PG_GETARG_INT32(10);
  Slot<std::vector<BuiltWalk>>* slot = make_slot<std::vector<BuiltWalk>>(CurrentMemoryContext);
  report(compute([&] {
    slot->value = new std::vector<BuiltWalk>(built_walks(kerbs_of(given), arms_of(given)));
  }));
  put_rows(fcinfo, *slot->value, [&](const BuiltWalk& walk, ReturnSetInfo* result) {
    Datum values[5] = {Int32GetDatum(walk.kerb + 1), Int32GetDatum(walk.arm + 1),
                       BoolGetDatum(walk.loose_start), BoolGetDatum(walk.loose_end),
                       line_datum(walk.line, {srid, false})};
    bool nulls[5] = {};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  });
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_walk_network) {
  InitMaterializedSRF(fcinfo, 0);
  GivenLines given;
  given.lines = take_lines(PG_GETARG_ARRAYTYPE_P(0), "lines");
  const int count = given.lines.count;
  given.levels = take_values(fcinfo, 1, INT4OID, count, "levels");
  given.mapped = take_values(fcinfo, 2, BOOLOID, count, "mapped");
  given.reach_start = take_values(fcinfo, 3, FLOAT8OID, count, "reach_start");
  given.reach_end = take_values(fcinfo, 4, FLOAT8OID, count, "reach_end");
  given.excess_start = take_values(fcinfo, 5, FLOAT8OID, count, "excess_start");
  given.excess_end = take_values(fcinfo, 6, FLOAT8OID, count, "excess_end");
  const int srid = PG_GETARG_INT32(7);
  Slot<std::vector<WalkLink>>* slot = make_slot<std::vector<WalkLink>>(CurrentMemoryContext);
  report(compute([&] { slot->value = new std::vector<WalkLink>(walk_network(lines_of(given))); }));
  put_rows(fcinfo, *slot->value, [&](const WalkLink& link, ReturnSetInfo* result) {
    Datum values[7] = {Int32GetDatum(link.line + 1),
                       Int32GetDatum(link.part),
                       Int32GetDatum(link.parts),
                       Int64GetDatum(link.id),
                       Int64GetDatum(link.from_node),
                       Int64GetDatum(link.to_node),
                       line_datum(link.geometry, {srid, false})};
    bool nulls[7] = {};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  });
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_walks_over_area) {
  InitMaterializedSRF(fcinfo, 0);
  GivenArea given;
  given.area = bytes_of(PG_GETARG_DATUM(0));
  given.x = take_values(fcinfo, 1, FLOAT8OID, any_count, "x");
  given.y = take_values(fcinfo, 2, FLOAT8OID, given.x.count, "y");
  given.from = take_values(fcinfo, 3, INT4OID, any_count, "from_places");
  given.to = take_values(fcinfo, 4, INT4OID, given.from.count, "to_places");
  given.metres = take_values(fcinfo, 5, FLOAT8OID, given.from.count, "metres");
  const double detour = PG_GETARG_FLOAT8(6);
  const int srid = PG_GETARG_INT32(7);
  Slot<std::vector<AreaWalk>>* slot = make_slot<std::vector<AreaWalk>>(CurrentMemoryContext);
  report(compute([&] { slot->value = new std::vector<AreaWalk>(area_walks_of(given, detour)); }));
  put_rows(fcinfo, *slot->value, [&](const AreaWalk& walk, ReturnSetInfo* result) {
    Datum values[3] = {Int32GetDatum(walk.from + 1), Int32GetDatum(walk.to + 1),
                       line_datum(walk.line, {srid, false})};
    bool nulls[3] = {};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  });
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_walk_parts) {
  InitMaterializedSRF(fcinfo, 0);
  const ValueArray from = take_values(fcinfo, 0, INT8OID, any_count, "from_nodes");
  const ValueArray to = take_values(fcinfo, 1, INT8OID, from.count, "to_nodes");
  Slot<std::vector<int>>* slot = make_slot<std::vector<int>>(CurrentMemoryContext);
  report(compute([&] {
    std::vector<WalkEnds> links;
    for (int i = 0; i < from.count; ++i)
      links.push_back({DatumGetInt64(from.values[i]), DatumGetInt64(to.values[i])});
    slot->value = new std::vector<int>(walk_parts(links));
  }));
  int number = 0;
  put_rows(fcinfo, *slot->value, [&](int part, ReturnSetInfo* result) {
    Datum values[2] = {Int32GetDatum(++number), Int32GetDatum(part + 1)};
    bool nulls[2] = {};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  });
  PG_RETURN_NULL();
}
