// streetgen._osm_lanes: the lanes that tags of a way of OpenStreetMap state, as one row.
#include "streetgen/osm_lanes.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "value/decimal.hpp"
#include "value/lane_text.hpp"

extern "C" {
#include <catalog/pg_type.h>
#include <funcapi.h>
#include <utils/array.h>
#include <utils/builtins.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {
namespace {

struct Texts {
  int count = 0;
  Datum* values = nullptr;
};

Texts take_texts(FunctionCallInfo fcinfo, int argument, const char* name) {
  Texts texts;
  ArrayType* array = PG_GETARG_ARRAYTYPE_P(argument);
  if (array_contains_nulls(array))
    ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED), errmsg("%s holds NULL", name)));
  deconstruct_array(array, TEXTOID, -1, false, TYPALIGN_INT, &texts.values, nullptr, &texts.count);
  return texts;
}

Datum texts_datum(const std::vector<std::string>& texts) {
  auto* values = static_cast<Datum*>(palloc(sizeof(Datum) * (texts.size() + 1)));
  for (std::size_t i = 0; i < texts.size(); ++i) values[i] = CStringGetTextDatum(texts[i].c_str());
  return PointerGetDatum(
      construct_array(values, static_cast<int>(texts.size()), TEXTOID, -1, false, TYPALIGN_INT));
}

// A word of each lane, parted by |; empty where no lane has one.  Where cycle and parking lanes
// have none they are left out.
template <class Word>
std::string listed(const std::vector<OsmLane>& lanes, const Word& word) {
  const bool of_all = std::any_of(lanes.begin(), lanes.end(), [&](const OsmLane& lane) {
    return !drives(lane.kind) && !word(lane).empty();
  });
  std::string list;
  bool said = false;
  const char* between = "";
  for (const OsmLane& lane : lanes) {
    if (!of_all && !drives(lane.kind)) continue;
    const std::string own = word(lane);
    said |= !own.empty();
    list += between + own;
    between = "|";
  }
  return said ? list : "";
}

// Of one direction, as columns of axis; an empty text is unknown.
struct DirectionTexts {
  std::string kinds, widths, turns, changes;
};

DirectionTexts texts_of(const std::vector<OsmLane>& lanes, bool listed_kinds) {
  DirectionTexts texts;
  if (listed_kinds)
    for (const OsmLane& lane : lanes)
      texts.kinds += (texts.kinds.empty() ? "" : "|") + std::string(lane_kind_name(lane.kind));
  texts.widths = listed(lanes, [](const OsmLane& lane) {
    std::string width;
    if (lane.width) append_short_decimal(width, *lane.width, 3);
    return width;
  });
  texts.turns = listed(lanes, [](const OsmLane& lane) { return lane.turn; });
  texts.changes = listed(lanes, [](const OsmLane& lane) { return lane.change; });
  return texts;
}

// A word of both directions, or one of each.
std::string access_text(const OsmLanes& lanes) {
  if (lanes.access_forward == lanes.access_backward) return lanes.access_forward;
  return lanes.access_forward + "|" + lanes.access_backward;
}

// As columns parking_left and parking_right of axis: what is not said at the end is left out.
std::string parking_text(const OsmSideParking& parking) {
  std::string text = parking.place, between;
  const auto add = [&](const std::string& word) {
    between += "|";
    if (word.empty()) return;
    text += between + word;
    between.clear();
  };
  add(parking.orientation);
  std::string depth;
  if (parking.depth) append_short_decimal(depth, *parking.depth, 3);
  add(depth);
  add(parking.capacity ? std::to_string(*parking.capacity) : "");
  return text;
}

// As columns strips_left and strips_right of axis.
std::string strips_text(const std::vector<SideStrip>& strips) {
  std::string text;
  for (const SideStrip& strip : strips) {
    if (!text.empty()) text += "|";
    text += side_strip_name(strip.kind);
    if (!strip.width) continue;
    text += " ";
    append_short_decimal(text, *strip.width, 3);
  }
  return text;
}

struct FoundOsmLanes {
  OsmLanes lanes;
  int driving[2] = {0, 0};
  DirectionTexts texts[2];
  std::vector<std::string> keys, reasons;
};

// Are all lanes those of whoever may drive there?  Of unknown lanes the access alone says it.
bool says_no_kinds(const std::vector<OsmLane>& lanes, bool known, const std::string& access) {
  const LaneKind usual = known ? LaneKind::general : lanes_for(access);
  return std::all_of(lanes.begin(), lanes.end(), [&](const OsmLane& lane) {
    return lane.kind == LaneKind::general || (lane.kind == usual && drives(usual));
  });
}

