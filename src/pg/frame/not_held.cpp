// streetgen._not_held: which advisory locks this session has yet to take.
#include "frame/border.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <storage/lock.h>
#include <utils/array.h>
}

namespace streetgen::pg {
namespace {

bool is_held(const LOCKTAG& lock, LOCKMODE mode) {
#if PG_VERSION_NUM >= 170000
  return LockHeldByMe(&lock, mode, false);
#else
  return LockHeldByMe(&lock, mode);
#endif
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_not_held) {
  using namespace streetgen::pg;
  const int32 model = PG_GETARG_INT32(0);
  ArrayType* given = PG_GETARG_ARRAYTYPE_P(1);
  const bool alone = PG_GETARG_BOOL(2);
  Datum* keys;
  int count, missing = 0;
  deconstruct_array(given, INT4OID, 4, true, TYPALIGN_INT, &keys, nullptr, &count);
  for (int i = 0; i < count; ++i) {
    // The lock is that of pg_advisory_xact_lock(integer, integer).
    LOCKTAG lock;
    SET_LOCKTAG_ADVISORY(lock, MyDatabaseId, static_cast<uint32>(model),
                         static_cast<uint32>(DatumGetInt32(keys[i])), 2);
    if (!is_held(lock, ExclusiveLock) && (alone || !is_held(lock, ShareLock)))
      keys[missing++] = keys[i];
  }
  PG_RETURN_ARRAYTYPE_P(construct_array(keys, missing, INT4OID, 4, true, TYPALIGN_INT));
}
