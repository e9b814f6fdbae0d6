// The result of streetgen._streets: one row for each thing that the core found, in plain values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "border.hpp"
#include "streetgen/interconnection.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/streets.hpp"

extern "C" {
#include <funcapi.h>
}

namespace streetgen::pg {

struct Row {
  const char* relation = "";
  int row_index = 0;
  std::int64_t axis_id = 0;
  int node_a = -1, node_b = -1, edge_a = -1, edge_b = -1;  // -1: NULL
  bool start_a = false, start_b = false;
  int level = 0;
  double measure_1 = 0, measure_2 = 0;
  std::string geom_1, geom_2;  // empty: NULL
  std::vector<std::int64_t> anchor_axis;
  std::vector<double> anchor_abscissa;
  const char* method = "";
  int lane_position = -1, ordinality = -1;  // -1: NULL
  std::string side, kind, turn;             // empty: NULL
};
using Rows = std::vector<Row>;

// Nodes, edges and section limits carry Z where `has_z`.
Rows rows_of(const Streets& streets, const Lanes& lanes,
             const std::vector<Interconnection>& interconnections, int srid, bool has_z);

void give(const Rows& rows, ReturnSetInfo* result);

}  // namespace streetgen::pg
