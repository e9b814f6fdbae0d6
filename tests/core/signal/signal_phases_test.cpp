#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "streetgen/error.hpp"
#include "streetgen/signal.hpp"

namespace streetgen {
namespace signal_phases_test {

using Turn = SignalRequest::Turn;

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
      m.approach = from;
      m.exit = (from + step) % arms;
      m.turn = 2 * step == arms ? Turn::through : 2 * step < arms ? Turn::left : Turn::right;
      m.length = m.turn == Turn::right ? 8 : m.turn == Turn::through ? 20 : 22;
      movements.push_back(m);
      ends.push_back({2 * from, 2 * static_cast<int>(m.exit) + 1});
    }
  const auto between = [&](int x, int a, int b) { return a < b ? a < x && x < b : x > a || x < b; };
  for (std::size_t i = 0; i < movements.size(); ++i)
    for (std::size_t j = 0; j < movements.size(); ++j) {
      const Ends &a = ends[i], &b = ends[j];
      if (i == j || a.from == b.from) continue;
      const bool cross = between(b.from, a.from, a.to) != between(b.to, a.from, a.to);
      if (a.to == b.to || cross) movements[i].conflicts.push_back(static_cast<int>(j));
    }
  return movements;
}

void expect_sound(const std::vector<SignalRequest>& movements,
                  const std::vector<SignalState>& states) {
  std::vector<int> greens(movements.size());
  for (std::size_t s = 0; s < states.size(); ++s) {
    EXPECT_GT(states[s].duration, 0);
    if (states[s].kind != SignalKind::green) {
      EXPECT_TRUE(states[s].greens.empty());
      continue;
    }
    ASSERT_LT(s + 2, states.size());
    EXPECT_EQ(states[s + 1].kind, SignalKind::amber);
    EXPECT_EQ(states[s + 2].kind, SignalKind::all_red);
    for (const SignalState::Green& green : states[s].greens) {
      const SignalRequest& m = movements[green.movement];
      ++greens[green.movement];
      // Who enters at the end of amber has left at the end of all red, also at 30 km/h in a turn.
      const double speed = (m.turn == Turn::through ? m.speed : std::min(m.speed, 30.0)) / 3.6;
      EXPECT_GE(states[s + 2].duration * speed + 1e-9, m.length + 5);
      if (green.right_of_way == RightOfWay::permit) continue;
      for (const SignalState::Green& other : states[s].greens) {
        if (other.right_of_way == RightOfWay::permit) continue;
        EXPECT_EQ(std::count(m.conflicts.begin(), m.conflicts.end(), other.movement), 0);
      }
    }
  }
  for (const int count : greens) EXPECT_GE(count, 1);
}

TEST(SignalPhases, AreTwoAtACrossingOfTwoStreets) {
  const auto movements = crossing(4);
  const auto states = signal_phases(movements);
  expect_sound(movements, states);
  EXPECT_EQ(states.size(), 6u);
  for (const SignalState& state : states)
    for (const SignalState::Green& green : state.greens)
      EXPECT_EQ(green.right_of_way == RightOfWay::permit,
                movements[green.movement].turn == Turn::left);
}

// Of two turns as long as each other, into one street, the one that comes first is protected.
TEST(SignalPhases, GoByNoRounding) {
  for (const double noise : {1e-9, 0.0, -1e-9}) {
    std::vector<SignalRequest> movements(4);
    for (int i = 0; i < 4; ++i) {
      movements[i].approach = i % 2;
      movements[i].exit = i < 2 ? 2 + i : 4;
      movements[i].turn = i < 2 ? Turn::through : i == 2 ? Turn::left : Turn::right;
      movements[i].length = 20 + (i == 2 ? noise : 0);
    }
    movements[2].conflicts = {3}, movements[3].conflicts = {2};
    const auto states = signal_phases(movements);
    ASSERT_EQ(states.size(), 3u);
    ASSERT_EQ(states[0].greens.size(), 4u);
    EXPECT_EQ(states[0].greens[2].right_of_way, RightOfWay::protect);
    EXPECT_EQ(states[0].greens[3].right_of_way, RightOfWay::permit);
  }
}

TEST(SignalPhases, ServeCrossingsOfManyArms) {
  for (int arms = 3; arms <= 20; ++arms) {
    const auto movements = crossing(arms);
    expect_sound(movements, signal_phases(movements));
    expect_sound(movements, signal_pairs(movements));
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
      m.turn = static_cast<Turn>(random() % 4);
      m.length = random() % 60;
      m.speed = 10 + random() % 120;
      m.lanes = 1 + random() % 4;
      m.importance = 1 + random() % 9;
      for (std::size_t j = 0; j < i; ++j)
        if (movements[j].approach != m.approach && random() % 3 == 0) {
          m.conflicts.push_back(static_cast<int>(j));
          movements[j].conflicts.push_back(static_cast<int>(i));
        }
    }
    expect_sound(movements, signal_phases(movements));
    expect_sound(movements, signal_pairs(movements));
  }
}

// Webster: a cycle of (1.5 L + 5) / (1 - Y), greens as y.
TEST(SignalPhases, ShareGreenByFlows) {
  auto movements = crossing(4);
  for (SignalRequest& m : movements) m.flow = m.approach % 2 == 0 ? 600 : 300;
  const auto states = signal_phases(movements);
  double cycle = 0, lost = 0;
  std::map<bool, double> greens;
  for (const SignalState& state : states) {
    cycle += state.duration;
    if (state.kind != SignalKind::green)
      lost += state.duration;
    else
      greens[movements[state.greens.front().movement].approach % 2 == 0] = state.duration;
  }
  EXPECT_NEAR(cycle, (1.5 * lost + 5) / (1 - 900.0 / 1800), 1.01);
  EXPECT_NEAR(greens[true] / greens[false], 2, 0.15);
}

TEST(SignalPhases, LastAsLongAsPeopleNeed) {
  auto movements = crossing(4);
  for (SignalRequest& m : movements) (m.approach % 2 == 0 ? m.walk_in : m.walk_out) = 41;
  for (const SignalState& state : signal_phases(movements))
    EXPECT_GE(state.duration, state.kind == SignalKind::green ? 41 : 0);
  const std::vector<SignalRequest> one = {movements.front()};
  SignalRequest alone = one.front();
  alone.conflicts.clear();
  const auto states = signal_phases({alone});
  EXPECT_GE(states.back().duration, 41);
}

TEST(SignalPhases, OfThePaperTakeTwentySecondsAPair) {
  for (int arms = 3; arms <= 6; ++arms) {
    double cycle = 0;
    for (const SignalState& state : signal_pairs(crossing(arms))) cycle += state.duration;
    EXPECT_NEAR(cycle, 20 * arms * (arms - 1) / 2, 1e-9);
  }
}

TEST(SignalPhases, OfNothingAreNone) {
  EXPECT_TRUE(signal_phases({}).empty());
  EXPECT_TRUE(signal_pairs({}).empty());
}

TEST(SignalPhases, RefuseWhatIsNoNumber) {
  for (const double bad : {std::nan(""), -1.0, std::numeric_limits<double>::infinity()}) {
    SignalRequest m;
    m.speed = bad;
    EXPECT_THROW(signal_phases({m}), Error);
    m.speed = 50;
    m.length = bad;
    EXPECT_THROW(signal_pairs({m}), Error);
  }
  SignalRequest m;
  m.conflicts = {3};
  EXPECT_THROW(signal_phases({m}), Error);
}

}  // namespace signal_phases_test
}  // namespace streetgen
