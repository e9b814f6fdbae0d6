// streetgen.plan_view and its twins for roads and paths: chains of lines, arcs and clothoids.
#include "streetgen/plan_view.hpp"

#include <string>
#include <utility>
#include <vector>

#include "frame/argument.hpp"
#include "frame/array_row.hpp"
#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "streetgen/border_line.hpp"
#include "streetgen/road_lanes.hpp"
#include "value/alignment_numbers.hpp"
#include "value/line_array.hpp"
#include "value/number_array.hpp"
#include "value/value_array.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <funcapi.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {
namespace {

// These functions are called for each row.  So they take the description of their result that the
// caller expects: one that is looked up leaves a kilobyte in the memory of the query at each call.

constexpr int chain_columns = 7;
// A plan view has no clothoids.
constexpr int plan_columns = 6;

double number_of(const PlanPiece& piece, int column) {
  const double numbers[chain_columns] = {
      piece.s,      piece.start.point.x, piece.start.point.y, piece.start.heading,
      piece.length, piece.curvature,     piece.curvature_end};
  return numbers[column];
}

// A column of pieces for each number.
NumberColumns columns_of(const std::vector<PlanPiece>& chain) {
  NumberColumns columns(chain_columns);
  for (const PlanPiece& piece : chain)
    for (int i = 0; i < chain_columns; ++i) columns[i].push_back(number_of(piece, i));
  return columns;
}

// A chain from the columns of one row, as give_row writes them.
std::vector<PlanPiece> read_chain(const NumberArray (&columns)[chain_columns]) {
  std::vector<double> of[chain_columns];
  for (int i = 0; i < chain_columns; ++i) {
    of[i] = read_numbers(columns[i], 1, "chain");
    if (of[i].size() != of[0].size())
      throw Error(ErrorKind::invalid_input, "the columns of a chain are of different length");
  }
  std::vector<PlanPiece> chain;
  for (std::size_t k = 0; k < of[0].size(); ++k)
    chain.push_back({of[0][k], {{of[1][k], of[2][k], 0}, of[3][k]}, of[4][k], of[5][k], of[6][k]});
  return chain;
}

// x, y and heading.
ChainPlace read_place(const NumberArray& array, const std::string& name) {
  const std::vector<double> numbers = read_numbers(array, 3, name);
  if (numbers.size() != 3)
    throw Error(ErrorKind::invalid_input, name + " has " + std::to_string(numbers.size()) +
                                              " numbers, expected x, y and a heading");
  return {{numbers[0], numbers[1], 0}, numbers[2]};
}

double tolerance_of(double value) { return in_range(value, 1e-4, 1e3, "tolerance"); }

// The columns of a road: its chain, stations, borders, and the places of lanes at both ends.
NumberColumns columns_of(const RoadLanes& road) {
  NumberColumns columns = columns_of(road.chain);
  columns.push_back(road.stations);
  columns.emplace_back();
  for (const auto& border : road.borders)
    columns.back().insert(columns.back().end(), border.begin(), border.end());
  for (const auto* ends : {&road.starts, &road.ends}) {
    columns.emplace_back();
    for (const LaneLimit& end : *ends)
      for (const double number :
           {end.middle.point.x, end.middle.point.y, end.middle.heading, end.width})
        columns.back().push_back(number);
  }
  return columns;
}

LanePart part_of(int number) {
  constexpr LanePart parts[] = {LanePart::whole, LanePart::left_half, LanePart::right_half};
  if (number < 0 || number > 2) throw Error(ErrorKind::invalid_input, "a part is 0, 1 or 2");
  return parts[number];
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_plan_view) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const std::string_view line = take_bytes(fcinfo, 0);
  const double tolerance = PG_GETARG_FLOAT8(1);
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  auto* slot = make_slot<std::vector<PlanPiece>>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new std::vector<PlanPiece>;
    *slot->value = plan_view(read_line(line, "line").line, tolerance_of(tolerance));
  });
  report(outcome);
  for (const PlanPiece& piece : *slot->value) {
    Datum values[plan_columns];
    const bool nulls[plan_columns] = {false};
    for (int i = 0; i < plan_columns; ++i) values[i] = Float8GetDatum(number_of(piece, i));
    tuplestore_putvalues(result_of(fcinfo)->setResult, result_of(fcinfo)->setDesc, values,
                         const_cast<bool*>(nulls));
  }
  PG_RETURN_NULL();
}

