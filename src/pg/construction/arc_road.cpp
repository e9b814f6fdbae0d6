// Arc roads from SQL: a line becomes a road, and roads are asked. Lines cross as EWKB; roads and
// points come as PostGIS stores them, so that a query that asks a road again only compares bytes.
#include "streetgen/arc_road.hpp"

#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "frame/varlena.hpp"
#include "value/stored.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <funcapi.h>
#include <utils/array.h>
#include <utils/builtins.h>
#include <utils/portal.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {
namespace {

constexpr double to_degrees = 180 / M_PI;

double offset_of(double value, const char* name) { return in_range(value, -200, 200, name); }
double tolerance_of(double value) { return in_range(value, 1e-3, 10, "tolerance"); }

struct PreparedRoad {
  std::string bytes;
  ArcRoad road;
  int srid;
  bool has_z;
};

// The road that the query asked last, so that it is made once; it goes with the query.
PreparedRoad* prepared = nullptr;
bool watched = false;

void forget_road(void*) {
  delete std::exchange(prepared, nullptr);
  watched = false;
}

void watch_query() {
  if (watched) return;
  MemoryContext owner = PortalContext != nullptr ? PortalContext : TopTransactionContext;
  auto* callback = static_cast<MemoryContextCallback*>(
      MemoryContextAllocZero(owner, sizeof(MemoryContextCallback)));
  callback->func = forget_road;
  MemoryContextRegisterResetCallback(owner, callback);
  watched = true;
}

std::string_view take_road(FunctionCallInfo fcinfo) {
  watch_query();
  return take_bytes(fcinfo, 0);
}

const PreparedRoad& road_of(std::string_view bytes) {
  if (prepared == nullptr || prepared->bytes != bytes) {
    const ReadCurve read = read_curve(wkb_of_stored(bytes), "road");
    auto* next =
        new PreparedRoad{std::string(bytes), ArcRoad::along(read.curve), read.srid, read.has_z};
    delete std::exchange(prepared, next);
  }
  return *prepared;
}

Point point_on(const PreparedRoad& prepared_road, std::string_view bytes, const char* name) {
  const ReadPoint read = read_point(wkb_of_stored(bytes), name);
  if (read.srid != prepared_road.srid)
    throw Error(ErrorKind::invalid_input, std::string(name) + " has SRID " +
                                              std::to_string(read.srid) + ", road " +
                                              std::to_string(prepared_road.srid));
  if (!prepared_road.road.flat() && !read.has_z)
    throw Error(ErrorKind::invalid_input,
                std::string(name) + " has no height, but road has heights",
                "ST_Force3D gives the point one.");
  return read.point;
}

struct Wish {
  double cap = 0, shift = 0;
  bool shifts = false;
  bool listed = false;
  int count = 0;  // of radii
  Datum* radii = nullptr;
  bool* nulls = nullptr;
};

Wish take_wish(FunctionCallInfo fcinfo) {
  Wish wish;
  wish.cap = PG_GETARG_FLOAT8(1);
  wish.shifts = !PG_ARGISNULL(2);
  if (wish.shifts) wish.shift = PG_GETARG_FLOAT8(2);
  wish.listed = !PG_ARGISNULL(3);
  if (wish.listed)
    deconstruct_array(PG_GETARG_ARRAYTYPE_P(3), FLOAT8OID, 8, true, 'd', &wish.radii, &wish.nulls,
                      &wish.count);
  return wish;
}

struct FittedRoad {
  ArcRoad road;
  Form form;
};

FittedRoad fitted(std::string_view line, const Wish& wish) {
  const ReadLine read = read_line(line, "line");
  ArcRoadFit fit;
  fit.cap = wish.cap;
  if (wish.shifts) fit.shift = wish.shift;
  for (int i = 0; i < wish.count; ++i)
    fit.radii.push_back(wish.nulls[i] ? std::optional<double>()
                                      : std::optional<double>(DatumGetFloat8(wish.radii[i])));
  if (wish.listed && fit.radii.empty())
    throw Error(ErrorKind::invalid_input, "radii has no elements, expected one for each of the " +
                                              std::to_string(read.line.size()) +
                                              " points of the line");
  return {ArcRoad::fit(read.line, fit), {read.srid, read.has_z}};
}

Datum vector_datum(const Point& vector) {
  // Minus zero becomes zero.
  Datum parts[3] = {Float8GetDatum(vector.x + 0.0), Float8GetDatum(vector.y + 0.0),
                    Float8GetDatum(vector.z + 0.0)};
  return PointerGetDatum(construct_array(parts, 3, FLOAT8OID, 8, true, 'd'));
}

const char* orientation_name(const RoadArc& arc) {
  if (std::abs(arc.orientation.z) < 1e-9) return "straight";
  return arc.orientation.z > 0 ? "left" : "right";
}

struct ArcRows {
  std::vector<RoadArc> arcs;
  std::vector<std::string> centres;
};

void give(const ArcRows& rows, ReturnSetInfo* result) {
  for (std::size_t i = 0; i < rows.arcs.size(); ++i) {
    const RoadArc& arc = rows.arcs[i];
    Datum values[9] = {Int32GetDatum(static_cast<int>(arc.vertex) + 1),
                       bytes_datum(rows.centres[i]),
                       Float8GetDatum(arc.radius),
                       Float8GetDatum(arc.angle * to_degrees),
                       Float8GetDatum(arc.start_abscissa),
                       Float8GetDatum(arc.end_abscissa),
                       vector_datum(arc.start_direction),
                       CStringGetTextDatum(orientation_name(arc)),
                       vector_datum(arc.orientation)};
    bool nulls[9] = {false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
}

struct BendRow {
  ArcRoad::Stretch stretch;
  std::string centre, corner, arc;
};
using BendRows = std::vector<BendRow>;

BendRows bend_rows(const PreparedRoad& prepared_road) {
  const Form form{prepared_road.srid, prepared_road.has_z};
  BendRows rows;
  for (const ArcRoad::Bend& bend : prepared_road.road.bends())
    rows.push_back({bend.stretch, write_point(bend.centre, form), write_point(bend.corner, form),
                    write_arc(bend.arc, form)});
  return rows;
}

void give(const BendRows& rows, ReturnSetInfo* result) {
  for (const BendRow& row : rows) {
    Datum values[6] = {Float8GetDatum(row.stretch.start_abscissa),
                       Float8GetDatum(row.stretch.end_abscissa),
                       Float8GetDatum(std::abs(row.stretch.radius)),
                       bytes_datum(row.centre),
                       bytes_datum(row.corner),
                       bytes_datum(row.arc)};
    bool nulls[6] = {false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
}

// A geometry in the current memory context.
Datum geometry_datum(const Stored& stored) {
  void* out = palloc(VARSIZE(stored.get()));
  memcpy(out, stored.get(), VARSIZE(stored.get()));
  return PointerGetDatum(out);
}

// The one row of a function.
void give_row(FunctionCallInfo fcinfo, Datum* values) {
  bool nulls[8] = {false};
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
}

// Degrees clockwise from the y axis, 0 to 360.
double azimuth_of(double heading) {
  const double azimuth = std::fmod(90 - heading * to_degrees + 720, 360);
  return azimuth < 0 ? azimuth + 360 : azimuth;
}

template <class Work>
Datum number_result(Work work) {
  double number = 0;
  const Outcome outcome = compute([&] { number = work(); });
  report(outcome);
  PG_RETURN_FLOAT8(number);
}

}  // namespace
}  // namespace streetgen::pg

using namespace streetgen;
using namespace streetgen::pg;

STREETGEN_FUNCTION(streetgen_arc_road) {
  if (PG_ARGISNULL(0) || PG_ARGISNULL(1)) PG_RETURN_NULL();
  const std::string_view line = take_bytes(fcinfo, 0);
  const Wish wish = take_wish(fcinfo);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const FittedRoad made = fitted(line, wish);
    result = {true, write_curve(made.road.curve(), made.form)};
  });
}

STREETGEN_FUNCTION(streetgen_arc_road_arcs) {
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  if (PG_ARGISNULL(0) || PG_ARGISNULL(1)) PG_RETURN_NULL();
  const std::string_view line = take_bytes(fcinfo, 0);
  const Wish wish = take_wish(fcinfo);
  Slot<ArcRows>* slot = make_slot<ArcRows>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new ArcRows;
    const FittedRoad made = fitted(line, wish);
    slot->value->arcs = made.road.arcs();
    for (const RoadArc& arc : slot->value->arcs)
      slot->value->centres.push_back(write_point(arc.centre, made.form));
  });
  report(outcome);
  give(*slot->value, reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo));
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_arc_road_length) {
  const std::string_view road = take_road(fcinfo);
  return number_result([&] { return road_of(road).road.length(); });
}

