#include "frame/border.hpp"

#include "frame/varlena.hpp"

extern "C" {
#include <storage/procsignal.h>

__attribute__((visibility("default"))) extern const Pg_magic_struct* Pg_magic_func(void);
PG_MODULE_MAGIC;
}

namespace streetgen::pg {

int sqlstate_of(ErrorKind kind) noexcept {
  switch (kind) {
    case ErrorKind::invalid_input:
      return ERRCODE_INVALID_PARAMETER_VALUE;
    case ErrorKind::degenerate:
      return ERRCODE_DATA_EXCEPTION;
    case ErrorKind::unsupported:
      return ERRCODE_FEATURE_NOT_SUPPORTED;
    case ErrorKind::cancelled:
      return ERRCODE_QUERY_CANCELED;
    case ErrorKind::spreads:
      return MAKE_SQLSTATE('S', 'G', '0', '0', '1');
  }
  return ERRCODE_INTERNAL_ERROR;
}

// A session that drops a database waits until each other one has closed its files: a long call does so on the way.
// No error of PostgreSQL leaves this function; what failed is due again at the end of the call.
static void answer_other_sessions() noexcept {
  const MemoryContext context = CurrentMemoryContext;
  PG_TRY();
  { ProcessProcSignalBarrier(); }
  PG_CATCH();
  {
    MemoryContextSwitchTo(context);
    FlushErrorState();
  }
  PG_END_TRY();
}

bool cancel_requested() noexcept {
  if (ProcSignalBarrierPending && INTERRUPTS_CAN_BE_PROCESSED()) answer_other_sessions();
  return QueryCancelPending || ProcDiePending;
}

void report(const Outcome& outcome) {
  if (outcome.sqlstate == 0) return;
  CHECK_FOR_INTERRUPTS();
  ereport(ERROR, (errcode(outcome.sqlstate), errmsg("%s", outcome.message),
                  outcome.hint[0] != '\0' ? errhint("%s", outcome.hint) : 0));
}

std::string_view bytes_of(Datum datum) {
  const auto* value = reinterpret_cast<const struct varlena*>(DatumGetPointer(datum));
  return {VARDATA_ANY(value), VARSIZE_ANY_EXHDR(value)};
}

std::string text_of(Datum datum) { return std::string(bytes_of(datum)); }

Datum bytes_datum(const std::string& bytes) {
  auto* out = static_cast<bytea*>(palloc(VARHDRSZ + bytes.size()));
  SET_VARSIZE(out, VARHDRSZ + bytes.size());
  memcpy(VARDATA(out), bytes.data(), bytes.size());
  return PointerGetDatum(out);
}

}  // namespace streetgen::pg
