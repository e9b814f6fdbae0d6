#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "signal/signal_phase.hpp"
#include "signal/signal_time.hpp"

namespace streetgen {

namespace {

constexpr double shortest_green = 7, usual_green = 30;  // seconds
constexpr double shortest_cycle = 30;                   // seconds, by Webster
constexpr double saturation_flow = 1800;  // vehicles an hour of a lane that has green all the time
constexpr std::size_t most_ordered = 7;   // phases of which every order is tried

// Phases in turn, with what lies between them and how long each has to last.
class Cycle {
 public:
  // `walks`: the seconds that people ask for, by their number.
  Cycle(const std::vector<SignalRequest>& movements, const SignalRules& rules,
        const std::vector<Phase>& phases, const std::map<int, double>& walks)
      : movements_(movements), rules_(rules), phases_(phases) {
    order_phases();
    least_.assign(phases_.size(), steps_up(shortest_green, rules));
    for (const auto& [walk, seconds] : walks) leave_room(walk, seconds);
  }

  double shortest() const { return lost() + std::accumulate(least_.begin(), least_.end(), 0.0); }

  std::vector<SignalState> states() const {
    const std::vector<double> greens = shared_out();
    std::vector<SignalState> states;
    for (std::size_t k = 0; k < phases_.size(); ++k) {
      states.push_back({SignalKind::green, greens[k], greens_of(movements_, phases_[k])});
      append_change(changes_[k], states);
    }
    if (walk_state_ > 0) states.push_back({SignalKind::walk, walk_state_, {}});
    return states;
  }

 private:
  SignalChange change(std::size_t from, std::size_t to) const {
    return change_between(movements_, phases_[from], phases_[to], rules_);
  }

