// streetgen._grow_forest and streetgen.forest_value: a number learnt from samples.
#include "streetgen/forest.hpp"

#include <string>
#include <vector>

#include "frame/border.hpp"
#include "streetgen/error.hpp"
#include "value/number_array.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <utils/array.h>
}

namespace streetgen::pg {
namespace {

std::vector<ForestSample> read_samples(const NumberArray& features, const NumberArray& values) {
  const std::vector<double> numbers = read_numbers(values, 1, "values");
  if (values.count > 0 && features.count % values.count != 0)
    throw Error(ErrorKind::invalid_input, std::to_string(values.count) + " values have " +
                                              std::to_string(features.count) +
                                              " features, not as many each");
  const int each = values.count > 0 ? features.count / values.count : 1;
  const std::vector<double> beside = read_numbers(features, each > 0 ? each : 1, "features");
  std::vector<ForestSample> samples;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    samples.push_back({{beside.begin() + i * each, beside.begin() + (i + 1) * each}, numbers[i]});
  return samples;
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_grow_forest) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const NumberArray features = take_numbers(fcinfo, 0), values = take_numbers(fcinfo, 1);
  Slot<Forest>* slot = make_slot<Forest>(CurrentMemoryContext);
  report(compute([&] { slot->value = new Forest(grow_forest(read_samples(features, values))); }));
  const Forest& forest = *slot->value;
  Datum* numbers = static_cast<Datum*>(palloc(forest.size() * sizeof(Datum)));
  for (std::size_t i = 0; i < forest.size(); ++i) numbers[i] = Float8GetDatum(forest[i]);
  PG_RETURN_ARRAYTYPE_P(construct_array(numbers, static_cast<int>(forest.size()), FLOAT8OID, 8,
                                        true, TYPALIGN_DOUBLE));
}

STREETGEN_FUNCTION(streetgen_forest_value) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const NumberArray forest = take_numbers(fcinfo, 0), features = take_numbers(fcinfo, 1);
  double value = 0;
  report(compute([&] {
    value = forest_value(read_numbers(forest, 1, "forest"), read_numbers(features, 1, "features"));
  }));
  PG_RETURN_FLOAT8(value);
}
