// Arguments that are arrays of rows, column by column: PostgreSQL's memory, plain pointers.
#pragma once

#include "frame/border.hpp"

extern "C" {
#include <access/tupdesc.h>
}

namespace streetgen::pg {

// A column of rows that are one argument together.
struct Column {
  const Datum* values;
  const bool* nulls;
};

// An argument that is an array of rows; NULL is none.
struct Rows {
  const char* of;
  int count = 0;
  TupleDesc type = nullptr;
  Datum* values = nullptr;  // column by column
  bool* nulls = nullptr;
};

// `of` names the rows in errors.  Raises where an element is NULL.
Rows rows(FunctionCallInfo fcinfo, int argument, const char* of);

// A column of the row type, by its name there; the first may hold NULL, the second raises.
Column column_or_null(const Rows& rows, const char* name, Oid type);
Column column(const Rows& rows, const char* name, Oid type);

}  // namespace streetgen::pg
