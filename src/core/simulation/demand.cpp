#include "simulation/demand.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "streetgen/error.hpp"

namespace streetgen {

namespace {

[[noreturn]] void refuse_demand(const std::string& message) {
  throw Error(ErrorKind::invalid_input, message);
}

std::string named(const TrafficNetwork& network, int link) {
  return "link " + std::to_string(network.links[link].link_id);
}

void require_link(const TrafficNetwork& network, int link, const char* what) {
  if (link < 0 || link >= network.size())
    refuse_demand(std::string(what) + " names link number " + std::to_string(link) + " of " +
                  std::to_string(network.size()));
}

void share_straight_on(const TrafficNetwork& network, int link, std::vector<double>& share) {
  const auto next = network.next.of(link);
  if (next.empty()) return;
  double* const first = &share[network.next.starts[link]];
  for (int i = 0; i < next.size(); ++i) first[i] = next[i] == network.links[link].straight_on;
  if (std::count(first, first + next.size(), 1.) == 0) *first = 1;
}

}  // namespace

void check_entries(const TrafficNetwork& network, const std::vector<TrafficEntry>& entries) {
  for (const TrafficEntry& e : entries) {
    require_link(network, e.link, "an entry");
    if (!std::isfinite(e.flow) || e.flow < 0)
      refuse_demand("the flow " + text_of(e.flow) + " into " + named(network, e.link) +
                    " is not 0 or more");
  }
}

std::vector<double> turn_shares(const TrafficNetwork& network,
                                const std::vector<TurnShare>& turns) {
  const RowsOf<std::int32_t>& next = network.next;
  std::vector<double> share(next.rows.size(), 0), stated(next.rows.size(), 0);
  std::vector<double> all(network.size(), 0);
  for (const TurnShare& t : turns) {
    require_link(network, t.link, "a share of turns");
    require_link(network, t.next, "a share of turns");
    if (!std::isfinite(t.share) || t.share < 0)
      refuse_demand("share " + text_of(t.share) + " of " + named(network, t.link) +
                    " is not 0 or more");
    int row = next.starts[t.link];
    while (row < next.starts[t.link + 1] && next.rows[row] != t.next) ++row;
    if (row == next.starts[t.link + 1])
      refuse_demand(named(network, t.next) + " does not follow " + named(network, t.link));
    stated[row] += t.share;
    all[t.link] += t.share;
  }
  for (int link = 0; link < network.size(); ++link) {
    if (all[link] > 0)
      for (int row = next.starts[link]; row < next.starts[link + 1]; ++row)
        share[row] = stated[row] / all[link];
    else
      share_straight_on(network, link, share);
  }
  return share;
}

}  // namespace streetgen
