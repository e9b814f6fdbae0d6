#include "signal/signal_phase.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

#include "signal/signal_time.hpp"

namespace streetgen {

namespace {

constexpr int turning_lanes = 2, crossed_lanes = 3;  // from which a turn has a phase of its own
constexpr double fast = 70;                          // km/h, likewise

using Turn = SignalRequest::Turn;

class Approaches {
 public:
  Approaches(const std::vector<SignalRequest>& movements, const SignalRules& rules)
      : movements_(movements), rules_(rules) {
    for (int i = 0; i < static_cast<int>(movements.size()); ++i)
      own_[movements[i].approach].push_back(i);
  }

  std::vector<Phase> phases(bool turn_phases) const {
    std::vector<Phase> phases;
    for (const std::vector<std::int64_t>& sharing : shared(turn_phases))
      for (Phase& phase : parted(sharing, turn_phases)) phases.push_back(std::move(phase));
    for (const std::int64_t approach : yielding()) let_in(approach, phases);
    for (Phase& phase : phases) std::sort(phase.begin(), phase.end());
    return phases;
  }

 private:
  bool in_conflict(int a, int b) const {
    return meets(movements_[a], b) || meets(movements_[b], a);
  }

  bool counts(std::int64_t approach) const {
    return movements_[own_.at(approach).front()].importance <= rules_.least_importance;
  }

  // Approaches that have a phase: where none counts, all of them.
  bool has_phase(std::int64_t approach) const {
    const bool some =
        std::any_of(own_.begin(), own_.end(), [&](const auto& arm) { return counts(arm.first); });
    return !some || counts(approach);
  }

  std::vector<std::int64_t> yielding() const {
    std::vector<std::int64_t> found;
    for (const auto& [approach, own] : own_)
      if (!has_phase(approach)) found.push_back(approach);
    return found;
  }

  // The main traffic of an approach: what goes through, or all of it where nothing does.
  std::vector<int> main_movements(std::int64_t approach) const {
    std::vector<int> through;
    for (const int i : own_.at(approach))
      if (movements_[i].turn == Turn::through) through.push_back(i);
    return through.empty() ? own_.at(approach) : through;
  }

  bool meet(std::int64_t a, std::int64_t b) const {
    for (const int i : main_movements(a))
      for (const int j : main_movements(b))
        if (in_conflict(i, j)) return true;
    return false;
  }

  int lanes_that_turn(int movement) const {
    std::set<std::int64_t> lanes;
    for (const int i : own_.at(movements_[movement].approach))
      if (movements_[i].turn == movements_[movement].turn) lanes.insert(movements_[i].lane);
    return static_cast<int>(lanes.size());
  }

  // Whether a turn across the main traffic of another approach asks for a phase of its own.
  bool needs_phase(int turn, std::int64_t other) const {
    const Turn kind = movements_[turn].turn;
    if (kind != Turn::left && kind != Turn::right) return false;
    std::set<std::int64_t> crossed;
    double speed = movements_[turn].speed;
    for (const int j : main_movements(other))
      if (movements_[j].turn == Turn::through && in_conflict(turn, j)) {
        crossed.insert(movements_[j].lane);
        speed = std::max(speed, movements_[j].speed);
      }
    if (crossed.empty()) return false;
    if (rules_.turn_phases) return *rules_.turn_phases;
    return lanes_that_turn(turn) >= turning_lanes ||
           static_cast<int>(crossed.size()) >= crossed_lanes || speed >= fast;
  }

  std::set<int> turns_apart(std::int64_t approach, std::int64_t other) const {
    std::set<int> turns;
    for (const int i : own_.at(approach))
      if (needs_phase(i, other)) turns.insert(i);
    return turns;
  }

  // A lane in which others than such turns wait cannot have green with the turns alone.
  bool have_lanes_of_their_own(const std::set<int>& turns, std::int64_t approach) const {
    std::set<std::int64_t> lanes;
    for (const int i : turns) lanes.insert(movements_[i].lane);
    return std::none_of(own_.at(approach).begin(), own_.at(approach).end(), [&](int i) {
      return movements_[i].turn != Turn::u_turn && turns.count(i) == 0 &&
             lanes.count(movements_[i].lane) > 0;
    });
  }

  bool may_share(std::int64_t a, std::int64_t b, bool turn_phases) const {
    if (meet(a, b)) return false;
    return !turn_phases || (have_lanes_of_their_own(turns_apart(a, b), a) &&
                            have_lanes_of_their_own(turns_apart(b, a), b));
  }

  // The most important approaches choose first.
  std::vector<std::int64_t> in_order() const {
    std::vector<std::tuple<int, int, std::int64_t>> order;
    for (const auto& [approach, own] : own_)
      if (has_phase(approach))
        order.emplace_back(movements_[own.front()].importance, -movements_[own.front()].lanes,
                           approach);
    std::sort(order.begin(), order.end());
    std::vector<std::int64_t> approaches;
    for (const auto& [importance, lanes, approach] : order) approaches.push_back(approach);
    return approaches;
  }

