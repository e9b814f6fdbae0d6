// streetgen._blocks: blocks of edges and kerbs, a row each, and the sides outside of them.
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "frame/argument.hpp"
#include "frame/border.hpp"
#include "streetgen/block.hpp"
#include "value/line_array.hpp"
#include "value/wkb.hpp"

extern "C" {
#include <funcapi.h>
#include <utils/builtins.h>
#include <utils/tuplestore.h>
}

namespace streetgen::pg {
namespace {

// The elements of an array that has none that is NULL, as many as `count` where that is not
// negative.
struct Values {
  int count;
  Datum* values;
};

Values take_values(FunctionCallInfo fcinfo, int argument, Oid type, int size, bool by_value,
                   char align, const char* name, int count = -1) {
  Values taken;
  bool* nulls;
  deconstruct_array(PG_GETARG_ARRAYTYPE_P(argument), type, size, by_value, align, &taken.values,
                    &nulls, &taken.count);
  if (count >= 0 && taken.count != count)
    ereport(ERROR, (errcode(ERRCODE_ARRAY_SUBSCRIPT_ERROR),
                    errmsg("%s has %d elements, expected %d", name, taken.count, count)));
  for (int i = 0; i < taken.count; ++i)
    if (nulls[i])
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED),
                      errmsg("element %d of %s is NULL", i + 1, name)));
  return taken;
}

Values take_ids(FunctionCallInfo fcinfo, int argument, const char* name, int count = -1) {
  return take_values(fcinfo, argument, INT8OID, 8, true, 'd', name, count);
}
Values take_numbers(FunctionCallInfo fcinfo, int argument, const char* name, int count = -1) {
  return take_values(fcinfo, argument, FLOAT8OID, 8, true, 'd', name, count);
}
Values take_words(FunctionCallInfo fcinfo, int argument, const char* name, int count) {
  const Values words = take_values(fcinfo, argument, TEXTOID, -1, false, 'i', name, count);
  for (int i = 0; i < words.count; ++i)
    words.values[i] = PointerGetDatum(PG_DETOAST_DATUM_PACKED(words.values[i]));
  return words;
}

struct BlocksCall {
  Values edges;
  LineArray edge_lines;
  Values on_rings;
  Values kerb_edges, kerb_sides;
  Values kerbs_contested, kerbs_change_level;
  LineArray kerb_lines;
  Values kept_edges, kept_left, kept_starts, kept_ends;
  Values places_x, places_y, kinds;
  double island_area, strip_width, strip_elongation;
};

// Numbers of edges by their ids; -1 of one that is not given.
class EdgeNumbers {
 public:
  explicit EdgeNumbers(const Values& ids) {
    for (int i = 0; i < ids.count; ++i) numbers_[DatumGetInt64(ids.values[i])] = i;
  }
  int of(Datum id) const {
    const auto found = numbers_.find(DatumGetInt64(id));
    return found == numbers_.end() ? -1 : found->second;
  }

 private:
  std::unordered_map<std::int64_t, int> numbers_;
};

KerbSide side_of(const std::string& word) {
  return word_of<KerbSide>(word, "side",
                           {{"left", KerbSide::left},
                            {"right", KerbSide::right},
                            {"start", KerbSide::start},
                            {"end", KerbSide::end},
                            {"corner_at_start", KerbSide::corner_at_start},
                            {"corner_at_end", KerbSide::corner_at_end},
                            {"across_start", KerbSide::across_start},
                            {"across_end", KerbSide::across_end}});
}

BlockKind kind_of(const std::string& word) {
  return word_of<BlockKind>(
      word, "kind",
      {{"block", BlockKind::block}, {"island", BlockKind::island}, {"strip", BlockKind::strip}});
}

BlocksInput read_input(const BlocksCall& call, Form* form) {
  BlocksInput input;
  const EdgeNumbers numbers(call.edges);
  input.edges = read_lines(call.edge_lines, "edge", form);
  for (int i = 0; i < call.on_rings.count; ++i)
    input.on_rings.push_back(DatumGetBool(call.on_rings.values[i]));
  std::vector<Line> lines = read_lines(call.kerb_lines, "kerb", form);
  for (int i = 0; i < call.kerb_edges.count; ++i) {
    Kerb kerb;
    kerb.edge = numbers.of(call.kerb_edges.values[i]);
    kerb.side = side_of(text_of(call.kerb_sides.values[i]));
    kerb.line = std::move(lines[i]);
    if (DatumGetBool(call.kerbs_contested.values[i])) kerb.method = Method::contested;
    if (DatumGetBool(call.kerbs_change_level.values[i])) kerb.method = Method::level_change;
    input.kerbs.push_back(std::move(kerb));
  }
  for (int i = 0; i < call.kept_edges.count; ++i) {
    const int edge = numbers.of(call.kept_edges.values[i]);
    if (edge >= 0)
      input.kept.push_back({edge, DatumGetBool(call.kept_left.values[i]), 1,
                            DatumGetFloat8(call.kept_starts.values[i]),
                            DatumGetFloat8(call.kept_ends.values[i])});
  }
  for (int i = 0; i < call.kinds.count; ++i)
    input.overrides.push_back({{finite(DatumGetFloat8(call.places_x.values[i]), "x"),
                                finite(DatumGetFloat8(call.places_y.values[i]), "y"), 0},
                               kind_of(text_of(call.kinds.values[i]))});
  input.settings = {in_range(call.island_area, 0, 1e6, "block_island_area"),
                    in_range(call.strip_width, 0, 1000, "block_strip_width"),
                    in_range(call.strip_elongation, 1, 1000, "block_strip_elongation")};
  return input;
}

struct FoundBlocks {
  Blocks blocks;
  std::vector<std::string> surfaces;
};

