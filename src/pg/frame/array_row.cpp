#include "frame/array_row.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <utils/array.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {

ReturnSetInfo* result_of(FunctionCallInfo fcinfo) {
  return reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
}

void give_row(const NumberColumns& columns, ReturnSetInfo* result) {
  if (columns.empty() || columns.front().empty()) return;
  const int count = static_cast<int>(columns.size());
  auto* values = static_cast<Datum*>(palloc0(count * sizeof(Datum)));
  auto* nulls = static_cast<bool*>(palloc0(count * sizeof(bool)));
  for (int i = 0; i < count; ++i) {
    const int length = static_cast<int>(columns[i].size());
    auto* numbers = static_cast<Datum*>(palloc(length * sizeof(Datum)));
    for (int k = 0; k < length; ++k) numbers[k] = Float8GetDatum(columns[i][k]);
    values[i] = PointerGetDatum(
        construct_array(numbers, length, FLOAT8OID, sizeof(float8), true, TYPALIGN_DOUBLE));
  }
  tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
}

}  // namespace streetgen::pg
