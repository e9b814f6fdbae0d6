// A law of car following that is a function of SQL: of streetgen.following[] to float8[].
#pragma once

#include "frame/border.hpp"
#include "streetgen/car_following.hpp"

extern "C" {
#include <access/tupdesc.h>
}

namespace streetgen::pg {

struct SqlLaw {
  FmgrInfo function;
  TupleDesc row;
  MemoryContext one_call;
  const char* name;
  ErrorData* raised;  // by the function; nullptr: nothing
};

// For the take step.  No function: nullptr.
SqlLaw* take_law(Oid function);

// For the compute step, which ends where the function raises something.
FollowingLaw law_of(SqlLaw* law);

// For the give step: raises what the function raised, with its name.
void report_law(const SqlLaw* law);

}  // namespace streetgen::pg
