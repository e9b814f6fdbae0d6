// The constructions that are usable alone from SQL.  Geometries cross as EWKB.
#include <cmath>
#include <string>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "streetgen/clean.hpp"
#include "streetgen/corner.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/surface.hpp"
#include "streetgen/trajectory.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <utils/array.h>
#include <utils/builtins.h>
}

namespace streetgen::pg {
namespace {

double width_of(double value, const char* name) { return in_range(value, 1e-3, 200, name); }
double radius_of(double value, const char* name) { return in_range(value, 0, 1000, name); }

struct Pair {
  ReadLine a, b;
};

Pair read_pair(std::string_view a, std::string_view b) {
  Pair pair{read_line(a, "axis_a"), read_line(b, "axis_b")};
  if (pair.a.srid != pair.b.srid)
    throw Error(ErrorKind::invalid_input, "axis_a has SRID " + std::to_string(pair.a.srid) +
                                              ", axis_b " + std::to_string(pair.b.srid));
  return pair;
}

// Refuses a curve of another SRID than the first.
CurvedLine read_kerb(std::string_view wkb, const char* name, int srid) {
  const ReadCurve read = read_curve(wkb, name);
  if (read.srid != srid)
    throw Error(ErrorKind::invalid_input, std::string(name) + " has SRID " +
                                              std::to_string(read.srid) + ", axis " +
                                              std::to_string(srid));
  return read.curve;
}

struct Numbers {
  int count;
  Datum* values;
};

Numbers take_lengths(FunctionCallInfo fcinfo, int argument) {
  Numbers numbers;
  bool* nulls;
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(argument), FLOAT8OID, 8, true, 'd', &numbers.values,
                    &nulls, &numbers.count);
  for (int i = 0; i < numbers.count; ++i)
    if (nulls[i])
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED),
                      errmsg("element %d of the list is NULL", i + 1)));
  return numbers;
}

template <class Check>
std::vector<double> checked(const Numbers& numbers, Check check, const char* name) {
  std::vector<double> out;
  for (int i = 0; i < numbers.count; ++i)
    out.push_back(check(DatumGetFloat8(numbers.values[i]), name));
  return out;
}

}  // namespace
}  // namespace streetgen::pg

using namespace streetgen;
using namespace streetgen::pg;

STREETGEN_FUNCTION(streetgen_arc_centre) {
  const std::string_view a = take_bytes(fcinfo, 0), b = take_bytes(fcinfo, 1);
  const double wa = PG_GETARG_FLOAT8(2), wb = PG_GETARG_FLOAT8(3), r = PG_GETARG_FLOAT8(4);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const Pair pair = read_pair(a, b);
    const auto centre = arc_centre(pair.a.line, pair.b.line, width_of(wa, "width_a"),
                                   width_of(wb, "width_b"), radius_of(r, "radius"));
    if (centre) result = {true, write_point(*centre, {pair.a.srid, false})};
  });
}

STREETGEN_FUNCTION(streetgen_corner_arc) {
  const std::string_view a = take_bytes(fcinfo, 0), b = take_bytes(fcinfo, 1);
  const double wa = PG_GETARG_FLOAT8(2), wb = PG_GETARG_FLOAT8(3), r = PG_GETARG_FLOAT8(4);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const Pair pair = read_pair(a, b);
    const auto corner = corner_arc(pair.a.line, pair.b.line, width_of(wa, "width_a"),
                                   width_of(wb, "width_b"), radius_of(r, "radius"));
    if (corner) result = {true, write_arc(corner->arc, {pair.a.srid, false})};
  });
}

STREETGEN_FUNCTION(streetgen_max_corner_radius) {
  const std::string_view a = take_bytes(fcinfo, 0), b = take_bytes(fcinfo, 1);
  const double wa = PG_GETARG_FLOAT8(2), wb = PG_GETARG_FLOAT8(3);
  bool found = false;
  double radius = 0;
  const Outcome outcome = compute([&] {
    const Pair pair = read_pair(a, b);
    const auto largest = max_corner_radius(pair.a.line, pair.b.line, width_of(wa, "width_a"),
                                           width_of(wb, "width_b"));
    found = largest.has_value();
    radius = largest.value_or(0);
  });
  report(outcome);
  if (!found) PG_RETURN_NULL();
  PG_RETURN_FLOAT8(radius);
}

