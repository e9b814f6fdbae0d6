// streetgen._leaders and _free_path: what is ahead of cars.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "simulation/car_rows.hpp"
#include "simulation/network_bytes.hpp"
#include "streetgen/traffic.hpp"
#include "value/given_rows.hpp"
#include "value/value_array.hpp"

extern "C" {
#include <utils/builtins.h>
}

namespace streetgen::pg {
namespace {

struct LeaderRow {
  std::int64_t car_id;
  std::optional<std::int64_t> leader;
  Leader found;
};

std::vector<LeaderRow> leaders_of(const TrafficNetwork& network, const CarsOnRoutes& read,
                                  const LeaderRules& rules) {
  const std::vector<Car>& cars = read.cars;
  Traffic traffic(network);
  traffic.routes = read.routes;
  traffic.reserve(static_cast<int>(cars.size()));
  for (const Car& car : cars) traffic.add(car);
  const std::vector<Leader> leaders = traffic.leaders(rules);
  std::vector<LeaderRow> found;
  for (std::size_t i = 0; i < cars.size(); ++i) {
    LeaderRow row{cars[i].car_id, {}, leaders[i]};
    if (leaders[i].car >= 0) row.leader = cars[leaders[i].car].car_id;
    found.push_back(row);
  }
  return found;
}

const char* virtual_word(Leader::Kind kind) {
  return kind == Leader::Kind::stationary ? "stationary" : "moving";
}

struct PathRow {
  std::int64_t link_id;
  double starts;  // metres ahead
};

std::vector<PathRow> path_rows(const TrafficNetwork& network, const LinkPlace& place,
                               double horizon, const std::vector<std::int32_t>& route) {
  check_route(network, route);
  std::vector<PathRow> found;
  double ahead = -place.metres;
  for (const std::int32_t link : free_path(network, place, horizon, route)) {
    found.push_back({network.links[link].link_id, ahead});
    ahead += network.links[link].length;
  }
  return found;
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_leaders) {
  using namespace streetgen;
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, 0);
  const std::string_view bytes = take_bytes(fcinfo, 0);
  const CarRows cars = take_cars(fcinfo, 1);
  const double at = PG_GETARG_FLOAT8(2), horizon = PG_GETARG_FLOAT8(3);
  const char* merging = text_to_cstring(PG_GETARG_TEXT_PP(4));
  const char* ahead = text_to_cstring(PG_GETARG_TEXT_PP(5));
  auto* slot = make_slot<std::vector<LeaderRow>>(CurrentMemoryContext);
  report(compute([&] {
    const TrafficNetwork network = read_network(bytes);
    LeaderRules rules;
    rules.time = finite(at, "at");
    rules.horizon = in_range(horizon, 0, farthest_horizon, "horizon");
    rules.merging = word_of<MergingLeader>(merging, "merging_leader",
                                           {{"none", MergingLeader::none},
                                            {"by_place", MergingLeader::by_place},
                                            {"by_time", MergingLeader::by_time}});
    rules.stationary_end = word_of<bool>(ahead, "virtual_car",
                                         {{"moving", false}, {"stationary", true}});
    slot->value =
        new std::vector<LeaderRow>(leaders_of(network, read_cars(cars, network), rules));
  }));
  put_rows(fcinfo, *slot->value, [](const LeaderRow& row, ReturnSetInfo* result) {
    const bool real = row.leader.has_value();
    Datum values[] = {Int64GetDatum(row.car_id),
                      Int64GetDatum(row.leader.value_or(0)),
                      real ? Datum{} : CStringGetTextDatum(virtual_word(row.found.kind)),
                      Float8GetDatum(row.found.distance),
                      Float8GetDatum(row.found.gap),
                      Float8GetDatum(row.found.speed / kmh)};
    bool nulls[] = {false, !real, real, false, false, false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  });
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_free_path) {
  using namespace streetgen;
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, 0);
  const std::string_view bytes = take_bytes(fcinfo, 0);
  const std::int64_t key = PG_GETARG_INT64(1);
  const double metres = PG_GETARG_FLOAT8(2), horizon = PG_GETARG_FLOAT8(3);
  const ValueArray route = take_values(fcinfo, 4, INT8OID, any_count, "route");
  auto* slot = make_slot<std::vector<PathRow>>(CurrentMemoryContext);
  report(compute([&] {
    const TrafficNetwork network = read_network(bytes);
    const LinkPlace place = known_place(network, key, metres);
    slot->value = new std::vector<PathRow>(
        path_rows(network, place, in_range(horizon, 0, farthest_horizon, "horizon"),
                  known_route(network, route, place.link)));
  }));
  put_rows(fcinfo, *slot->value, [](const PathRow& row, ReturnSetInfo* result) {
    Datum values[] = {Int64GetDatum(row.link_id), Float8GetDatum(row.starts)};
    bool nulls[] = {false, false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  });
  PG_RETURN_NULL();
}
