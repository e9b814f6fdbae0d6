// What check_model asks of each surface and line, before it asks PostGIS.  Geometries come as EWKB.
#include "streetgen/sound.hpp"

#include <string_view>
#include <vector>

#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "value/wkb.hpp"

namespace streetgen::pg {
namespace {

// Of what the core does not take, such as NaN: `otherwise`, for PostGIS to judge.
template <class Question>
Datum answer(bool otherwise, Question question) {
  bool yes = otherwise;
  const Outcome outcome = compute([&] { yes = question(); });
  if (outcome.sqlstate != ERRCODE_INVALID_PARAMETER_VALUE) report(outcome);
  PG_RETURN_BOOL(yes);
}

}  // namespace
}  // namespace streetgen::pg

using namespace streetgen;
using namespace streetgen::pg;

STREETGEN_FUNCTION(streetgen_surely_valid) {
  const std::string_view surface = take_bytes(fcinfo, 0);
  return answer(false, [&] { return surely_valid(read_surface(surface, "surface")); });
}

STREETGEN_FUNCTION(streetgen_share_ground) {
  const std::string_view a = take_bytes(fcinfo, 0), b = take_bytes(fcinfo, 1);
  return answer(
      true, [&] { return share_ground(read_surface(a, "surface"), read_surface(b, "surface")); });
}

STREETGEN_FUNCTION(streetgen_lies_on) {
  std::string_view bytes[4];
  const int count = PG_NARGS();
  for (int i = 0; i < count; ++i) bytes[i] = take_bytes(fcinfo, i);
  return answer(false, [&] {
    std::vector<MultiPolygon> surfaces;
    for (int i = 1; i < count; ++i) surfaces.push_back(read_surface(bytes[i], "surface"));
    return lies_on(read_line(bytes[0], "line").line, surfaces);
  });
}
