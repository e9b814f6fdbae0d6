#include "simulation/signal_aspect.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/path_ahead.hpp"
#include "streetgen/traffic.hpp"

namespace streetgen {

Aspect aspect_at(const TrafficNetwork& network, int link, double time) {
  require_link(network, link);
  const auto aspects = network.aspects.of(link);
  if (aspects.empty()) return Aspect::none;
  const int plan = network.links[link].plan;
  double second = 0;
  if (plan >= 0 && plan < static_cast<int>(network.plans.size()) && std::isfinite(time)) {
    const double cycle = network.plans[plan].cycle;
    second = std::fmod(time - network.plans[plan].start_offset, cycle);
    if (second < 0) second += cycle;
  }
  const SignalAspect* after =
      std::upper_bound(aspects.begin(), aspects.end(), second,
                       [](double s, const SignalAspect& aspect) { return s < aspect.since; });
  return (after == aspects.begin() ? aspects.end() : after)[-1].aspect;
}

bool stops_for(Aspect aspect, double speed, double metres, double deceleration) {
  return aspect == Aspect::red ||
         (aspect == Aspect::amber && speed * speed <= 2 * deceleration * metres);
}

}  // namespace streetgen
