#include "simulation/require_place.hpp"

#include <string>

#include "streetgen/error.hpp"

namespace streetgen {

void require_place(const TrafficNetwork& network, std::int64_t car_id, const LinkPlace& place) {
  const auto refuse = [&](const std::string& where) {
    throw Error(ErrorKind::invalid_input, "car " + std::to_string(car_id) + " stands " + where);
  };
  if (place.link < 0 || place.link >= network.size())
    refuse("on link " + std::to_string(place.link) + ", which is none of the " +
           std::to_string(network.size()));
  const Link& link = network.links[place.link];
  if (!(place.metres >= 0 && place.metres <= link.length))
    refuse("at " + text_of(place.metres) + " metres of link " + std::to_string(link.link_id) +
           ", which ends at " + text_of(link.length));
}

}  // namespace streetgen
