// Events of a simulation, which happen by order: a driver brakes, overtakes or breaks down, a car
// pulls out from the kerb, somebody crosses.  Campos, section 3.4: events of driving
// simulators.
//
// An event fires once, in the step after its trigger came, and for one car: its own, else the first
// that comes along the lane of its place.  Lengths are metres, times seconds, speeds metres a
// second.
#pragma once

#include <cstdint>
#include <optional>

#include "streetgen/traffic.hpp"

namespace streetgen {

enum class EventKind : std::uint8_t {
  brake,      // the car brakes to a speed, and keeps to it
  breakdown,  // the car stops, and stands
  overtake,   // the car changes to the lane for passing where it is safe, and drives faster
  pull_out,   // a standing car is on the lane at the place, once nobody is there or too near
  cross,      // somebody is on all lanes of the street at the place; who can stop before does
};

enum class EventTrigger : std::uint8_t {
  time,   // since the start
  place,  // the car passes the place
  gap,    // the car is so near before the place
};

struct TrafficEvent {
  std::int64_t event_id = 0;
  EventKind kind = EventKind::brake;
  EventTrigger trigger = EventTrigger::time;
  LinkPlace place;
  double at = 0;                       // seconds, or metres of the gap
  std::optional<std::int64_t> car_id;  // none: whichever comes first
  double speed = 0;                    // that a car brakes to, or by which one that overtakes is faster
  double deceleration = 5;             // of brake and breakdown
  double duration = 10;                // how long it lasts; infinite: to the end
};

struct FiredEvent {
  std::int64_t event_id = 0;
  double time = 0;                     // at the start of the step in which it acts
  std::optional<std::int64_t> car_id;  // the car that it acts on or that brought it
  LinkPlace place;                     // of that car, or the place of the event
};

}  // namespace streetgen