void put_into_words(FoundOsmLanes& found) {
  const OsmLanes& lanes = found.lanes;
  const bool plain[2] = {
      says_no_kinds(lanes.forward, lanes.forward_known || lanes.lane_count, lanes.access_forward),
      says_no_kinds(lanes.backward, lanes.backward_known || lanes.lane_count,
                    lanes.access_backward)};
  // Of unknown lanes the kinds of one direction say how many the other one has.
  const bool by_kinds = lanes.direction == WayDirection::both && !lanes.forward_known &&
                        !lanes.backward_known && !lanes.lane_count && !(plain[0] && plain[1]);
  for (int way = 0; way < 2; ++way) {
    const std::vector<OsmLane>& of_way = way == 0 ? lanes.forward : lanes.backward;
    found.driving[way] = static_cast<int>(std::count_if(
        of_way.begin(), of_way.end(), [](const OsmLane& lane) { return drives(lane.kind); }));
    found.texts[way] = texts_of(of_way, by_kinds || !plain[way]);
  }
  for (const UnreadTag& tag : lanes.unread) {
    found.keys.push_back(tag.key);
    found.reasons.push_back(tag.reason);
  }
}

void give(const FoundOsmLanes& found, ReturnSetInfo* result) {
  const OsmLanes& lanes = found.lanes;
  constexpr int count = 21;
  Datum values[count];
  bool nulls[count] = {false};
  int next = 0;
  const auto number = [&](int value, bool known) {
    nulls[next] = !known;
    values[next++] = Int32GetDatum(value);
  };
  const auto text = [&](const std::string& words) {
    nulls[next] = words.empty();
    values[next++] = CStringGetTextDatum(words.c_str());
  };
  text(lanes.direction == WayDirection::both     ? "both"
       : lanes.direction == WayDirection::direct ? "direct"
                                                 : "reverse");
  number(lanes.lane_count.value_or(0), lanes.lane_count.value_or(0) > 0);
  number(found.driving[0], lanes.forward_known);
  number(found.driving[1], lanes.backward_known);
  number(lanes.both_ways, lanes.both_ways > 0);
  for (const auto list : {&DirectionTexts::kinds, &DirectionTexts::widths, &DirectionTexts::turns,
                          &DirectionTexts::changes})
    for (const DirectionTexts& texts : found.texts) text(texts.*list);
  nulls[next] = !lanes.roadway_offset;
  values[next++] = Float8GetDatum(lanes.roadway_offset.value_or(0));
  text(access_text(lanes));
  text(parking_text(lanes.parking_left));
  text(parking_text(lanes.parking_right));
  text(strips_text(lanes.strips_left));
  text(strips_text(lanes.strips_right));
  values[next++] = texts_datum(found.keys);
  values[next++] = texts_datum(found.reasons);
  tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_osm_lanes) {
  using namespace streetgen;
  using namespace streetgen::pg;
  const Texts keys = take_texts(fcinfo, 0, "keys"), words = take_texts(fcinfo, 1, "words");
  const char* side = text_to_cstring(PG_GETARG_TEXT_PP(2));
  OsmLaneUse use;
  use.lane_width = PG_GETARG_FLOAT8(3);
  use.cycle_lane_width = PG_GETARG_FLOAT8(4);
  use.parking_lane_width = PG_GETARG_FLOAT8(5);
  const double roadway_width = PG_GETARG_FLOAT8(6);
  const int usual_lanes = PG_GETARG_INT32(7);
  use.two_way_width = PG_GETARG_FLOAT8(8);
  use.narrowest_of_several = PG_GETARG_FLOAT8(9);
  use.diagonal_depth = PG_GETARG_FLOAT8(10);
  use.perpendicular_depth = PG_GETARG_FLOAT8(11);
  InitMaterializedSRF(fcinfo, 0);
  Slot<FoundOsmLanes>* slot = make_slot<FoundOsmLanes>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new FoundOsmLanes;
    use.driving_side = word_of<DrivingSide>(
        side, "driving side", {{"left", DrivingSide::left}, {"right", DrivingSide::right}});
    if (in_range(roadway_width, 0, 200, "width") > 0) use.roadway_width = roadway_width;
    use.usual_lanes = static_cast<int>(in_range(usual_lanes, 1, 30, "usual lanes"));
    OsmTags tags;
    for (int i = 0; i < keys.count && i < words.count; ++i)
      tags[text_of(keys.values[i])] = text_of(words.values[i]);
    slot->value->lanes = read_osm_lanes(tags, use);
    put_into_words(*slot->value);
  });
  report(outcome);
  give(*slot->value, reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo));
  PG_RETURN_NULL();
}

STREETGEN_FUNCTION(streetgen_access_word) {
  using namespace streetgen::pg;
  char* said = text_to_cstring(PG_GETARG_TEXT_PP(0));
  const char* word = "";
  const Outcome outcome = compute([&] { word = streetgen::access_word(said); });
  report(outcome);
  PG_RETURN_TEXT_P(cstring_to_text(word));
}

STREETGEN_FUNCTION(streetgen_osm_tag_use) {
  using namespace streetgen;
  InitMaterializedSRF(fcinfo, 0);
  const auto* result = reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo);
  const auto tell = [&](const char* of, const std::vector<OsmTagUse>& uses) {
    for (const OsmTagUse& use : uses) {
      Datum values[3] = {CStringGetTextDatum(of), CStringGetTextDatum(use.keys),
                         CStringGetTextDatum(use.becomes)};
      bool nulls[3] = {};
      tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
    }
  };
  tell("lanes", osm_tag_uses());
  tell("ways", osm_way_tag_uses());
  PG_RETURN_NULL();
}
