// streetgen._car_frames: how cars stand.
#include <utility>
#include <vector>

#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "simulation/car_rows.hpp"
#include "simulation/network_bytes.hpp"
#include "streetgen/traffic.hpp"
#include "value/given_rows.hpp"

namespace streetgen::pg {
namespace {

struct CarFrame {
  std::int64_t car_id;
  LinkFrame frame;
};

std::vector<CarFrame> frames_of(const TrafficNetwork& network, CarsOnRoutes given) {
  Traffic traffic(network);
  traffic.routes = std::move(given.routes);
  traffic.reserve(static_cast<int>(given.cars.size()));
  std::vector<CarFrame> frames;
  for (const Car& car : given.cars)
    frames.push_back({car.car_id, body_frame(traffic, traffic.add(car))});
  return frames;
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_car_frames) {
  using namespace streetgen;
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, 0);
  const std::string_view bytes = take_bytes(fcinfo, 0);
  const CarRows cars = take_cars(fcinfo, 1);
  auto* slot = make_slot<std::vector<CarFrame>>(CurrentMemoryContext);
  report(compute([&] {
    const TrafficNetwork network = read_network(bytes);
    slot->value = new std::vector<CarFrame>(frames_of(network, read_cars(cars, network)));
  }));
  put_rows(fcinfo, *slot->value, [](const CarFrame& row, ReturnSetInfo* result) {
    Datum values[] = {Int64GetDatum(row.car_id), Float8GetDatum(row.frame.x),
                      Float8GetDatum(row.frame.y), Float8GetDatum(row.frame.heading)};
    bool nulls[4] = {false};
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
  });
  PG_RETURN_NULL();
}
