#include "simulation/event_rows.hpp"

#include <string>

#include "frame/argument.hpp"
#include "simulation/car_rows.hpp"

extern "C" {
#include <catalog/pg_type.h>
}

namespace streetgen::pg {

EventRows take_events(FunctionCallInfo fcinfo, int argument) {
  const Rows events = rows(fcinfo, argument, "events");
  return {events.count,
          column(events, "event_id", INT8OID),
          column(events, "kind", TEXTOID),
          column(events, "trigger", TEXTOID),
          column(events, "link_id", INT8OID),
          column(events, "metres", FLOAT8OID),
          column(events, "at", FLOAT8OID),
          column_or_null(events, "car_id", INT8OID),
          column(events, "speed", FLOAT8OID),
          column(events, "deceleration", FLOAT8OID),
          column(events, "duration", FLOAT8OID)};
}

std::vector<TrafficEvent> read_events(const EventRows& rows, const TrafficNetwork& network) {
  std::vector<TrafficEvent> events;
  for (int i = 0; i < rows.count; ++i) {
    const auto number = [&](const Column& column) { return DatumGetFloat8(column.values[i]); };
    TrafficEvent event;
    event.event_id = DatumGetInt64(rows.event_id.values[i]);
    const std::string of_event = " of event " + std::to_string(event.event_id);
    event.kind = word_of<EventKind>(text_of(rows.kind.values[i]), "the kind" + of_event,
                                    {{"brake", EventKind::brake},
                                     {"breakdown", EventKind::breakdown},
                                     {"overtake", EventKind::overtake},
                                     {"pull_out", EventKind::pull_out},
                                     {"cross", EventKind::cross}});
    event.trigger = word_of<EventTrigger>(text_of(rows.trigger.values[i]), "the trigger" + of_event,
                                          {{"time", EventTrigger::time},
                                           {"place", EventTrigger::place},
                                           {"gap", EventTrigger::gap}});
    event.place = known_place(network, DatumGetInt64(rows.link_id.values[i]),
                              finite(number(rows.metres), "the place" + of_event));
    event.at = number(rows.at);
    if (!rows.car_id.nulls[i]) event.car_id = DatumGetInt64(rows.car_id.values[i]);
    event.speed = number(rows.speed) * kmh;
    event.deceleration = number(rows.deceleration);
    event.duration = number(rows.duration);
    events.push_back(event);
  }
  return events;
}

}  // namespace streetgen::pg
