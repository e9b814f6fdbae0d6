// The stages of a road from SQL: path, curves, profile, estimate; and heights of the ground.
#include "streetgen/road_design.hpp"

#include <string>
#include <vector>

#include "design/road_site.hpp"
#include "frame/geometry_result.hpp"
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

void give_numbers(FunctionCallInfo fcinfo, std::initializer_list<double> numbers) {
  Datum values[8];
  bool nulls[8] = {false};
  int n = 0;
  for (double number : numbers) values[n++] = Float8GetDatum(number);
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
}

const char* barrier_name(Barrier barrier) {
  switch (barrier) {
    case Barrier::terrain:
      return "terrain";
    case Barrier::zone:
      return "zone";
    case Barrier::grade:
      return "grade";
    case Barrier::turn:
      return "turn";
    default:
      return "none";
  }
}

struct PathResult {
  RoadPath path;
  char barrier[16] = "";
};

std::vector<VertexCurve> given_curves(const std::vector<double>& numbers) {
  std::vector<VertexCurve> curves;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    curves.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  return curves;
}

void give_term(FunctionCallInfo fcinfo, const char* what, double start, double end, double value) {
  Datum values[4] = {CStringGetTextDatum(what), Float8GetDatum(start), Float8GetDatum(end),
                     Float8GetDatum(value)};
  bool nulls[4] = {false};
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
}

}  // namespace
}  // namespace streetgen::pg

using namespace streetgen;
using namespace streetgen::pg;

STREETGEN_FUNCTION(streetgen_ground_heights) {
  const SiteArgument::Column tiles = take_column(PG_GETARG_DATUM(0), BYTEAOID);
  const NumberArray xs = take_numbers(fcinfo, 1), ys = take_numbers(fcinfo, 2);
  using Heights = std::vector<double>;
  Slot<Heights>* slot = make_slot<Heights>(CurrentMemoryContext);
  report(compute([&] {
    slot->value = new Heights;
    const Terrain terrain = read_terrain(tiles);
    for (int i = 0; i < xs.count && i < ys.count; ++i)
      slot->value->push_back(
          terrain.ground(DatumGetFloat8(xs.values[i]), DatumGetFloat8(ys.values[i])).height);
  }));
  const int count = static_cast<int>(slot->value->size());
  auto* values = static_cast<Datum*>(palloc((count + 1) * sizeof(Datum)));
  for (int i = 0; i < count; ++i) values[i] = Float8GetDatum((*slot->value)[i]);
  PG_RETURN_ARRAYTYPE_P(construct_array(values, count, FLOAT8OID, 8, true, 'd'));
}

STREETGEN_FUNCTION(streetgen_height_tile_box) {
  const std::string_view tile = take_bytes(fcinfo, 0);
  double box[5] = {0};
  report(compute([&] {
    const HeightTile read = read_height_tile(tile);
    box[0] = read.x, box[1] = read.y - read.height * read.cell;
    box[2] = read.x + read.width * read.cell, box[3] = read.y, box[4] = read.srid;
  }));
  Datum values[5];
  for (int i = 0; i < 5; ++i) values[i] = Float8GetDatum(box[i]);
  PG_RETURN_ARRAYTYPE_P(construct_array(values, 5, FLOAT8OID, 8, true, 'd'));
}