STREETGEN_FUNCTION(streetgen_border_line) {
  const std::string_view axis = take_bytes(fcinfo, 0);
  const double abscissa = PG_GETARG_FLOAT8(1), width = PG_GETARG_FLOAT8(2);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const ReadLine read = read_line(axis, "axis");
    result = {true, write_line(border_line(read.line, finite(abscissa, "abscissa"),
                                           width_of(width, "width")),
                               {read.srid, false})};
  });
}

STREETGEN_FUNCTION(streetgen_section_surface) {
  const std::string_view axis = take_bytes(fcinfo, 0);
  const double width = PG_GETARG_FLOAT8(1), start = PG_GETARG_FLOAT8(2), end = PG_GETARG_FLOAT8(3);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const ReadLine read = read_line(axis, "axis");
    result = {true, write_polygon(section_surface(read.line, width_of(width, "width"),
                                                  finite(start, "start_abscissa"),
                                                  finite(end, "end_abscissa")),
                                  {read.srid, false})};
  });
}

STREETGEN_FUNCTION(streetgen_offset_line) {
  const std::string_view axis = take_bytes(fcinfo, 0);
  const double start = PG_GETARG_FLOAT8(1), end = PG_GETARG_FLOAT8(2);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const ReadLine read = read_line(axis, "axis");
    in_range(start, -200, 200, "axis_offset");
    in_range(end, -200, 200, "offset_end");
    result = {true, write_line(offset_line(read.line, start, end), {read.srid, false})};
  });
}

STREETGEN_FUNCTION(streetgen_intersection_surface) {
  Datum* axes;
  bool* nulls;
  int count;
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(0), BYTEAOID, -1, false, 'i', &axes, &nulls, &count);
  for (int i = 0; i < count; ++i) {
    if (nulls[i])
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED), errmsg("axis %d is NULL", i + 1)));
    axes[i] = PointerGetDatum(PG_DETOAST_DATUM_PACKED(axes[i]));
  }
  const Numbers widths = take_lengths(fcinfo, 1), radii = take_lengths(fcinfo, 2);
  const bool curved = PG_GETARG_BOOL(3);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    std::vector<Line> lines;
    int srid = 0;
    for (int i = 0; i < count; ++i) {
      ReadLine read = read_line(bytes_of(axes[i]), "axis " + std::to_string(i + 1));
      if (i > 0 && read.srid != srid)
        throw Error(ErrorKind::invalid_input, "the axes have different SRIDs, " +
                                                  std::to_string(srid) + " and " +
                                                  std::to_string(read.srid));
      srid = read.srid;
      lines.push_back(std::move(read.line));
    }
    const auto w = checked(widths, width_of, "width"), r = checked(radii, radius_of, "radius");
    const CurvedRing ring = curved ? intersection_ring(lines, w, r) : CurvedRing{};
    result = {true, ring.empty() ? write_polygon(intersection_surface(lines, w, r), {srid, false})
                                 : write_curved(ring, {srid, false})};
  });
}

STREETGEN_FUNCTION(streetgen_variable_buffer) {
  const std::string_view line = take_bytes(fcinfo, 0);
  const Numbers radii = take_lengths(fcinfo, 1);
  const char* side = text_to_cstring(PG_GETARG_TEXT_PP(2));
  const char* ends = text_to_cstring(PG_GETARG_TEXT_PP(3));
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const ReadLine read = read_line(line, "line");
    const Side which = word_of<Side>(
        side, "side", {{"both", Side::both}, {"left", Side::left}, {"right", Side::right}});
    const Ends form = word_of<Ends>(ends, "ends", {{"flat", Ends::flat}, {"round", Ends::round}});
    result = {true, write_polygon(variable_buffer(read.line, checked(radii, radius_of, "radius"),
                                                  which, form),
                                  {read.srid, false})};
  });
}

STREETGEN_FUNCTION(streetgen_offset_strip) {
  const std::string_view kerb = take_bytes(fcinfo, 0);
  const double start = PG_GETARG_FLOAT8(1), end = PG_GETARG_FLOAT8(2);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const ReadCurve read = read_curve(kerb, "kerb");
    result = {true, write_polygon(offset_strip(read.curve, in_range(start, 0, 200, "width_start"),
                                               in_range(end, 0, 200, "width_end")),
                                  {read.srid, false})};
  });
}

