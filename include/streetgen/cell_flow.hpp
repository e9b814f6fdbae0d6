// Traffic as a flow through the cells of a network: each link is cut into equal cells, and a cell
// has a density.  Wilkie, Sewall and Lin, section 3.2.
//
// `lwr` (Lighthill, Whitham, Richards) has a triangular diagram: cars drive at the speed of their
// link until a jam comes back at `wave_speed`.  `arz` (Aw, Rascle, Zhang) also carries how eager
// drivers are.  At density r, of the jam density, they drive at link speed * (eagerness - sqrt(r)),
// which is the speed of Sewall's exponent 1/2.  An eagerness of 1 is in equilibrium.
//
// The flow across a border of cells is Godunov's, the smaller one of what the cell before sends
// and the cell behind takes (Daganzo).  Densities of `lwr` at a border are its limited downwind
// values (Despres and Lagoutiere), so that a jump stays as narrow as a cell or two.
//
// Lengths are metres, times seconds, speeds metres a second, densities cars a metre of lane, flows
// cars a second.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "streetgen/traffic.hpp"
#include "streetgen/traffic_demand.hpp"

namespace streetgen {

enum class FlowModel : std::uint8_t { lwr, arz };

struct FlowRules {
  FlowModel model = FlowModel::lwr;
  double cell_size = 10;        // about; each link has cells of its own equal length
  double shortest_cell = 5;     // a link shorter than it counts as so long: it would bound the step
  double jam_density = 1 / 7.;  // a car of 5 m and 2 m to the next one
  double wave_speed = 5;        // of the tail of a jam that dissolves; lwr alone
  double change_time = 3;       // a lane change takes so long (Laval and Daganzo)
  double relaxation = 0;        // time to become as eager as in equilibrium, 0: never; arz alone
};

struct CellRun;

// Cars leave at a link without a next one, but where a lane beside goes on: there they change.  A
// movement is closed at red and amber.  One that gives way, or yields by arrival, takes what flow
// the others left in the step before; where movements meet in a lane, who goes first comes first.
// A lane for both directions has cells of its own each way.  People who cross stop nobody.
class CellFlow {
 public:
  // The network stays as it is and where it is.  Refused (invalid_input): a rule that is not
  // positive, a link without length or speed.
  CellFlow(const TrafficNetwork& network, const FlowRules& rules);
  ~CellFlow();
  CellFlow(CellFlow&&) noexcept;
  CellFlow& operator=(CellFlow&&) noexcept;

  int cells() const;
  // The cells of a link are one behind the other, from its start.
  int first_cell(int link) const;
  int cell_count(int link) const;
  double cell_length(int link) const;
  int link_of_cell(int cell) const;

  double density(int cell) const;
  double speed(int cell) const;  // an empty cell has that of its link
  // Refused: a density below 0 or above jam, a speed that no eagerness from 0 to 1 gives.
  void set_density(int cell, double density);
  void set_state(int cell, double density, double speed);  // lwr: as set_density

  // Refused: a link that is not there, a flow below 0, a share that is none of a next link.
  void set_entries(const std::vector<TrafficEntry>& entries);
  void set_turns(const std::vector<TurnShare>& turns);

  // The greatest step that keeps each wave within a cell (Courant, Friedrichs and Lewy).
  double greatest_step() const;
  // Refused: a step that is not positive or greater than that, which the error names.
  void step(double seconds);

  double time() const;
  double mass() const;            // cars on the network
  double waiting() const;         // cars that find no room to enter
  double entered() const;         // cars that came in so far
  double left() const;            // cars that left so far
  double passed(int link) const;  // cars that came to the link so far

 private:
  std::unique_ptr<CellRun> run_;
};

}  // namespace streetgen