  // Each approach joins the first phase with whose approaches it may share one.
  std::vector<std::vector<std::int64_t>> shared(bool turn_phases) const {
    std::vector<std::vector<std::int64_t>> phases;
    for (const std::int64_t approach : in_order()) {
      const auto first = std::find_if(phases.begin(), phases.end(), [&](const auto& phase) {
        return std::all_of(phase.begin(), phase.end(), [&](std::int64_t other) {
          return may_share(approach, other, turn_phases);
        });
      });
      if (first == phases.end())
        phases.push_back({approach});
      else
        first->push_back(approach);
    }
    return phases;
  }

  // The turns apart of approaches that share a phase, with who turns back from their lanes.
  std::set<int> all_turns_apart(const std::vector<std::int64_t>& sharing) const {
    std::set<int> turns;
    std::set<std::int64_t> lanes;
    for (const std::int64_t a : sharing)
      for (const std::int64_t b : sharing)
        if (a != b)
          for (const int i : turns_apart(a, b)) turns.insert(i), lanes.insert(movements_[i].lane);
    for (const std::int64_t a : sharing)
      for (const int i : own_.at(a))
        if (movements_[i].turn == Turn::u_turn && lanes.count(movements_[i].lane)) turns.insert(i);
    return turns;
  }

  // Turns apart that do not meet have one phase, before the others.
  std::vector<Phase> parted(const std::vector<std::int64_t>& sharing, bool turn_phases) const {
    const std::set<int> turns = turn_phases ? all_turns_apart(sharing) : std::set<int>();
    std::vector<Phase> phases;
    Phase rest;
    for (const std::int64_t approach : sharing) {
      Phase own_turns;
      for (const int i : own_.at(approach)) (turns.count(i) ? own_turns : rest).push_back(i);
      if (!own_turns.empty()) join(own_turns, phases);
    }
    if (!rest.empty()) phases.push_back(rest);
    return phases;
  }

  void join(const Phase& turns, std::vector<Phase>& phases) const {
    const auto first = std::find_if(phases.begin(), phases.end(), [&](const Phase& phase) {
      return std::none_of(turns.begin(), turns.end(),
                          [&](int i) { return meetings(i, phase) > 0; });
    });
    if (first == phases.end())
      phases.push_back(turns);
    else
      first->insert(first->end(), turns.begin(), turns.end());
  }

  long meetings(int movement, const Phase& phase) const {
    return std::count_if(phase.begin(), phase.end(),
                         [&](int other) { return in_conflict(movement, other); });
  }

  // An approach without a phase goes with the one that it meets least.
  void let_in(std::int64_t approach, std::vector<Phase>& phases) const {
    const auto all = [&](const Phase& phase) {
      long sum = 0;
      for (const int i : own_.at(approach)) sum += meetings(i, phase);
      return sum;
    };
    const auto least =
        std::min_element(phases.begin(), phases.end(),
                         [&](const Phase& a, const Phase& b) { return all(a) < all(b); });
    least->insert(least->end(), own_.at(approach).begin(), own_.at(approach).end());
  }

  const std::vector<SignalRequest>& movements_;
  const SignalRules& rules_;
  std::map<std::int64_t, std::vector<int>> own_;
};

}  // namespace

std::vector<Phase> phases_of(const std::vector<SignalRequest>& movements, const SignalRules& rules,
                             bool turn_phases) {
  return Approaches(movements, rules).phases(turn_phases);
}

void merge_least(const std::vector<SignalRequest>& movements, std::vector<Phase>& phases) {
  const auto lighter = [&](const Phase& a, const Phase& b) {
    return weight_of(movements, a) < weight_of(movements, b);
  };
  for (int turn = 0; turn < 2; ++turn) {
    const auto least = std::min_element(phases.begin(), phases.end() - turn, lighter);
    std::rotate(least, least + 1, phases.end() - turn);
  }
  Phase last = std::move(phases.back());
  phases.pop_back();
  phases.back().insert(phases.back().end(), last.begin(), last.end());
  std::sort(phases.back().begin(), phases.back().end());
}

double weight_of(const std::vector<SignalRequest>& movements, const Phase& phase) {
  double most = 0;
  for (const int i : phase) {
    const SignalRequest& m = movements[i];
    most = std::max(most, std::sqrt(m.lanes) * std::pow(1.25, 5 - std::clamp(m.importance, 1, 9)));
  }
  return most;
}

std::vector<SignalState::Green> greens_of(const std::vector<SignalRequest>& movements,
                                          const Phase& phase) {
  Phase order = phase;
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::pair(movements[a].precedence, a) < std::pair(movements[b].precedence, b);
  });
  std::vector<SignalState::Green> greens;
  for (const int i : order) {
    const bool gives_way =
        std::any_of(greens.begin(), greens.end(), [&](const SignalState::Green& g) {
          return g.right_of_way == RightOfWay::protect &&
                 (meets(movements[i], g.movement) || meets(movements[g.movement], i));
        });
    greens.push_back({i, gives_way ? RightOfWay::permit : RightOfWay::protect});
  }
  std::sort(greens.begin(), greens.end(),
            [](const auto& a, const auto& b) { return a.movement < b.movement; });
  return greens;
}

}  // namespace streetgen
