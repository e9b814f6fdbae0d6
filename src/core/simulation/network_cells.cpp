#include "streetgen/network_cells.hpp"

#include <algorithm>
#include <cmath>

#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

namespace {

constexpr double smallest_cell = 0.1, largest_cell = 10000;
constexpr int most_cells = 10000000;

CellBeside cell_beside(const TrafficNetwork& network, const NetworkCells& cells,
                       const NetworkCell& cell, bool left) {
  const NeighbourPlace there = beside(network, {cell.link, (cell.from + cell.to) / 2}, left);
  const int link = there.place.link;
  if (link < 0) return {};
  const int count = cells.first[link + 1] - cells.first[link];
  const double share = there.place.metres / network.links[link].length;
  return {cells.first[link] + std::clamp(static_cast<int>(share * count), 0, count - 1),
          there.may_change, there.opposite};
}

}  // namespace

int cell_count(double length, double size) {
  return std::max(1, static_cast<int>(length / size + 0.5));
}

NetworkCells cells_of(const TrafficNetwork& network, double size) {
  if (!(size >= smallest_cell && size <= largest_cell))
    throw Error(ErrorKind::invalid_input, "size " + text_of(size) + " m of cells is not from " +
                                              text_of(smallest_cell) + " to " +
                                              text_of(largest_cell));
  double metres = 0;
  for (const Link& link : network.links) metres += link.length;
  if (network.size() + metres / size > most_cells)
    throw Error(ErrorKind::invalid_input,
                "cells of " + text_of(size) + " m are more than " + std::to_string(most_cells) +
                    " on " + text_of(std::round(metres / 1000)) + " km of links; " +
                    text_of(std::ceil(10 * metres / (most_cells - network.size())) / 10) +
                    " m fit");
  NetworkCells made;
  for (int link = 0; link < network.size(); ++link) {
    poll_cancel();
    const double length = network.links[link].length;
    const int count = cell_count(length, size);
    made.first.push_back(static_cast<std::int32_t>(made.cells.size()));
    for (int i = 0; i < count; ++i)
      made.cells.push_back({link, length * i / count, length * (i + 1) / count});
  }
  made.first.push_back(static_cast<std::int32_t>(made.cells.size()));
  for (int i = 0; i < made.first.back(); ++i) {
    poll_cancel();
    const NetworkCell& cell = made.cells[i];
    if (i > made.first[cell.link]) {
      made.before.add(i - 1);
    } else {
      for (const std::int32_t link : network.before.of(cell.link))
        made.before.add(made.first[link + 1] - 1);
    }
    made.before.end_owner();
    if (i + 1 < made.first[cell.link + 1]) {
      made.next.add(i + 1);
    } else {
      for (const std::int32_t link : network.next.of(cell.link)) made.next.add(made.first[link]);
    }
    made.next.end_owner();
    made.left.push_back(cell_beside(network, made, cell, true));
    made.right.push_back(cell_beside(network, made, cell, false));
  }
  return made;
}

}  // namespace streetgen
