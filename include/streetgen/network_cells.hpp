// The links of a network in equal cells, for programs that simulate traffic as a flow.  Wilkie,
// Sewall and Lin, section 3.2.
#pragma once

#include <cstdint>
#include <vector>

#include "streetgen/traffic.hpp"

namespace streetgen {

// The number of cells of a link: as many as come nearest to a size, at least one.
int cell_count(double length, double size);

struct NetworkCell {
  std::int32_t link = -1;
  double from = 0, to = 0;  // metres along the link
};

// The cell beside the middle of another one; cell -1: none.
struct CellBeside {
  std::int32_t cell = -1;
  bool may_change = false;  // whether a car may change to it
  bool opposite = false;    // whether its traffic comes towards
};

// Cells are counted over all links in their order, those of a link from its start.
struct NetworkCells {
  std::vector<std::int32_t> first;  // by link, and the number of all cells
  std::vector<NetworkCell> cells;
  RowsOf<std::int32_t> next, before;
  std::vector<CellBeside> left, right;  // by cell
};

// Asks for a cancel.  Refused (invalid_input): a size that is not from 0.1 to 10,000 m, or of which
// more than ten million would be.
NetworkCells cells_of(const TrafficNetwork& network, double size);

}  // namespace streetgen