STREETGEN_FUNCTION(streetgen_arc_road_point) {
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  const std::string_view road = take_road(fcinfo);
  const double metres = PG_GETARG_FLOAT8(1), wheelbase = PG_GETARG_FLOAT8(2);
  RoadPlace place;
  Slot<Stored>* slot = make_slot<Stored>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    in_range(wheelbase, 0.01, 100, "wheelbase");
    const PreparedRoad& asked = road_of(road);
    place = asked.road.at(finite(metres, "metres"));
    slot->value = new Stored(stored_point(place.point, {asked.srid, asked.has_z}));
  });
  report(outcome);
  Datum values[7] = {geometry_datum(*slot->value),
                     vector_datum(place.forward),
                     vector_datum(place.right),
                     vector_datum(place.up),
                     Float8GetDatum(azimuth_of(place.heading)),
                     Float8GetDatum(place.curvature),
                     Float8GetDatum(std::atan(wheelbase * place.curvature) * to_degrees)};
  give_row(fcinfo, values);
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_arc_road_locate) {
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  const std::string_view road = take_road(fcinfo), point = take_bytes(fcinfo, 1);
  RoadFoot foot;
  const Outcome outcome = compute([&] {
    const PreparedRoad& asked = road_of(road);
    foot = asked.road.locate(point_on(asked, point, "point"));
  });
  report(outcome);
  Datum values[3] = {Float8GetDatum(foot.abscissa), Float8GetDatum(foot.offset),
                     Float8GetDatum(foot.distance)};
  give_row(fcinfo, values);
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_arc_road_distance) {
  const std::string_view road = take_road(fcinfo);
  const std::string_view a = take_bytes(fcinfo, 1), b = take_bytes(fcinfo, 2);
  return number_result([&] {
    const PreparedRoad& asked = road_of(road);
    return asked.road.locate(point_on(asked, b, "b")).abscissa -
           asked.road.locate(point_on(asked, a, "a")).abscissa;
  });
}

