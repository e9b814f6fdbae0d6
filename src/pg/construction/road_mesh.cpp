// streetgen._road_mesh, _gltf_mesh and _indexed_mesh: the triangles of surfaces, with the heights
// of axes; and _gltf_shape: those of objects.
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "streetgen/gltf_mesh.hpp"
#include "streetgen/indexed_mesh.hpp"
#include "streetgen/object_shape.hpp"
#include "streetgen/surface_mesh.hpp"
#include "value/decimal.hpp"
#include "value/line_array.hpp"
#include "value/value_array.hpp"
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

// The first arguments of all.
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

// The row of _indexed_mesh.
struct IndexedRow {
  std::vector<std::string> places, normals, texture;
  // Each mesh that has triangles has its surface, whether it is the kerb of that, and their count.
  std::vector<int> numbers, kerbs, triangles;
  // Numbers from 1 of place, texture and normal of each corner.
  std::vector<int> corners;
};

// The numbers of a list, divided by spaces, or by commas as whole steps.
template <std::size_t size>
std::vector<std::string> texts_of(const std::vector<std::array<std::int64_t, size>>& values,
                                  int digits, bool decimals) {
  const double steps = std::pow(10, digits);
  std::vector<std::string> texts;
  for (const auto& value : values) {
    std::string text;
    for (const std::int64_t part : value) {
      if (!text.empty()) text += decimals ? ' ' : ',';
      if (decimals)
        append_short_decimal(text, static_cast<double>(part) / steps, digits);
      else
        text += std::to_string(part);
    }
    texts.push_back(std::move(text));
  }
  return texts;
}

IndexedRow indexed_row(const std::vector<GroundMesh>& meshes, const Point& origin, int digits,
                       bool decimals) {
  std::vector<const SurfaceMesh*> members;
  for (const GroundMesh& mesh : meshes) members.insert(members.end(), {&mesh.ground, &mesh.kerb});
  const IndexedMesh indexed = indexed_mesh(members, origin, std::pow(10, -digits));
  IndexedRow row;
  row.places = texts_of(indexed.places, digits, decimals);
  row.normals = texts_of(indexed.normals, 3, true);
  row.texture = texts_of(indexed.texture, 3, true);
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (indexed.triangles[i].empty()) continue;
    row.numbers.push_back(static_cast<int>(i / 2) + 1);
    row.kerbs.push_back(static_cast<int>(i % 2));
    row.triangles.push_back(static_cast<int>(indexed.triangles[i].size()));
    for (const auto& corners : indexed.triangles[i])
      for (const IndexedMesh::Corner& corner : corners)
        row.corners.insert(row.corners.end(),
                           {corner.place + 1, corner.texture + 1, corner.normal + 1});
  }
  return row;
}

Datum text_list(const std::vector<std::string>& values) {
  const int count = static_cast<int>(values.size());
  auto* all = static_cast<Datum*>(palloc(count * sizeof(Datum)));
  for (int i = 0; i < count; ++i)
    all[i] = PointerGetDatum(
        cstring_to_text_with_len(values[i].data(), static_cast<int>(values[i].size())));
  const Datum array =
      PointerGetDatum(construct_array(all, count, TEXTOID, -1, false, TYPALIGN_INT));
  for (int i = 0; i < count; ++i) pfree(DatumGetPointer(all[i]));
  pfree(all);
  return array;
}

Datum integer_list(const std::vector<int>& values, Oid type) {
  const int count = static_cast<int>(values.size());
  auto* all = static_cast<Datum*>(palloc(count * sizeof(Datum)));
  for (int i = 0; i < count; ++i)
    all[i] = type == BOOLOID ? BoolGetDatum(values[i] != 0) : Int32GetDatum(values[i]);
  const Datum array = PointerGetDatum(
      type == BOOLOID ? construct_array(all, count, BOOLOID, 1, true, TYPALIGN_CHAR)
                      : construct_array(all, count, INT4OID, 4, true, TYPALIGN_INT));
  pfree(all);
  return array;
}

