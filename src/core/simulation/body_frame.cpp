#include <algorithm>
#include <cmath>

#include "streetgen/traffic.hpp"

namespace streetgen {

LinkFrame body_frame(const Traffic& traffic, int car) {
  const TrafficNetwork& network = traffic.network();
  const Car standing = traffic.car(car);
  LinkFrame front = frame(network, standing.place);
  double behind = standing.length - standing.place.metres;  // the start of the last link seen
  int last = standing.place.link;
  for (const int link : traffic.links_under(car)) {
    if (link == last) continue;
    if (behind <= 0) break;
    behind -= network.links[link].length;
    last = link;
  }
  const LinkFrame rear = frame(network, {last, std::max(0., -behind)});
  // A car of which no link behind is known stands straight on.
  const double straight = std::max(0., behind);
  const double east = front.x - rear.x + straight * std::cos(rear.heading);
  const double north = front.y - rear.y + straight * std::sin(rear.heading);
  if (std::hypot(east, north) > 1e-9) front.heading = std::atan2(north, east);
  return front;
}

}  // namespace streetgen
