#include "model/streets_give.hpp"

#include "value/value_array.hpp"

extern "C" {
#include <funcapi.h>
#include <parser/parse_coerce.h>
#include <utils/builtins.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {

namespace {

struct GivenColumn {
  Oid type;
  FmgrInfo cast;  // of a geometry, from bytea
};

GivenColumn given_column(const FormData_pg_attribute* attribute) {
  GivenColumn column{attribute->atttypid, {}};
  Oid cast;
  switch (column.type) {
    case BOOLOID:
    case INT4OID:
    case INT8OID:
    case FLOAT8OID:
    case TEXTOID:
    case INT8ARRAYOID:
    case FLOAT8ARRAYOID:
      return column;
  }
  if (find_coercion_pathway(column.type, BYTEAOID, COERCION_EXPLICIT, &cast) != COERCION_PATH_FUNC)
    elog(ERROR, "column %s has a type that nothing computed becomes", NameStr(attribute->attname));
  fmgr_info(cast, &column.cast);
  return column;
}

Datum text_datum(std::string_view text) {
  return PointerGetDatum(cstring_to_text_with_len(text.data(), static_cast<int>(text.size())));
}

// The value of a column, which is of its type: else an error, not a wild read.
Datum datum_of(const Value& value, GivenColumn* column) {
  switch (column->type) {
    case BOOLOID:
      if (const bool* given = std::get_if<bool>(&value)) return BoolGetDatum(*given);
      break;
    case INT4OID:
      if (const auto* given = std::get_if<std::int32_t>(&value)) return Int32GetDatum(*given);
      break;
    case INT8OID:
      if (const auto* given = std::get_if<std::int64_t>(&value)) return Int64GetDatum(*given);
      break;
    case FLOAT8OID:
      if (const double* given = std::get_if<double>(&value)) return Float8GetDatum(*given);
      break;
    case TEXTOID:
      if (const auto* given = std::get_if<std::string_view>(&value)) return text_datum(*given);
      if (const auto* given = std::get_if<std::string>(&value)) return text_datum(*given);
      break;
    case INT8ARRAYOID:
      if (const auto* given = std::get_if<std::vector<std::int64_t>>(&value))
        return bigints(*given);
      break;
    case FLOAT8ARRAYOID:
      if (const auto* given = std::get_if<std::vector<double>>(&value)) return doubles(*given);
      break;
    default:
      if (const auto* given = std::get_if<Geometry>(&value))
        return PointerGetDatum(given->bytes.get());
      // The cast takes no type modifier.
      if (const auto* given = std::get_if<Ewkb>(&value))
        return FunctionCall1(&column->cast, bytes_datum(given->bytes));
  }
  elog(ERROR, "a computed value is not of its column's type %u", column->type);
}

}  // namespace

Datum give(FunctionCallInfo fcinfo, const Table& table, const ComputedStreets& computed,
           const Named& named) {
  InitMaterializedSRF(fcinfo, 0);
  auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  const int width = result->setDesc->natts;
  auto* columns = static_cast<GivenColumn*>(palloc(sizeof(GivenColumn) * width));
  for (int i = 0; i < width; ++i) columns[i] = given_column(TupleDescAttr(result->setDesc, i));
  auto* datums = static_cast<Datum*>(palloc(sizeof(Datum) * width));
  auto* nulls = static_cast<bool*>(palloc(sizeof(bool) * width));
  Slot<Row>* slot = make_slot<Row>(CurrentMemoryContext);
  MemoryContext per_row =
      AllocSetContextCreate(CurrentMemoryContext, "streetgen row", ALLOCSET_DEFAULT_SIZES);
  const std::size_t count = table.count(computed);
  for (std::size_t at = 0; at < count; ++at) {
    CHECK_FOR_INTERRUPTS();
    bool is_row = false;
    const Outcome outcome = compute([&] {
      if (slot->value == nullptr) slot->value = new Row;
      is_row = table.fill(computed, named, at, *slot->value);
    });
    report(outcome);
    if (!is_row) continue;
    const Row& row = *slot->value;
    if (static_cast<int>(row.size()) != width - 1)
      elog(ERROR, "a computed row has %d values for %d columns", static_cast<int>(row.size()),
           width - 1);
    MemoryContext outer = MemoryContextSwitchTo(per_row);
    datums[0] = Int32GetDatum(static_cast<std::int32_t>(at) + 1);
    nulls[0] = false;
    for (int i = 1; i < width; ++i) {
      const Value& value = row[i - 1];
      nulls[i] = std::holds_alternative<std::monostate>(value);
      datums[i] = nulls[i] ? 0 : datum_of(value, &columns[i]);
    }
    tuplestore_putvalues(result->setResult, result->setDesc, datums, nulls);
    MemoryContextSwitchTo(outer);
    MemoryContextReset(per_row);
  }
  MemoryContextDelete(per_row);
  return 0;
}

}  // namespace streetgen::pg
