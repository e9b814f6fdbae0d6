#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

#include "rounds.hpp"
#include "streetgen/error.hpp"
#include "streetgen/signal.hpp"

namespace streetgen {
namespace signal_phases_test {

using Turn = SignalRequest::Turn;

const SignalRules usual;

// A crossing of `arms` streets with a lane each way, every turn but back. Two movements meet where
// their chords in the circle of ends cross, or where they lead to one street.
std::vector<SignalRequest> crossing(int arms) {
  std::vector<SignalRequest> movements;
  struct Ends {
    int from, to;
  };
  std::vector<Ends> ends;
  for (int from = 0; from < arms; ++from)
    for (int step = 1; step < arms; ++step) {
      SignalRequest m;
      m.approach = m.lane = from;
      m.exit = (from + step) % arms;
      m.turn = 2 * step == arms ? Turn::through : 2 * step < arms ? Turn::left : Turn::right;
      m.length = m.turn == Turn::right ? 8 : m.turn == Turn::through ? 20 : 22;
      m.precedence = m.turn == Turn::through ? 0 : static_cast<int>(m.length);
      movements.push_back(m);
      ends.push_back({2 * from, 2 * static_cast<int>(m.exit) + 1});
    }
  const auto between = [&](int x, int a, int b) { return a < b ? a < x && x < b : x > a || x < b; };
  for (std::size_t i = 0; i < movements.size(); ++i)
    for (std::size_t j = 0; j < movements.size(); ++j) {
      const Ends &a = ends[i], &b = ends[j];
      if (i == j || a.from == b.from) continue;
      const bool cross = between(b.from, a.from, a.to) != between(b.to, a.from, a.to);
      if (a.to == b.to || cross)
        movements[i].conflicts.push_back({static_cast<int>(j), movements[i].length * 0.6});
    }
  return movements;
}

bool meet(const std::vector<SignalRequest>& movements, int a, int b) {
  const auto& conflicts = movements[a].conflicts;
  return std::any_of(conflicts.begin(), conflicts.end(),
                     [&](const auto& c) { return c.movement == b; });
}

double cycle_of(const std::vector<SignalState>& states) {
  double cycle = 0;
  for (const SignalState& state : states) cycle += state.duration;
  return cycle;
}

// The green state that comes next, and the seconds until then.
std::pair<std::size_t, double> next_green(const std::vector<SignalState>& states, std::size_t s) {
  double between = 0;
  for (std::size_t step = 1; step <= states.size(); ++step) {
    const std::size_t at = (s + step) % states.size();
    if (states[at].kind == SignalKind::green) return {at, between};
    between += states[at].duration;
  }
  return {s, between};
}

void expect_clear(const std::vector<SignalRequest>& movements,
                  const std::vector<SignalState>& states, std::size_t s) {
  const auto [next, between] = next_green(states, s);
  if (next == s || states[s + 2].duration >= usual.longest_all_red) return;
  const auto within = [&](std::size_t state, int movement) {
    const auto& greens = states[state].greens;
    return std::any_of(greens.begin(), greens.end(),
                       [&](const auto& g) { return g.movement == movement; });
  };
  for (const Intergreen& i : intergreens(movements, usual))
    if (!i.ends_on_foot && !i.begins_on_foot && within(s, i.ends) && within(next, i.begins) &&
        !within(s, i.begins) && !within(next, i.ends)) {
      EXPECT_GE(between + 1e-9, i.seconds);
    }
}

void expect_rights_of_way(const std::vector<SignalRequest>& movements, const SignalState& state) {
  for (const SignalState::Green& a : state.greens)
    for (const SignalState::Green& b : state.greens)
      if (a.right_of_way == RightOfWay::protect && b.right_of_way == RightOfWay::protect) {
        EXPECT_FALSE(a.movement != b.movement && meet(movements, a.movement, b.movement));
      }
}

void expect_sound(const std::vector<SignalRequest>& movements,
                  const std::vector<SignalState>& states) {
  std::set<int> served;
  for (std::size_t s = 0; s < states.size(); ++s) {
    EXPECT_GT(states[s].duration, 0);
    EXPECT_NEAR(states[s].duration, std::round(states[s].duration), 1e-9);
    if (states[s].kind != SignalKind::green) {
      EXPECT_TRUE(states[s].greens.empty());
      continue;
    }
    ASSERT_LT(s + 2, states.size());
    EXPECT_EQ(states[s + 1].kind, SignalKind::amber);
    EXPECT_EQ(states[s + 2].kind, SignalKind::all_red);
    EXPECT_LE(states[s + 2].duration, usual.longest_all_red);
    for (const SignalState::Green& green : states[s].greens) served.insert(green.movement);
    expect_clear(movements, states, s);
    expect_rights_of_way(movements, states[s]);
  }
  EXPECT_EQ(served.size(), movements.size());
}

TEST(SignalPhases, AreTwoAtACrossingOfTwoStreets) {
  const auto movements = crossing(4);
  const auto states = signal_phases(movements, usual);
  expect_sound(movements, states);
  EXPECT_EQ(states.size(), 6u);
  for (const SignalState& state : states)
    for (const SignalState::Green& green : state.greens)
      EXPECT_EQ(green.right_of_way == RightOfWay::permit,
                movements[green.movement].turn == Turn::left);
}

// Of two turns into one street the one that goes first is protected.
TEST(SignalPhases, GoByPrecedence) {
  std::vector<SignalRequest> movements(4);
  for (int i = 0; i < 4; ++i) {
    movements[i].approach = i % 2;
    movements[i].exit = i < 2 ? 2 + i : 4;
    movements[i].turn = i < 2 ? Turn::through : i == 2 ? Turn::left : Turn::right;
    movements[i].precedence = i == 2 ? 3 : i == 3 ? 2 : i;
  }
  movements[2].conflicts = {{3, 5}}, movements[3].conflicts = {{2, 5}};
  const auto states = signal_phases(movements, usual);
  ASSERT_EQ(states.size(), 3u);
  ASSERT_EQ(states[0].greens.size(), 4u);
  EXPECT_EQ(states[0].greens[2].right_of_way, RightOfWay::permit);
  EXPECT_EQ(states[0].greens[3].right_of_way, RightOfWay::protect);
}

TEST(SignalPhases, ServeCrossingsOfManyArms) {
  for (int arms = 3; arms <= 5 + rounds(15); ++arms) {
    const auto movements = crossing(arms);
    const auto states = signal_phases(movements, usual);
    expect_sound(movements, states);
    EXPECT_LE(cycle_of(states), 120);
    expect_sound(movements, signal_pairs(movements, usual));
  }
}

TEST(SignalPhases, ServeWhateverMeets) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<SignalRequest> movements(1 + random() % 14);
    for (std::size_t i = 0; i < movements.size(); ++i) {
      SignalRequest& m = movements[i];
      m.approach = random() % 5;
      m.exit = random() % 5;
      m.lane = static_cast<int>(m.approach) * 3 + random() % 3;
      m.turn = static_cast<Turn>(random() % 4);
      m.length = random() % 60;
      m.speed = 10 + random() % 120;
      m.lanes = 1 + random() % 4;
      m.importance = 1 + random() % 9;
      m.precedence = static_cast<int>(i);
      if (random() % 4 == 0)
        m.walks.push_back({static_cast<int>(random() % 3), 5.0 + random() % 60, 0});
      for (std::size_t j = 0; j < i; ++j)
        if (movements[j].approach != m.approach && random() % 3 == 0) {
          const double reach = random() % 60;
          m.conflicts.push_back({static_cast<int>(j), reach});
          movements[j].conflicts.push_back({static_cast<int>(i), reach / 2});
        }
    }
    const auto states = signal_phases(movements, usual);
    expect_sound(movements, states);
    EXPECT_LE(cycle_of(states), 120);
    expect_sound(movements, signal_pairs(movements, usual));
  }
}

