// What a flow through the cells of a network consists of.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "simulation/cell_law.hpp"
#include "streetgen/cell_flow.hpp"

namespace streetgen {

// Cars of a cell may change to a cell beside it.
struct CellChange {
  std::int32_t from = -1, to = -1;
  std::int32_t link = -1, to_link = -1;
  bool must = false;  // the link ends without a next one
};

// A row of `next` by which a link is come to.
struct CellMerge {
  std::int32_t row = -1, from = -1;
  std::int32_t after = 0;  // how many of the others go first
};

// A link and its only next one, which has no other before it, no signal and nobody to yield to.
struct CellJoint {
  std::int32_t from = -1, to = -1;
};

// The signal of a movement shows the same until a time.
struct CellSignal {
  std::int32_t link = -1;
  double until = 0;
};

struct CellRun {
  const TrafficNetwork* network = nullptr;
  FlowRules rules;
  std::vector<LinkCells> links;
  CellStates states;
  std::vector<CellChange> changes;
  std::vector<CellJoint> joints;
  std::vector<std::int32_t> senders, takers;  // links that end, or begin, at no joint
  RowsOf<CellMerge> merges;                   // of each link, who goes first before the others
  std::vector<CellSignal> signalled;          // of movements
  std::vector<std::int32_t> yielding;         // movements that do not always go first

  // By row of TrafficNetwork::next.
  std::vector<double> share;    // of those that go on
  std::vector<double> granted;  // share of those that want to go on and may

  // By link.
  std::vector<char> leaves, closed;
  std::vector<double> limit;  // greatest flow that may come to it
  std::vector<CellFlux> inflow, outflow;
  std::vector<double> entry, waiting, passed;

  std::vector<double> border;  // flows between the cells of a link
  double greatest_step = std::numeric_limits<double>::infinity();
  double time = 0, entered = 0, left = 0;

  template <class Task>
  auto by_law(const Task& task) const {
    return rules.model == FlowModel::lwr ? task(LwrLaw{rules.jam_density, rules.wave_speed})
                                         : task(ArzLaw{rules.jam_density, rules.relaxation});
  }
  int last_cell(int link) const { return links[link].first + links[link].count - 1; }
};

RowsOf<CellMerge> merges_of(const TrafficNetwork& network);
// Finds joints, and all other ends of links.
void find_joints(CellRun& run);
std::vector<CellChange> changes_of(const CellRun& run);

// The flows between links of a step, from what cells hold.
void flow_between_links(CellRun& run, double step);
// Cars change to cells beside theirs.
void change_cells(CellRun& run, double step);

}  // namespace streetgen
