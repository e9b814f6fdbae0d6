// streetgen._network_rings: the rings of a network that may be roundabouts, a row each.
#include <string>
#include <unordered_map>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "streetgen/roundabout.hpp"
#include "value/control_rows.hpp"
#include "value/line_array.hpp"

extern "C" {
#include <funcapi.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {
namespace {

struct AxisColumns {
  LineArray lines;
  Datum *axis_ids, *levels, *one_ways, *tagged, *widths, *widths_end, *offsets, *importances,
      *lanes_forward, *lanes_backward;
  ControlRows controls;
};

// Of a type that is passed by value, by its width in bytes.
char alignment_of(int width) { return width == 8 ? 'd' : width == 4 ? 'i' : 'c'; }

Datum* take_column(FunctionCallInfo fcinfo, int argument, Oid type, int width, int count) {
  ArrayType* array = PG_GETARG_ARRAYTYPE_P(argument);
  Datum* values;
  int found;
  if (array_contains_nulls(array))
    ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED), errmsg("a value of an axis is NULL")));
  deconstruct_array(array, type, width, true, alignment_of(width), &values, nullptr, &found);
  if (found != count)
    ereport(ERROR, (errcode(ERRCODE_ARRAY_SUBSCRIPT_ERROR),
                    errmsg("argument %d has %d elements for %d axes", argument, found, count)));
  return values;
}

std::vector<RingAxis> read_axes(const AxisColumns& columns, Form* form) {
  std::vector<Line> lines = read_lines(columns.lines, "axis", form);
  std::unordered_map<std::int64_t, std::vector<ControlPoint>> controls;
  for (const ControlPoint& control : read_controls(columns.controls))
    controls[control.axis_id].push_back(control);
  std::vector<RingAxis> axes;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int way = DatumGetInt32(columns.one_ways[i]);
    axes.push_back(
        {DatumGetInt64(columns.axis_ids[i]), std::move(lines[i]), DatumGetInt32(columns.levels[i]),
         way > 0   ? OneWay::along
         : way < 0 ? OneWay::against
                   : OneWay::no,
         DatumGetBool(columns.tagged[i]), DatumGetFloat8(columns.widths[i]),
         DatumGetFloat8(columns.widths_end[i]), DatumGetFloat8(columns.offsets[i]),
         DatumGetInt32(columns.importances[i]), DatumGetInt32(columns.lanes_forward[i]) > 0,
         DatumGetInt32(columns.lanes_backward[i]) > 0,
         controls[DatumGetInt64(columns.axis_ids[i])]});
  }
  return axes;
}

struct GivenRings {
  std::vector<NetworkRing> rings;
  std::vector<std::string> lines, centres;
  std::vector<std::vector<std::string>> faces;
};

// A column of edges as an array.
template <class Value>
Datum array_of(const std::vector<RingEdge>& edges, Oid type, int width, Value value) {
  auto* values = static_cast<Datum*>(palloc(sizeof(Datum) * (edges.size() + 1)));
  for (std::size_t i = 0; i < edges.size(); ++i) values[i] = value(edges[i]);
  return PointerGetDatum(construct_array(values, static_cast<int>(edges.size()), type, width, true,
                                         alignment_of(width)));
}

Datum array_of(const std::vector<std::string>& lines) {
  auto* values = static_cast<Datum*>(palloc(sizeof(Datum) * lines.size()));
  for (std::size_t i = 0; i < lines.size(); ++i) values[i] = bytes_datum(lines[i]);
  return PointerGetDatum(
      construct_array(values, static_cast<int>(lines.size()), BYTEAOID, -1, false, 'i'));
}

void put_edges(const std::vector<RingEdge>& edges, Datum* values) {
  values[0] =
      array_of(edges, INT8OID, 8, [](const RingEdge& e) { return Int64GetDatum(e.axis_id); });
  values[1] = array_of(edges, FLOAT8OID, 8,
                       [](const RingEdge& e) { return Float8GetDatum(e.start_abscissa); });
  values[2] = array_of(edges, FLOAT8OID, 8,
                       [](const RingEdge& e) { return Float8GetDatum(e.end_abscissa); });
  values[3] =
      array_of(edges, BOOLOID, 1, [](const RingEdge& e) { return BoolGetDatum(e.along_axis); });
}