// What ends counts against what begins next: a long way to leave by, and a long one to come by.
TEST(SignalPhases, AreAllRedForPairs) {
  std::vector<SignalRequest> movements(2);
  for (int i = 0; i < 2; ++i) {
    movements[i].approach = movements[i].lane = i;
    movements[i].exit = 2 + i;
    movements[i].length = 60;
    movements[i].conflicts = {{1 - i, 50}};
  }
  const auto both_far = signal_phases(movements, usual);
  EXPECT_EQ(both_far[2].duration, 1);
  movements[1].conflicts = {{0, 5}};
  const auto near = signal_phases(movements, usual);
  // 55 m at 50 km/h are 3.96 s, less 5 m; the other way about nobody is late.
  EXPECT_EQ(near[2].duration, 4);
  EXPECT_EQ(near[5].duration, 1);
}

// The one order takes least where all red is cut, and cuts a change of 16 s; the other one none.
TEST(SignalPhases, FollowEachOtherSoThatNoChangeLacksTime) {
  std::vector<SignalRequest> movements(3);
  for (int i = 0; i < 3; ++i) {
    movements[i].approach = movements[i].lane = i;
    movements[i].exit = 3 + i;
    movements[i].length = 140;
    movements[i].speed = 30;
  }
  movements[0].conflicts = {{1, 133}, {2, 33}};
  movements[1].conflicts = {{0, 5}, {2, 5}};
  movements[2].conflicts = {{0, 5}, {1, 33}};
  std::vector<double> all_red;
  std::vector<int> greens;
  for (const SignalState& state : signal_phases(movements, usual)) {
    if (state.kind == SignalKind::all_red) all_red.push_back(state.duration);
    for (const SignalState::Green& green : state.greens) greens.push_back(green.movement);
  }
  EXPECT_EQ(greens, (std::vector<int>{0, 2, 1}));
  EXPECT_EQ(all_red, (std::vector<double>{4, 4, 1}));
}

