#include "value/paint_rows.hpp"

#include <sstream>

#include "frame/argument.hpp"

extern "C" {
#include <catalog/pg_type.h>
}

namespace streetgen::pg {

PaintRows take_paint(FunctionCallInfo fcinfo, int junctions, int changes, int leaving) {
  const Rows kinds = rows(fcinfo, junctions, "junction overrides");
  const Rows beside = rows(fcinfo, changes, "lane adjacency overrides");
  const Rows words = rows(fcinfo, leaving, "words about paint");
  return {
      {kinds.count, column(kinds, "axis_id", INT8OID), column(kinds, "x", FLOAT8OID),
       column(kinds, "y", FLOAT8OID), column(kinds, "kind", TEXTOID)},
      {beside.count, column(beside, "axis_id", INT8OID), column(beside, "abscissa", FLOAT8OID),
       column(beside, "lane_from", INT4OID), column(beside, "lane_to", INT4OID),
       column(beside, "change", TEXTOID)},
      {words.count, column(words, "axis_id", INT8OID), column_or_null(words, "forward", TEXTOID),
       column_or_null(words, "backward", TEXTOID), column(words, "bare", BOOLOID)}};
}

namespace {

// Words of OSM's change:lanes, parted by bars.
LeavingLanes leaving_of(const Column& words, int row) {
  LeavingLanes lanes;
  if (words.nulls[row]) return lanes;
  std::istringstream text(text_of(words.values[row]));
  for (std::string word; std::getline(text, word, '|');) {
    std::optional<LeavingLane> leaving;
    if (!word.empty()) {
      const bool both = word == "yes";
      leaving = LeavingLane{both || word == "not_right" || word == "only_left",
                            both || word == "not_left" || word == "only_right"};
    }
    lanes.push_back(leaving);
  }
  return lanes;
}

}  // namespace

PaintRules read_paint(const PaintRows& rows) {
  PaintRules rules;
  for (int i = 0; i < rows.junctions.count; ++i) {
    const auto coordinate = [i](const Column& column) {
      return finite(DatumGetFloat8(column.values[i]), "place of a junction override");
    };
    rules.junctions.push_back(
        {DatumGetInt64(rows.junctions.axis_id.values[i]),
         {coordinate(rows.junctions.x), coordinate(rows.junctions.y)},
         word_of<JunctionKind>(text_of(rows.junctions.kind.values[i]),
                               "kind of a junction override",
                               {{"ramp", JunctionKind::ramp},
                                {"fork", JunctionKind::fork},
                                {"merge", JunctionKind::merge},
                                {"signals", JunctionKind::signals},
                                {"stop", JunctionKind::stop},
                                {"priority", JunctionKind::priority},
                                {"right_before_left", JunctionKind::right_before_left},
                                {"roundabout", JunctionKind::roundabout},
                                {"continuation", JunctionKind::continuation},
                                {"end", JunctionKind::end}})});
  }
  const auto& changes = rows.changes;
  for (int i = 0; i < changes.count; ++i)
    rules.changes.push_back(
        {DatumGetInt64(changes.axis_id.values[i]),
         finite(DatumGetFloat8(changes.abscissa.values[i]),
                "abscissa of a lane adjacency override"),
         DatumGetInt32(changes.lane_from.values[i]), DatumGetInt32(changes.lane_to.values[i]),
         word_of<bool>(text_of(changes.change.values[i]), "change of a lane adjacency override",
                       {{"allowed", true}, {"forbidden", false}})});
  for (int i = 0; i < rows.leaving.count; ++i) {
    const std::int64_t axis_id = DatumGetInt64(rows.leaving.axis_id.values[i]);
    rules.leaving.push_back(
        {axis_id, leaving_of(rows.leaving.forward, i), leaving_of(rows.leaving.backward, i)});
    if (DatumGetBool(rows.leaving.bare.values[i])) rules.bare.push_back(axis_id);
  }
  return rules;
}

}  // namespace streetgen::pg
