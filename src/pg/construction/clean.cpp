// streetgen._clean_network: the lines of an import, cleaned together.
#include "streetgen/clean.hpp"

#include <optional>
#include <string>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "value/line_array.hpp"
#include "value/wkb.hpp"

STREETGEN_FUNCTION(streetgen_clean_network) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const LineArray lines = take_lines(PG_GETARG_ARRAYTYPE_P(0), "lines");
  const LineArray beside = take_lines(PG_GETARG_ARRAYTYPE_P(1), "beside");
  const double tolerance = PG_GETARG_FLOAT8(2), epsilon = PG_GETARG_FLOAT8(3),
               r_min = PG_GETARG_FLOAT8(4);
  using Changed = std::vector<std::optional<std::string>>;
  Slot<Changed>* slot = make_slot<Changed>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    Form form;
    const std::vector<Line> given = read_lines(lines, "line", &form);
    const std::vector<Line> cleaned = clean(
        given, read_lines(beside, "line beside", nullptr), in_range(tolerance, 0, 10, "tolerance"),
        in_range(epsilon, 0, 1000, "epsilon"), in_range(r_min, 0, 1000, "r_min"));
    slot->value = new Changed(given.size());
    for (std::size_t i = 0; i < given.size(); ++i)
      if (cleaned[i].size() < given[i].size()) (*slot->value)[i] = write_line(cleaned[i], form);
  });
  report(outcome);
  Datum* values = static_cast<Datum*>(palloc(sizeof(Datum) * (lines.count + 1)));
  bool* nulls = static_cast<bool*>(palloc(lines.count + 1));
  for (int i = 0; i < lines.count; ++i) {
    const std::optional<std::string>& changed = (*slot->value)[i];
    nulls[i] = !changed;
    values[i] = changed ? bytes_datum(*changed) : Datum(0);
  }
  int size[] = {lines.count}, first[] = {1};
  PG_RETURN_ARRAYTYPE_P(
      construct_md_array(values, nulls, 1, size, first, BYTEAOID, -1, false, 'i'));
}
