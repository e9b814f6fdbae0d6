#include "simulation/following_law.hpp"

#include <cmath>
#include <cstring>
#include <vector>

#include "streetgen/error.hpp"

extern "C" {
#include <access/htup_details.h>
#include <catalog/pg_proc.h>
#include <catalog/pg_type.h>
#include <miscadmin.h>
#include <utils/acl.h>
#include <utils/array.h>
#include <utils/lsyscache.h>
#include <utils/regproc.h>
#include <utils/typcache.h>
}

namespace streetgen::pg {

namespace {

bool is_following(Oid type) {
  const Oid relation = OidIsValid(type) ? get_typ_typrelid(type) : InvalidOid;
  if (!OidIsValid(relation)) return false;
  const char* schema = get_namespace_name(get_rel_namespace(relation));
  return schema != nullptr && std::strcmp(schema, "streetgen") == 0 &&
         std::strcmp(get_rel_name(relation), "following") == 0;
}

bool may_run(Oid function) {
#if PG_VERSION_NUM >= 160000
  return object_aclcheck(ProcedureRelationId, function, GetUserId(), ACL_EXECUTE) == ACLCHECK_OK;
#else
  return pg_proc_aclcheck(function, GetUserId(), ACL_EXECUTE) == ACLCHECK_OK;
#endif
}

// Its row type. Everybody may call streetgen._simulate with any oid.
Oid checked_law(Oid function) {
  if (get_func_name(function) == nullptr)
    ereport(ERROR, (errcode(ERRCODE_INVALID_PARAMETER_VALUE),
                    errmsg("there is no function %u", function)));
  Oid* arguments = nullptr;
  int count = 0;
  const Oid result = get_func_signature(function, &arguments, &count);
  const Oid row = count == 1 ? get_element_type(arguments[0]) : InvalidOid;
  if (result != FLOAT8ARRAYOID || !is_following(row) || get_func_retset(function) ||
      get_func_prokind(function) != PROKIND_FUNCTION)
    ereport(ERROR, (errcode(ERRCODE_INVALID_PARAMETER_VALUE),
                    errmsg("%s is no function of streetgen.following[] that gives float8[]",
                           format_procedure(function)),
                    errhint("streetgen.simulate takes its name.")));
  if (!may_run(function))
    aclcheck_error(ACLCHECK_NO_PRIV, OBJECT_FUNCTION, get_func_name(function));
  return row;
}

}  // namespace

SqlLaw* take_law(Oid function) {
  if (!OidIsValid(function)) return nullptr;
  const Oid row = checked_law(function);
  auto* law = static_cast<SqlLaw*>(palloc0(sizeof(SqlLaw)));
  fmgr_info(function, &law->function);
  law->row = lookup_rowtype_tupdesc_copy(row, -1);
  law->one_call =
      AllocSetContextCreate(CurrentMemoryContext, "streetgen law", ALLOCSET_DEFAULT_SIZES);
  law->name = format_procedure(function);
  return law;
}

namespace {

Datum row_of(const SqlLaw* law, const Following& car) {
  Datum values[] = {Float8GetDatum(car.speed), Float8GetDatum(car.desired_speed),
                    Float8GetDatum(car.gap), Float8GetDatum(car.leader_speed),
                    Float8GetDatum(car.leader_acceleration)};
  bool nulls[5] = {false};
  return HeapTupleGetDatum(heap_form_tuple(law->row, values, nulls));
}

void ask(SqlLaw* law, const Following* cars, int count, double* answers) {
  auto* rows = static_cast<Datum*>(palloc(sizeof(Datum) * (count + 1)));
  for (int i = 0; i < count; ++i) rows[i] = row_of(law, cars[i]);
  LOCAL_FCINFO(call, 1);
  InitFunctionCallInfoData(*call, &law->function, 1, InvalidOid, nullptr, nullptr);
  call->args[0].value =
      PointerGetDatum(construct_array(rows, count, law->row->tdtypeid, -1, false, TYPALIGN_DOUBLE));
  call->args[0].isnull = false;
  const Datum result = FunctionCallInvoke(call);
  if (call->isnull)
    ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED), errmsg("it gives NULL"),
                    errhint("Give an array of accelerations, one for each car.")));
  Datum* given = nullptr;
  bool* nulls = nullptr;
  int given_count = 0;
  deconstruct_array(DatumGetArrayTypeP(result), FLOAT8OID, 8, true, TYPALIGN_DOUBLE, &given, &nulls,
                    &given_count);
  if (given_count != count)
    ereport(ERROR, (errcode(ERRCODE_ARRAY_SUBSCRIPT_ERROR),
                    errmsg("it gives %d accelerations for %d cars", given_count, count),
                    errhint("Give one for each car, in their order.")));
  for (int i = 0; i < count; ++i) {
    answers[i] = nulls[i] ? NAN : DatumGetFloat8(given[i]);
    if (!std::isfinite(answers[i]))
      ereport(ERROR, (errcode(ERRCODE_INVALID_PARAMETER_VALUE),
                      errmsg("it gives %s for a car at %g m/s with a gap of %g m",
                             nulls[i] ? "NULL" : "a number that is not finite", cars[i].speed,
                             cars[i].gap),
                      errhint("Give a finite acceleration, m/s2, for each car.")));
  }
}

// An error of the function stays in `raised`: no longjmp leaves this frame.
bool asked(SqlLaw* law, const Following* cars, int count, double* answers) noexcept {
  const MemoryContext before = CurrentMemoryContext;
  PG_TRY();
  {
    MemoryContextReset(law->one_call);
    MemoryContextSwitchTo(law->one_call);
    ask(law, cars, count, answers);
  }
  PG_CATCH();
  {
    MemoryContextSwitchTo(before);
    law->raised = CopyErrorData();
    FlushErrorState();
  }
  PG_END_TRY();
  MemoryContextSwitchTo(before);
  return law->raised == nullptr;
}

}  // namespace

FollowingLaw law_of(SqlLaw* law) {
  if (law == nullptr) return {};
  return [law](const std::vector<Following>& cars, std::vector<double>& answers) {
    answers.resize(cars.size());
    if (cars.empty()) return;
    if (!asked(law, cars.data(), static_cast<int>(cars.size()), answers.data()))
      throw Error(ErrorKind::invalid_input, law->name);
  };
}

void report_law(const SqlLaw* law) {
  if (law == nullptr || law->raised == nullptr) return;
  const ErrorData* raised = law->raised;
  ereport(ERROR, (errcode(raised->sqlerrcode), errmsg("%s: %s", law->name, raised->message),
                  raised->detail != nullptr ? errdetail_internal("%s", raised->detail) : 0,
                  raised->hint != nullptr ? errhint("%s", raised->hint) : 0));
}

}  // namespace streetgen::pg
