// Alignments from SQL.
#include "streetgen/alignment.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "streetgen/alignment_line.hpp"
#include "streetgen/road_standard.hpp"
#include "value/alignment_numbers.hpp"
#include "value/number_array.hpp"
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

std::vector<GradePiece> grades_of(const NumberArray& array) {
  return vertical_alignment(grade_points_of(array));
}

const char* kind_name(ElementKind kind) {
  return kind == ElementKind::line ? "line" : kind == ElementKind::arc ? "arc" : "clothoid";
}

std::vector<VertexCurve> curves_of(const NumberArray& radii, const NumberArray& in,
                                   const NumberArray& out) {
  const std::vector<double> r = read_numbers(radii, 1, "radii");
  const std::vector<double> a = read_numbers(in, 1, "clothoids");
  const std::vector<double> b = read_numbers(out, 1, "clothoids");
  if (a.size() != r.size() || b.size() != r.size())
    throw Error(ErrorKind::invalid_input,
                std::to_string(r.size()) + " radii, but " + std::to_string(a.size()) + " clothoids",
                "Give one of each for each point of the line.");
  std::vector<VertexCurve> curves;
  for (std::size_t i = 0; i < r.size(); ++i) curves.push_back({r[i], a[i], b[i]});
  return curves;
}

}  // namespace
}  // namespace streetgen::pg

using namespace streetgen;
using namespace streetgen::pg;

STREETGEN_FUNCTION(streetgen_horizontal_alignment) {
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  const std::string_view line = take_bytes(fcinfo, 0);
  const NumberArray radii = take_numbers(fcinfo, 1), in = take_numbers(fcinfo, 2),
                    out = take_numbers(fcinfo, 3);
  using Elements = std::vector<AlignmentElement>;
  Slot<Elements>* slot = make_slot<Elements>(CurrentMemoryContext);
  report(compute([&] {
    slot->value =
        new Elements(horizontal_alignment(read_line(line, "line").line, curves_of(radii, in, out)));
  }));
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  for (const AlignmentElement& e : *slot->value) {
    Datum values[8] = {CStringGetTextDatum(kind_name(e.kind())),
                       Float8GetDatum(e.abscissa),
                       Float8GetDatum(e.start.x),
                       Float8GetDatum(e.start.y),
                       Float8GetDatum(e.heading),
                       Float8GetDatum(e.length),
                       Float8GetDatum(e.curvature_start),
                       Float8GetDatum(e.curvature_end)};
    bool nulls[8] = {false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_vertical_alignment) {
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  const NumberArray grades = take_numbers(fcinfo, 0);
  using Pieces = std::vector<GradePiece>;
  Slot<Pieces>* slot = make_slot<Pieces>(CurrentMemoryContext);
  report(compute([&] { slot->value = new Pieces(grades_of(grades)); }));
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  for (const GradePiece& p : *slot->value) {
    const double end = p.grade + p.bend * (p.end_abscissa - p.start_abscissa);
    Datum values[7] = {CStringGetTextDatum(p.bend == 0  ? "grade"
                                           : p.bend > 0 ? "sag"
                                                        : "crest"),
                       Float8GetDatum(p.start_abscissa),
                       Float8GetDatum(p.end_abscissa),
                       Float8GetDatum(p.height),
                       Float8GetDatum(p.grade),
                       Float8GetDatum(end),
                       Float8GetDatum(p.bend == 0 ? 0 : std::abs(1 / p.bend))};
    bool nulls[7] = {false};
    nulls[6] = p.bend == 0;
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_alignment_point) {
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  const NumberArray elements = take_numbers(fcinfo, 0), grades = take_numbers(fcinfo, 1);
  const double metres = PG_GETARG_FLOAT8(2);
  AlignmentPlace place;
  GradePlace height;
  report(compute([&] {
    place = alignment_place(elements_of(elements), finite(metres, "metres"));
    if (grades.count > 0) height = grade_place(grades_of(grades), metres);
  }));
  Datum values[6] = {Float8GetDatum(place.point.x),   Float8GetDatum(place.point.y),
                     Float8GetDatum(height.height),   Float8GetDatum(place.heading),
                     Float8GetDatum(place.curvature), Float8GetDatum(height.grade)};
  bool nulls[6] = {false, false, grades.count == 0, false, false, grades.count == 0};
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_alignment_line) {
  const NumberArray elements = take_numbers(fcinfo, 0), grades = take_numbers(fcinfo, 1);
  const int srid = PG_GETARG_INT32(2);
  const double from = PG_GETARG_FLOAT8(3), to = PG_GETARG_FLOAT8(4);
  const double tolerance = PG_GETARG_FLOAT8(5);
  const LineOffset beside{PG_GETARG_FLOAT8(6), PG_GETARG_FLOAT8(7)};
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const auto read = elements_of(elements);
    if (read.empty()) throw Error(ErrorKind::invalid_input, "the alignment has no elements");
    const auto pieces = grades.count > 0 ? grades_of(grades) : std::vector<GradePiece>();
    result = {true, write_line(alignment_line(read, pieces, from, to, tolerance, beside),
                               {srid, grades.count > 0})};
  });
}

STREETGEN_FUNCTION(streetgen_curvature_spectrum) {
  const std::string_view line = take_bytes(fcinfo, 0);
  const double step = PG_GETARG_FLOAT8(1), extent = PG_GETARG_FLOAT8(2);
  double shares[5];
  bool any = false;
  report(compute([&] {
    const auto read = curvature_spectrum(read_line(line, "line").line, step, extent);
    any = !read.empty();
    for (std::size_t i = 0; i < read.size(); ++i) shares[i] = read[i];
  }));
  if (!any) PG_RETURN_NULL();
  Datum values[5];
  for (int i = 0; i < 5; ++i) values[i] = Float8GetDatum(shares[i]);
  PG_RETURN_ARRAYTYPE_P(construct_array(values, 5, FLOAT8OID, 8, true, 'd'));
}

STREETGEN_FUNCTION(streetgen_least_radius) {
  const double speed = PG_GETARG_FLOAT8(0), superelevation = PG_GETARG_FLOAT8(1);
  const bool by_norm = PG_ARGISNULL(2);
  const double friction = by_norm ? -1 : PG_GETARG_FLOAT8(2);
  double radius = 0;
  report(compute([&] {
    if (!by_norm) in_range(friction, 0, 2, "friction");
    radius = least_radius(in_range(speed, 1, 400, "speed"),
                          in_range(superelevation, -0.2, 0.2, "superelevation"), friction);
  }));
  PG_RETURN_FLOAT8(radius);
}
