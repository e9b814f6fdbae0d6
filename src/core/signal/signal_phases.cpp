#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "streetgen/error.hpp"
#include "streetgen/signal.hpp"

namespace streetgen {

namespace {

constexpr double reaction = 1;                                              // seconds
constexpr double braking = 3;                                               // m/s2
constexpr double car_length = 5;                                            // metres
constexpr double turning_speed = 30 / 3.6;                                  // m/s at most in a turn
constexpr double shortest_amber = 3, shortest_green = 7, usual_green = 30;  // seconds
constexpr double shortest_cycle = 30, longest_cycle = 120;                  // seconds, by Webster
constexpr double saturation_flow = 1800;  // vehicles an hour of a lane that has green all the time
constexpr double pair_state = 20;         // seconds, of the paper

void require(bool holds, std::size_t movement, const char* what) {
  if (!holds)
    throw Error(ErrorKind::invalid_input,
                "movement " + std::to_string(movement + 1) + " of a signal program has " + what);
}

bool within(double value, double low, double high) { return value >= low && value <= high; }

void check(const std::vector<SignalRequest>& movements) {
  for (std::size_t i = 0; i < movements.size(); ++i) {
    const SignalRequest& m = movements[i];
    require(within(m.length, 0, 1e4), i, "a length beyond 0 to 10000 m");
    require(within(m.speed, 1, 500), i, "a speed beyond 1 to 500 km/h");
    require(m.lanes >= 1 && m.lanes <= 100, i, "lanes beyond 1 to 100");
    require(!m.flow || within(*m.flow, 0, 1e6), i, "a flow beyond 0 to 1000000 vehicles an hour");
    require(within(m.walk_in, 0, 600) && within(m.walk_out, 0, 600), i,
            "a time to walk beyond 0 to 600 s");
    for (const int other : m.conflicts)
      require(
          other >= 0 && other < static_cast<int>(movements.size()) && other != static_cast<int>(i),
          i, "a conflict with a movement that is not there");
  }
}

// With edges numbered as they come, so that a program does not hang on their ids.
std::vector<SignalRequest> numbered(std::vector<SignalRequest> movements) {
  std::map<std::int64_t, std::int64_t> numbers;
  for (SignalRequest& m : movements)
    for (std::int64_t* edge : {&m.approach, &m.exit})
      *edge = numbers.emplace(*edge, static_cast<std::int64_t>(numbers.size())).first->second;
  return movements;
}

double half_second_up(double seconds) { return std::ceil(2 * seconds - 1e-9) / 2; }

// Traffic that cannot stop before the line still drives; what enters at the end of amber leaves in
// all red.
double amber_of(const SignalRequest& m) {
  return std::max(shortest_amber, half_second_up(reaction + m.speed / 3.6 / (2 * braking)));
}
double all_red_of(const SignalRequest& m) {
  const double speed = m.speed / 3.6;
  const double across =
      m.turn == SignalRequest::Turn::through ? speed : std::min(speed, turning_speed);
  return half_second_up((m.length + car_length) / across);
}

// The ends of a green state: amber and all red for all that have green in it.
void append_change(const std::vector<SignalRequest>& movements,
                   const std::vector<SignalState::Green>& greens,
                   std::vector<SignalState>& states) {
  double amber = 0, all_red = 0;
  for (const SignalState::Green& green : greens) {
    amber = std::max(amber, amber_of(movements[green.movement]));
    all_red = std::max(all_red, all_red_of(movements[green.movement]));
  }
  states.push_back({SignalKind::amber, amber, {}});
  states.push_back({SignalKind::all_red, all_red, {}});
}

class Phases {
 public:
  explicit Phases(const std::vector<SignalRequest>& movements) : movements_(movements) {
    for (int i = 0; i < static_cast<int>(movements.size()); ++i)
      approaches_[movements[i].approach].push_back(i);
  }

  std::vector<SignalState> states() const {
    const std::vector<std::vector<std::int64_t>> phases = found();
    std::vector<SignalState> states;
    for (const std::vector<std::int64_t>& phase : phases) {
      states.push_back({SignalKind::green, usual_green, greens_of(phase)});
      append_change(movements_, states.back().greens, states);
    }
    share_out(phases, states);
    // People cross in all red where all streets have green at once.
    if (phases.size() == 1) states.back().duration += longest_walk();
    return states;
  }

