// The links that a driver goes by: of a route, or by shares of turns.
#include <algorithm>

#include "simulation/driver.hpp"
#include "support/random.hpp"

namespace streetgen {

double drawn(std::uint64_t seed, std::uint64_t who, std::uint64_t number) {
  return Random::part(Random::part(seed, who).next(), number).uniform();
}

namespace {

int turn(const CarRun& run, const Driver& driver, const WayPlace& at) {
  const RowsOf<std::int32_t>& next = run.network->next;
  const int first = next.starts[at.link], end = next.starts[at.link + 1];
  if (end - first == 1) return next.rows[first];
  const auto may = [&](int row) {
    return run.share[row] > 0 && (run.link(next.rows[row]).traffic & driver.kind) != 0;
  };
  double all = 0;
  for (int row = first; row < end; ++row)
    if (may(row)) all += run.share[row];
  if (all <= 0) return run.link(at.link).straight_on;
  double rest = all * drawn(run.seed, driver.car_id,
                            at.passed + (static_cast<std::uint64_t>(driver.turned) << 32));
  int found = -1;
  for (int row = first; row < end && rest >= 0; ++row)
    if (may(row)) {
      found = next.rows[row];
      rest -= run.share[row];
    }
  return found;
}

}  // namespace

int go_on(const CarRun& run, const Driver& driver, WayPlace& at) {
  const auto next = run.network->next.of(at.link);
  int link = way_ends;
  if (driver.route >= 0) {
    const auto& route = run.cars.routes[driver.route];
    if (at.on_route < 0) return must_change;
    if (at.on_route + 1 == static_cast<int>(route.size())) return way_ends;
    link = route[at.on_route + 1];
    if (std::find(next.begin(), next.end(), link) == next.end()) return must_change;
    ++at.on_route;
  } else {
    if (next.empty()) return run.merges[at.link] ? must_change : way_ends;
    link = turn(run, driver, at);
    if (link < 0) return way_ends;
  }
  at.link = link;
  ++at.passed;
  return link;
}

}  // namespace streetgen
