// Functions that take geometries as EWKB and give one.
#pragma once

#include <string>
#include <string_view>

#include "frame/border.hpp"

namespace streetgen::pg {

inline std::string_view take_bytes(FunctionCallInfo fcinfo, int argument) {
  return bytes_of(PointerGetDatum(PG_GETARG_BYTEA_PP(argument)));
}

// The result of a primitive: EWKB, or nothing (NULL).
struct GivenGeometry {
  bool present = false;
  std::string wkb;
};

template <class Work>
Datum geometry_result(FunctionCallInfo fcinfo, Work work) {
  Slot<GivenGeometry>* slot = make_slot<GivenGeometry>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new GivenGeometry;
    work(*slot->value);
  });
  report(outcome);
  if (!slot->value->present) PG_RETURN_NULL();
  return bytes_datum(slot->value->wkb);
}

}  // namespace streetgen::pg
