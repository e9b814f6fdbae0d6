// streetgen._simulate and _fired_events: traffic on a network, step by step.
#include "streetgen/simulation.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "frame/progress.hpp"
#include "simulation/car_rows.hpp"
#include "simulation/event_rows.hpp"
#include "simulation/following_law.hpp"
#include "simulation/network_bytes.hpp"
#include "value/given_rows.hpp"
#include "value/value_array.hpp"

extern "C" {
#include <utils/builtins.h>
}

namespace streetgen::pg {
namespace {

struct DemandCall {
  CarRows cars;
  ValueArray entries, flows;         // keys of links; cars an hour
  ValueArray turn_links, turn_next;  // keys of links
  ValueArray turn_shares;
};

DemandCall take_demand(FunctionCallInfo fcinfo) {
  DemandCall call;
  call.cars = take_cars(fcinfo, 1);
  call.entries = take_values(fcinfo, 2, INT8OID, any_count, "entries");
  call.flows = take_values(fcinfo, 3, FLOAT8OID, call.entries.count, "flows");
  call.turn_links = take_values(fcinfo, 4, INT8OID, any_count, "turn_links");
  call.turn_next = take_values(fcinfo, 5, INT8OID, call.turn_links.count, "turn_next");
  call.turn_shares = take_values(fcinfo, 6, FLOAT8OID, call.turn_links.count, "turn_shares");
  return call;
}

SimulationDemand demand_of(const DemandCall& call, const TrafficNetwork& network) {
  constexpr double an_hour = 3600;
  SimulationDemand demand;
  CarsOnRoutes read = read_cars(call.cars, network);
  demand.cars = std::move(read.cars);
  demand.routes = std::move(read.routes);
  for (int i = 0; i < call.entries.count; ++i)
    demand.entries.push_back(
        {known_link(network, DatumGetInt64(call.entries.values[i])),
         in_range(DatumGetFloat8(call.flows.values[i]), 0, 1e6, "a flow") / an_hour});
  for (int i = 0; i < call.turn_links.count; ++i)
    demand.turns.push_back({known_link(network, DatumGetInt64(call.turn_links.values[i])),
                            known_link(network, DatumGetInt64(call.turn_next.values[i])),
                            in_range(DatumGetFloat8(call.turn_shares.values[i]), 0, 1e6,
                                     "a share of turns")});
  return demand;
}

SimulationOptions options_of(const std::string& method, double duration, double step,
                             double output, std::int64_t seed) {
  SimulationOptions options;
  options.method = word_of<SimulationMethod>(method, "method", {{"idm", SimulationMethod::idm},
                                                                {"lwr", SimulationMethod::lwr},
                                                                {"arz", SimulationMethod::arz}});
  options.duration = finite(duration, "duration");
  options.step = finite(step, "step");
  options.output = finite(output, "output");
  options.seed = static_cast<std::uint64_t>(seed);
  return options;
}

struct StateRow {
  double time;
  std::optional<std::int64_t> car_id;
  std::int32_t cell = -1;
  std::int64_t link_id;
  double metres, length, width, speed, density;
  std::uint8_t kind;  // of a car
  bool flat;          // no height is known there
  LinkFrame frame;
};

// More would take more memory than a server should give.
constexpr std::size_t most_rows = 10000000;

std::vector<StateRow> rows_of(const TrafficNetwork& network, const SimulationDemand& demand,
                              const SimulationOptions& options) {
  std::vector<StateRow> rows;
  const auto row_at = [&](double time, const LinkPlace& place) {
    StateRow row{};
    row.time = time;
    row.cell = -1;
    row.link_id = network.links[place.link].link_id;
    row.metres = place.metres;
    row.flat = network.heights.of(place.link).empty();
    row.frame = frame(network, place);
    return row;
  };
  simulate(network, demand, options, [&](const SimulationState& state) {
    if (rows.size() + state.cars.size() + state.cells.size() > most_rows)
      throw Error(ErrorKind::invalid_input,
                  "more than " + std::to_string(most_rows) + " rows by " +
                      streetgen::text_of(state.time) + " s",
                  "Ask for a greater output, or for less at once.");
    for (const SimulatedCar& car : state.cars) {
      StateRow row = row_at(state.time, car.place);
      row.car_id = car.car_id;
      row.frame = car.frame;
      row.length = car.length;
      row.width = car.width;
      row.kind = car.kind;
      row.speed = car.speed;
      rows.push_back(row);
    }
    for (const SimulatedCell& cell : state.cells) {
      StateRow row = row_at(state.time, cell.place);
      row.cell = cell.cell;
      row.length = cell.length;
      row.speed = cell.speed;
      row.density = std::max(0.0, cell.density);  // rounding may leave less
      rows.push_back(row);
    }
  });
  return rows;
}

struct FiredRow {
  FiredEvent fired;
  std::int64_t link_id;
};

std::vector<FiredRow> fired_rows(const TrafficNetwork& network, const SimulationDemand& demand,
                                 const SimulationOptions& options) {
  std::vector<FiredRow> rows;
  for (const FiredEvent& fired : simulate(network, demand, options, {}).fired)
    rows.push_back({fired, network.links[fired.place.link].link_id});
  return rows;
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_simulate) {
  using namespace streetgen;
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, 0);
  const std::string_view bytes = take_bytes(fcinfo, 0);
  const DemandCall call = take_demand(fcinfo);
  const char* method = text_to_cstring(PG_GETARG_TEXT_PP(7));
  const double duration = PG_GETARG_FLOAT8(8), step = PG_GETARG_FLOAT8(9);
  const double output = PG_GETARG_FLOAT8(10);
  const std::int64_t seed = PG_GETARG_INT64(11);
  SqlLaw* law = take_law(PG_GETARG_OID(12));
  const EventRows events = take_events(fcinfo, 13);
  auto* slot = make_slot<std::vector<StateRow>>(CurrentMemoryContext);
  begin_progress("traffic");
  const Outcome outcome = compute([&] {
    const TrafficNetwork network = read_network(bytes);
    SimulationDemand demand = demand_of(call, network);
    demand.events = read_events(events, network);
    SimulationOptions options = options_of(method, duration, step, output, seed);
    options.driving.law = law_of(law);
    slot->value = new std::vector<StateRow>(rows_of(network, demand, options));
  });
  end_progress();
  report_law(law);
  report(outcome);
  put_rows(fcinfo, *slot->value, [](const StateRow& row, ReturnSetInfo* result) {
    constexpr double kilometre = 1000;
    const bool car = row.car_id.has_value();
    Datum values[] = {Float8GetDatum(row.time),
                      Int64GetDatum(row.car_id.value_or(0)),
                      Int64GetDatum(row.cell + 1),
                      Int64GetDatum(row.link_id),
                      Float8GetDatum(row.metres),
                      Float8GetDatum(row.length),
                      Float8GetDatum(row.width),
                      car ? CStringGetTextDatum(kind_word(row.kind)) : Datum{},
                      Float8GetDatum(row.speed / kmh),
                      Float8GetDatum(row.density * kilometre),
                      Float8GetDatum(row.frame.x),
                      Float8GetDatum(row.frame.y),
                      Float8GetDatum(row.frame.height),
                      Float8GetDatum(row.frame.heading)};
    bool nulls[14] = {false};
    nulls[1] = nulls[6] = nulls[7] = !car;
    nulls[2] = nulls[9] = car;
    nulls[12] = row.flat;
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  });
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_fired_events) {
  using namespace streetgen;
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, 0);
  const std::string_view bytes = take_bytes(fcinfo, 0);
  const DemandCall call = take_demand(fcinfo);
  const EventRows events = take_events(fcinfo, 7);
  const double duration = PG_GETARG_FLOAT8(8), step = PG_GETARG_FLOAT8(9);
  const std::int64_t seed = PG_GETARG_INT64(10);
  auto* slot = make_slot<std::vector<FiredRow>>(CurrentMemoryContext);
  begin_progress("traffic");
  const Outcome outcome = compute([&] {
    const TrafficNetwork network = read_network(bytes);
    SimulationDemand demand = demand_of(call, network);
    demand.events = read_events(events, network);
    slot->value = new std::vector<FiredRow>(
        fired_rows(network, demand, options_of("idm", duration, step, 0, seed)));
  });
  end_progress();
  report(outcome);
  put_rows(fcinfo, *slot->value, [](const FiredRow& row, ReturnSetInfo* result) {
    Datum values[] = {Int64GetDatum(row.fired.event_id), Float8GetDatum(row.fired.time),
                      Int64GetDatum(row.fired.car_id.value_or(0)), Int64GetDatum(row.link_id),
                      Float8GetDatum(row.fired.place.metres)};
    bool nulls[] = {false, false, !row.fired.car_id.has_value(), false, false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  });
  PG_RETURN_NULL();
}
