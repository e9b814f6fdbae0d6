// streetgen._only_own_functions: whether functions of others may stand in for those that a model
// calls.  The rule is SQL, streetgen._check_functions_beside; a session asks it once, and again
// after the catalogue changed.
#include "frame/owner.hpp"

extern "C" {
#include <access/xact.h>
#include <catalog/namespace.h>
#include <catalog/pg_type.h>
#include <nodes/value.h>
#include <parser/parse_func.h>
#include <utils/builtins.h>
#include <utils/inval.h>
#include <utils/syscache.h>
}

namespace streetgen::pg {
namespace {

// For whom and which model it was proved last, and how often the catalogue has changed by then.
NameData proved_model;
Oid proved_owner = InvalidOid, proved_caller = InvalidOid;
uint64 catalogue_changes = 0, proved_at = 0;

void note_change(Datum, int, uint32) { ++catalogue_changes; }

void watch_catalogue() {
  static bool watched = false;
  if (watched) return;
  watched = true;
  for (const int cache :
       {PROCOID, OPEROID, TYPEOID, NAMESPACEOID, AUTHOID, AUTHMEMMEMROLE, DATABASEOID})
    CacheRegisterSyscacheCallback(cache, note_change, Datum{0});
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_only_own_functions) {
  using namespace streetgen::pg;
  watch_catalogue();
  const Name model = PG_GETARG_NAME(0);
  const Oid owner = owner_of(NameStr(*model));
  // Who borrows the rights of the owner; whoever calls with his own borrows none.
  const Oid caller = GetUserId() == GetOuterUserId() ? owner : GetOuterUserId();
  if (owner == proved_owner && caller == proved_caller && catalogue_changes == proved_at &&
      strcmp(NameStr(*model), NameStr(proved_model)) == 0)
    PG_RETURN_BOOL(true);
  const uint64 before = catalogue_changes;
  Oid types[] = {NAMEOID, OIDOID, OIDOID};
  List* rule =
      list_make2(makeString(pstrdup("streetgen")), makeString(pstrdup("_check_functions_beside")));
  OidFunctionCall3(LookupFuncName(rule, 3, types, false), NameGetDatum(model),
                   ObjectIdGetDatum(owner), ObjectIdGetDatum(caller));
  // A snapshot of the whole transaction may not show what changed since: that proves nothing later.
  if (IsolationUsesXactSnapshot()) PG_RETURN_BOOL(true);
  namestrcpy(&proved_model, NameStr(*model));
  proved_owner = owner;
  proved_caller = caller;
  proved_at = before;
  PG_RETURN_BOOL(true);
}
