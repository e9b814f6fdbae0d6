// streetgen._cityjson_boundaries and _wavefront_faces: triangles of an indexed mesh as text.
#include <cstdint>
#include <string>
#include <vector>

#include "frame/border.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "value/value_array.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <funcapi.h>
#include <utils/builtins.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {

namespace {

constexpr int numbers_per_triangle = 9;

// The arguments of both functions: triangles of each mesh, the numbers of their corners, and the
// number in the file of each place.
struct TriangleLists {
  ValueArray triangles, corners, places;
};

TriangleLists take_lists(FunctionCallInfo fcinfo) {
  return {take_values(fcinfo, 0, INT4OID, any_count, "triangles"),
          take_values(fcinfo, 1, INT4OID, any_count, "corners"),
          take_values(fcinfo, 2, INT8OID, any_count, "places")};
}

// A text for each mesh: what `write` appends for the corners of each triangle.
template <class Write>
std::vector<std::string> texts_of(const TriangleLists& lists, Write write) {
  std::vector<std::string> texts;
  std::int64_t corner = 0;
  for (int i = 0; i < lists.triangles.count; ++i) {
    poll_cancel();
    std::string& text = texts.emplace_back();
    const std::int64_t triangles = DatumGetInt32(lists.triangles.values[i]);
    const std::int64_t last = corner + triangles * numbers_per_triangle;
    if (last < corner || last > lists.corners.count)
      throw Error(ErrorKind::invalid_input, "corners are fewer than triangles name");
    for (; corner < last; corner += numbers_per_triangle) write(text, corner);
  }
  return texts;
}

int corner_number(const TriangleLists& lists, std::int64_t which) {
  return DatumGetInt32(lists.corners.values[which]);
}

// The number in the file of the place of a corner.
std::string place_text(const TriangleLists& lists, std::int64_t which) {
  const int place = corner_number(lists, which);
  if (place < 1 || place > lists.places.count)
    throw Error(ErrorKind::invalid_input, "a corner names no place");
  return std::to_string(DatumGetInt64(lists.places.values[place - 1]));
}

template <class Write>
Datum give_texts(FunctionCallInfo fcinfo, const TriangleLists& lists, Write write) {
  auto* slot = make_slot<std::vector<std::string>>(CurrentMemoryContext);
  const Outcome outcome =
      compute([&] { slot->value = new std::vector<std::string>(texts_of(lists, write)); });
  report(outcome);
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  int mesh = 0;
  for (const std::string& text : *slot->value) {
    Datum values[2] = {Int32GetDatum(++mesh), PointerGetDatum(cstring_to_text_with_len(
                                                  text.data(), static_cast<int>(text.size())))};
    bool nulls[2] = {};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
    pfree(DatumGetPointer(values[1]));
  }
  PG_RETURN_NULL();
}

}  // namespace

}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_cityjson_boundaries) {
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  const TriangleLists lists = take_lists(fcinfo);
  return give_texts(fcinfo, lists, [&](std::string& text, std::int64_t corner) {
    if (!text.empty()) text += ',';
    for (int k = 0; k < 3; ++k) {
      text += k == 0 ? "[[" : ",";
      text += place_text(lists, corner + 3 * k);
    }
    text += "]]";
  });
}

STREETGEN_FUNCTION(streetgen_wavefront_faces) {
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  const TriangleLists lists = take_lists(fcinfo);
  const std::int64_t texture = PG_GETARG_INT64(3), normals = PG_GETARG_INT64(4);
  return give_texts(fcinfo, lists, [&](std::string& text, std::int64_t corner) {
    text += text.empty() ? "f" : "\nf";
    for (int k = 0; k < 3; ++k, corner += 3) {
      text += ' ' + place_text(lists, corner);
      text += '/' + std::to_string(texture + corner_number(lists, corner + 1));
      text += '/' + std::to_string(normals + corner_number(lists, corner + 2));
    }
  });
}
