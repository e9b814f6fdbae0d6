// streetgen._as_owner: calls a function for a model with the rights of its owner alone.  What he
// hung on its tables cannot take back the role of the caller: the server refuses SET ROLE there.
#include "frame/owner.hpp"

extern "C" {
#include <access/htup_details.h>
#include <catalog/pg_namespace.h>
#include <catalog/pg_type.h>
#include <miscadmin.h>
#include <nodes/value.h>
#include <parser/parse_func.h>
#include <utils/acl.h>
#include <utils/builtins.h>
#include <utils/lsyscache.h>
#include <utils/syscache.h>
}

namespace streetgen::pg {

Oid owner_of(const char* model) {
  HeapTuple schema = SearchSysCache1(NAMESPACENAME, CStringGetDatum(model));
  if (!HeapTupleIsValid(schema)) return GetUserId();
  const Oid owner = reinterpret_cast<Form_pg_namespace>(GETSTRUCT(schema))->nspowner;
  ReleaseSysCache(schema);
  return owner;
}

}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_as_owner) {
  const Name model = PG_GETARG_NAME(0);
  const Oid owner = streetgen::pg::owner_of(NameStr(*model));
  Oid caller;
  int context;
  GetUserIdAndSecContext(&caller, &context);
  if (!has_privs_of_role(caller, owner))
    ereport(ERROR, (errcode(ERRCODE_INSUFFICIENT_PRIVILEGE),
                    errmsg("model \"%s\" belongs to another role", NameStr(*model)),
                    errhint("Its owner, or a superuser, does this.")));
  Oid types[] = {NAMEOID};
  List* name = list_make2(makeString(pstrdup("streetgen")),
                          makeString(text_to_cstring(PG_GETARG_TEXT_PP(1))));
  const Oid called = LookupFuncName(name, 1, types, false);
  // After an error the end of the transaction, or of the block that caught it, takes this back.
  if (caller != owner)
    SetUserIdAndSecContext(owner, context | SECURITY_LOCAL_USERID_CHANGE |
                                      SECURITY_RESTRICTED_OPERATION);
  const Datum result = OidFunctionCall1(called, NameGetDatum(model));
  SetUserIdAndSecContext(caller, context);
  if (get_func_rettype(called) != INT8OID) PG_RETURN_NULL();
  PG_RETURN_DATUM(result);
}
