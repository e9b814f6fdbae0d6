#include <algorithm>
#include <cmath>
#include <string>

#include "simulation/require_place.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "streetgen/progress.hpp"
#include "streetgen/simulation.hpp"

namespace streetgen {

namespace {

constexpr double most_steps = 1e9;

[[noreturn]] void refuse_simulation(const std::string& message) {
  throw Error(ErrorKind::invalid_input, message);
}

void check_options(const SimulationOptions& options) {
  if (!(options.duration > 0 && options.duration <= longest_duration))
    refuse_simulation("duration " + text_of(options.duration) + " s is not above 0 and at most " +
                      text_of(longest_duration) + " s");
  if (!(options.step > 0)) refuse_simulation("step " + text_of(options.step) + " is not above 0");
  if (!(options.duration / options.step <= most_steps))
    refuse_simulation("step " + text_of(options.step) + " s is too short for a duration of " +
                      text_of(options.duration) + " s");
  if (!(options.output >= 0))
    refuse_simulation("output " + text_of(options.output) + " is not 0 or more");
}

// A car may reach back onto the link behind its own.
void require_apart(const Traffic& traffic) {
  LeaderRules near;
  near.horizon = longest_car;
  const std::vector<Leader> leaders = traffic.leaders(near);
  for (int i = 0; i < traffic.size(); ++i) {
    if (!traffic.holds(i) || leaders[i].car < 0 || leaders[i].gap > -1e-6) continue;
    refuse_simulation("cars " + std::to_string(traffic.car(i).car_id) + " and " +
                      std::to_string(traffic.car(leaders[i].car).car_id) + " stand on each other");
  }
}

// Each step, and the state where it is due.
template <class Step, class State>
void run_steps(const SimulationOptions& options, const Step& step, const State& state,
               const SimulationListener& listener) {
  const std::int64_t steps = std::max<std::int64_t>(
      1, static_cast<std::int64_t>(std::ceil(options.duration / options.step - 1e-9)));
  double due = options.output;
  if (listener) listener(state(0));
  for (std::int64_t i = 1; i <= steps; ++i) {
    poll_cancel();
    tell_progress("simulate", static_cast<std::size_t>(i - 1), static_cast<std::size_t>(steps));
    step();
    const double time = static_cast<double>(i) * options.step;
    if (!listener || (i < steps && time < due - options.step * 1e-6)) continue;
    listener(state(time));
    if (options.output > 0)
      due = options.output * (std::floor((time + options.step * 1e-6) / options.output) + 1);
  }
}

SimulationResult simulate_cars(const TrafficNetwork& network, const SimulationDemand& demand,
                               const SimulationOptions& options,
                               const SimulationListener& listener) {
  CarFollowing cars(network, options.driving, options.seed);
  cars.set_routes(demand.routes);
  cars.set_turns(demand.turns);
  cars.set_entries(demand.entries);
  cars.set_events(demand.events);
  for (const Car& car : demand.cars) cars.add(car);
  require_apart(cars.traffic());
  SimulationState state;
  run_steps(
      options, [&] { cars.step(options.step); },
      [&](double time) -> const SimulationState& {
        const Traffic& traffic = cars.traffic();
        state.time = time;
        state.cars.clear();
        for (int i = 0; i < traffic.size(); ++i) {
          if (!traffic.holds(i)) continue;
          const Car car = traffic.car(i);
          state.cars.push_back({car.car_id, car.place, body_frame(traffic, i), car.speed,
                                cars.acceleration(i), car.length, car.width, car.kind});
        }
        return state;
      },
      listener);
  SimulationResult result;
  result.entered = static_cast<double>(cars.entered());
  result.left = static_cast<double>(cars.left());
  result.waiting = static_cast<double>(cars.waiting());
  result.there = cars.traffic().count();
  result.fired = cars.fired();
  for (int link = 0; link < network.size(); ++link)
    result.passed.push_back(static_cast<double>(cars.passed(link)));
  return result;
}

// A car is in the cell of its front; those that it has no room for stand behind, then ahead.
void put_cars(CellFlow& flow, const TrafficNetwork& network, const std::vector<Car>& cars,
              double jam_density) {
  for (const Car& car : cars) {
    require_place(network, car.car_id, car.place);
    const int link = car.place.link;
    const double length = network.links[link].length;
    const int first = flow.first_cell(link), count = flow.cell_count(link);
    const int own = std::min(count - 1, static_cast<int>(car.place.metres / length * count));
    double left = 1;
    const auto put = [&](int cell) {
      const double before = flow.density(first + cell);
      const double after = std::min(jam_density, before + left / flow.cell_length(link));
      flow.set_density(first + cell, after);
      left -= (after - before) * flow.cell_length(link);
    };
    for (int cell = own; cell >= 0 && left > 1e-12; --cell) put(cell);
    for (int cell = own + 1; cell < count && left > 1e-12; ++cell) put(cell);
    if (left > 1e-12)
      refuse_simulation("link " + std::to_string(network.links[link].link_id) +
                        " has no room for car " + std::to_string(car.car_id) + " at jam density " +
                        text_of(jam_density));
  }
}

SimulationResult simulate_flow(const TrafficNetwork& network, const SimulationDemand& demand,
                               const SimulationOptions& options,
                               const SimulationListener& listener) {
  if (!demand.events.empty()) refuse_simulation("a flow through cells has no events");
  FlowRules rules = options.flow;
  rules.model = options.method == SimulationMethod::lwr ? FlowModel::lwr : FlowModel::arz;
  CellFlow flow(network, rules);
  flow.set_turns(demand.turns);
  flow.set_entries(demand.entries);
  put_cars(flow, network, demand.cars, rules.jam_density);
  SimulationState state;
  run_steps(
      options, [&] { flow.step(options.step); },
      [&](double time) -> const SimulationState& {
        state.time = time;
        state.cells.clear();
        for (int link = 0; link < network.size(); ++link) {
          const int first = flow.first_cell(link), count = flow.cell_count(link);
          for (int i = 0; i < count; ++i) {
            const double metres = network.links[link].length * (i + 0.5) / count;
            state.cells.push_back({first + i,
                                   {link, metres},
                                   flow.cell_length(link),
                                   flow.density(first + i),
                                   flow.speed(first + i)});
          }
        }
        return state;
      },
      listener);
  SimulationResult result;
  result.entered = flow.entered();
  result.left = flow.left();
  result.waiting = flow.waiting();
  result.there = flow.mass();
  for (int link = 0; link < network.size(); ++link) result.passed.push_back(flow.passed(link));
  return result;
}

}  // namespace

SimulationResult simulate(const TrafficNetwork& network, const SimulationDemand& demand,
                          const SimulationOptions& options, const SimulationListener& listener) {
  check_options(options);
  return options.method == SimulationMethod::idm
             ? simulate_cars(network, demand, options, listener)
             : simulate_flow(network, demand, options, listener);
}

}  // namespace streetgen