// Two lanes that turn across, three lanes across, 70 km/h: each alone asks for a phase.
TEST(SignalPhases, GiveTurnsAPhase) {
  const auto approach = [](int from, int lanes, int turning, double speed) {
    std::vector<SignalRequest> movements;
    for (int lane = 0; lane < lanes + turning; ++lane) {
      SignalRequest m;
      m.approach = from, m.exit = lane < lanes ? 2 + from : 4;
      m.lane = 10 * from + lane;
      m.turn = lane < lanes ? Turn::through : Turn::left;
      m.precedence = lane < lanes ? 0 : 1;
      m.length = 20, m.lanes = lanes + turning, m.speed = speed;
      movements.push_back(m);
    }
    return movements;
  };
  const auto states = [&](int lanes, int turning, double speed, std::optional<bool> by_hand) {
    std::vector<SignalRequest> movements = approach(0, 1, turning, speed);
    for (const SignalRequest& m : approach(1, lanes, 0, speed)) movements.push_back(m);
    for (int i = 1; i <= turning; ++i)
      for (int j = 1 + turning; j < static_cast<int>(movements.size()); ++j)
        movements[i].conflicts.push_back({j, 10}), movements[j].conflicts.push_back({i, 10});
    SignalRules rules;
    rules.turn_phases = by_hand;
    const auto found = signal_phases(movements, rules);
    expect_sound(movements, found);
    return found.size();
  };
  EXPECT_EQ(states(2, 1, 50, {}), 3u);
  EXPECT_EQ(states(2, 2, 50, {}), 6u);
  EXPECT_EQ(states(3, 1, 50, {}), 6u);
  EXPECT_EQ(states(2, 1, 70, {}), 6u);
  EXPECT_EQ(states(2, 1, 50, true), 6u);
  EXPECT_EQ(states(3, 2, 70, false), 3u);
}

// A drive goes with others, and gives way to all of them that it meets.
TEST(SignalPhases, AreNoneOfADrive) {
  auto movements = crossing(4);
  for (SignalRequest& m : movements)
    if (m.approach == 3) m.importance = 6, m.precedence += 100;
  const auto states = signal_phases(movements, usual);
  expect_sound(movements, states);
  for (const SignalState& state : states) {
    if (state.kind != SignalKind::green) continue;
    EXPECT_TRUE(std::any_of(state.greens.begin(), state.greens.end(),
                            [&](const auto& g) { return movements[g.movement].approach != 3; }));
    for (const SignalState::Green& a : state.greens)
      for (const SignalState::Green& b : state.greens)
        if (movements[a.movement].approach == 3 && b.right_of_way == RightOfWay::protect &&
            meet(movements, a.movement, b.movement)) {
          EXPECT_EQ(a.right_of_way, RightOfWay::permit);
        }
  }
}

// Webster: a cycle of (1.5 L + 5) / (1 - Y), greens as y.
TEST(SignalPhases, ShareGreenByFlows) {
  auto movements = crossing(4);
  for (SignalRequest& m : movements) m.flow = m.approach % 2 == 0 ? 600 : 300;
  const auto states = signal_phases(movements, usual);
  double lost = 0;
  std::map<bool, double> greens;
  for (const SignalState& state : states) {
    if (state.kind != SignalKind::green)
      lost += state.duration;
    else
      greens[movements[state.greens.front().movement].approach % 2 == 0] = state.duration;
  }
  EXPECT_NEAR(cycle_of(states), (1.5 * lost + 5) / (1 - 900.0 / 1800), 1.01);
  EXPECT_NEAR(greens[true] / greens[false], 2, 0.2);
}

