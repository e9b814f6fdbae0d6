#include <algorithm>
#include <cmath>

#include "simulation/path_ahead.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

bool leads(const TrafficNetwork& network, int link, int next) {
  const auto following = network.next.of(link);
  return std::find(following.begin(), following.end(), next) != following.end();
}

void require_link(const TrafficNetwork& network, int link) {
  if (link < 0 || link >= network.size())
    throw Error(ErrorKind::invalid_input, "link " + std::to_string(link) +
                                              " is none of the network's " +
                                              std::to_string(network.size()) + " links");
}

std::vector<std::int32_t> free_path(const TrafficNetwork& network, const LinkPlace& place,
                                    double horizon, const std::vector<std::int32_t>& route) {
  require_link(network, place.link);
  if (!(horizon >= 0 && horizon <= farthest_horizon))
    throw Error(ErrorKind::invalid_input, "a horizon of " + text_of(horizon) +
                                              " metres is not between 0 and " +
                                              text_of(farthest_horizon));
  const auto found = std::find(route.begin(), route.end(), place.link);
  PathAhead path(network, place.link, &route,
                 found == route.end() ? -1 : static_cast<int>(found - route.begin()));
  std::vector<std::int32_t> links{place.link};
  const double length = network.links[place.link].length;
  double way = length - std::clamp(place.metres, 0.0, length);
  for (int next = path.next(); next >= 0 && way < horizon; next = path.next()) {
    poll_cancel();
    require_link(network, next);
    path.go_on(next);
    links.push_back(next);
    way += network.links[next].length;
  }
  return links;
}

void check_route(const TrafficNetwork& network, const std::vector<std::int32_t>& route) {
  for (const std::int32_t link : route) require_link(network, link);
  for (std::size_t i = 0; i + 1 < route.size(); ++i) {
    const auto beside = network.beside.of(route[i]);
    if (leads(network, route[i], route[i + 1]) ||
        std::any_of(beside.begin(), beside.end(), [&](const LinkBeside& other) {
          return other.link == route[i + 1] && !other.opposite;
        }))
      continue;
    throw Error(ErrorKind::invalid_input,
                "link " + std::to_string(network.links[route[i + 1]].link_id) +
                    " of the route neither follows link " +
                    std::to_string(network.links[route[i]].link_id) + " nor lies beside it");
  }
}

}  // namespace streetgen
