// Events of a model as the core takes them.
#pragma once

#include <vector>

#include "frame/composite_rows.hpp"
#include "streetgen/traffic_event.hpp"

namespace streetgen::pg {

struct EventRows {
  int count = 0;
  Column event_id, kind, trigger, link_id, metres, at, car_id, speed, deceleration, duration;
};

// An argument of type streetgen.traffic_event[].
EventRows take_events(FunctionCallInfo fcinfo, int argument);

// For the compute step.  Refused: an event on no link.
std::vector<TrafficEvent> read_events(const EventRows& rows, const TrafficNetwork& network);

}  // namespace streetgen::pg
