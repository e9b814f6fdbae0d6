// Places beside an axis, from SQL.  Geometries cross as EWKB.
#include "streetgen/object.hpp"

#include <cmath>
#include <string>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "streetgen/width_profile.hpp"
#include "value/number_array.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <utils/array.h>
#include <utils/builtins.h>
}

using namespace streetgen;
using namespace streetgen::pg;

namespace {

WidthProfile read_borders(const NumberArray& borders) {
  WidthProfile profile;
  const std::vector<double> values = read_numbers(borders, 3, "borders");
  for (std::size_t i = 0; i < values.size(); i += 3)
    profile.places.push_back({values[i], values[i + 1], values[i + 2]});
  if (profile.empty()) throw Error(ErrorKind::invalid_input, "borders has no place");
  return profile;
}

int side_of(const char* side) { return word_of<int>(side, "side", {{"left", +1}, {"right", -1}}); }

// Of an axis, its borders, and abscissa, width and angle (degrees) of a crossing.
template <class Draw>
Datum crossing_result(FunctionCallInfo fcinfo, Draw draw) {
  const std::string_view axis = take_bytes(fcinfo, 0);
  const NumberArray borders = take_numbers(fcinfo, 1);
  const double abscissa = PG_GETARG_FLOAT8(2), width = PG_GETARG_FLOAT8(3);
  const double angle = PG_GETARG_FLOAT8(4);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const ReadLine read = read_line(axis, "axis");
    draw(result, read, read_borders(borders),
         StreetCrossing{finite(abscissa, "abscissa"), in_range(width, 0.1, 100, "width"),
                        in_range(angle, 10, 170, "angle") * M_PI / 180});
  });
}

}  // namespace

STREETGEN_FUNCTION(streetgen_place_on) {
  const std::string_view axis = take_bytes(fcinfo, 0);
  const double abscissa = PG_GETARG_FLOAT8(1), offset = PG_GETARG_FLOAT8(2);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const ReadLine read = read_line(axis, "axis");
    const StandingPlace place = place_beside(
        read.line, {finite(abscissa, "abscissa"), in_range(offset, -1000, 1000, "axis_offset")});
    result = {true, write_point(place.point, {read.srid, false})};
  });
}

STREETGEN_FUNCTION(streetgen_direction_on) {
  const std::string_view axis = take_bytes(fcinfo, 0);
  const double abscissa = PG_GETARG_FLOAT8(1), turn = PG_GETARG_FLOAT8(2);
  double degrees = 0;
  const Outcome outcome = compute([&] {
    const ReadLine read = read_line(axis, "axis");
    degrees = place_beside(read.line, {finite(abscissa, "abscissa"), 0}).direction * 180 / M_PI;
    degrees = std::fmod(degrees + in_range(turn, -360, 360, "orientation") + 360, 360);
  });
  report(outcome);
  PG_RETURN_FLOAT8(degrees);
}

STREETGEN_FUNCTION(streetgen_border_at) {
  const NumberArray borders = take_numbers(fcinfo, 0);
  const double abscissa = PG_GETARG_FLOAT8(1);
  const char* side = text_to_cstring(PG_GETARG_TEXT_PP(2));
  double away = 0;
  const Outcome outcome = compute(
      [&] { away = read_borders(borders).at(finite(abscissa, "abscissa")).on(side_of(side)); });
  report(outcome);
  PG_RETURN_FLOAT8(away);
}

STREETGEN_FUNCTION(streetgen_roadway_border) {
  const std::string_view axis = take_bytes(fcinfo, 0);
  const NumberArray borders = take_numbers(fcinfo, 1);
  const double from = PG_GETARG_FLOAT8(2), to = PG_GETARG_FLOAT8(3);
  const char* side = text_to_cstring(PG_GETARG_TEXT_PP(4));
  const double beside = PG_GETARG_FLOAT8(5);
  return geometry_result(fcinfo, [&](GivenGeometry& result) {
    const ReadLine read = read_line(axis, "axis");
    const Line line = roadway_border(read.line, read_borders(borders),
                                     {finite(from, "abscissa"), finite(to, "abscissa_end"),
                                      side_of(side), in_range(beside, -1000, 1000, "axis_offset")});
    if (line.size() > 1) result = {true, write_line(line, {read.srid, false})};
  });
}

STREETGEN_FUNCTION(streetgen_crossing_ground) {
  return crossing_result(fcinfo, [](GivenGeometry& result, const ReadLine& axis,
                                    const WidthProfile& borders, const StreetCrossing& crossing) {
    const auto ground = crossing_ground(axis.line, borders, crossing);
    if (ground) result = {true, write_polygon({*ground}, {axis.srid, false})};
  });
}

STREETGEN_FUNCTION(streetgen_crossing_stripes) {
  const char* marking = text_to_cstring(PG_GETARG_TEXT_PP(5));
  return crossing_result(fcinfo, [=](GivenGeometry& result, const ReadLine& axis,
                                     const WidthProfile& borders, const StreetCrossing& crossing) {
    const auto paint = word_of<CrossingPaint>(marking, "marking",
                                              {{"zebra", CrossingPaint::zebra},
                                               {"ladder", CrossingPaint::ladder},
                                               {"lines", CrossingPaint::lines},
                                               {"dashes", CrossingPaint::dashes},
                                               {"dots", CrossingPaint::dots}});
    const MultiPolygon stripes = crossing_stripes(axis.line, borders, crossing, paint);
    result = {true, write_surface(stripes, {axis.srid, false})};
  });
}

STREETGEN_FUNCTION(streetgen_locate_on) {
  const std::string_view axis = take_bytes(fcinfo, 0), place = take_bytes(fcinfo, 1);
  PlaceBeside found;
  const Outcome outcome = compute([&] {
    const ReadLine read = read_line(axis, "axis");
    const ReadPoint point = read_point(place, "place");
    if (point.srid != read.srid)
      throw Error(ErrorKind::invalid_input, "place has SRID " + std::to_string(point.srid) +
                                                ", axis " + std::to_string(read.srid));
    found = beside_axis(read.line, point.point);
  });
  report(outcome);
  Datum values[2] = {Float8GetDatum(found.abscissa), Float8GetDatum(found.offset)};
  PG_RETURN_POINTER(construct_array(values, 2, FLOAT8OID, 8, true, 'd'));
}
