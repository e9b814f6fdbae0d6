#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "made_network.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "streetgen/progress.hpp"
#include "streetgen/simulation.hpp"

namespace streetgen {
namespace simulate_test {

using simulation_test::NetworkMaker;

// A street that ends at a signal.
TrafficNetwork street(float green_to) {
  NetworkMaker made;
  const int in = made.lane(900, 14), out = made.lane(300, 14);
  const int ahead = made.movement(in, out, 20, 14);
  made.green(ahead, 90, 0, green_to, green_to + 3);
  return made.network();
}

SimulationOptions options(SimulationMethod method, double duration = 120) {
  SimulationOptions o;
  o.method = method;
  o.duration = duration;
  return o;
}

TEST(Simulate, TellsTheStateWhenItIsDue) {
  const TrafficNetwork network = street(30);
  SimulationDemand demand;
  demand.entries = {{0, 0.1, -1}};
  for (const SimulationMethod method :
       {SimulationMethod::idm, SimulationMethod::lwr, SimulationMethod::arz}) {
    SimulationOptions o = options(method, 20);
    o.output = 5;
    std::vector<double> times;
    const SimulationResult result = simulate(network, demand, o, [&](const SimulationState& state) {
      times.push_back(state.time);
      EXPECT_EQ(state.cells.empty(), method == SimulationMethod::idm);
    });
    ASSERT_EQ(times.size(), 5u);
    for (int i = 0; i < 5; ++i) EXPECT_NEAR(times[i], 5 * i, 1e-9);
    EXPECT_NEAR(result.entered + result.waiting, 2, 1);
    EXPECT_NEAR(result.entered, result.left + result.there, 1e-9);
  }
}

// Where the queue behind red ends: metres from the stop, of cars that stand.
TEST(Simulate, JamBehindRedEndsAtThePlaceOfBothMethods) {
  NetworkMaker made;
  const int in = made.lane(1500, 14), out = made.lane(300, 14);
  const int ahead = made.movement(in, out, 20, 14);
  made.plans.push_back({1, 100, 0});
  made.signal(ahead, 0, {{0, Aspect::red}});
  const TrafficNetwork network = made.network();
  SimulationDemand demand;
  demand.entries = {{in, 0.25, -1}};
  double tail[2] = {0, 0};
  simulate(network, demand, options(SimulationMethod::idm, 500), [&](const SimulationState& s) {
    tail[0] = 0;
    for (const SimulatedCar& car : s.cars)
      if (car.speed < 1) tail[0] = std::max(tail[0], 1500 - car.place.metres + 5);
  });
  SimulationOptions flow = options(SimulationMethod::lwr, 500);
  flow.step = 0.25;
  simulate(network, demand, flow, [&](const SimulationState& s) {
    tail[1] = 0;
    for (const SimulatedCell& cell : s.cells)
      if (cell.speed < 1 && cell.place.link == in)
        tail[1] = std::max(tail[1], 1500 - cell.place.metres + 5);
  });
  EXPECT_GT(tail[1], 500);
  EXPECT_NEAR(tail[0], tail[1], 0.1 * tail[1]);
}

TEST(Simulate, PutsCarsIntoTheirCells) {
  const TrafficNetwork network = street(30);
  SimulationDemand demand;
  for (int i = 0; i < 60; ++i) {
    Car car;
    car.car_id = i;
    car.place = {0, 895 - 7.0 * i};
    demand.cars.push_back(car);
  }
  bool first = true;
  simulate(network, demand, options(SimulationMethod::lwr, 1), [&](const SimulationState& s) {
    double cars = 0;
    for (const SimulatedCell& cell : s.cells) cars += cell.density * cell.length;
    if (first) {
      EXPECT_NEAR(cars, 60, 1e-9);
    }
    first = false;
  });
  for (int i = 0; i < 200; ++i) demand.cars.push_back(demand.cars[i % 60]);
  EXPECT_THROW(simulate(network, demand, options(SimulationMethod::lwr, 1), {}), Error);
}

void refused(const SimulationOptions& o, const std::string& word) {
  const TrafficNetwork network = street(30);
  try {
    simulate(network, {}, o, {});
    ADD_FAILURE() << "nothing was refused: " << word;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

TEST(Simulate, RefusesBadInput) {
  for (const double seconds : {0., -1., 1e9, std::nan("")})
    refused(options(SimulationMethod::idm, seconds), "duration");
  SimulationOptions o = options(SimulationMethod::lwr);
  o.step = 3600;
  refused(o, "the greatest that holds, 0.7");
  o.step = 0;
  refused(o, "step 0");
  o.step = std::nan("");
  refused(o, "step nan");
  o = options(SimulationMethod::idm);
  o.output = -1;
  refused(o, "output -1");
}

int asked = 0;
std::size_t told = 0;

TEST(Simulate, TellsItsProgressAndStopsWhenAsked) {
  const TrafficNetwork network = street(30);
  asked = 0, told = 0;
  set_progress_listener([](const char*, std::size_t done, std::size_t) noexcept { told = done; });
  set_cancel_check([]() noexcept { return ++asked > 50; });
  for (const SimulationMethod method : {SimulationMethod::idm, SimulationMethod::lwr}) {
    asked = 0;
    EXPECT_THROW(simulate(network, {}, options(method, 1e6), {}), Error);
    EXPECT_NEAR(told, 49, 2);
  }
  set_cancel_check(nullptr);
  set_progress_listener(nullptr);
}

}  // namespace simulate_test
}  // namespace streetgen
