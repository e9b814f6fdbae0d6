// streetgen._link_frame: how a car stands at a place of a link.
#include <string_view>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "simulation/car_rows.hpp"
#include "simulation/network_bytes.hpp"
#include "streetgen/traffic.hpp"

extern "C" {
#include <access/htup_details.h>
#include <funcapi.h>
}

// x, y, height (NULL where none is known), heading, curvature, steering and grade.
STREETGEN_FUNCTION(streetgen_link_frame) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const std::string_view bytes = take_bytes(fcinfo, 0);
  const std::int64_t key = PG_GETARG_INT64(1);
  const double metres = PG_GETARG_FLOAT8(2), wheelbase = PG_GETARG_FLOAT8(3);
  TupleDesc type = nullptr;
  get_call_result_type(fcinfo, nullptr, &type);
  type = BlessTupleDesc(type);
  LinkFrame place;
  bool flat = false;
  const Outcome outcome = compute([&] {
    const TrafficNetwork network = read_network(bytes);
    const LinkPlace at = known_place(network, key, metres);
    place = frame(network, at, in_range(wheelbase, 0.1, 30, "wheelbase"));
    flat = network.heights.of(at.link).empty();
  });
  report(outcome);
  const double numbers[] = {place.x,         place.y,        place.height, place.heading,
                            place.curvature, place.steering, place.grade};
  constexpr int columns = 7;
  Datum values[columns];
  bool nulls[columns] = {false};
  for (int i = 0; i < columns; ++i) values[i] = Float8GetDatum(numbers[i]);
  nulls[2] = nulls[6] = flat;
  return HeapTupleGetDatum(heap_form_tuple(type, values, nulls));
}
