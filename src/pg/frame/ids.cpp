// streetgen._ids: the ids of rows in the order of their numbers, an aggregate.
#include "frame/border.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <utils/array.h>
}

namespace streetgen::pg {
namespace {

struct IdList {
  int count = 0, room = 0;
  Datum* ids = nullptr;  // 0 where no row has the number
};

void put(IdList* list, int number, Datum id) {
  if (number < 1)
    ereport(ERROR, (errcode(ERRCODE_INVALID_PARAMETER_VALUE),
                    errmsg("the number of a row is %d, expected 1 or more", number)));
  if (number > list->room) {
    const Size room = Max(2 * static_cast<Size>(list->room), Max(static_cast<Size>(number), 64));
    if (room > MaxAllocSize / sizeof(Datum))
      ereport(ERROR,
              (errcode(ERRCODE_PROGRAM_LIMIT_EXCEEDED), errmsg("too many rows for a list of ids")));
    auto* ids = static_cast<Datum*>(palloc0(sizeof(Datum) * room));
    if (list->ids != nullptr) {
      memcpy(ids, list->ids, sizeof(Datum) * list->count);
      pfree(list->ids);
    }
    list->ids = ids;
    list->room = static_cast<int>(room);
  }
  list->ids[number - 1] = id;
  list->count = Max(list->count, number);
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_ids_put) {
  using namespace streetgen::pg;
  MemoryContext kept;
  if (!AggCheckCallContext(fcinfo, &kept)) elog(ERROR, "an aggregate's step, called by itself");
  MemoryContext outer = MemoryContextSwitchTo(kept);
  auto* list = PG_ARGISNULL(0) ? new (palloc(sizeof(IdList))) IdList
                               : reinterpret_cast<IdList*>(PG_GETARG_POINTER(0));
  if (!PG_ARGISNULL(1) && !PG_ARGISNULL(2)) put(list, PG_GETARG_INT32(1), PG_GETARG_DATUM(2));
  MemoryContextSwitchTo(outer);
  PG_RETURN_POINTER(list);
}

STREETGEN_FUNCTION(streetgen_ids_list) {
  using namespace streetgen::pg;
  const auto* list = reinterpret_cast<IdList*>(PG_GETARG_POINTER(0));
  PG_RETURN_POINTER(construct_array(list->ids, list->count, INT8OID, 8, true, TYPALIGN_DOUBLE));
}
