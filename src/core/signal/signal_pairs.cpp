#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "signal/signal_time.hpp"

namespace streetgen {

namespace {

constexpr double pair_state = 20;  // seconds, of the paper
constexpr double least_green = 5;  // seconds

using Pairs = std::map<std::pair<std::int64_t, std::int64_t>, std::vector<SignalState::Green>>;

// The movements of each pair of roads. Traffic that turns back goes with the first pair of its
// road, and gives way.
Pairs pairs_of(const std::vector<SignalRequest>& movements) {
  Pairs pairs;
  std::map<std::int64_t, std::vector<int>> turning_back;
  for (int i = 0; i < static_cast<int>(movements.size()); ++i) {
    const SignalRequest& m = movements[i];
    if (m.approach == m.exit)
      turning_back[m.approach].push_back(i);
    else
      pairs[std::minmax(m.approach, m.exit)].push_back({i, RightOfWay::protect});
  }
  for (const auto& [approach, own] : turning_back) {
    const auto first = std::find_if(pairs.begin(), pairs.end(), [id = approach](const auto& pair) {
      return pair.first.first == id || pair.first.second == id;
    });
    auto& greens = first != pairs.end() ? first->second : pairs[{approach, approach}];
    for (const int i : own) greens.push_back({i, RightOfWay::permit});
  }
  return pairs;
}

// Lanes of one road may merge into one of the other.
void yield_to_earlier(const std::vector<SignalRequest>& movements,
                      std::vector<SignalState::Green>& greens) {
  std::sort(greens.begin(), greens.end(),
            [](const auto& a, const auto& b) { return a.movement < b.movement; });
  std::set<int> open;
  for (SignalState::Green& green : greens) {
    const auto& conflicts = movements[green.movement].conflicts;
    if (std::any_of(conflicts.begin(), conflicts.end(),
                    [&](const auto& c) { return open.count(c.movement) > 0; }))
      green.right_of_way = RightOfWay::permit;
    if (green.right_of_way == RightOfWay::protect) open.insert(green.movement);
  }
}

std::vector<int> of(const std::vector<SignalState::Green>& greens) {
  std::vector<int> movements;
  for (const SignalState::Green& green : greens) movements.push_back(green.movement);
  return movements;
}

}  // namespace

std::vector<SignalState> signal_pairs(const std::vector<SignalRequest>& requests,
                                      const SignalRules& rules) {
  check_requests(requests, rules);
  const std::vector<SignalRequest> movements = numbered(requests);
  std::vector<std::vector<SignalState::Green>> turns;
  for (auto& [roads, greens] : pairs_of(movements)) {
    yield_to_earlier(movements, greens);
    turns.push_back(greens);
  }
  std::vector<SignalState> states;
  for (std::size_t k = 0; k < turns.size(); ++k) {
    const SignalChange change =
        change_between(movements, of(turns[k]), of(turns[(k + 1) % turns.size()]), rules);
    states.push_back(
        {SignalKind::green, std::max(least_green, pair_state - change.duration()), turns[k]});
    append_change(change, states);
  }
  return states;
}

}  // namespace streetgen