STREETGEN_FUNCTION(streetgen_crossing_surface) {
  const std::string_view axis = take_bytes(fcinfo, 0);
  const std::string_view left = take_bytes(fcinfo, 1), right = take_bytes(fcinfo, 2);
  const double abscissa = PG_GETARG_FLOAT8(3), width = PG_GETARG_FLOAT8(4);
  const double angle = PG_GETARG_FLOAT8(5);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const ReadLine read = read_line(axis, "axis");
    const auto surface = crossing_surface(
        read.line, read_kerb(left, "kerb_left", read.srid),
        read_kerb(right, "kerb_right", read.srid), finite(abscissa, "abscissa"),
        in_range(width, 0.1, 100, "width"), in_range(angle, 10, 170, "angle") * M_PI / 180);
    if (surface) result = {true, write_polygon({*surface}, {read.srid, false})};
  });
}

STREETGEN_FUNCTION(streetgen_turning_radius) {
  const double speed = PG_GETARG_FLOAT8(0), width = PG_GETARG_FLOAT8(1);
  const char* mode = text_to_cstring(PG_GETARG_TEXT_PP(2));
  const double minimal = PG_GETARG_FLOAT8(3), maximal = PG_GETARG_FLOAT8(4);
  double radius = 0;
  const Outcome outcome = compute([&] {
    in_range(minimal, 0, 1000, "minimal");
    radius = turning_radius(in_range(speed, 0, 400, "speed"), width_of(width, "width"), mode,
                            minimal, in_range(maximal, minimal, 1000, "maximal"));
  });
  report(outcome);
  PG_RETURN_FLOAT8(radius);
}

STREETGEN_FUNCTION(streetgen_clean) {
  const std::string_view line = take_bytes(fcinfo, 0);
  Datum* keep;
  bool* nulls;
  int count;
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(1), BOOLOID, 1, true, 'c', &keep, &nulls, &count);
  const double epsilon = PG_GETARG_FLOAT8(2), r_min = PG_GETARG_FLOAT8(3);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const ReadLine read = read_line(line, "line");
    std::vector<bool> kept;
    for (int i = 0; i < count; ++i) kept.push_back(!nulls[i] && DatumGetBool(keep[i]));
    const Line cleaned = clean(read.line, kept, in_range(epsilon, 0, 1000, "epsilon"),
                               in_range(r_min, 0, 1000, "r_min"));
    result = {true, write_line(cleaned, {read.srid, read.has_z})};
  });
}

STREETGEN_FUNCTION(streetgen_interconnection) {
  const std::string_view in = take_bytes(fcinfo, 0), out = take_bytes(fcinfo, 1),
                         at = take_bytes(fcinfo, 2);
  const char* rule = text_to_cstring(PG_GETARG_TEXT_PP(3));
  const double tolerance = PG_GETARG_FLOAT8(4);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    enum class Rule { bezier, arcs, control };
    const Rule wanted = word_of<Rule>(
        rule, "rule", {{"bezier", Rule::bezier}, {"arcs", Rule::arcs}, {"control", Rule::control}});
    const ReadLine lane_in = read_line(in, "lane_in"), lane_out = read_line(out, "lane_out");
    const ReadPoint centre = read_point(at, "centre");
    if (lane_in.srid != lane_out.srid || lane_in.srid != centre.srid)
      throw Error(ErrorKind::invalid_input, "lane_in has SRID " + std::to_string(lane_in.srid) +
                                                ", lane_out " + std::to_string(lane_out.srid) +
                                                ", centre " + std::to_string(centre.srid));
    const Trajectory path =
        trajectory(lane_in.line, lane_out.line, centre.point,
                   wanted == Rule::arcs ? TrajectoryRule::arcs : TrajectoryRule::bezier,
                   in_range(tolerance, 1e-3, 10, "tolerance"), 0,
                   wanted == Rule::control ? std::optional<Point>(centre.point) : std::nullopt);
    result = {true, write_line(path.line, {lane_in.srid, false})};
  });
}