TEST(SignalPhases, HoldWithNoTrafficAndTooMuch) {
  for (const double flow : {0.0, 1.0, 1e6}) {
    auto movements = crossing(4);
    for (SignalRequest& m : movements) m.flow = flow;
    const auto states = signal_phases(movements, usual);
    expect_sound(movements, states);
    EXPECT_GE(cycle_of(states), 22);
    EXPECT_LE(cycle_of(states), 120);
  }
}

// People cross the one street while the other one has green, from its start to the start of the
// one that they cross.
TEST(SignalPhases, LastAsLongAsPeopleNeed) {
  auto movements = crossing(4);
  for (SignalRequest& m : movements) {
    m.walks.push_back({static_cast<int>(m.approach), 41, 0});
    if (m.turn == Turn::through) m.walks.push_back({static_cast<int>(m.exit), 41, m.length});
  }
  const auto states = signal_phases(movements, usual);
  expect_sound(movements, states);
  for (std::size_t s = 0; s < states.size(); ++s)
    if (states[s].kind == SignalKind::green) {
      EXPECT_GE(states[s].duration + next_green(states, s).second, 41);
    }
}

TEST(SignalPhases, HaveAStateForPeopleWhereNoPhaseHasRoom) {
  SignalRequest alone;
  alone.walks.push_back({0, 14, 0});
  const auto states = signal_phases({alone}, usual);
  ASSERT_EQ(states.size(), 4u);
  EXPECT_EQ(states.back().kind, SignalKind::walk);
  EXPECT_GE(states.back().duration, 14);
}

// Where the longest cycle is too short for phases, they become one; a walk that is too long goes.
TEST(SignalPhases, GiveWayToTheLongestCycle) {
  SignalRules rules;
  rules.longest_cycle = 30;
  const auto movements = crossing(5);
  const auto states = signal_phases(movements, rules);
  expect_sound(movements, states);
  EXPECT_LE(cycle_of(states), 30);
  SignalRequest alone;
  alone.walks.push_back({0, 54, 0});
  EXPECT_LE(cycle_of(signal_phases({alone}, rules)), 30);
  EXPECT_GE(cycle_of(signal_phases({alone}, usual)), 54);
}

TEST(SignalPhases, OfThePaperTakeTwentySecondsAPair) {
  for (int arms = 3; arms <= 6; ++arms)
    EXPECT_NEAR(cycle_of(signal_pairs(crossing(arms), usual)), 20 * arms * (arms - 1) / 2, 1e-9);
}

TEST(SignalPhases, OfNothingAreNone) {
  EXPECT_TRUE(signal_phases({}, usual).empty());
  EXPECT_TRUE(signal_pairs({}, usual).empty());
  EXPECT_TRUE(intergreens({}, usual).empty());
}

TEST(SignalPhases, RefuseWhatIsNoNumber) {
  for (const double bad : {std::nan(""), -1.0, std::numeric_limits<double>::infinity()}) {
    SignalRequest m;
    m.speed = bad;
    EXPECT_THROW(signal_phases({m}, usual), Error);
    m.speed = 50;
    m.length = bad;
    EXPECT_THROW(signal_pairs({m}, usual), Error);
    SignalRules rules;
    rules.longest_cycle = bad;
    EXPECT_THROW(signal_phases({SignalRequest()}, rules), Error);
  }
  SignalRequest m;
  m.conflicts = {{3, 0}};
  EXPECT_THROW(signal_phases({m}, usual), Error);
}

// 22 m to where they meet and a car at 50 km/h, less 9 m: 1.3 s after amber of 3.3 s.
TEST(Intergreen, FollowsThePaths) {
  std::vector<SignalRequest> movements(2);
  movements[0].conflicts = {{1, 22}}, movements[1].conflicts = {{0, 9}};
  SignalRules rules;
  rules.step = 0.1;
  const auto found = intergreens(movements, rules);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].seconds, 3.4 + 1.3, 0.1001);
}

}  // namespace signal_phases_test
}  // namespace streetgen