STREETGEN_FUNCTION(streetgen_arc_road_offset) {
  const std::string_view road = take_road(fcinfo);
  const double axis_offset = PG_GETARG_FLOAT8(1);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const PreparedRoad& asked = road_of(road);
    const auto beside = asked.road.offset(offset_of(axis_offset, "axis_offset"));
    if (beside) result = {true, write_curve(beside->curve(), {asked.srid, asked.has_z})};
  });
}

STREETGEN_FUNCTION(streetgen_arc_road_bends) {
  const std::string_view road = take_road(fcinfo);
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  Slot<BendRows>* slot = make_slot<BendRows>(CurrentMemoryContext);
  const Outcome outcome = compute([&] { slot->value = new BendRows(bend_rows(road_of(road))); });
  report(outcome);
  give(*slot->value, reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo));
  return 0;
}

STREETGEN_FUNCTION(streetgen_arc_road_kinks) {
  using Kinks = std::vector<std::pair<double, std::string>>;
  const std::string_view road = take_road(fcinfo);
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  Slot<Kinks>* slot = make_slot<Kinks>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new Kinks;
    const PreparedRoad& asked = road_of(road);
    for (const ArcRoad::Kink& kink : asked.road.kinks())
      slot->value->push_back({kink.angle, write_point(kink.place, {asked.srid, asked.has_z})});
  });
  report(outcome);
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  for (const auto& [angle, place] : *slot->value) {
    Datum values[2] = {Float8GetDatum(angle), bytes_datum(place)};
    bool nulls[2] = {false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
  return 0;
}

STREETGEN_FUNCTION(streetgen_arc_road_line) {
  const std::string_view road = take_road(fcinfo);
  const double tolerance = PG_GETARG_FLOAT8(1);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const PreparedRoad& asked = road_of(road);
    result = {true,
              write_line(asked.road.line(tolerance_of(tolerance)), {asked.srid, asked.has_z})};
  });
}

STREETGEN_FUNCTION(streetgen_arc_road_mesh) {
  const std::string_view road = take_road(fcinfo);
  const double left = PG_GETARG_FLOAT8(1), right = PG_GETARG_FLOAT8(2);
  const double tolerance = PG_GETARG_FLOAT8(3);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const PreparedRoad& asked = road_of(road);
    result = {true,
              write_tin(asked.road.mesh(offset_of(left, "offset_left"),
                                        offset_of(right, "offset_right"), tolerance_of(tolerance)),
                        asked.srid)};
  });
}

STREETGEN_FUNCTION(streetgen_arc_road_stretches) {
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  const std::string_view road = take_road(fcinfo);
  using Stretches = std::vector<ArcRoad::Stretch>;
  Slot<Stretches>* slot = make_slot<Stretches>(CurrentMemoryContext);
  const Outcome outcome =
      compute([&] { slot->value = new Stretches(road_of(road).road.stretches()); });
  report(outcome);
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  for (const ArcRoad::Stretch& stretch : *slot->value) {
    Datum values[3] = {Float8GetDatum(stretch.start_abscissa), Float8GetDatum(stretch.end_abscissa),
                       Float8GetDatum(std::abs(stretch.radius))};
    bool nulls[3] = {false, false, stretch.radius == 0};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_arc_road_speed_limit) {
  const double radius = PG_GETARG_FLOAT8(0), friction = PG_GETARG_FLOAT8(1);
  const double superelevation = PG_GETARG_FLOAT8(2), safety = PG_GETARG_FLOAT8(3);
  return number_result([&] {
    return arc_speed_limit(in_range(radius, 0, 1e6, "radius"), in_range(friction, 0, 2, "friction"),
                           in_range(superelevation, -0.2, 0.2, "superelevation"),
                           in_range(safety, 0, 1, "safety"));
  });
}