STREETGEN_FUNCTION(streetgen_road_path) {
  InitMaterializedSRF(fcinfo, 0);
  const SiteArgument site = take_site(fcinfo, 0);
  const std::string_view places = take_bytes(fcinfo, 1);
  const NumberArray straight = take_numbers(fcinfo, 2);
  Slot<PathResult>* slot = make_slot<PathResult>(CurrentMemoryContext);
  report(compute([&] {
    slot->value = new PathResult;
    const Line line = read_line(places, "places").line;
    std::vector<bool> sides;
    for (double side : read_numbers(straight, 1, "straight")) sides.push_back(side != 0);
    sides.resize(line.size(), false);
    slot->value->path = road_path(read_site(site)->site(), line, sides);
    strlcpy(slot->value->barrier, barrier_name(slot->value->path.barrier), 16);
  }));
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  const PathResult& found = *slot->value;
  for (const PathVertex& v : found.path.vertices) {
    Datum values[5] = {Float8GetDatum(v.point.x), Float8GetDatum(v.point.y),
                       Float8GetDatum(v.point.z), BoolGetDatum(v.by_hand), 0};
    bool nulls[5] = {false, false, false, false, true};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
  if (found.path.vertices.empty()) {
    Datum values[5] = {0, 0, 0, 0, CStringGetTextDatum(found.barrier)};
    bool nulls[5] = {true, true, true, true, false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  }
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_road_curves) {
  InitMaterializedSRF(fcinfo, 0);
  const SiteArgument site = take_site(fcinfo, 0);
  const std::string_view line = take_bytes(fcinfo, 1);
  const NumberArray given = take_numbers(fcinfo, 2);
  using Curves = std::vector<VertexCurve>;
  Slot<Curves>* slot = make_slot<Curves>(CurrentMemoryContext);
  report(compute([&] {
    const Line read = read_line(line, "path").line;
    std::vector<VertexCurve> by_hand = given_curves(read_numbers(given, 3, "curves"));
    by_hand.resize(read.size());
    slot->value = new Curves(road_curves(read_rules(site), read, by_hand));
  }));
  for (const VertexCurve& c : *slot->value)
    give_numbers(fcinfo, {c.radius, c.clothoid_in, c.clothoid_out});
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_road_profile) {
  InitMaterializedSRF(fcinfo, 0);
  const SiteArgument site = take_site(fcinfo, 0);
  const NumberArray elements = take_numbers(fcinfo, 1), ends = take_numbers(fcinfo, 2),
                    fixed = take_numbers(fcinfo, 3), rejected = take_numbers(fcinfo, 4),
                    limits = take_numbers(fcinfo, 5);
  using Points = std::vector<GradePoint>;
  Slot<Points>* slot = make_slot<Points>(CurrentMemoryContext);
  report(compute([&] {
    ProfileWish wish;
    const std::vector<double> heights = read_numbers(ends, 2, "end heights");
    if (heights.size() == 2) wish.start_height = heights[0], wish.end_height = heights[1];
    wish.fixed = grade_points_of(fixed);
    wish.rejected = read_numbers(rejected, 1, "rejected");
    const std::vector<double> bounds = read_numbers(limits, 3, "limits");
    for (std::size_t i = 0; i < bounds.size(); i += 3)
      wish.limits.push_back({bounds[i], bounds[i + 1], bounds[i + 2]});
    slot->value = new Points(road_profile(read_site(site)->site(), elements_of(elements), wish));
  }));
  for (const GradePoint& p : *slot->value) give_numbers(fcinfo, {p.abscissa, p.height, p.radius});
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_road_estimate) {
  InitMaterializedSRF(fcinfo, 0);
  const SiteArgument site = take_site(fcinfo, 0);
  const NumberArray elements = take_numbers(fcinfo, 1), grades = take_numbers(fcinfo, 2);
  Slot<RoadEstimate>* slot = make_slot<RoadEstimate>(CurrentMemoryContext);
  report(compute([&] {
    slot->value = new RoadEstimate(road_estimate(read_site(site)->site(), elements_of(elements),
                                                 vertical_alignment(grade_points_of(grades))));
  }));
  const RoadEstimate& e = *slot->value;
  for (const RoadStructure& s : e.structures)
    give_term(fcinfo, s.kind == StructureKind::bridge ? "is bridge" : "is tunnel", s.start_abscissa,
              s.end_abscissa, 0);
  const std::pair<const char*, double> terms[] = {
      {"pavement", e.cost.pavement}, {"land", e.cost.land},     {"fill", e.cost.fill},
      {"cut", e.cost.cut},           {"bridge", e.cost.bridge}, {"tunnel", e.cost.tunnel},
      {"zones", e.cost.zones},       {"use", e.cost.use}};
  for (const auto& [name, cost] : terms) give_term(fcinfo, name, 0, e.length, cost);
  PG_RETURN_NULL();
}