// The path from the end of a lane to the beginning of another: places are x, y and heading.
STREETGEN_FUNCTION(streetgen_path_view) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const std::string_view path = take_bytes(fcinfo, 0);
  const NumberArray from = take_numbers(fcinfo, 1), to = take_numbers(fcinfo, 2);
  const double tolerance = PG_GETARG_FLOAT8(3), lane_width = PG_GETARG_FLOAT8(4);
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  Slot<NumberColumns>* slot = make_slot<NumberColumns>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new NumberColumns;
    const auto chain = path_view(read_line(path, "path").line, read_place(from, "place_from"),
                                 read_place(to, "place_to"), tolerance_of(tolerance),
                                 in_range(lane_width, 1e-3, 1e3, "lane_width"));
    *slot->value = columns_of(chain);
  });
  report(outcome);
  give_row(*slot->value, result_of(fcinfo));
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_chain_station) {
  using namespace streetgen;
  using namespace streetgen::pg;
  NumberArray columns[chain_columns];
  for (int i = 0; i < chain_columns; ++i) columns[i] = take_numbers(fcinfo, i);
  const double x = PG_GETARG_FLOAT8(chain_columns), y = PG_GETARG_FLOAT8(chain_columns + 1);
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  ChainStation station;
  const Outcome outcome = compute([&] {
    const Point place{in_range(x, -1e12, 1e12, "x"), in_range(y, -1e12, 1e12, "y"), 0};
    station = station_of(read_chain(columns), place);
  });
  report(outcome);
  Datum values[] = {Float8GetDatum(station.s), Float8GetDatum(station.aside),
                    Float8GetDatum(station.heading), Float8GetDatum(station.beyond)};
  const bool nulls[] = {false, false, false, false};
  tuplestore_putvalues(result_of(fcinfo)->setResult, result_of(fcinfo)->setDesc, values,
                       const_cast<bool*>(nulls));
  PG_RETURN_NULL();
}

