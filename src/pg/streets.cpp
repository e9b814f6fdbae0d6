// streetgen._streets: the whole pipeline over a set of axes, and the tables of what it computed.
#include <unordered_map>
#include <unordered_set>

#include "progress.hpp"
#include "streets_call.hpp"
#include "streets_give.hpp"
#include "streets_input.hpp"
#include "streets_rows.hpp"

namespace streetgen::pg {
namespace {

ComputedStreets compute_streets(const StreetsCall& call) {
  const StreetsInput input = read_input(call);
  Streets result = streets(input.axes, input.settings, input.overrides, input.former);
  Lanes traffic = lanes(result, input.lanes, input.lane_overrides, input.lane_settings);
  std::vector<Interconnection> pairs = interconnections(
      result, input.axes, traffic.lanes, input.restrictions, input.interconnection_settings);
  return computed_streets(std::move(result), std::move(traffic), std::move(pairs), input.srid,
                          input.has_z);
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

Datum give_table(FunctionCallInfo fcinfo, const Table& table) {
  Kept* kept = Kept::find(PG_GETARG_INT64(0));
  if (kept == nullptr || !kept->knows(table))
    ereport(
        ERROR,
        (errcode(ERRCODE_OBJECT_NOT_IN_PREREQUISITE_STATE),
         errmsg("no streets of number %lld are kept", static_cast<long long>(PG_GETARG_INT64(0))),
         errhint("They are kept until the statement ends that computed them, and most of "
                 "their rows until they were given.")));
  const Datum given = give(fcinfo, table, kept->computed());
  if (table.forget != nullptr) report(compute([&] { kept->forget(table); }));
  return given;
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_streets) {
  using namespace streetgen::pg;
  if (PG_ARGISNULL(0) || PG_ARGISNULL(2)) PG_RETURN_NULL();
  StreetsCall call;
  take(fcinfo, &call);
  Slot<Kept>* slot = make_slot<Kept>(fcinfo->flinfo->fn_mcxt);
  begin_progress(call.axes.count);
  const Outcome outcome = compute([&] { slot->value = new Kept(compute_streets(call)); });
  end_progress();
  report(outcome);
  PG_RETURN_INT64(slot->value->number());
}

#define STREETGEN_TABLE(table)                                              \
  STREETGEN_FUNCTION(streetgen_computed_##table) {                          \
    return streetgen::pg::give_table(fcinfo, streetgen::pg::table##_table); \
  }

STREETGEN_TABLE(node)
STREETGEN_TABLE(edge)
STREETGEN_TABLE(section_limit)
STREETGEN_TABLE(section)
STREETGEN_TABLE(corner)
STREETGEN_TABLE(intersection)
STREETGEN_TABLE(lane)
STREETGEN_TABLE(lane_separator)
STREETGEN_TABLE(marking)
STREETGEN_TABLE(interconnection)
STREETGEN_TABLE(report)
