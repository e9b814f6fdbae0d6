// streetgen._lanes: the lanes of one axis alone, a row each.
#include <string>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "streetgen/lane.hpp"
#include "value/lane_text.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <funcapi.h>
#include <utils/builtins.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {
namespace {

struct FoundLanes {
  int srid = 0;
  std::vector<Lane> lanes;
  std::vector<std::string> lines, surfaces;
};

void give(const FoundLanes& found, ReturnSetInfo* result) {
  for (std::size_t i = 0; i < found.lanes.size(); ++i) {
    const Lane& lane = found.lanes[i];
    const Datum values[10] = {Int32GetDatum(lane.ordinality),
                              Int32GetDatum(lane.position),
                              CStringGetTextDatum(lane_side_name(lane.side)),
                              BoolGetDatum(lane.along_axis),
                              BoolGetDatum(lane.both_ways),
                              CStringGetTextDatum(lane_kind_name(lane.kind)),
                              Float8GetDatum(lane.width),
                              Float8GetDatum(lane.axis_offset),
                              bytes_datum(found.lines[i]),
                              bytes_datum(found.surfaces[i])};
    const bool nulls[10] = {false};
    tuplestore_putvalues(result->setResult, result->setDesc, const_cast<Datum*>(values),
                         const_cast<bool*>(nulls));
  }
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_lanes) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const std::string_view axis = bytes_of(PointerGetDatum(PG_GETARG_BYTEA_PP(0)));
  const double width = PG_GETARG_FLOAT8(1), width_end = PG_GETARG_FLOAT8(2);
  const int counts[2] = {PG_GETARG_INT32(3), PG_GETARG_INT32(4)};
  const char* words[6];
  for (int i = 0; i < 6; ++i) words[i] = text_to_cstring(PG_GETARG_TEXT_PP(5 + i));
  const int lanes_both = PG_GETARG_INT32(11);
  InitMaterializedSRF(fcinfo, 0);
  Slot<FoundLanes>* slot = make_slot<FoundLanes>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new FoundLanes;
    const ReadLine read = read_line(axis, "axis");
    in_range(width, 1e-3, 200, "width");
    in_range(width_end, 1e-3, 200, "width_end");
    const auto list = [&](int way) {
      const std::string of_way = way == 0 ? "_forward" : "_backward", widths = words[2 + way];
      const int count = static_cast<int>(in_range(counts[way], 0, 40, "lanes" + of_way));
      std::vector<LaneWish> lanes = read_lanes(count, words[way], widths, "", {}, "");
      if (!widths.empty() && !names_lanes(widths, lanes))
        refuse_word(widths, "lane_width" + of_way,
                    "a width for each of " + std::to_string(lanes.size()) + " lanes");
      return lanes;
    };
    std::vector<LaneWish> both(static_cast<int>(in_range(lanes_both, 0, 40, "lanes_both")));
    const LaneSettings settings = read_lane_settings(words[4], words[5], LaneSettings{}.narrowest);
    FoundLanes& found = *slot->value;
    found.lanes = axis_lanes(read.line, width, width_end, {list(0), list(1), both}, settings);
    for (const Lane& lane : found.lanes) {
      found.lines.push_back(write_line(lane.line, {read.srid, false}));
      found.surfaces.push_back(write_surface(lane.surface, {read.srid, false}));
    }
  });
  report(outcome);
  give(*slot->value, reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo));
  PG_RETURN_NULL();
}