 private:
  bool in_conflict(int a, int b) const {
    const std::vector<int>& of_a = movements_[a].conflicts;
    return std::find(of_a.begin(), of_a.end(), b) != of_a.end();
  }

  // The main traffic of an approach: what goes through, or all of it where nothing does.
  std::vector<int> main_movements(std::int64_t approach) const {
    std::vector<int> through;
    for (const int i : approaches_.at(approach))
      if (movements_[i].turn == SignalRequest::Turn::through) through.push_back(i);
    return through.empty() ? approaches_.at(approach) : through;
  }

  bool meet(std::int64_t a, std::int64_t b) const {
    for (const int i : main_movements(a))
      for (const int j : main_movements(b))
        if (in_conflict(i, j) || in_conflict(j, i)) return true;
    return false;
  }

  // Each approach joins the first phase with whose approaches it does not meet; the most important
  // ones choose first.
  std::vector<std::vector<std::int64_t>> found() const {
    std::vector<std::tuple<int, int, std::int64_t>> order;
    for (const auto& [approach, own] : approaches_)
      order.emplace_back(movements_[own.front()].importance, -movements_[own.front()].lanes,
                         approach);
    std::sort(order.begin(), order.end());
    std::vector<std::vector<std::int64_t>> phases;
    for (const auto& [importance, lanes, approach] : order) {
      const auto fits = [&, id = approach](const std::vector<std::int64_t>& phase) {
        return std::none_of(phase.begin(), phase.end(),
                            [&](std::int64_t other) { return meet(id, other); });
      };
      const auto first = std::find_if(phases.begin(), phases.end(), fits);
      if (first == phases.end())
        phases.push_back({approach});
      else
        first->push_back(approach);
    }
    return phases;
  }

  // Through traffic first, then the shorter turn: what meets one before it gives way.
  std::vector<SignalState::Green> greens_of(const std::vector<std::int64_t>& phase) const {
    std::vector<int> order;
    for (const std::int64_t approach : phase)
      order.insert(order.end(), approaches_.at(approach).begin(), approaches_.at(approach).end());
    const auto rank = [&](int i) {
      const SignalRequest& m = movements_[i];
      // Longer by a millimetre, not by what rounding does to equal turns.
      return std::tuple(m.turn == SignalRequest::Turn::u_turn    ? 2
                        : m.turn == SignalRequest::Turn::through ? 0
                                                                 : 1,
                        std::llround(m.length * 1000), i);
    };
    std::sort(order.begin(), order.end(), [&](int a, int b) { return rank(a) < rank(b); });
    std::vector<SignalState::Green> greens;
    for (const int i : order) {
      const bool gives_way =
          std::any_of(greens.begin(), greens.end(), [&](const SignalState::Green& g) {
            return g.right_of_way == RightOfWay::protect &&
                   (in_conflict(i, g.movement) || in_conflict(g.movement, i));
          });
      greens.push_back({i, gives_way ? RightOfWay::permit : RightOfWay::protect});
    }
    std::sort(greens.begin(), greens.end(),
              [](const auto& a, const auto& b) { return a.movement < b.movement; });
    return greens;
  }

  // People cross the streets that have red.
  double least_green(const std::vector<std::int64_t>& phase) const {
    double least = shortest_green;
    const auto has_green = [&](std::int64_t edge) {
      return std::find(phase.begin(), phase.end(), edge) != phase.end();
    };
    for (const SignalRequest& m : movements_) {
      if (!has_green(m.approach)) least = std::max(least, m.walk_in);
      if (!has_green(m.exit)) least = std::max(least, m.walk_out);
    }
    return std::ceil(least);
  }

  // The time that people need to cross the widest street.
  double longest_walk() const {
    double longest = 0;
    for (const SignalRequest& m : movements_) longest = std::max({longest, m.walk_in, m.walk_out});
    return std::ceil(longest);
  }