// Arrays of one row: edge, left, ring, start, end.
struct SideArrays {
  explicit SideArrays(std::size_t size) {
    for (Datum*& column : columns) column = static_cast<Datum*>(palloc(sizeof(Datum) * (size + 1)));
  }
  void add(const Values& edges, const EdgeSide& side, int ring) {
    columns[0][count] = edges.values[side.edge];
    columns[1][count] = BoolGetDatum(side.left);
    columns[2][count] = Int32GetDatum(ring);
    columns[3][count] = Float8GetDatum(side.start);
    columns[4][count] = Float8GetDatum(side.end);
    ++count;
  }
  void put(Datum* values) {
    values[0] = array(0, INT8OID, 8, 'd');
    values[1] = array(1, BOOLOID, 1, 'c');
    values[2] = array(2, INT4OID, 4, 'i');
    values[3] = array(3, FLOAT8OID, 8, 'd');
    values[4] = array(4, FLOAT8OID, 8, 'd');
  }
  Datum array(int column, Oid type, int size, char align) {
    return PointerGetDatum(construct_array(columns[column], count, type, size, true, align));
  }

  Datum* columns[5];
  int count = 0;
};

void give(const BlocksCall& call, const FoundBlocks& found, ReturnSetInfo* result) {
  const std::vector<Block>& blocks = found.blocks.blocks;
  MemoryContext row = AllocSetContextCreate(CurrentMemoryContext, "block", ALLOCSET_DEFAULT_SIZES);
  MemoryContext before = MemoryContextSwitchTo(row);
  for (std::size_t b = 0; b <= blocks.size(); ++b) {
    Datum values[10];
    bool nulls[10] = {false};
    const bool outside = b == blocks.size();
    SideArrays sides(outside ? found.blocks.outside.size() : blocks[b].sides.size());
    if (outside) {
      for (const EdgeSide& side : found.blocks.outside) sides.add(call.edges, side, 1);
      values[0] = Int32GetDatum(0);
      values[4] = BoolGetDatum(true);
      nulls[1] = nulls[2] = nulls[3] = true;
    } else {
      for (const BlockSide& side : blocks[b].sides) sides.add(call.edges, side.side, side.ring);
      values[0] = Int32GetDatum(static_cast<int>(b) + 1);
      values[1] = CStringGetTextDatum(block_kind_name(blocks[b].kind));
      values[2] = CStringGetTextDatum(method_name(blocks[b].method));
      values[3] = bytes_datum(found.surfaces[b]);
      values[4] = BoolGetDatum(blocks[b].has_all_kerbs);
    }
    sides.put(values + 5);
    tuplestore_putvalues(result->setResult, result->setDesc, values, nulls);
    MemoryContextReset(row);
  }
  MemoryContextSwitchTo(before);
  MemoryContextDelete(row);
}

}  // namespace
}  // namespace streetgen::pg

STREETGEN_FUNCTION(streetgen_blocks) {
  using namespace streetgen;
  using namespace streetgen::pg;
  InitMaterializedSRF(fcinfo, 0);
  BlocksCall call;
  call.edges = take_ids(fcinfo, 0, "edges");
  call.edge_lines = take_lines(PG_GETARG_ARRAYTYPE_P(1), "edge_lines");
  call.on_rings = take_values(fcinfo, 2, BOOLOID, 1, true, 'c', "on_rings", call.edges.count);
  call.kerb_edges = take_ids(fcinfo, 3, "kerb_edges");
  const int kerbs = call.kerb_edges.count;
  call.kerb_sides = take_words(fcinfo, 4, "kerb_sides", kerbs);
  call.kerbs_contested = take_values(fcinfo, 5, BOOLOID, 1, true, 'c', "kerbs_contested", kerbs);
  call.kerbs_change_level =
      take_values(fcinfo, 6, BOOLOID, 1, true, 'c', "kerbs_change_level", kerbs);
  call.kerb_lines = take_lines(PG_GETARG_ARRAYTYPE_P(7), "kerb_lines");
  call.kept_edges = take_ids(fcinfo, 8, "kept_edges");
  const int kept = call.kept_edges.count;
  call.kept_left = take_values(fcinfo, 9, BOOLOID, 1, true, 'c', "kept_left", kept);
  call.kept_starts = take_numbers(fcinfo, 10, "kept_starts", kept);
  call.kept_ends = take_numbers(fcinfo, 11, "kept_ends", kept);
  call.places_x = take_numbers(fcinfo, 12, "places_x");
  call.places_y = take_numbers(fcinfo, 13, "places_y", call.places_x.count);
  call.kinds = take_words(fcinfo, 14, "kinds", call.places_x.count);
  call.island_area = PG_GETARG_FLOAT8(15);
  call.strip_width = PG_GETARG_FLOAT8(16);
  call.strip_elongation = PG_GETARG_FLOAT8(17);
  if (call.edge_lines.count != call.edges.count || call.kerb_lines.count != kerbs)
    ereport(ERROR,
            (errcode(ERRCODE_ARRAY_SUBSCRIPT_ERROR), errmsg("ids and lines differ in number")));
  Slot<FoundBlocks>* slot = make_slot<FoundBlocks>(CurrentMemoryContext);
  const Outcome outcome = compute([&] {
    slot->value = new FoundBlocks;
    Form form;
    slot->value->blocks = blocks(read_input(call, &form));
    for (const Block& block : slot->value->blocks.blocks)
      slot->value->surfaces.push_back(write_surface(block.surface, {form.srid, false}));
  });
  report(outcome);
  give(call, *slot->value, reinterpret_cast<ReturnSetInfo*>(fcinfo->resultinfo));
  PG_RETURN_NULL();
}
