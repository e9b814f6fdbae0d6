#include "streetgen/cell_flow.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "made_network.hpp"
#include "rounds.hpp"
#include "streetgen/error.hpp"

namespace streetgen {
namespace cell_flow_test {

using simulation_test::NetworkMaker;

constexpr double jam = 0.143, free_speed = 30, wave = 5, road = 3000;

FlowRules rules(double cell_size, FlowModel model = FlowModel::lwr) {
  FlowRules r;
  r.model = model;
  r.cell_size = cell_size;
  r.jam_density = jam;
  r.wave_speed = wave;
  return r;
}

TrafficNetwork one_road() {
  NetworkMaker made;
  made.lane(road, free_speed);
  return made.network();
}

// States left and right of the middle of a road; an exact density at metres from there.
struct Riemann {
  double left, right, seconds;
  std::function<double(double metres)> exact;
  double left_speed = 0, right_speed = 0;
};

// The mean absolute error of density after a while.  Cells take the mean of the exact state.
double error_of(const Riemann& problem, int cells, FlowModel model, double courant) {
  const TrafficNetwork network = one_road();
  CellFlow flow(network, rules(road / cells, model));
  for (int i = 0; i < cells; ++i) {
    const bool left = 2 * i < cells;
    flow.set_state(i, left ? problem.left : problem.right,
                   left ? problem.left_speed : problem.right_speed);
  }
  const int steps = static_cast<int>(problem.seconds / (courant * flow.greatest_step())) + 1;
  for (int i = 0; i < steps; ++i) flow.step(problem.seconds / steps);
  double error = 0;
  // The ends of the road are no part of the problem: waves from there do not reach its middle.
  for (int i = cells / 4; i < 3 * cells / 4; ++i) {
    double exact = 0;
    for (int k = 0; k < 20; ++k)
      exact += problem.exact((i + (k + 0.5) / 20) * road / cells - road / 2) / 20;
    error += std::abs(flow.density(i) - exact) * 2 / cells;
  }
  return error;
}

// The order of convergence: the slope of errors over sizes of cells, both by logarithm.
double order_of(const Riemann& problem, FlowModel model, double courant = 0.9) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (int part = 24; part <= 800; part = part * 5 / 4) {
    const int cells = 4 * part;
    const double size = std::log(1. / cells);
    const double error = std::log(error_of(problem, cells, model, courant));
    n += 1, x += size, y += error, xx += size * size, xy += size * error;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

// A shock is where it belongs to within a cell, on each grid.
void within_a_cell(const Riemann& problem, FlowModel model) {
  for (int cells = 96; cells <= 3200; cells += 4 + cells / 4 / 4 * 4)
    EXPECT_LT(error_of(problem, cells, model, 0.9),
              std::abs(problem.right - problem.left) * 2 / cells)
        << cells;
}

double capacity_density() { return wave * jam / (free_speed + wave); }

TEST(LwrFlow, CapacityIsThatOfTheTriangle) {
  EXPECT_NEAR(free_speed * capacity_density() * 3600, 2206, 0.5);
}

Riemann shock() {
  const double left = 0.02 * jam, right = 0.8 * jam;
  const double speed = (wave * (jam - right) - free_speed * left) / (right - left);
  return {left, right, 20, [=](double x) { return x < speed * 20 ? left : right; }};
}

TEST(LwrFlow, ShockConvergesWithFirstOrder) { within_a_cell(shock(), FlowModel::lwr); }

// The jam's tail from the mass that gathers there.
TEST(LwrFlow, ShockGoesAtTheSpeedOfItsMass) {
  const TrafficNetwork network = one_road();
  CellFlow flow(network, rules(10));
  const double left = 0.02 * jam, right = 0.8 * jam;
  const auto tail = [&] {
    double mass = 0;
    for (int i = 75; i < 225; ++i) mass += flow.density(i) * 10;
    return (1500 * right - mass) / (right - left);
  };
  for (int i = 0; i < 300; ++i) flow.set_density(i, i < 150 ? left : right);
  const double before = tail();
  while (flow.time() < 20 - 1e-9) flow.step(0.25);
  EXPECT_NEAR((tail() - before) / flow.time(), 0.512821, 1e-6);
}

// A jam that dissolves: traffic at capacity between its end and the first cars.
Riemann release(double jammed) {
  const double middle = capacity_density();
  return {jammed, 0.1 * middle, 20, [=](double x) {
            if (x < -wave * 20) return jammed;
            return x < free_speed * 20 ? middle : 0.1 * middle;
          }};
}

TEST(LwrFlow, RarefactionConvergesWithFirstOrder) {
  for (const double jammed : {jam, 0.5 * jam})
    for (const double courant : {1.0, 0.9, 0.35})
      EXPECT_GT(order_of(release(jammed), FlowModel::lwr, courant), 0.9) << jammed << courant;
}

// The exact solution of Aw, Rascle and Zhang: a wave of one eagerness, then cars at the speed of
// those to the right.
struct ArzState {
  double density, speed;  // of jam and of the link
  double eagerness() const { return speed + std::sqrt(density); }
};

ArzState arz_at(const ArzState& left, const ArzState& right, double slope) {
  const double eager = left.eagerness(), slower = eager - right.speed;
  const ArzState middle{slower > 0 ? slower * slower : 0, std::min(right.speed, eager)};
  if (slope > right.speed) return right;
  if (middle.density >= left.density) {
    const double q = left.density * left.speed, r = middle.density * middle.speed;
    const double shock =
        middle.density > left.density ? (r - q) / (middle.density - left.density) : -1;
    return slope < shock ? left : middle;
  }
  if (slope < left.speed - std::sqrt(left.density) / 2) return left;
  if (slope > middle.speed - std::sqrt(middle.density) / 2)
    return middle.density > 0 || slope < right.speed ? middle : right;
  const double root = (eager - slope) / 1.5;
  return {root * root, eager - root};
}

Riemann arz(const ArzState& left, const ArzState& right) {
  Riemann p{left.density * jam,      right.density * jam,     15, {},
            left.speed * free_speed, right.speed * free_speed};
  p.exact = [=](double x) { return arz_at(left, right, x / 15 / free_speed).density * jam; };
  return p;
}

TEST(ArzFlow, ShockAndRarefactionConvergeWithFirstOrder) {
  const auto calm = [](double density, double eager = 1) {
    return ArzState{density, eager - std::sqrt(density)};
  };
  within_a_cell(arz(calm(0.1), calm(0.6)), FlowModel::arz);
  within_a_cell(arz(calm(0.2, 0.8), calm(0.5, 0.8)), FlowModel::arz);
  // In a fan Godunov's error is as h log(1 / h).
  for (const int cells : {96, 200, 400, 800, 1600, 3200})
    EXPECT_LT(error_of(arz(calm(0.7), calm(0.1)), cells, FlowModel::arz, 0.9),
              0.35 * jam * std::log(cells) / cells);
}

TEST(ArzFlow, MeetsTheExactSolutionBesideContacts) {
  const ArzState left{0.3, 0.2}, right{0.1, 0.5}, slow{0.4, 0.1};
  for (const Riemann& p : {arz(left, right), arz(left, slow), arz(right, left)}) {
    EXPECT_LT(error_of(p, 960, FlowModel::arz, 0.9), 6e-3 * jam);
    // A contact spreads over as many cells as the root of the steps: order 1/2.
    EXPECT_GT(order_of(p, FlowModel::arz), 0.4);
  }
}

TEST(ArzFlow, KeepsDensityAndSpeedBounded) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0, 1);
  const TrafficNetwork network = one_road();
  for (int round = 0; round < 20; ++round) {
    CellFlow flow(network, rules(30, FlowModel::arz));
    for (int i = 0; i < flow.cells(); ++i) {
      const double density = any(random) < 0.2 ? 0 : any(random);
      flow.set_state(i, density * jam, any(random) * (1 - std::sqrt(density)) * free_speed);
    }
    for (int i = 0; i < 200; ++i) {
      flow.step(flow.greatest_step() * (0.2 + 0.8 * any(random)));
      for (int c = 0; c < flow.cells(); ++c) {
        ASSERT_GE(flow.density(c), -1e-12);
        ASSERT_LE(flow.density(c), jam * (1 + 1e-12));
        ASSERT_GE(flow.speed(c), 0);
        ASSERT_LE(flow.speed(c), free_speed * (1 + 1e-9));
      }
    }
  }
}

// A motorway with a ramp that merges, an exit, a crossing with a signal and one that gives way.
struct Interchange {
  int entry, ramp, auxiliary, exit, side, main_out, side_out;
  int merge = -1, ahead = -1, cross = -1;
  TrafficNetwork network;
};

Interchange interchange() {
  NetworkMaker made;
  Interchange i;
  i.entry = made.lane(700, 33);
  i.ramp = made.lane(200, 14);
  const int beside = made.lane(150, 33);
  i.auxiliary = made.lane(150, 22);
  i.exit = made.lane(90, 14);
  const int through = made.lane(400, 33);
  i.side = made.lane(120, 14);
  i.main_out = made.lane(200, 14);
  i.side_out = made.lane(100, 14);
  made.movement(i.entry, beside, 12, 33);
  made.movement(i.ramp, i.auxiliary, 9, 14);
  made.movement(beside, through, 3, 33);
  made.movement(beside, i.exit, 14, 14);
  made.lanes_beside(i.auxiliary, beside, 5, 145, true, false);
  i.ahead = made.movement(through, i.main_out, 20, 14);
  i.cross = made.movement(i.side, i.side_out, 18, 14);
  i.merge = made.movement(i.side, i.main_out, 15, 10);
  const int give = made.movement(i.exit, i.side_out, 15, 10);
  made.green(i.ahead, 60, 0, 25, 28);
  made.green(i.cross, 60, 30, 55, 58);
  made.conflict(i.ahead, 8, 14, i.cross, 6, 12, Precedence::by_signal);
  made.conflict(i.ahead, 12, 20, i.merge, 8, 15);
  made.conflict(i.cross, 12, 18, give, 9, 15);
  i.network = made.network();
  i.network.links[beside].straight_on = 11;
  return i;
}

void keeps_mass(FlowModel model) {
  const Interchange town = interchange();
  FlowRules r = rules(10, model);
  CellFlow flow(town.network, r);
  flow.set_entries({{town.entry, 0.5}, {town.ramp, 0.3}, {town.side, 0.2}});
  const auto out_of_entry = town.network.next.of(2);
  flow.set_turns({{2, out_of_entry[0], 3},
                  {2, out_of_entry[1], 1},
                  {town.side, town.cross, 1},
                  {town.side, town.merge, 2}});
  while (flow.time() < 600) {
    flow.step(0.1);
    const double all = flow.mass() + flow.left();
    ASSERT_NEAR(all, flow.entered(), 1e-9 * std::max(1., flow.entered()));
    for (int c = 0; c < flow.cells(); ++c) {
      ASSERT_GE(flow.density(c), -1e-12);
      ASSERT_LE(flow.density(c), jam * (1 + 1e-12));
    }
  }
  EXPECT_NEAR(flow.entered() + flow.waiting(), flow.time(), 1e-6 * flow.time());
  // Everybody gets through: the auxiliary lane ends, and who was on it has changed.
  EXPECT_GT(flow.left(), 150);
  EXPECT_GT(flow.passed(town.auxiliary), 50);
  EXPECT_GT(flow.passed(town.merge), 20);
  flow.set_entries({});
  // A short run of the tests does not wait until it is empty.
  if (rounds(10) < 10) return;
  while (flow.mass() + flow.waiting() > 1e-3 && flow.time() < 6000) flow.step(0.1);
  EXPECT_LE(flow.mass() + flow.waiting(), 1e-3);
}

TEST(LwrFlow, KeepsMassThroughRampsAndJunctions) { keeps_mass(FlowModel::lwr); }
TEST(ArzFlow, KeepsMassThroughRampsAndJunctions) { keeps_mass(FlowModel::arz); }

TEST(LwrFlow, QueuesAtRedAndPassesAtGreenAtCapacity) {
  NetworkMaker made;
  const int in = made.lane(600, 15), out = made.lane(600, 15);
  const int ahead = made.movement(in, out, 20, 15);
  made.green(ahead, 100, 0, 50, 50);
  const TrafficNetwork network = made.network();
  CellFlow flow(network, rules(10));
  flow.set_entries({{in, 1}});
  while (flow.time() < 1000 - 1e-9) flow.step(0.25);
  const double capacity = 15 * wave / (15 + wave) * jam;
  // The first cars come after 40 s.
  EXPECT_NEAR(flow.passed(ahead), (10 + 9 * 50) * capacity, 1);
  EXPECT_GT(flow.density(flow.first_cell(in)), 0.5 * jam);
}

TEST(LwrFlow, MajorStreamGoesFirstWhereBothMerge) {
  NetworkMaker made;
  const int major = made.lane(300, 15), minor = made.lane(300, 15), out = made.lane(300, 15);
  const int first = made.movement(major, out, 15, 15), second = made.movement(minor, out, 15, 15);
  made.conflict(first, 5, 15, second, 5, 15);
  const TrafficNetwork network = made.network();
  CellFlow flow(network, rules(10));
  flow.set_entries({{major, 0.3}, {minor, 0.5}});
  while (flow.time() < 600) flow.step(0.25);
  EXPECT_NEAR(flow.passed(first), 0.3 * 600, 15);
  const double capacity = 15 * wave / (15 + wave) * jam;
  EXPECT_NEAR(flow.passed(second), (capacity - 0.3) * 600, 15);
}

void refused(const std::function<void()>& task, const std::string& word) {
  try {
    task();
    ADD_FAILURE() << "nothing was refused: " << word;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    EXPECT_NE((error.what() + error.hint()).find(word), std::string::npos) << error.what();
  }
}

TEST(CellFlow, RefusesBadInput) {
  const TrafficNetwork network = one_road();
  CellFlow flow(network, rules(10));
  refused([&] { flow.set_density(3, jam * 1.01); }, "jam");
  refused([&] { flow.set_density(3, std::nan("")); }, "nan");
  refused([&] { flow.set_density(-1, 0); }, "cell -1");
  refused([&] { flow.step(3600); }, "0.333333333333 s");
  refused([&] { flow.step(0); }, "step 0");
  refused([&] { flow.step(std::nan("")); }, "step");
  refused([&] { flow.set_entries({{0, -1}}); }, "-1");
  refused([&] { flow.set_entries({{7, 1}}); }, "7");
  refused([&] { flow.set_turns({{0, 0, 1}}); }, "does not follow");
  refused([&] { CellFlow(network, rules(0)); }, "cell_size");
  flow.step(flow.greatest_step());
}

}  // namespace cell_flow_test
}  // namespace streetgen
