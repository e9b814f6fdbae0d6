// Cars of a model as the core takes them.
#pragma once

#include <vector>

#include "frame/composite_rows.hpp"
#include "streetgen/traffic.hpp"

namespace streetgen::pg {

struct CarRows {
  int count = 0;
  Column car_id, link_id, metres, speed, length, width, kind;
};

// An argument of type streetgen.traffic_car[]; NULL is none.
CarRows take_cars(FunctionCallInfo fcinfo, int argument);

// For the compute step.  Refused: a car on no link, or twice.
std::vector<Car> read_cars(const CarRows& rows, const TrafficNetwork& network);

// The link of a key, which is refused where the network has none.
int known_link(const TrafficNetwork& network, std::int64_t key);
// A place on it, which is refused beyond its ends.
LinkPlace known_place(const TrafficNetwork& network, std::int64_t key, double metres);

constexpr double kmh = 1 / 3.6;  // metres a second

}  // namespace streetgen::pg