  // The load of its lanes, 0 to 1: by the flows of its approaches, where one is known.
  std::optional<double> load(const std::vector<std::int64_t>& phase) const {
    std::optional<double> most;
    for (const std::int64_t approach : phase) {
      const SignalRequest& m = movements_[approaches_.at(approach).front()];
      if (m.flow) most = std::max(most.value_or(0), *m.flow / (m.lanes * saturation_flow));
    }
    return most;
  }

  double weight(const std::vector<std::int64_t>& phase) const {
    double most = 0;
    for (const std::int64_t approach : phase) {
      const SignalRequest& m = movements_[approaches_.at(approach).front()];
      most =
          std::max(most, std::sqrt(m.lanes) * std::pow(1.25, 5 - std::clamp(m.importance, 1, 9)));
    }
    return most;
  }

  void share_out(const std::vector<std::vector<std::int64_t>>& phases,
                 std::vector<SignalState>& states) const {
    if (phases.empty()) return;
    double lost = 0, loads = 0, weights = 0, unknown = 0;
    for (const SignalState& state : states)
      if (state.kind != SignalKind::green) lost += state.duration;
    for (const auto& phase : phases) {
      weights += weight(phase);
      if (const auto known = load(phase))
        loads += *known;
      else
        unknown += weight(phase);
    }
    const bool by_flow = unknown == 0 && loads > 0;
    const double cycle = by_flow ? std::clamp((1.5 * lost + 5) / (1 - std::min(loads, 0.9)),
                                              shortest_cycle, longest_cycle)
                                 : lost + usual_green * phases.size();
    for (std::size_t k = 0; k < phases.size(); ++k) {
      const double share = by_flow ? *load(phases[k]) / loads : weight(phases[k]) / weights;
      states[3 * k].duration =
          std::max(least_green(phases[k]), std::round(std::max(0.0, cycle - lost) * share));
    }
  }

  const std::vector<SignalRequest>& movements_;
  std::map<std::int64_t, std::vector<int>> approaches_;
};

}  // namespace

std::vector<SignalState> signal_phases(const std::vector<SignalRequest>& requests) {
  check(requests);
  const std::vector<SignalRequest> movements = numbered(requests);
  return Phases(movements).states();
}

std::vector<SignalState> signal_pairs(const std::vector<SignalRequest>& requests) {
  check(requests);
  const std::vector<SignalRequest> movements = numbered(requests);
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<SignalState::Green>> pairs;
  std::map<std::int64_t, std::vector<int>> turning_back;
  for (int i = 0; i < static_cast<int>(movements.size()); ++i) {
    const SignalRequest& m = movements[i];
    if (m.approach == m.exit)
      turning_back[m.approach].push_back(i);
    else
      pairs[std::minmax(m.approach, m.exit)].push_back({i, RightOfWay::protect});
  }
  // Traffic that turns back goes with the first pair of its road, and gives way.
  for (const auto& [approach, own] : turning_back) {
    const auto first = std::find_if(pairs.begin(), pairs.end(), [id = approach](const auto& pair) {
      return pair.first.first == id || pair.first.second == id;
    });
    auto& greens = first != pairs.end() ? first->second : pairs[{approach, approach}];
    for (const int i : own) greens.push_back({i, RightOfWay::permit});
  }
  std::vector<SignalState> states;
  for (auto& [roads, greens] : pairs) {
    std::sort(greens.begin(), greens.end(),
              [](const auto& a, const auto& b) { return a.movement < b.movement; });
    // Lanes of one road may merge into one of the other.
    std::set<int> open;
    for (SignalState::Green& green : greens) {
      const std::vector<int>& conflicts = movements[green.movement].conflicts;
      if (std::any_of(conflicts.begin(), conflicts.end(),
                      [&](int other) { return open.count(other) > 0; }))
        green.right_of_way = RightOfWay::permit;
      if (green.right_of_way == RightOfWay::protect) open.insert(green.movement);
    }
    const std::size_t green = states.size();
    states.push_back({SignalKind::green, pair_state, greens});
    append_change(movements, greens, states);
    states[green].duration =
        std::max(5.0, pair_state - states[green + 1].duration - states[green + 2].duration);
  }
  return states;
}

}  // namespace streetgen
