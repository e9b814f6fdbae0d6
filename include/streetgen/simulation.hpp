// Traffic on a network from a demand, step by step: cars that follow each other, or a flow through
// cells.  Wilkie, Sewall and Lin, sections 3 and 7.
//
// Lengths are metres, times seconds, speeds metres a second, densities cars a metre of lane.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "streetgen/car_following.hpp"
#include "streetgen/cell_flow.hpp"
#include "streetgen/traffic.hpp"
#include "streetgen/traffic_demand.hpp"
#include "streetgen/traffic_event.hpp"

namespace streetgen {

enum class SimulationMethod : std::uint8_t { idm, lwr, arz };

// Indices are those of the links of the network, and of the routes here.
struct SimulationDemand {
  std::vector<Car> cars;  // on the network at the start; in a flow each is one car of its cell
  std::vector<TrafficEntry> entries;
  std::vector<TurnShare> turns;
  std::vector<std::vector<std::int32_t>> routes;  // cars alone follow them
  std::vector<TrafficEvent> events;               // of cars; a flow has none
};

struct SimulationOptions {
  SimulationMethod method = SimulationMethod::idm;
  double duration = 600, step = 0.1;
  double output = 1;  // between two states that are told
  std::uint64_t seed = 1;
  DrivingRules driving;  // of idm; with a law of one's own that one counts
  FlowRules flow;        // of lwr and arz, but for its model
};

struct SimulatedCar {
  std::int64_t car_id = 0;
  LinkPlace place;  // of its front
  LinkFrame frame;  // as body_frame has it
  double speed = 0, acceleration = 0;
  float length = 0, width = 0;
  std::uint8_t kind = traffic::car;
};

struct SimulatedCell {
  std::int32_t cell = -1;  // counted over all links
  LinkPlace place;         // of its middle
  double length = 0, density = 0, speed = 0;
};

struct SimulationState {
  double time = 0;                   // since the start
  std::vector<SimulatedCar> cars;    // of idm, by index of the simulation
  std::vector<SimulatedCell> cells;  // of lwr and arz
};

// The cars that entered and left.  Flows count parts of cars.
struct SimulationResult {
  double entered = 0, left = 0;
  double waiting = 0;          // found no room to enter until the end
  double there = 0;            // on the network at the end
  std::vector<double> passed;  // by link: cars that came to it
  std::vector<FiredEvent> fired;
};

// Gets the state at the start, then each `output` seconds, and at the end.
using SimulationListener = std::function<void(const SimulationState&)>;

// The same seed gives the same bytes on each machine.  Tells its progress, and asks for a cancel in
// each step.  Refused (invalid_input): a duration that is not positive or beyond
// `longest_duration`, a step too short for it, an output below 0, more cars than a link has room
// for, and cars on each other.  So is what CarFollowing and CellFlow refuse: a step of a flow that
// is too long names the greatest one.
constexpr double longest_duration = 1e7;
SimulationResult simulate(const TrafficNetwork& network, const SimulationDemand& demand,
                          const SimulationOptions& options, const SimulationListener& listener);

}  // namespace streetgen
