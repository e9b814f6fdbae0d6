// Rows that a function gives, one after the other.
#pragma once

#include <cstring>
#include <vector>

#include "frame/border.hpp"
#include "value/stored.hpp"

extern "C" {
#include <funcapi.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {

// A line as PostGIS stores it, in the current memory.
inline Datum line_datum(const Line& line, const Form& form) {
  Slot<Stored>* slot = make_slot<Stored>(CurrentMemoryContext);
  report(compute([&] { slot->value = new Stored(stored_line(line, form)); }));
  void* out = palloc(VARSIZE(slot->value->get()));
  memcpy(out, slot->value->get(), VARSIZE(slot->value->get()));
  return PointerGetDatum(out);
}

// Puts a row of values for each of `all`, made in a memory of its own.
template <class Given, class Put>
void put_rows(FunctionCallInfo fcinfo, const std::vector<Given>& all, Put put) {
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  MemoryContext per_row =
      AllocSetContextCreate(CurrentMemoryContext, "streetgen row", ALLOCSET_DEFAULT_SIZES);
  for (const Given& one : all) {
    MemoryContext before = MemoryContextSwitchTo(per_row);
    put(one, result);
    MemoryContextSwitchTo(before);
    MemoryContextReset(per_row);
  }
}

}  // namespace streetgen::pg
