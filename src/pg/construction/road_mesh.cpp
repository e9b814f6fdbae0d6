// streetgen._road_mesh and _gltf_mesh: the triangles of surfaces, with the heights of axes.
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "streetgen/gltf_mesh.hpp"
#include "streetgen/surface_mesh.hpp"
#include "value/line_array.hpp"
#include "value/value_array.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <funcapi.h>
#include <utils/array.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {

namespace {

// The first arguments of both functions.
struct MeshArguments {
  LineArray surfaces;
  const Datum *levels, *wanted, *raised;
  LineArray lines, axes;
  const Datum *axis_levels, *axis_widths;
  double tolerance;
};

MeshArguments take_arguments(FunctionCallInfo fcinfo) {
  MeshArguments taken;
  taken.surfaces = take_lines(PG_GETARG_ARRAYTYPE_P(0), "surfaces");
  const int count = taken.surfaces.count;
  taken.levels = take_values(fcinfo, 1, INT4OID, count, "levels").values;
  taken.wanted = take_values(fcinfo, 2, BOOLOID, count, "wanted").values;
  taken.raised = take_values(fcinfo, 3, FLOAT8OID, count, "raised").values;
  taken.lines = take_lines(PG_GETARG_ARRAYTYPE_P(4), "lines");
  taken.axes = take_lines(PG_GETARG_ARRAYTYPE_P(5), "axes");
  taken.axis_levels = take_values(fcinfo, 6, INT4OID, taken.axes.count, "axis_levels").values;
  taken.axis_widths = take_values(fcinfo, 7, FLOAT8OID, taken.axes.count, "axis_widths").values;
  taken.tolerance = PG_GETARG_FLOAT8(8);
  return taken;
}

std::vector<GroundMesh> made(const MeshArguments& taken) {
  in_range(taken.tolerance, 1e-3, 10, "tolerance");
  if (taken.lines.count != taken.surfaces.count)
    throw Error(ErrorKind::invalid_input, "surfaces and lines differ in number");
  std::vector<Line> lines = read_lines(taken.lines, "line", nullptr);
  std::vector<MeshedSurface> asked;
  for (int i = 0; i < taken.surfaces.count; ++i)
    asked.push_back(
        {read_surface(bytes_of(taken.surfaces.values[i]), "surface " + std::to_string(i + 1)),
         DatumGetInt32(taken.levels[i]), std::move(lines[i]),
         finite(DatumGetFloat8(taken.raised[i]), "raised"), DatumGetBool(taken.wanted[i])});
  std::vector<HeightAxis> axes;
  for (Line& line : read_lines(taken.axes, "axis", nullptr))
    axes.push_back(
        {std::move(line), DatumGetInt32(taken.axis_levels[axes.size()]),
         in_range(DatumGetFloat8(taken.axis_widths[axes.size()]), 0, 1000, "axis_widths") / 2});
  return mesh_surfaces(asked, axes, taken.tolerance);
}

// A row of _road_mesh.
struct MeshRow {
  int number;
  bool kerb;
  std::string tin;
  std::vector<float> normals, texture;
};

MeshRow row_of(int number, bool kerb, const SurfaceMesh& mesh, int srid) {
  MeshRow row{number, kerb, write_tin(mesh.triangles, srid), {}, {}};
  for (const Point& normal : mesh.normals)
    for (const double value : {normal.x, normal.y, normal.z})
      row.normals.push_back(static_cast<float>(value));
  for (const auto& [along, aside] : mesh.texture)
    row.texture.insert(row.texture.end(), {static_cast<float>(along), static_cast<float>(aside)});
  return row;
}

Datum floats_datum(const float* values, int count) {
  auto* all = static_cast<Datum*>(palloc(count * sizeof(Datum)));
  for (int i = 0; i < count; ++i) all[i] = Float4GetDatum(values[i]);
  const Datum array =
      PointerGetDatum(construct_array(all, count, FLOAT4OID, 4, true, TYPALIGN_INT));
  pfree(all);
  return array;
}

Datum floats_datum(const std::vector<float>& values) {
  return floats_datum(values.data(), static_cast<int>(values.size()));
}

}  // namespace

}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_road_mesh) {
  using namespace streetgen;
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  const MeshArguments taken = take_arguments(fcinfo);
  const int srid = PG_GETARG_INT32(9);
  Slot<std::vector<MeshRow>>* slot = make_slot<std::vector<MeshRow>>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new std::vector<MeshRow>;
    int number = 0;
    for (const GroundMesh& mesh : made(taken)) {
      ++number;
      if (!mesh.ground.triangles.empty())
        slot->value->push_back(row_of(number, false, mesh.ground, srid));
      if (!mesh.kerb.triangles.empty())
        slot->value->push_back(row_of(number, true, mesh.kerb, srid));
    }
  });
  report(outcome);
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  for (const MeshRow& row : *slot->value) {
    Datum values[5] = {Int32GetDatum(row.number), BoolGetDatum(row.kerb), bytes_datum(row.tin),
                       floats_datum(row.normals), floats_datum(row.texture)};
    bool nulls[5] = {};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
    for (int i = 2; i < 5; ++i) pfree(DatumGetPointer(values[i]));
  }
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_gltf_mesh) {
  using namespace streetgen;
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  const MeshArguments taken = take_arguments(fcinfo);
  const Datum* materials =
      take_values(fcinfo, 9, INT4OID, taken.surfaces.count, "materials").values;
  const int kerb = PG_GETARG_INT32(10);
  const Point origin{PG_GETARG_FLOAT8(11), PG_GETARG_FLOAT8(12), PG_GETARG_FLOAT8(13)};
  using Packed = std::map<int, GltfMesh>;
  Slot<Packed>* slot = make_slot<Packed>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    for (const double value : {origin.x, origin.y, origin.z}) finite(value, "origin");
    const std::vector<GroundMesh> meshes = made(taken);
    std::map<int, std::vector<const SurfaceMesh*>> of_material;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      of_material[DatumGetInt32(materials[i])].push_back(&meshes[i].ground);
      of_material[kerb].push_back(&meshes[i].kerb);
    }
    slot->value = new Packed;
    for (const auto& [material, members] : of_material)
      if (GltfMesh packed = gltf_mesh(members, origin); packed.indices > 0)
        (*slot->value)[material] = std::move(packed);
  });
  report(outcome);
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  for (const auto& [material, mesh] : *slot->value) {
    Datum values[6] = {Int32GetDatum(material),           Int64GetDatum(mesh.vertices),
                       Int64GetDatum(mesh.indices),       floats_datum(mesh.least.data(), 3),
                       floats_datum(mesh.most.data(), 3), bytes_datum(mesh.bytes)};
    bool nulls[6] = {};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
    for (int i = 3; i < 6; ++i) pfree(DatumGetPointer(values[i]));
  }
  PG_RETURN_NULL();
}
