#include "frame/composite_rows.hpp"

extern "C" {
#include <access/htup_details.h>
#include <catalog/pg_type.h>
#include <utils/array.h>
#include <utils/typcache.h>
}

namespace streetgen::pg {

Rows rows(FunctionCallInfo fcinfo, int argument, const char* of) {
  Rows rows{of};
  if (PG_ARGISNULL(argument)) return rows;
  ArrayType* array = PG_GETARG_ARRAYTYPE_P(argument);
  Datum* elements;
  bool* missing;
  deconstruct_array(array, ARR_ELEMTYPE(array), -1, false, TYPALIGN_DOUBLE, &elements, &missing,
                    &rows.count);
  rows.type = lookup_rowtype_tupdesc_copy(ARR_ELEMTYPE(array), -1);
  const int width = rows.type->natts;
  auto* values = static_cast<Datum*>(palloc(sizeof(Datum) * width));
  auto* nulls = static_cast<bool*>(palloc(sizeof(bool) * width));
  rows.values = static_cast<Datum*>(
      palloc_extended(sizeof(Datum) * width * Max(rows.count, 1), MCXT_ALLOC_HUGE));
  rows.nulls = static_cast<bool*>(
      palloc_extended(sizeof(bool) * width * Max(rows.count, 1), MCXT_ALLOC_HUGE));
  for (int row = 0; row < rows.count; ++row) {
    if (missing[row])
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED),
                      errmsg("row %d of the %s is NULL", row + 1, of)));
    HeapTupleHeader header = DatumGetHeapTupleHeader(elements[row]);
    HeapTupleData tuple;
    tuple.t_len = HeapTupleHeaderGetDatumLength(header);
    ItemPointerSetInvalid(&tuple.t_self);
    tuple.t_tableOid = InvalidOid;
    tuple.t_data = header;
    heap_deform_tuple(&tuple, rows.type, values, nulls);
    for (int i = 0; i < width; ++i) {
      const Size at = static_cast<Size>(i) * rows.count + row;
      rows.nulls[at] = nulls[i];
      const bool packed = TupleDescAttr(rows.type, i)->attlen == -1 && !nulls[i];
      rows.values[at] = packed ? PointerGetDatum(PG_DETOAST_DATUM_PACKED(values[i])) : values[i];
    }
  }
  return rows;
}

Column column_or_null(const Rows& rows, const char* name, Oid type) {
  if (rows.type == nullptr) return {};
  for (int i = 0; i < rows.type->natts; ++i) {
    const FormData_pg_attribute* attribute = TupleDescAttr(rows.type, i);
    const Size first = static_cast<Size>(i) * rows.count;
    if (strcmp(NameStr(attribute->attname), name) == 0 && attribute->atttypid == type)
      return {rows.values + first, rows.nulls + first};
  }
  elog(ERROR, "the %s have no column %s", rows.of, name);
}

Column column(const Rows& rows, const char* name, Oid type) {
  const Column found = column_or_null(rows, name, type);
  for (int row = 0; row < rows.count; ++row)
    if (found.nulls[row])
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED),
                      errmsg("%s is NULL in row %d of the %s", name, row + 1, rows.of)));
  return found;
}

}  // namespace streetgen::pg
