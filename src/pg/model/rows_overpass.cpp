// The rows of subject overpass.
#include <utility>

#include "model/row_value.hpp"
#include "model/streets_give.hpp"

namespace streetgen::pg {

namespace {

using Computed = const ComputedStreets&;

const char* overpass_method_name(OverpassMethod method) {
  switch (method) {
    case OverpassMethod::by_hand:
      return "by_hand";
    case OverpassMethod::level:
      return "level";
    case OverpassMethod::importance:
      return "importance";
    case OverpassMethod::order:
      return "order";
  }
  return "";
}

bool fill_overpass(const ComputedStreets& computed, const Named& named, std::size_t i, Row& row) {
  const Overpass& overpass = computed.overpasses[i];
  const std::int64_t above = named.edges[overpass.edge_above];
  const std::int64_t below = named.edges[overpass.edge_below];
  return above != 0 && below != 0 &&
         put(row, above, overpass.abscissa_above, below, overpass.abscissa_below,
             Geometry{stored_point(overpass.point, flat(computed))}, overpass.clearance,
             name(overpass_method_name(overpass.method)));
}

const Table overpass_table{[](Computed c) { return c.overpasses.size(); }, fill_overpass};

}  // namespace

STREETGEN_TABLE(overpass, &Named::edges)

}  // namespace streetgen::pg
