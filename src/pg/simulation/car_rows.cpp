#include "simulation/car_rows.hpp"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <unordered_set>
#include <utility>

#include "frame/argument.hpp"

extern "C" {
#include <catalog/pg_type.h>
}

namespace streetgen::pg {

namespace {

constexpr std::initializer_list<std::pair<const char*, std::uint8_t>> kinds = {
    {"car", traffic::car},
    {"bus", traffic::bus},
    {"carpool", traffic::carpool},
    {"cycle", traffic::cycle}};

}  // namespace

const char* kind_word(std::uint8_t kind) {
  for (const auto& [word, bit] : kinds)
    if (bit == kind) return word;
  return kinds.begin()->first;
}

CarRows take_cars(FunctionCallInfo fcinfo, int argument) {
  const Rows cars = rows(fcinfo, argument, "cars");
  CarRows taken{cars.count,
                column(cars, "car_id", INT8OID),
                column(cars, "link_id", INT8OID),
                column(cars, "metres", FLOAT8OID),
                column(cars, "speed", FLOAT8OID),
                column(cars, "length", FLOAT8OID),
                column(cars, "width", FLOAT8OID),
                column(cars, "kind", TEXTOID)};
  const Column routes = column_or_null(cars, "route", INT8ARRAYOID);
  taken.routes = static_cast<ValueArray*>(
      palloc_extended(sizeof(ValueArray) * Max(cars.count, 1), MCXT_ALLOC_HUGE));
  for (int i = 0; i < cars.count; ++i) {
    taken.routes[i] = ValueArray{0, nullptr};
    if (!routes.nulls[i])
      taken.routes[i] = values_of(
          routes.values[i], INT8OID,
          psprintf("the route of car " INT64_FORMAT, DatumGetInt64(taken.car_id.values[i])));
  }
  return taken;
}

std::vector<std::int32_t> known_route(const TrafficNetwork& network, const ValueArray& keys,
                                      int link) {
  const auto key_at = [&](int i) { return DatumGetInt64(keys.values[i]); };
  int own = 0;
  while (own < keys.count && key_at(own) != network.links[link].link_id) ++own;
  if (own == keys.count) return {};
  int first = own, last = own;
  while (first > 0 && link_of(network, key_at(first - 1)) >= 0) --first;
  while (last + 1 < keys.count && link_of(network, key_at(last + 1)) >= 0) ++last;
  std::vector<std::int32_t> route;
  for (int i = first; i <= last; ++i) route.push_back(link_of(network, key_at(i)));
  return route;
}

int known_link(const TrafficNetwork& network, std::int64_t key) {
  const int link = link_of(network, key);
  if (link < 0)
    throw Error(ErrorKind::invalid_input, "there is no link " + std::to_string(key),
                "View link of the model lists them.");
  return link;
}

LinkPlace known_place(const TrafficNetwork& network, std::int64_t key, double metres) {
  const int link = known_link(network, key);
  const double length = network.links[link].length;
  if (!(metres >= -1e-6 && metres <= length + 1e-6))
    throw Error(
        ErrorKind::invalid_input,
        "link " + std::to_string(key) + " has no place at " + streetgen::text_of(metres) + " m",
        "It is " + streetgen::text_of(length) + " m long.");
  return {link, std::clamp(metres, 0.0, length)};
}

CarsOnRoutes read_cars(const CarRows& rows, const TrafficNetwork& network) {
  CarsOnRoutes read;
  std::unordered_set<std::int64_t> seen;
  for (int i = 0; i < rows.count; ++i) {
    Car car;
    car.car_id = DatumGetInt64(rows.car_id.values[i]);
    const std::string of_car = " of car " + std::to_string(car.car_id);
    if (!seen.insert(car.car_id).second)
      throw Error(ErrorKind::invalid_input,
                  "car " + std::to_string(car.car_id) + " stands more than once in the list");
    const auto measure = [&](const Column& column, double low, double high, const char* name) {
      return in_range(DatumGetFloat8(column.values[i]), low, high, name + of_car);
    };
    car.place = known_place(network, DatumGetInt64(rows.link_id.values[i]),
                            finite(DatumGetFloat8(rows.metres.values[i]), "the place" + of_car));
    car.speed = measure(rows.speed, 0, 500, "the speed") * kmh;
    car.length = static_cast<float>(measure(rows.length, 0.5, longest_car, "the length"));
    car.width = static_cast<float>(measure(rows.width, 0.3, 5, "the width"));
    car.kind = word_of<std::uint8_t>(text_of(rows.kind.values[i]), "the kind" + of_car,
                                     kinds);
    std::vector<std::int32_t> route = known_route(network, rows.routes[i], car.place.link);
    if (!route.empty()) {
      try {
        check_route(network, route);
      } catch (const Error& gap) {
        throw Error(gap.kind(), "car " + std::to_string(car.car_id) + ": " + gap.what(),
                    "Function route finds one without a gap.");
      }
      car.route = static_cast<std::int32_t>(read.routes.size());
      read.routes.push_back(std::move(route));
    }
    read.cars.push_back(car);
  }
  return read;
}

}  // namespace streetgen::pg
