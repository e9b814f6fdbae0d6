// A car on its way, and all that a simulation of cars consists of.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "streetgen/car_following.hpp"

namespace streetgen {

constexpr double no_end = std::numeric_limits<double>::infinity();

// A place on the way of a car: a link, how many links were before it, and which one of the route
// it is (-1: none).
struct WayPlace {
  std::int32_t link = -1;
  std::uint32_t passed = 0;
  std::int32_t on_route = -1;
};

constexpr int way_ends = -1;     // the car leaves there
constexpr int must_change = -2;  // the way goes on beside

// Room on a link that waits for a car that was let in.
struct ReservedRoom {
  std::int32_t link = -1;
  double metres = 0;
};

struct Driver {
  std::int64_t car_id = -1;
  WayPlace at;
  double metres = 0, speed = 0, length = 0, acceleration = 0;
  double way = 0;     // metres driven
  double asked = -1;  // since when it waits to be let in; -1: it does not
  double changed = -no_end;  // when it changed lanes
  double chose = -no_end;    // when it chose anew where to turn
  std::int32_t route = -1;
  std::int32_t event = -1;  // that it obeys
  std::uint32_t let_in = 0;  // it may go on up to the link with so many before it
  // The lanes where it waited to be let in: at first, and at last.  There it may be stopped yet.
  std::uint32_t let_in_from = 0, last_let_in_from = 0;
  std::uint32_t turned = 0;  // how often it chose anew where to turn
  std::uint8_t kind = traffic::car;
  bool here = false;                 // on the network
  bool no_room = false;              // it may enter, and has no room behind
  std::vector<std::int32_t> claims;  // links that it was let in to and has not left
  std::vector<ReservedRoom> reserved;
};

// Who was let in to a movement, or to a lane for both directions.
struct GroundClaim {
  std::int32_t car = -1;
  std::uint64_t order = 0;
  double start = 0;  // the way of the car when its front is at the start of the link
};

// The nearest car that waits to be let in to a movement.
struct Arrival {
  std::uint64_t step = 0;  // when it was seen
  double seconds = 0;      // until it is at the start of the movement
  bool stands = false;
  std::int32_t car = -1;
};

struct LetInRequest {
  std::int32_t car = -1;
  WayPlace before;                 // the place of the lane that ends before the movement
  double to_stop = 0, to_end = 0;  // metres to where it waits, and to the end of the lane
  double asked = 0;
};

// A stretch that somebody else was let in to before.
struct SightedClaim {
  double wait = 0;  // metres to its start
  double gap = 0;   // metres that the other one is nearer to its end, less those to its start
  double speed = 0;
};

struct Sight {
  double gap = no_end, leader_speed = 0, leader_acceleration = 0;  // of the car ahead
  double stop = no_end;                                            // metres to where it must stand
  double desired_speed = 0;
  double free = no_end;  // metres that it may go, whatever its law says
  std::vector<SightedClaim> claims;
  bool asks = false;     // to be let in
  bool revoked = false;  // it was let in and must wait now
  LetInRequest request;
};

// Who went last from a link to a next one.
struct LastLeft {
  std::int32_t car = -1;
  std::int64_t car_id = -1;
  double way = 0;  // of the car when its front was at the end
};

// An event, and what became of it.
struct EventRun {
  TrafficEvent event;
  int car = -1;                  // that it is for, by index
  int passed = -1;               // who passed its place
  std::int64_t passed_id = -1;   // its key, as another car may come by that index
  double fired = -1;             // when; -1: not yet
  std::vector<LinkPlace> across; // of who crosses: its places on all lanes there
  bool has_fired() const { return fired >= 0; }
};

struct CarRun {
  CarRun(const TrafficNetwork& net, const DrivingRules& r, std::uint64_t s)
      : network(&net), rules(r), seed(s), cars(net) {}

  const TrafficNetwork* network;
  DrivingRules rules;
  std::uint64_t seed;
  Traffic cars;
  std::vector<Driver> drivers;

  // By link.
  std::vector<char> guarded;    // a movement into which cars are let in
  std::vector<char> crossed;    // others need its ground
  std::vector<char> merges;     // it ends beside a lane that goes on
  std::vector<char> leads_out;  // who never changes lanes comes to an end by it
  std::vector<float> clear_at;  // metres of the front from which on nobody needs its ground
  std::vector<std::vector<GroundClaim>> claims;
  std::vector<Arrival> arrivals;
  std::vector<double> occupied, reserved;  // metres of cars that stand close
  std::vector<LastLeft> last_left;
  std::vector<std::int64_t> passed;
  std::vector<double> share;  // by row of `next`

  struct Entry {
    TrafficEntry entry;
    double next = 0;  // when the next car comes
    std::int64_t waiting = 0, drawn = 0;
  };
  std::vector<Entry> entries;
  std::vector<EventRun> events;
  std::vector<char> eventful;  // by link: an event has its place there; empty: there are none
  std::vector<FiredEvent> fired;
  std::vector<LetInRequest> requests;
  std::vector<Sight> sights;  // by car
  std::vector<Following> rows;
  std::vector<double> answers;
  std::uint64_t orders = 0, steps = 0;
  std::int64_t next_car_id = 1, entered = 0, left = 0;
  double time = 0;

  const Link& link(int i) const { return network->links[i]; }
  // Metres that a car takes in a queue.
  double room_of(const Driver& driver) const {
    return driver.length + rules.driver.least_gap + 0.5;
  }
};

// Moves a place on to the next link of a driver's way.  Gives the link, or one of both above.
int go_on(const CarRun& run, const Driver& driver, WayPlace& at);
// A number in [0, 1) that depends on its arguments alone.
double drawn(std::uint64_t seed, std::uint64_t who, std::uint64_t number);

}  // namespace streetgen