// Rows of _gltf_mesh and _gltf_shape: a number, and the data of its mesh.
Datum give_packed(FunctionCallInfo fcinfo, const std::map<int, GltfMesh>& packed) {
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  for (const auto& [part, mesh] : packed) {
    Datum values[6] = {Int32GetDatum(part),
                       Int64GetDatum(mesh.vertices),
                       Int64GetDatum(mesh.indices),
                       floats_datum(mesh.least.data(), 3),
                       floats_datum(mesh.most.data(), 3),
                       bytes_datum(mesh.bytes)};
    bool nulls[6] = {};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
    for (int i = 3; i < 6; ++i) pfree(DatumGetPointer(values[i]));
  }
  PG_RETURN_NULL();
}

}  // namespace

}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_indexed_mesh) {
  using namespace streetgen;
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  const MeshArguments taken = take_arguments(fcinfo);
  const Point origin{PG_GETARG_FLOAT8(9), PG_GETARG_FLOAT8(10), PG_GETARG_FLOAT8(11)};
  const int digits = PG_GETARG_INT32(12);
  const bool decimals = PG_GETARG_BOOL(13);
  Slot<IndexedRow>* slot = make_slot<IndexedRow>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    for (const double value : {origin.x, origin.y, origin.z}) finite(value, "origin");
    in_range(digits, 0, 8, "digits");
    slot->value = new IndexedRow(indexed_row(made(taken), origin, digits, decimals));
  });
  report(outcome);
  const IndexedRow& row = *slot->value;
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  Datum values[7] = {text_list(row.places),
                     text_list(row.texture),
                     text_list(row.normals),
                     integer_list(row.numbers, INT4OID),
                     integer_list(row.kerbs, BOOLOID),
                     integer_list(row.triangles, INT4OID),
                     integer_list(row.corners, INT4OID)};
  bool nulls[7] = {};
  tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  PG_RETURN_NULL();
}

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
  const Datum* parts = take_values(fcinfo, 9, INT4OID, taken.surfaces.count, "parts").values;
  const Datum* kerb_parts =
      take_values(fcinfo, 10, INT4OID, taken.surfaces.count, "kerb_parts").values;
  const Point origin{PG_GETARG_FLOAT8(11), PG_GETARG_FLOAT8(12), PG_GETARG_FLOAT8(13)};
  using Packed = std::map<int, GltfMesh>;
  Slot<Packed>* slot = make_slot<Packed>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    for (const double value : {origin.x, origin.y, origin.z}) finite(value, "origin");
    const std::vector<GroundMesh> meshes = made(taken);
    std::map<int, std::vector<const SurfaceMesh*>> of_part;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      of_part[DatumGetInt32(parts[i])].push_back(&meshes[i].ground);
      of_part[DatumGetInt32(kerb_parts[i])].push_back(&meshes[i].kerb);
    }
    slot->value = new Packed;
    for (const auto& [part, members] : of_part)
      if (GltfMesh packed = gltf_mesh(members, origin); packed.indices > 0)
        (*slot->value)[part] = std::move(packed);
  });
  report(outcome);
  return give_packed(fcinfo, *slot->value);
}

STREETGEN_FUNCTION(streetgen_gltf_shape) {
  using namespace streetgen;
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  const std::string_view kind = take_bytes(fcinfo, 0);
  using Packed = std::map<int, GltfMesh>;
  Slot<Packed>* slot = make_slot<Packed>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    const ObjectShape shape = object_shape(std::string(kind));
    slot->value = new Packed;
    if (!shape.post.triangles.empty()) (*slot->value)[0] = gltf_mesh({&shape.post}, {});
    if (!shape.head.triangles.empty()) (*slot->value)[1] = gltf_mesh({&shape.head}, {});
  });
  report(outcome);
  return give_packed(fcinfo, *slot->value);
}
