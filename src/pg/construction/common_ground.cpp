// streetgen._common_ground: the share of a line's ground that another one has beside it.
#include "streetgen/common_ground.hpp"

#include "frame/argument.hpp"
#include "frame/geometry_result.hpp"
#include "value/wkb.hpp"

STREETGEN_FUNCTION(streetgen_common_ground) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const std::string_view line = take_bytes(fcinfo, 0), other = take_bytes(fcinfo, 1);
  const double distance = PG_GETARG_FLOAT8(2);
  double shared = 0;
  const Outcome outcome = compute([&] {
    shared = common_ground(read_line(line, "line").line, read_line(other, "other").line,
                           in_range(distance, 0.001, 1000, "distance"));
  });
  report(outcome);
  PG_RETURN_FLOAT8(shared);
}
