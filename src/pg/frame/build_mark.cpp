// streetgen._require_one_build, and the look into the catalogue that each function begins with.
#include "frame/build_mark.hpp"

#include "frame/border.hpp"
#include "streetgen_build_mark.h"

extern "C" {
#include <access/htup_details.h>
#include <catalog/namespace.h>
#include <catalog/pg_proc.h>
#include <commands/dbcommands.h>
#include <lib/stringinfo.h>
#include <utils/builtins.h>
#include <utils/guc.h>
#include <utils/inval.h>
#include <utils/syscache.h>
}

namespace streetgen::pg {

bool is_one_build = false;

namespace {

// Since the session began: then it is the SQL that was made anew, and this module the older one.
bool was_one_build = false;

// How often the catalogue has changed.
uint64 changes = 0;

void forget(Datum, int, uint32) {
  is_one_build = false;
  ++changes;
}

// What streetgen._build_mark() gives, without a call of it: anybody may ask at any time.
bool sql_has_our_mark() {
  const Oid schema = get_namespace_oid("streetgen", true);
  if (!OidIsValid(schema)) return false;
  HeapTuple function =
      SearchSysCache3(PROCNAMEARGSNSP, CStringGetDatum("_build_mark"),
                      PointerGetDatum(buildoidvector(nullptr, 0)), ObjectIdGetDatum(schema));
  if (!HeapTupleIsValid(function)) return false;
  bool missing;
  const Datum body = SysCacheGetAttr(PROCNAMEARGSNSP, function, Anum_pg_proc_prosrc, &missing);
  const bool ours =
      !missing && strcmp(TextDatumGetCString(body), "SELECT '" STREETGEN_BUILD_MARK "'") == 0;
  ReleaseSysCache(function);
  return ours;
}

// A word for the shell.
const char* quoted(const char* word) {
  StringInfoData text;
  initStringInfo(&text);
  appendStringInfoChar(&text, '\'');
  for (; *word != '\0'; ++word) {
    if (*word == '\'')
      appendStringInfoString(&text, "'\\''");
    else
      appendStringInfoChar(&text, *word);
  }
  appendStringInfoChar(&text, '\'');
  return text.data;
}

// Where this server has the files of its extensions; Debian's may have them below another root.
const char* renewal_script() {
  char share[MAXPGPATH];
  get_share_path(my_exec_path, share);
  const char* root = GetConfigOption("extension_destdir", true, false);
  return psprintf("%s%s/extension/streetgen_renew.sql", root == nullptr ? "" : root, share);
}

}  // namespace

void look_for_build_mark() {
  static bool listens = false;
  if (!listens) {
    CacheRegisterSyscacheCallback(PROCOID, forget, 0);
    listens = true;
  }
  // A change that comes while we look is looked at, too.  A look that an error ends proves nothing.
  while (!is_one_build) {
    const uint64 before = changes;
    if (!sql_has_our_mark()) {
      const char* database = get_database_name(MyDatabaseId);
      ereport(
          ERROR,
          (errcode(ERRCODE_OBJECT_NOT_IN_PREREQUISITE_STATE),
           errmsg("the SQL of StreetGen in database \"%s\" is of another build than its module",
                  database),
           was_one_build ? errhint("It was made anew while this session went on: connect again.")
                         : errhint("Make the extension anew, as a superuser on the server: "
                                   "psql -d %s -f %s",
                                   quoted(database), quoted(renewal_script()))));
    }
    is_one_build = changes == before;
  }
  was_one_build = true;
}

}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_require_one_build) { PG_RETURN_VOID(); }
