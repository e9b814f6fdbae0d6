// Cars that follow each other on a network, obey its signals and its rights of way, and change
// lanes.  Wilkie, Sewall and Lin, section 3.1.
//
// A car accelerates by a law of its speed, the speed that it desires, and the gap to and speed of
// what is ahead.  The law is the Intelligent Driver Model (Treiber, Hennecke and Helbing 2000), or
// one of yours.  Lane changes are by MOBIL (Kesting, Treiber and Helbing 2007).
//
// A car waits before a movement that others cross until it is let in.  It is by its signal and by
// the right of way, where the stretches that both need are free in time, and where it has room to
// stand behind all of them.  A red behind a lane that is too short to wait on is passed by who has
// waited for a cycle.  Who was let in first goes first; others wait before the shared stretch.  So
// nobody meets another there.  A lane for both directions is let to those of one direction.  Who
// finds no room for `patience` seconds turns where there is some, if it has no route.  Nobody
// changes by choice to a lane from which no way leads out.  People who cross stop nobody.
//
// A step moves all cars from the state at its start: speeds change by the acceleration there, and
// places by the mean of both speeds.  No car goes farther than what was free.  The same seed gives
// the same bytes on each machine.
//
// Lengths are metres, times seconds, speeds metres a second.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "streetgen/traffic.hpp"
#include "streetgen/traffic_demand.hpp"
#include "streetgen/traffic_event.hpp"

namespace streetgen {

// The numbers of the Intelligent Driver Model.
struct DriverModel {
  double acceleration = 0.73;
  double braking = 1.67;  // comfortable
  double time_gap = 1.6;
  double least_gap = 2;  // at a standstill
};

// A car and what is ahead of it.
struct Following {
  double speed = 0, desired_speed = 0;
  double gap = 0;  // from its front to the rear ahead; infinite where nothing is
  double leader_speed = 0, leader_acceleration = 0;
};

// Fills an acceleration for each car.
using FollowingLaw = std::function<void(const std::vector<Following>&, std::vector<double>&)>;

// a (1 - (v / v0)^4 - (s* / s)^2), s* = s0 + max(0, v T + v dv / (2 sqrt(a b))).
double idm_acceleration(const DriverModel& driver, const Following& following);
// The gap at which all drive at a speed: (s0 + v T) / sqrt(1 - (v / v0)^4).
double idm_equilibrium_gap(const DriverModel& driver, double speed, double desired_speed);

struct LaneChangeRules {
  double politeness = 0.3;    // what others lose counts by it
  double safe_braking = 4;    // nobody must brake harder behind who changes
  double threshold = 0.1;     // what a change must gain, metres a second squared
  double keep_to_side = 0.1;  // the gain of the lane to the side that traffic keeps to
  double rest = 10;           // seconds from a change to the next one that need not be
  double change_back = 300;   // who leaves the lane of a route does so farther from its end
  double interval = 1;        // seconds between two looks beside
};

struct DrivingRules {
  DriverModel driver;
  LaneChangeRules lanes;
  FollowingLaw law;               // empty: the driver model
  double horizon = 1000;          // nobody looks farther
  double hardest_braking = 9;     // beyond it the law is not obeyed
  double amber_deceleration = 3;  // who can stop so at amber does
  double time_margin = 1;         // between two on a shared stretch, for who gives way
  double patience = 10;           // who waited so long passes before who stands, or turns elsewhere
  float car_length = 5, car_width = 1.8F;  // of cars that enter
};

struct CarRun;

class CarFollowing {
 public:
  // The network stays as it is and where it is.  Refused (invalid_input): a rule that is not
  // positive, a link without length or speed.
  CarFollowing(const TrafficNetwork& network, const DrivingRules& rules, std::uint64_t seed = 1);
  ~CarFollowing();
  CarFollowing(CarFollowing&&) noexcept;
  CarFollowing& operator=(CarFollowing&&) noexcept;

  // Routes of cars and entries, by index.  Refused: as check_route.
  void set_routes(const std::vector<std::vector<std::int32_t>>& routes);
  // Refused: a link or route that is not there, a flow below 0, a share that is none of a next
  // link.
  void set_entries(const std::vector<TrafficEntry>& entries);
  void set_turns(const std::vector<TurnShare>& turns);
  // Refused: a place off its link, numbers that are not finite or below 0, a deceleration of 0, a
  // car that pulls out on a movement, on a lane for both directions, or less than its length and
  // half a metre after the start of a lane.
  void set_events(const std::vector<TrafficEvent>& events);

  // The index of the new car.  Refused: what Traffic::add refuses, a speed below 0, a place on
  // another car.
  int add(const Car& car);

  // Refused: a step that is not positive or longer than 1 s.
  void step(double seconds);

  // Cars as they stand now; indices stay while they are on the network.
  const Traffic& traffic() const;
  double acceleration(int car) const;  // of the last step

  const std::vector<FiredEvent>& fired() const;  // so far, in their order

  double time() const;
  std::int64_t waiting() const;         // cars that find no room to enter
  std::int64_t entered() const;         // cars that came in so far
  std::int64_t left() const;            // cars that left so far
  std::int64_t passed(int link) const;  // cars that came to the link so far

 private:
  std::unique_ptr<CarRun> run_;
};

}  // namespace streetgen
