// The points of a line as files of SUMO and of SymuVia have them.
#include <cmath>
#include <string>

#include "frame/geometry_result.hpp"
#include "value/decimal.hpp"
#include "value/stored.hpp"
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
