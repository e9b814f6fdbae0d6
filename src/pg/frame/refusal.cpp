// streetgen._refuse: an error that needs no CONTEXT.
#include "frame/border.hpp"

extern "C" {
#include <utils/builtins.h>
}

namespace {

bool is_sqlstate(const char* state) {
  return state != nullptr && strlen(state) == 5 && strncmp(state, "00", 2) != 0 &&
         strspn(state, "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ") == 5;
}

}  // namespace

STREETGEN_FUNCTION(streetgen_refuse) {
  const char* given[8];
  for (int i = 0; i < 8; ++i)
    given[i] = PG_ARGISNULL(i) ? nullptr : text_to_cstring(PG_GETARG_TEXT_PP(i));
  const auto& [state, message, detail, hint, schema, relation, attribute, rule] = given;
  if (!is_sqlstate(state))
    ereport(ERROR,
            (errcode(ERRCODE_INVALID_PARAMETER_VALUE),
             errmsg("a refusal cannot have the SQLSTATE %s", state == nullptr ? "NULL" : state),
             errhint("It is five digits and capitals, such as 22023.")));
  // Whoever catches the error has kept the stack, and puts it back.
  error_context_stack = nullptr;
  ereport(ERROR, (errcode(MAKE_SQLSTATE(state[0], state[1], state[2], state[3], state[4])),
                  errmsg_internal("%s", message == nullptr ? "NULL" : message),
                  detail == nullptr ? 0 : errdetail_internal("%s", detail),
                  hint == nullptr ? 0 : errhint("%s", hint),
                  schema == nullptr ? 0 : err_generic_string(PG_DIAG_SCHEMA_NAME, schema),
                  relation == nullptr ? 0 : err_generic_string(PG_DIAG_TABLE_NAME, relation),
                  attribute == nullptr ? 0 : err_generic_string(PG_DIAG_COLUMN_NAME, attribute),
                  rule == nullptr ? 0 : err_generic_string(PG_DIAG_CONSTRAINT_NAME, rule)));
}
