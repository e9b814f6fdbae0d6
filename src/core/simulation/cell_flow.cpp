#include "streetgen/cell_flow.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "simulation/cell_run.hpp"
#include "simulation/demand.hpp"
#include "simulation/link_end.hpp"
#include "streetgen/error.hpp"
#include "streetgen/network_cells.hpp"

namespace streetgen {

namespace {

[[noreturn]] void refuse_flow(const std::string& message, const std::string& hint = "") {
  throw Error(ErrorKind::invalid_input, message, hint);
}

void require_rule(const char* name, double value, bool zero) {
  if (!std::isfinite(value) || value < 0 || (value == 0 && !zero))
    refuse_flow(std::string("rule ") + name + " of cells is " + text_of(value),
                zero ? "It is 0 or more." : "It is above 0.");
}

std::string link_text(const CellRun& run, int link) {
  return "link " + std::to_string(run.network->links[link].link_id);
}

// A cell has about the wanted size: what a link is longer or shorter is divided equally.
void make_cells(CellRun& run) {
  int first = 0;
  int most = 0;
  for (int i = 0; i < run.network->size(); ++i) {
    const Link& link = run.network->links[i];
    if (!(link.length > 0) || !(link.speed > 0) || !std::isfinite(link.length) ||
        !std::isfinite(link.speed))
      refuse_flow(link_text(run, i) + " has length " + text_of(link.length) + " and speed " +
                  text_of(link.speed));
    const double length = std::max(link.length, run.rules.shortest_cell);
    LinkCells cells;
    cells.first = first;
    cells.count = cell_count(length, run.rules.cell_size);
    cells.length = length / cells.count;
    cells.speed = link.speed;
    cells.capacity = run.by_law([&](const auto& law) { return law.capacity(link.speed); });
    first += cells.count;
    most = std::max(most, cells.count);
    run.links.push_back(cells);
  }
  run.states.density.assign(first, 0);
  if (run.rules.model == FlowModel::arz) run.states.eager.assign(first, 0);
  run.border.assign(most + 1, 0);
}

void read_junctions(CellRun& run) {
  const int size = run.network->size();
  run.share = turn_shares(*run.network, {});
  run.granted.assign(run.share.size(), 1);
  run.merges = merges_of(*run.network);
  run.leaves.assign(size, 0);
  run.closed.assign(size, 0);
  run.limit.assign(size, INFINITY);
  run.inflow.assign(size, {});
  run.outflow.assign(size, {});
  run.entry.assign(size, 0);
  run.waiting.assign(size, 0);
  run.passed.assign(size, 0);
  for (int link = 0; link < size; ++link) {
    run.leaves[link] = leaves_at_end(*run.network, link);
    if (!run.network->aspects.of(link).empty()) run.signalled.push_back({link});
    for (const LinkConflict& c : run.network->conflicts.of(link))
      if (c.precedence == Precedence::gives_way || c.precedence == Precedence::by_arrival) {
        run.yielding.push_back(link);
        break;
      }
  }
}

}  // namespace

CellFlow::CellFlow(const TrafficNetwork& network, const FlowRules& rules)
    : run_(std::make_unique<CellRun>()) {
  require_rule("cell_size", rules.cell_size, false);
  require_rule("shortest_cell", rules.shortest_cell, true);
  require_rule("jam_density", rules.jam_density, false);
  require_rule("wave_speed", rules.wave_speed, false);
  require_rule("change_time", rules.change_time, false);
  require_rule("relaxation", rules.relaxation, true);
  run_->network = &network;
  run_->rules = rules;
  make_cells(*run_);
  read_junctions(*run_);
  find_joints(*run_);
  run_->changes = changes_of(*run_);
  run_->by_law([&](const auto& law) {
    for (const LinkCells& link : run_->links)
      run_->greatest_step = std::min(run_->greatest_step, link.length / law.fastest(link.speed));
  });
}

CellFlow::~CellFlow() = default;
CellFlow::CellFlow(CellFlow&&) noexcept = default;
CellFlow& CellFlow::operator=(CellFlow&&) noexcept = default;

int CellFlow::cells() const { return static_cast<int>(run_->states.density.size()); }
int CellFlow::first_cell(int link) const { return run_->links[link].first; }
int CellFlow::cell_count(int link) const { return run_->links[link].count; }
double CellFlow::cell_length(int link) const { return run_->links[link].length; }
double CellFlow::density(int cell) const { return run_->states.density[cell]; }

int CellFlow::link_of_cell(int cell) const {
  const auto behind = std::upper_bound(run_->links.begin(), run_->links.end(), cell,
                                       [](int c, const LinkCells& link) { return c < link.first; });
  return static_cast<int>(behind - run_->links.begin()) - 1;
}

double CellFlow::speed(int cell) const {
  const double free = run_->links[link_of_cell(cell)].speed;
  return run_->by_law([&](const auto& law) { return law.speed(run_->states, cell, free); });
}

void CellFlow::set_density(int cell, double density) {
  if (cell < 0 || cell >= cells())
    refuse_flow("there is no cell " + std::to_string(cell) + " of " + std::to_string(cells()));
  if (!(density >= 0) || density > run_->rules.jam_density)
    refuse_flow("density " + text_of(density) + " of a cell of " +
                    link_text(*run_, link_of_cell(cell)) + " is not from 0 to jam, " +
                    text_of(run_->rules.jam_density),
                "Densities are cars a metre of lane.");
  run_->states.density[cell] = density;
  if (run_->rules.model == FlowModel::arz) run_->states.eager[cell] = density;
}

void CellFlow::set_state(int cell, double density, double speed) {
  set_density(cell, density);
  if (run_->rules.model == FlowModel::lwr) return;
  const double free = run_->links[link_of_cell(cell)].speed;
  const double most = free * (1 - std::sqrt(density / run_->rules.jam_density));
  if (!(speed >= 0) || speed > most * (1 + 1e-12))
    refuse_flow("speed " + text_of(speed) + " of a cell of " +
                link_text(*run_, link_of_cell(cell)) + " is not from 0 to " + text_of(most) +
                ", the speed of its density");
  const double eagerness =
      std::min(1., speed / free + std::sqrt(density / run_->rules.jam_density));
  run_->states.eager[cell] = density * eagerness;
}

void CellFlow::set_entries(const std::vector<TrafficEntry>& entries) {
  check_entries(*run_->network, entries);
  std::fill(run_->entry.begin(), run_->entry.end(), 0);
  for (const TrafficEntry& e : entries) run_->entry[e.link] += e.flow;
}

void CellFlow::set_turns(const std::vector<TurnShare>& turns) {
  run_->share = turn_shares(*run_->network, turns);
}

double CellFlow::greatest_step() const { return run_->greatest_step; }

void CellFlow::step(double seconds) {
  if (!(seconds > 0)) refuse_flow("step " + text_of(seconds) + " is not above 0");
  const double most = run_->greatest_step;
  if (seconds > most * (1 + 1e-12))
    refuse_flow("step " + text_of(seconds) + " s is longer than the greatest that holds, " +
                    text_of(most) + " s",
                "In a step no wave may pass a cell (Courant, Friedrichs and Lewy): take a "
                "shorter step or longer cells.");
  flow_between_links(*run_, seconds);
  run_->by_law([&](const auto& law) {
    for (int link = 0; link < run_->network->size(); ++link) {
      law.advance(run_->states, run_->links[link], run_->inflow[link], run_->outflow[link], seconds,
                  run_->border.data());
      run_->passed[link] += run_->inflow[link].cars * seconds;
    }
  });
  change_cells(*run_, seconds);
  run_->time += seconds;
}

double CellFlow::time() const { return run_->time; }

double CellFlow::mass() const {
  double mass = 0;
  for (const LinkCells& link : run_->links) {
    double cells = 0;
    for (int i = 0; i < link.count; ++i) cells += run_->states.density[link.first + i];
    mass += cells * link.length;
  }
  return mass;
}

double CellFlow::waiting() const {
  double cars = 0;
  for (const double w : run_->waiting) cars += w;
  return cars;
}

double CellFlow::entered() const { return run_->entered; }
double CellFlow::left() const { return run_->left; }
double CellFlow::passed(int link) const { return run_->passed[link]; }

}  // namespace streetgen
