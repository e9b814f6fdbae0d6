// streetgen._road_mesh: the triangles of surfaces, with the heights of axes.
#include <optional>
#include <string>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "streetgen/surface_mesh.hpp"
#include "value/line_array.hpp"
#include "value/value_array.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <funcapi.h>
#include <utils/tuplestore.h>
}

STREETGEN_FUNCTION(streetgen_road_mesh) {
  using namespace streetgen;
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, 0);
  const LineArray surfaces = take_lines(PG_GETARG_ARRAYTYPE_P(0), "surfaces");
  const Datum* levels = take_values(fcinfo, 1, INT4OID, surfaces.count, "levels").values;
  const Datum* wanted = take_values(fcinfo, 2, BOOLOID, surfaces.count, "wanted").values;
  const LineArray axes = take_lines(PG_GETARG_ARRAYTYPE_P(3), "axes");
  const Datum* axis_levels = take_values(fcinfo, 4, INT4OID, axes.count, "axis_levels").values;
  const double tolerance = PG_GETARG_FLOAT8(5);
  const int srid = PG_GETARG_INT32(6);
  using Meshes = std::vector<std::optional<std::string>>;
  Slot<Meshes>* slot = make_slot<Meshes>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    in_range(tolerance, 1e-3, 10, "tolerance");
    std::vector<MeshedSurface> asked;
    for (int i = 0; i < surfaces.count; ++i)
      asked.push_back(
          {read_surface(bytes_of(surfaces.values[i]), "surface " + std::to_string(i + 1)),
           DatumGetInt32(levels[i]), DatumGetBool(wanted[i])});
    std::vector<HeightAxis> known;
    for (Line& line : read_lines(axes, "axis", nullptr))
      known.push_back({std::move(line), DatumGetInt32(axis_levels[known.size()])});
    slot->value = new Meshes;
    for (const std::vector<Triangle>& mesh : mesh_surfaces(asked, known, tolerance))
      slot->value->push_back(mesh.empty() ? std::nullopt : std::optional(write_tin(mesh, srid)));
  });
  report(outcome);
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  for (std::size_t i = 0; i < slot->value->size(); ++i) {
    std::optional<std::string>& mesh = (*slot->value)[i];
    if (!mesh) continue;
    Datum values[2] = {Int32GetDatum(static_cast<int>(i) + 1), bytes_datum(*mesh)};
    bool nulls[2] = {false, false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
    pfree(DatumGetPointer(values[1]));
    mesh.reset();
  }
  PG_RETURN_NULL();
}