  // Phases follow each other so that no change lacks time, where an order does, and that changes
  // take least; of equal orders the first one holds.
  void order_phases() {
    const std::size_t n = phases_.size();
    std::vector<std::vector<SignalChange>> between(n, std::vector<SignalChange>(n));
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) between[i][j] = change(i, j);
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), 0);
    const auto all = [&](const std::vector<std::size_t>& turns) {
      double lacks = 0, lasts = 0;
      for (std::size_t k = 0; k < n; ++k) {
        const SignalChange& change = between[turns[k]][turns[(k + 1) % n]];
        lacks += change.lacks, lasts += change.duration();
      }
      return std::pair(std::round(lacks / rules_.step), std::round(1e6 * lasts));
    };
    std::vector<std::size_t> best = order;
    if (n > 2 && n <= most_ordered)
      while (std::next_permutation(order.begin() + 1, order.end()))
        if (all(order) < all(best)) best = order;
    std::vector<Phase> phases;
    for (const std::size_t k : best) phases.push_back(phases_[k]);
    phases_ = std::move(phases);
    for (std::size_t k = 0; k < n; ++k) changes_.push_back(between[best[k]][best[(k + 1) % n]]);
  }

  // Seconds that pass from the end of a phase to the start of a walk, beyond those of its change.
  double delay_after(std::size_t k, int walk) const {
    double delay = 0;
    for (const int i : phases_[k])
      for (const SignalRequest::Walk& w : movements_[i].walks)
        if (w.walk == walk) delay = std::max(delay, intergreen_to_walk(movements_[i], w, rules_));
    return std::max(0.0, delay - changes_[k].duration());
  }

  bool taken(std::size_t k, int walk) const {
    return std::any_of(phases_[k].begin(), phases_[k].end(), [&](int i) {
      const auto& walks = movements_[i].walks;
      return std::any_of(walks.begin(), walks.end(), [&](const auto& w) { return w.walk == walk; });
    });
  }

  // Seconds from the start of a phase to the next one that takes the walk; all of it is free.
  double room_from(std::size_t k, int walk) const {
    double room = 0;
    for (std::size_t step = 0; step < phases_.size(); ++step) {
      const std::size_t at = (k + step) % phases_.size();
      if (taken(at, walk)) break;
      room += least_[at] + changes_[at].duration();
    }
    return room;
  }

  // The phase that needs least to be added lasts long enough; else a state of its own.
  void leave_room(int walk, double seconds) {
    const std::size_t n = phases_.size();
    std::size_t best = n;
    double best_added = 0, best_least = 0;
    for (std::size_t k = 0; k < n; ++k) {
      if (taken(k, walk)) continue;
      const double delay = delay_after((k + n - 1) % n, walk);
      const double least =
          std::max({least_[k], steps_up(delay + rules_.shortest_walk, rules_),
                    steps_up(least_[k] + seconds + delay - room_from(k, walk), rules_)});
      if (best == n || least - least_[k] < best_added)
        best = k, best_added = least - least_[k], best_least = least;
    }
    if (best < n)
      least_[best] = best_least;
    else
      walk_state_ = std::max(walk_state_, steps_up(seconds + delay_after(n - 1, walk), rules_));
  }

  double lost() const {
    double sum = walk_state_;
    for (const SignalChange& change : changes_) sum += change.duration();
    return sum;
  }

  // The load of its lanes, 0 to 1: by the flows of its approaches, where one is known.
  std::optional<double> load(const Phase& phase) const {
    std::optional<double> most;
    for (const int i : phase) {
      const SignalRequest& m = movements_[i];
      if (m.flow) most = std::max(most.value_or(0), *m.flow / (m.lanes * saturation_flow));
    }
    return most;
  }

  // What each phase gets of the green, all together 1; Webster's cycle where flows are known.
  std::vector<double> shares(double& cycle) const {
    std::vector<double> shares;
    double loads = 0;
    bool known = true;
    for (const Phase& phase : phases_) {
      const auto own = load(phase);
      known = known && own;
      loads += shares.emplace_back(own.value_or(0));
    }
    if (known && loads > 0) {
      cycle = std::max(shortest_cycle, (1.5 * lost() + 5) / (1 - std::min(loads, 0.9)));
    } else {
      loads = 0;
      for (std::size_t k = 0; k < phases_.size(); ++k)
        loads += shares[k] = weight_of(movements_, phases_[k]);
      cycle = lost() + usual_green * phases_.size();
    }
    for (double& share : shares) share /= loads;
    return shares;
  }

  // Greens of whole steps that fill the cycle: no one is under its least, and what is left goes by
  // shares.
  std::vector<double> shared_out() const {
    double cycle = 0;
    const std::vector<double> share = shares(cycle);
    const double longest = std::floor(rules_.longest_cycle / rules_.step + 1e-6) * rules_.step;
    cycle = std::max(shortest(), std::min(longest, steps_up(cycle, rules_)));
    std::vector<double> greens = least_;
    double left = cycle - shortest();
    for (; left > rules_.step / 2; left -= rules_.step) {
      std::size_t next = 0;
      for (std::size_t k = 1; k < greens.size(); ++k)
        if (greens[k] * share[next] < greens[next] * share[k]) next = k;
      greens[next] += rules_.step;
    }
    return greens;
  }

  const std::vector<SignalRequest>& movements_;
  const SignalRules& rules_;
  std::vector<Phase> phases_;
  std::vector<SignalChange> changes_;  // after each phase
  std::vector<double> least_;          // green of each phase
  double walk_state_ = 0;              // after all of them; 0: there is none
};

std::map<int, double> walks_of(const std::vector<SignalRequest>& movements) {
  std::map<int, double> walks;
  for (const SignalRequest& m : movements)
    for (const SignalRequest::Walk& w : m.walks) walks[w.walk] = std::max(walks[w.walk], w.seconds);
  return walks;
}

void drop_longest(std::map<int, double>& walks) {
  walks.erase(std::max_element(walks.begin(), walks.end(),
                               [](const auto& a, const auto& b) { return a.second < b.second; }));
}

}  // namespace

std::vector<SignalState> signal_phases(const std::vector<SignalRequest>& requests,
                                       const SignalRules& rules) {
  check_requests(requests, rules);
  if (requests.empty()) return {};
  const std::vector<SignalRequest> movements = numbered(requests);
  std::map<int, double> walks = walks_of(movements);
  const auto fits = [&](const Cycle& cycle) { return cycle.shortest() <= rules.longest_cycle; };
  // Walks that take longer than the cycle leaves them go first.
  Phase all(movements.size());
  std::iota(all.begin(), all.end(), 0);
  while (!walks.empty() && !fits(Cycle(movements, rules, {all}, walks))) drop_longest(walks);
  const Cycle with_turns(movements, rules, phases_of(movements, rules, true), walks);
  if (fits(with_turns)) return with_turns.states();
  std::vector<Phase> phases = phases_of(movements, rules, false);
  while (phases.size() > 1 && !fits(Cycle(movements, rules, phases, walks)))
    merge_least(movements, phases);
  return Cycle(movements, rules, phases, walks).states();
}

}  // namespace streetgen
