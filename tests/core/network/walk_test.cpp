#include "network/walk.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace streetgen {
namespace walk_test {

Network network_of(const std::vector<Line>& lines, const std::vector<int>& levels = {}) {
  std::vector<NetworkAxis> axes;
  for (std::size_t i = 0; i < lines.size(); ++i)
    axes.push_back({static_cast<std::int64_t>(i + 1), lines[i], levels.empty() ? 0 : levels[i]});
  return network(axes, 0.1, Crossing::over);
}

bool all(const Edge&) { return true; }

TEST(Walks, GoAboutASquareAndItsOutside) {
  const auto found = walks(
      network_of({{{0, 0}, {10, 0}}, {{10, 0}, {10, 10}}, {{10, 10}, {0, 10}}, {{0, 10}, {0, 0}}}),
      all);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].size(), 4u);
  EXPECT_TRUE(found[0][0].at_start);
  EXPECT_EQ(found[0][1].edge, 1);  // the ground lies on the left
  EXPECT_FALSE(found[1][0].at_start);
}

TEST(Walks, GoToADeadEndAndBack) {
  const auto found = walks(network_of({{{0, 0}, {10, 0}}, {{10, 0}, {20, 5}}}), all);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].size(), 4u);
}

TEST(Walks, TakeALevelForItselfOrAllTogether) {
  const Network network =
      network_of({{{0, 0}, {10, 0}, {10, 10}}, {{10, 10}, {0, 10}, {0, 0}}}, {0, 1});
  const auto on_level = [](int level) {
    return [level](const Edge& edge) { return edge.level == level; };
  };
  EXPECT_EQ(walks(network, on_level(0)).size(), 1u);
  EXPECT_EQ(walks(network, on_level(1)).size(), 1u);
  EXPECT_EQ(walks(network, all).size(), 2u);
  EXPECT_TRUE(walks(network, on_level(7)).empty());
}

// Euler: without crossings, nodes - edges + walks = 1 + pieces. Each side of an edge is walked
// once.
TEST(Walks, AreAsManyAsEulerSays) {
  std::mt19937_64 random(11);
  for (int turn = 0; turn < 50; ++turn) {
    // A grid of which streets are missing; crossings are nodes as lines are cut there.
    std::vector<Line> lines;
    for (int x = 0; x < 6; ++x)
      for (int y = 0; y < 6; ++y) {
        const Point p{50.0 * x, 50.0 * y};
        if (random() % 4 > 0) lines.push_back({p, {p.x + 50, p.y}});
        if (random() % 4 > 0) lines.push_back({p, {p.x, p.y + 50}});
        if (random() % 4 == 0) lines.push_back({p, {p.x + 50, p.y + 50}});
      }
    const Network network = network_of(lines);
    std::vector<int> piece(network.nodes.size());
    for (std::size_t n = 0; n < piece.size(); ++n) piece[n] = static_cast<int>(n);
    for (bool changed = true; changed;) {
      changed = false;
      for (const Edge& edge : network.edges) {
        const int low = std::min(piece[edge.from_node], piece[edge.to_node]);
        for (const int n : {edge.from_node, edge.to_node})
          if (piece[n] != low) piece[n] = low, changed = true;
      }
    }
    int pieces = 0;
    for (std::size_t n = 0; n < piece.size(); ++n) pieces += piece[n] == static_cast<int>(n);
    const auto found = walks(network, all);
    std::map<int, int> times;
    for (const Walk& walk : found)
      for (const EdgeEnd& step : walk) ++times[slot(step)];
    EXPECT_EQ(times.size(), 2 * network.edges.size());
    for (const auto& [side, count] : times) EXPECT_EQ(count, 1) << side;
    // Each piece has an outside of its own.
    EXPECT_EQ(static_cast<int>(network.nodes.size()) - static_cast<int>(network.edges.size()) +
                  static_cast<int>(found.size()),
              2 * pieces);
  }
}

}  // namespace walk_test
}  // namespace streetgen