// The columns of a chain, stations, values by border and station, ends of borders, stations and
// heights, and the tolerance.
STREETGEN_FUNCTION(streetgen_chain_borders) {
  using namespace streetgen;
  using namespace streetgen::pg;
  NumberArray columns[chain_columns];
  for (int i = 0; i < chain_columns; ++i) columns[i] = take_numbers(fcinfo, i);
  const NumberArray station = take_numbers(fcinfo, chain_columns);
  const NumberArray border = take_numbers(fcinfo, chain_columns + 1);
  const NumberArray end = take_numbers(fcinfo, chain_columns + 2);
  const NumberArray height_station = take_numbers(fcinfo, chain_columns + 3);
  const NumberArray height = take_numbers(fcinfo, chain_columns + 4);
  const double tolerance = PG_GETARG_FLOAT8(chain_columns + 5);
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  auto* slot = make_slot<std::vector<Line>>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new std::vector<Line>;
    BorderCourse course;
    course.chain = read_chain(columns);
    course.stations = read_numbers(station, 1, "station");
    if (course.stations.size() < 2)
      throw Error(ErrorKind::invalid_input, "there are not two stations");
    const std::vector<double> values = read_numbers(border, course.stations.size(), "border");
    for (auto at = values.begin(); at != values.end(); at += course.stations.size())
      course.borders.emplace_back(at, at + course.stations.size());
    course.height_stations = read_numbers(height_station, 1, "height_station");
    course.heights = read_numbers(height, 1, "height");
    if (course.heights.size() != course.height_stations.size())
      throw Error(ErrorKind::invalid_input, "there are not as many heights as stations of heights");
    std::vector<BorderEnds> ends;
    const std::vector<double> places = read_numbers(end, 4, "ends");
    for (std::size_t i = 0; i < places.size(); i += 4)
      ends.push_back({{places[i], places[i + 1], 0}, {places[i + 2], places[i + 3], 0}});
    *slot->value = border_lines(course, ends, tolerance_of(tolerance));
  });
  report(outcome);
  for (std::size_t b = 0; b < slot->value->size(); ++b) {
    const Line& line = (*slot->value)[b];
    for (std::size_t i = 0; i < line.size(); ++i) {
      Datum values[] = {Int32GetDatum(static_cast<int>(b) + 1),
                        Int32GetDatum(static_cast<int>(i) + 1),
                        BoolGetDatum(i + 1 == line.size()),
                        Float8GetDatum(line[i].x),
                        Float8GetDatum(line[i].y),
                        Float8GetDatum(line[i].z)};
      const bool nulls[] = {false, false, false, false, false, false};
      tuplestore_putvalues(result_of(fcinfo)->setResult, result_of(fcinfo)->setDesc, values,
                           const_cast<bool*>(nulls));
    }
  }
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_road_lanes) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const std::string_view axis = take_bytes(fcinfo, 0);
  const NumberArray alignment = take_numbers(fcinfo, 1);
  const double reach = PG_GETARG_FLOAT8(2);
  const LineArray lines = take_lines(PG_GETARG_ARRAYTYPE_P(3), "lines");
  const LineArray surfaces = take_lines(PG_GETARG_ARRAYTYPE_P(4), "surfaces");
  const ValueArray widths = take_values(fcinfo, 5, FLOAT8OID, lines.count, "widths");
  const ValueArray parts = take_values(fcinfo, 6, INT4OID, lines.count, "parts");
  const double tolerance = PG_GETARG_FLOAT8(7);
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  Slot<NumberColumns>* slot = make_slot<NumberColumns>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new NumberColumns;
    std::vector<LaneGround> lanes;
    for (int i = 0; i < lines.count && i < surfaces.count; ++i) {
      const std::string number = std::to_string(i + 1);
      lanes.push_back({read_surface(bytes_of(surfaces.values[i]), "surface " + number),
                       read_line(bytes_of(lines.values[i]), "line " + number).line,
                       in_range(DatumGetFloat8(widths.values[i]), 0, 1e4, "width"),
                       part_of(DatumGetInt32(parts.values[i]))});
    }
    const Line line = read_line(axis, "axis").line;
    auto course = course_beside(elements_of(alignment), line, in_range(reach, 0, 1e3, "reach"));
    *slot->value = columns_of(course.empty() ? road_lanes(line, lanes, tolerance_of(tolerance))
                                             : road_lanes(std::move(course), lanes));
  });
  report(outcome);
  give_row(*slot->value, result_of(fcinfo));
  PG_RETURN_NULL();
}

// The columns of a chain, stations, values by border and station, and two stations.
STREETGEN_FUNCTION(streetgen_road_part) {
  using namespace streetgen;
  using namespace streetgen::pg;
  NumberArray columns[chain_columns];
  for (int i = 0; i < chain_columns; ++i) columns[i] = take_numbers(fcinfo, i);
  const NumberArray station = take_numbers(fcinfo, chain_columns);
  const NumberArray border = take_numbers(fcinfo, chain_columns + 1);
  const double from = PG_GETARG_FLOAT8(chain_columns + 2);
  const double to = PG_GETARG_FLOAT8(chain_columns + 3);
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  Slot<NumberColumns>* slot = make_slot<NumberColumns>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new NumberColumns;
    RoadLanes road;
    road.chain = read_chain(columns);
    road.stations = read_numbers(station, 1, "station");
    if (road.stations.size() < 2)
      throw Error(ErrorKind::invalid_input, "there are not two stations");
    if (!(from >= 0)) throw Error(ErrorKind::invalid_input, "a part begins before its road");
    const std::vector<double> values = read_numbers(border, road.stations.size(), "border");
    for (auto at = values.begin(); at != values.end(); at += road.stations.size())
      road.borders.emplace_back(at, at + road.stations.size());
    const RoadLanes part = road_part(road, from, std::min(to, road.stations.back()));
    if (part.chain.empty()) throw Error(ErrorKind::invalid_input, "a part has no length");
    *slot->value = columns_of(part);
  });
  report(outcome);
  give_row(*slot->value, result_of(fcinfo));
  PG_RETURN_NULL();
}