void give(const GivenRings& found, ReturnSetInfo* result) {
  for (std::size_t i = 0; i < found.rings.size(); ++i) {
    CHECK_FOR_INTERRUPTS();
    const NetworkRing& ring = found.rings[i];
    Datum values[23] = {Int32GetDatum(static_cast<int>(i) + 1),
                        Int32GetDatum(ring.level),
                        bytes_datum(found.lines[i]),
                        bytes_datum(found.centres[i]),
                        Float8GetDatum(ring.radius),
                        Float8GetDatum(ring.on_circle),
                        Float8GetDatum(ring.compactness),
                        Float8GetDatum(ring.one_way),
                        Float8GetDatum(ring.against),
                        Float8GetDatum(ring.single_arm),
                        Int32GetDatum(ring.arm_nodes),
                        Int32GetDatum(ring.inside)};
    put_edges(ring.edges, values + 12);
    put_edges(ring.arms, values + 16);
    values[20] =
        array_of(ring.edges, INT4OID, 4, [](const RingEdge& e) { return Int32GetDatum(e.face); });
    values[21] = array_of(found.faces[i]);
    values[22] = BoolGetDatum(ring.waist);
    const bool nulls[23] = {false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, const_cast<bool*>(nulls));
  }
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_network_rings) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const LineArray lines = take_lines(PG_GETARG_ARRAYTYPE_P(1), "axes");
  const AxisColumns columns{lines,
                            take_column(fcinfo, 0, INT8OID, 8, lines.count),
                            take_column(fcinfo, 2, INT4OID, 4, lines.count),
                            take_column(fcinfo, 3, INT4OID, 4, lines.count),
                            take_column(fcinfo, 4, BOOLOID, 1, lines.count),
                            take_column(fcinfo, 5, FLOAT8OID, 8, lines.count),
                            take_column(fcinfo, 6, FLOAT8OID, 8, lines.count),
                            take_column(fcinfo, 7, FLOAT8OID, 8, lines.count),
                            take_column(fcinfo, 8, INT4OID, 4, lines.count),
                            take_column(fcinfo, 9, INT4OID, 4, lines.count),
                            take_column(fcinfo, 10, INT4OID, 4, lines.count),
                            take_controls(fcinfo, 17)};
  const double control_distance = PG_GETARG_FLOAT8(18), queue_length = PG_GETARG_FLOAT8(19);
  double numbers[4];
  for (int i = 0; i < 4; ++i) numbers[i] = PG_GETARG_FLOAT8(11 + i);
  const bool split = PG_GETARG_BOOL(15), counter_clockwise = PG_GETARG_BOOL(16);
  InitMaterializedSRF(fcinfo, 0);
  Slot<GivenRings>* slot = make_slot<GivenRings>(CurrentMemoryContext);
  report(compute([&] {
    slot->value = new GivenRings;
    GivenRings& found = *slot->value;
    Form form;
    const std::vector<RingAxis> axes = read_axes(columns, &form);
    found.rings = network_rings(axes, {in_range(numbers[0], 1e-6, 1000, "tolerance"),
                                       split ? Crossing::split : Crossing::over,
                                       in_range(numbers[1], 1e-3, 1000, "radius_least"),
                                       in_range(numbers[2], numbers[1], 1000, "radius_greatest"),
                                       in_range(numbers[3], 0, 1, "shape_least"),
                                       counter_clockwise,
                                       {in_range(control_distance, 0, 1000, "control_distance"),
                                        in_range(queue_length, 0, 1000, "queue_length")}});
    for (const NetworkRing& ring : found.rings) {
      found.lines.push_back(write_line(ring.line, {form.srid, false}));
      std::vector<std::string>& faces = found.faces.emplace_back();
      for (const Ring& face : ring.faces) faces.push_back(write_line(face, {form.srid, false}));
      found.centres.push_back(write_point(ring.centre, {form.srid, false}));
    }
  }));
  give(*slot->value, reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo));
  PG_RETURN_NULL();
}
