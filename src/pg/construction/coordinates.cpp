// The points of a line as files of SUMO and of SymuVia have them, and points that are one in files.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "frame/argument.hpp"
#include "frame/geometry_result.hpp"
#include "streetgen/first_within.hpp"
#include "value/decimal.hpp"
#include "value/number_array.hpp"
#include "value/stored.hpp"
#include "value/value_array.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <utils/builtins.h>
}

namespace streetgen::pg {
namespace {

// The arguments of both: a line, an origin and the digits of a coordinate. Nothing is NULL.
template <class Work>
Datum line_text(FunctionCallInfo fcinfo, Work work) {
  const std::string_view line = take_bytes(fcinfo, 0);
  const Point origin{PG_GETARG_FLOAT8(1), PG_GETARG_FLOAT8(2)};
  const int digits = PG_GETARG_INT32(3);
  Slot<std::string>* slot = make_slot<std::string>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new std::string;
    Line points = read_vertices(wkb_of_stored(line), "the line");
    for (Point& point : points) point = {point.x - origin.x, point.y - origin.y};
    work(points, digits, *slot->value);
  });
  report(outcome);
  const std::string& text = *slot->value;
  if (text.empty()) PG_RETURN_NULL();
  return PointerGetDatum(cstring_to_text_with_len(text.data(), static_cast<int>(text.size())));
}

void append_place(std::string& text, const Point& place, char between, int digits) {
  append_short_decimal(text, place.x, digits);
  text += between;
  append_short_decimal(text, place.y, digits);
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_rounded_coordinates) {
  using namespace streetgen;
  using namespace streetgen::pg;
  return line_text(fcinfo, [](const Line& points, int digits, std::string& text) {
    const double step = std::pow(10.0, -digits);
    Line places;
    for (const Point& point : points) {
      const Point place{std::rint(point.x / step) * step, std::rint(point.y / step) * step};
      if (places.empty() || place.x != places.back().x || place.y != places.back().y)
        places.push_back(place);
    }
    if (places.size() < 2) return;
    for (const Point& place : places) {
      if (!text.empty()) text += ' ';
      append_place(text, place, ',', digits);
    }
  });
}

STREETGEN_FUNCTION(streetgen_symuvia_points) {
  using namespace streetgen;
  using namespace streetgen::pg;
  return line_text(fcinfo, [](const Line& points, int digits, std::string& text) {
    if (points.size() < 3) return;
    text = "<POINTS_INTERNES>";
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      text += "<POINT_INTERNE coordonnees=\"";
      append_place(text, points[i], ' ', digits);
      text += "\"/>";
    }
    text += "</POINTS_INTERNES>";
  });
}

// Places as x, y and z, the group of each, and a reach.
STREETGEN_FUNCTION(streetgen_first_within) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const NumberArray place = take_numbers(fcinfo, 0);
  const ValueArray group = take_values(fcinfo, 1, INT8OID, place.count / 3, "groups");
  const double reach = PG_GETARG_FLOAT8(2);
  auto* slot = make_slot<std::vector<int>>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    const std::vector<double> numbers = read_numbers(place, 3, "places");
    std::vector<Point> places;
    std::vector<std::int64_t> groups;
    for (int i = 0; i < group.count; ++i) {
      places.push_back({numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]});
      groups.push_back(DatumGetInt64(group.values[i]));
    }
    slot->value = new std::vector<int>;
    *slot->value = first_within(places, groups, in_range(reach, 1e-6, 1e3, "reach"));
  });
  report(outcome);
  const int count = static_cast<int>(slot->value->size());
  auto* first = static_cast<Datum*>(palloc(count * sizeof(Datum)));
  for (int i = 0; i < count; ++i) first[i] = Int32GetDatum((*slot->value)[i] + 1);
  PG_RETURN_ARRAYTYPE_P(construct_array(first, count, INT4OID, 4, true, TYPALIGN_INT));
}
