// The heights along a road as the polynomials of OpenDRIVE.
#include "streetgen/height_curve.hpp"

#include <vector>

#include "frame/argument.hpp"
#include "frame/array_row.hpp"
#include "frame/border.hpp"
#include "frame/geometry_result.hpp"
#include "value/number_array.hpp"

extern "C" {
#include <funcapi.h>
}

// Stations, heights and the tolerance; as many columns as a polynomial has numbers.
STREETGEN_FUNCTION(streetgen_height_curve) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const NumberArray station = take_numbers(fcinfo, 0), height = take_numbers(fcinfo, 1);
  const double tolerance = PG_GETARG_FLOAT8(2);
  InitMaterializedSRF(fcinfo, MAT_SRF_USE_EXPECTED_DESC);
  auto* slot = make_slot<NumberColumns>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    const std::vector<double> stations = read_numbers(station, 1, "station");
    const std::vector<double> heights = read_numbers(height, 1, "height");
    if (heights.size() != stations.size())
      throw Error(ErrorKind::invalid_input, "there is not a height for each station");
    for (std::size_t i = 1; i < stations.size(); ++i)
      if (!(stations[i] > stations[i - 1]))
        throw Error(ErrorKind::invalid_input, "stations do not increase");
    slot->value = new NumberColumns(5);
    for (const HeightPiece& piece :
         height_curve(stations, heights, in_range(tolerance, 1e-6, 1e3, "tolerance"))) {
      const double numbers[] = {piece.s, piece.a, piece.b, piece.c, piece.d};
      for (int i = 0; i < 5; ++i) (*slot->value)[i].push_back(numbers[i]);
    }
  });
  report(outcome);
  give_row(*slot->value, result_of(fcinfo));
  PG_RETURN_NULL();
}
