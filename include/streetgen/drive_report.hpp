// A log of drives on a network: on which lane each sample is, and how near the car ahead.  Campos, section 3.4: reports of driving simulators.
//
// A log has samples of actors, each of a time and a place.  The lanes of an actor are found for all
// of its samples together: the links that lie near them and follow each other, by the least sum of
// squared distances and of turns that no link makes (Newson and Krumm 2009, without chance).
//
// Lengths are metres, times seconds, speeds metres a second, heights metres, angles radians.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "streetgen/traffic.hpp"

namespace streetgen {

constexpr double not_logged = std::numeric_limits<double>::quiet_NaN();

struct DriveSample {
  std::int32_t actor = 0;  // 0 or more, below the number of samples
  double time = 0, x = 0, y = 0;
  double height = not_logged;
  double speed = not_logged;  // else that between the samples before and after
  float length = 5;           // of the actor; its place is that of its front
};

enum class DriveFinding : std::uint8_t {
  none,
  no_time,   // the time is not finite
  no_place,  // x or y is not finite
  twice,     // the actor has a sample at this time already
  off_road,  // no lane is near
};

struct DrivenSample {
  DriveFinding finding = DriveFinding::none;
  LocatedPlace located;  // link -1: on none
  bool against = false;  // it drives against the traffic of the lane
  double speed = not_logged;
  double over_limit = not_logged;  // its speed less that which is allowed on the lanes there
  // The next one ahead on its way, of those logged in the second before; -1: none.  Who drives
  // against the traffic looks along its own link alone.  The gap is from rear to front, and from
  // front to front of two that drive towards each other.  The leader has gone on at its speed since
  // its own sample.
  std::int32_t leader = -1;
  double gap = not_logged;
  double time_to_collision = not_logged;  // of both at these speeds; where they come nearer
};

// A sample is on the road up to so far beyond the ground of a lane.
constexpr double beside_lane = 2;

// A row for each sample, in their order.  The order of samples counts where two have one actor and
// time: the second one is left out.  Signals hide nobody, as a log has a clock of its own.  Refused
// (invalid_input): an actor that is none of these numbers, a length that is not positive or beyond `longest_car`.
std::vector<DrivenSample> drive_report(const TrafficNetwork& network,
                                       const std::vector<DriveSample>& samples);

}  // namespace streetgen
