#include "signal/signal_time.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "streetgen/error.hpp"

namespace streetgen {

namespace {

constexpr double reaction = 1;        // seconds
constexpr double braking = 3;         // m/s2
constexpr double car_length = 5;      // metres
constexpr double crossing_depth = 4;  // metres, of people on foot beside each other
constexpr double turning_speed =
    30 / 3.6;                         // m/s in a turn and from a slow street; more in a wide turn
constexpr double sideways = 3;        // m/s2 in a turn, at most
constexpr double shortest_amber = 3;  // seconds

void require(bool holds, std::size_t movement, const char* what) {
  if (!holds)
    throw Error(ErrorKind::invalid_input,
                "movement " + std::to_string(movement + 1) + " of a signal program has " + what);
}

bool within(double value, double low, double high) { return value >= low && value <= high; }

void check_conflicts(const std::vector<SignalRequest>& movements, std::size_t i) {
  for (const SignalRequest::Conflict& c : movements[i].conflicts) {
    require(c.movement >= 0 && c.movement < static_cast<int>(movements.size()) &&
                c.movement != static_cast<int>(i),
            i, "a conflict with a movement that is not there");
    require(within(c.reach, 0, 1e4), i, "a way to a conflict beyond 0 to 10000 m");
  }
}

void check_walks(const SignalRequest& m, std::size_t i) {
  for (const SignalRequest::Walk& w : m.walks) {
    require(w.walk >= 0, i, "people on foot that are not there");
    require(within(w.seconds, 0, 600), i, "a time to walk beyond 0 to 600 s");
    require(within(w.reach, 0, 1e4), i, "a way to people on foot beyond 0 to 10000 m");
  }
}

// Before it, a car that could not stop has come to the line.
double time_to_stop(const SignalRequest& m) { return reaction + m.speed / 3.6 / (2 * braking); }

// A turn is a quarter of a circle.
double speed_in_turn(double length) {
  return std::max(turning_speed, std::sqrt(sideways * length * 2 / M_PI));
}

// Who comes from a slow street leaves the junction as others do.
double speed_across(const SignalRequest& m) {
  const double speed = std::max(m.speed / 3.6, turning_speed);
  return m.turn == SignalRequest::Turn::through ? speed : std::min(speed, speed_in_turn(m.length));
}

const SignalRequest::Conflict* conflict_with(const SignalRequest& m, int other) {
  const auto found = std::find_if(m.conflicts.begin(), m.conflicts.end(),
                                  [&](const auto& c) { return c.movement == other; });
  return found == m.conflicts.end() ? nullptr : &*found;
}

// From the last entry of `a` to the start of `b`, where they meet.
std::optional<double> time_to_clear(const std::vector<SignalRequest>& movements, int a, int b) {
  const SignalRequest &leaves = movements[a], &enters = movements[b];
  const SignalRequest::Conflict* out = conflict_with(leaves, b);
  const SignalRequest::Conflict* in = conflict_with(enters, a);
  if (!out && !in) return std::nullopt;
  const double way_out = out ? out->reach : leaves.length, way_in = in ? in->reach : 0;
  return std::max(0.0,
                  (way_out + car_length) / speed_across(leaves) - way_in / (enters.speed / 3.6));
}

double last_entry(const SignalRequest& m) { return std::max(shortest_amber, time_to_stop(m)); }

}  // namespace

void check_requests(const std::vector<SignalRequest>& movements, const SignalRules& rules) {
  if (!within(rules.step, 0.1, 10) || !within(rules.longest_cycle, 30, 3600) ||
      !within(rules.shortest_walk, 0, 60) || !within(rules.longest_all_red, 0, 60))
    throw Error(ErrorKind::invalid_input,
                "a signal program has a cycle beyond 30 to 3600 s, a step beyond 0.1 to 10 s, or a "
                "walk or an all red beyond 0 to 60 s");
  for (std::size_t i = 0; i < movements.size(); ++i) {
    const SignalRequest& m = movements[i];
    require(within(m.length, 0, 1e4), i, "a length beyond 0 to 10000 m");
    require(within(m.speed, 1, 500), i, "a speed beyond 1 to 500 km/h");
    require(m.lanes >= 1 && m.lanes <= 100, i, "lanes beyond 1 to 100");
    require(!m.flow || within(*m.flow, 0, 1e6), i, "a flow beyond 0 to 1000000 vehicles an hour");
    check_conflicts(movements, i);
    check_walks(m, i);
  }
}

std::vector<SignalRequest> numbered(std::vector<SignalRequest> movements) {
  std::map<std::int64_t, std::int64_t> edges, lanes;
  const auto number = [](auto& numbers, std::int64_t& id) {
    id = numbers.emplace(id, static_cast<std::int64_t>(numbers.size())).first->second;
  };
  for (SignalRequest& m : movements) {
    number(edges, m.approach), number(edges, m.exit);
    number(lanes, m.lane);
  }
  return movements;
}

double steps_up(double seconds, const SignalRules& rules) {
  return std::ceil(seconds / rules.step - 1e-6) * rules.step;
}

bool meets(const SignalRequest& movement, int other) {
  return conflict_with(movement, other) != nullptr;
}

// The nearest step: what comes later is clear with the time between greens.
double amber_of(const SignalRequest& movement, const SignalRules& rules) {
  return std::max(steps_up(shortest_amber, rules),
                  std::round(time_to_stop(movement) / rules.step) * rules.step);
}

double intergreen(const std::vector<SignalRequest>& movements, int a, int b,
                  const SignalRules& rules) {
  const auto clear = time_to_clear(movements, a, b);
  return clear ? steps_up(last_entry(movements[a]) + *clear, rules) : 0;
}

double intergreen_to_walk(const SignalRequest& movement, const SignalRequest::Walk& walk,
                          const SignalRules& rules) {
  return steps_up(
      last_entry(movement) + (walk.reach + crossing_depth + car_length) / speed_across(movement),
      rules);
}

SignalChange change_between(const std::vector<SignalRequest>& movements,
                            const std::vector<int>& ends, const std::vector<int>& begins,
                            const SignalRules& rules) {
  const auto within = [](const std::vector<int>& phase, int i) {
    return std::find(phase.begin(), phase.end(), i) != phase.end();
  };
  SignalChange change;
  for (const int a : ends) change.amber = std::max(change.amber, amber_of(movements[a], rules));
  change.all_red = rules.step;
  for (const int a : ends)
    for (const int b : begins)
      if (!within(begins, a) && !within(ends, b))
        change.all_red =
            std::max({change.all_red, intergreen(movements, a, b, rules) - change.amber,
                      steps_up(time_to_clear(movements, a, b).value_or(0), rules)});
  const double longest = std::max(rules.step, rules.longest_all_red);
  change.lacks = std::max(0.0, change.all_red - longest);
  change.all_red -= change.lacks;
  return change;
}

void append_change(const SignalChange& change, std::vector<SignalState>& states) {
  states.push_back({SignalKind::amber, change.amber, {}});
  states.push_back({SignalKind::all_red, change.all_red, {}});
}

std::vector<Intergreen> intergreens(const std::vector<SignalRequest>& movements,
                                    const SignalRules& rules) {
  check_requests(movements, rules);
  std::vector<Intergreen> found;
  for (int i = 0; i < static_cast<int>(movements.size()); ++i) {
    for (const SignalRequest::Conflict& c : movements[i].conflicts)
      found.push_back({i, c.movement, false, false, intergreen(movements, i, c.movement, rules)});
    for (const SignalRequest::Walk& w : movements[i].walks) {
      found.push_back({i, w.walk, false, true, intergreen_to_walk(movements[i], w, rules)});
      found.push_back({w.walk, i, true, false, steps_up(w.seconds - rules.shortest_walk, rules)});
    }
  }
  return found;
}

}  // namespace streetgen
