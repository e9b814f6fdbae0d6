// streetgen._streets: the whole pipeline over a set of axes, and the tables of what it computed.
#include <initializer_list>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "frame/progress.hpp"
#include "model/streets_call.hpp"
#include "model/streets_give.hpp"
#include "model/streets_input.hpp"
#include "model/streets_rows.hpp"
#include "streetgen/street_network.hpp"

extern "C" {
#include <utils/array.h>
}

namespace streetgen::pg {
namespace {

// As many as the hint of an error holds, with room for one more and the brace; others turn up in
// the run with these.
std::string array_of(const std::vector<std::int64_t>& axes) {
  std::string text = "{" + std::to_string(axes.front());
  for (std::size_t i = 1; i < axes.size() && text.size() + 24 < sizeof(Outcome::hint); ++i)
    text += "," + std::to_string(axes[i]);
  return text + "}";
}

ComputedStreets compute_streets(const StreetsCall& call) {
  const StreetsInput input = read_input(call);
  try {
    return {street_model(input.model), input.srid, input.has_z};
  } catch (const ChangeSpreads& spreads) {
    throw Error(ErrorKind::spreads, spreads.what(), array_of(spreads.axes()));
  }
}

ComputedStreets compute_network(const StreetsCall& call) {
  const StreetsInput input = read_input(call);
  const StreetSettings& settings = input.model.settings;
  StreetModel model;
  model.streets.network =
      street_network(input.model.axes, settings.tolerance, settings.crossing, settings.controls);
  return {std::move(model), input.srid, input.has_z};
}

// Computations of statements under way, by number: each is there until its statement has ended.
class Kept {
 public:
  explicit Kept(ComputedStreets computed) : computed_(std::move(computed)) {
    all()[number_] = this;
  }
  ~Kept() { all().erase(number_); }
  Kept(const Kept&) = delete;
  Kept& operator=(const Kept&) = delete;

  std::int64_t number() const { return number_; }

  const ComputedStreets& computed() const { return computed_; }
  bool knows(const Table& table) const { return forgotten_.count(&table) == 0; }
  void forget(const Table& table) {
    forgotten_.insert(&table);
    table.forget(computed_);
  }

  static Kept* find(std::int64_t number) {
    const auto found = all().find(number);
    return found == all().end() ? nullptr : found->second;
  }

 private:
  static std::unordered_map<std::int64_t, Kept*>& all() {
    static std::unordered_map<std::int64_t, Kept*> kept;
    return kept;
  }
  static std::int64_t next() {
    static std::int64_t last = 0;
    return ++last;
  }

  std::int64_t number_ = next();
  ComputedStreets computed_;
  std::unordered_set<const Table*> forgotten_;
};

Ids take_ids(FunctionCallInfo fcinfo, int argument) {
  ArrayType* array = PG_GETARG_ARRAYTYPE_P(argument);
  if (ARR_NDIM(array) > 1 || ARR_HASNULL(array))
    ereport(ERROR,
            (errcode(ERRCODE_INVALID_PARAMETER_VALUE), errmsg("ids are no list of numbers")));
  return {reinterpret_cast<const std::int64_t*>(ARR_DATA_PTR(array)),
          static_cast<std::size_t>(ArrayGetNItems(ARR_NDIM(array), ARR_DIMS(array)))};
}

}  // namespace

Datum give_kept(FunctionCallInfo fcinfo, const Table& table,
                std::initializer_list<Ids Named::*> arguments) {
  Kept* kept = Kept::find(PG_GETARG_INT64(0));
  if (kept == nullptr || !kept->knows(table))
    ereport(ERROR, (errcode(ERRCODE_OBJECT_NOT_IN_PREREQUISITE_STATE),
                    errmsg("no streets of number %lld are kept",
                           static_cast<long long>(PG_GETARG_INT64(0))),
                    errhint("They are kept until the statement ends that computed them, and most "
                            "of their rows until they were given.")));
  Named named;
  int argument = 0;
  for (Ids Named::*ids : arguments) named.*ids = take_ids(fcinfo, ++argument);
  const Datum given = give(fcinfo, table, kept->computed(), named);
  if (table.forget != nullptr) report(compute([&] { kept->forget(table); }));
  return given;
}

}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_streets) {
  using namespace streetgen::pg;
  if (PG_ARGISNULL(0) || PG_ARGISNULL(2) || PG_ARGISNULL(11)) PG_RETURN_NULL();
  StreetsCall call;
  take(fcinfo, &call);
  Slot<Kept>* slot = make_slot<Kept>(fcinfo->flinfo->fn_mcxt);
  char of[NAMEDATALEN];
  snprintf(of, sizeof of, "streets of %d axes", call.axes.count);
  begin_progress(of);
  const Outcome outcome = compute([&] { slot->value = new Kept(compute_streets(call)); });
  end_progress();
  report(outcome);
  PG_RETURN_INT64(slot->value->number());
}

STREETGEN_FUNCTION(streetgen_network) {
  using namespace streetgen::pg;
  StreetsCall call{};
  take_network(fcinfo, &call);
  Slot<Kept>* slot = make_slot<Kept>(fcinfo->flinfo->fn_mcxt);
  const Outcome outcome = compute([&] { slot->value = new Kept(compute_network(call)); });
  report(outcome);
  PG_RETURN_INT64(slot->value->number());
}
