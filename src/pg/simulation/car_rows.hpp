// Cars of a model as the core takes them.
#pragma once

#include <vector>

#include "frame/composite_rows.hpp"
#include "streetgen/traffic.hpp"
#include "value/value_array.hpp"

namespace streetgen::pg {

struct CarRows {
  int count = 0;
  Column car_id, link_id, metres, speed, length, width, kind;
  ValueArray* routes = nullptr;  // of each car: keys of links
};

// An argument of type streetgen.traffic_car[]; NULL is none.
CarRows take_cars(FunctionCallInfo fcinfo, int argument);

struct CarsOnRoutes {
  std::vector<Car> cars;
  std::vector<std::vector<std::int32_t>> routes;  // by index, as cars name them
};

// For the compute step.  Refused: a car on no link, or twice; a route with a gap.  Of a route counts
// the part about the link of its car that the network has.
CarsOnRoutes read_cars(const CarRows& rows, const TrafficNetwork& network);

// The part of a route about a link that a network has; none where the link is not on it.
std::vector<std::int32_t> known_route(const TrafficNetwork& network, const ValueArray& keys,
                                      int link);

// The word of a bit of traffic.
const char* kind_word(std::uint8_t kind);

// The link of a key, which is refused where the network has none.
int known_link(const TrafficNetwork& network, std::int64_t key);
// A place on it, which is refused beyond its ends.
LinkPlace known_place(const TrafficNetwork& network, std::int64_t key, double metres);

constexpr double kmh = 1 / 3.6;  // metres a second

}  // namespace streetgen::pg
