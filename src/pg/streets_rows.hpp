// What was computed, table by table: a row for each thing that the core found, in plain values.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "streetgen/interconnection.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/streets.hpp"

namespace streetgen::pg {

struct ComputedStreets {
  Streets streets;
  Lanes lanes;
  std::vector<Interconnection> interconnections;
  int srid = 0;
  bool has_z = false;  // nodes, edges and section limits carry Z

  // The edges of axes that have an asked edge, or one at an asked node: rows of others are not
  // written.
  std::vector<bool> written_edges;
};
ComputedStreets computed_streets(Streets streets, Lanes lanes,
                                 std::vector<Interconnection> interconnections, int srid,
                                 bool has_z);

struct Ewkb {
  std::string bytes;
};
// monostate: NULL.
using Value = std::variant<std::monostate, bool, std::int32_t, std::int64_t, double, std::string,
                           Ewkb, std::vector<std::int64_t>, std::vector<double>>;
using Row = std::vector<Value>;

// The rows of a table, made one by one in the order of its columns in SQL after the first, the
// number by which others refer to it.
struct Table {
  std::size_t (*count)(const ComputedStreets& computed);
  // False: nothing is written of this one.
  bool (*fill)(const ComputedStreets& computed, std::size_t index, Row& row);
  // Frees what these rows alone tell: they are given once. Null: they may be given again.
  void (*forget)(ComputedStreets& computed) = nullptr;
};

extern const Table node_table, edge_table, section_limit_table, section_table, corner_table,
    intersection_table, lane_table, lane_separator_table, marking_table, interconnection_table,
    report_table;

}  // namespace streetgen::pg
