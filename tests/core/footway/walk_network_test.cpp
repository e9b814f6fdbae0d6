#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "geometry/polyline.hpp"
#include "streetgen/walk_network.hpp"

namespace streetgen {
namespace {

WalkLine mapped(Line line, double reach = 0, double excess = 0) {
  return {std::move(line), 0, true, excess, excess, reach, reach};
}
WalkLine built(Line line) { return {std::move(line), 0, false, 0, 0, 0, 0}; }

TEST(WalkNetwork, MappedLinesMeetAtVerticesThatTheyShare) {
  const auto links = walk_network(
      {mapped({{0, 0}, {10, 0}, {20, 0}}), mapped({{10, 0}, {10, 9}}), mapped({{5, -5}, {5, 5}})});
  ASSERT_EQ(links.size(), 4u);
  EXPECT_EQ(links[0].to_node, links[1].from_node);
  EXPECT_EQ(links[0].to_node, links[2].from_node);
  EXPECT_EQ(links[0].part, 1);
  EXPECT_EQ(links[1].part, 2);
  EXPECT_EQ(links[1].parts, 2);
}

TEST(WalkNetwork, LinesOfTwoLevelsMeetAtAVertexAndDoNotCross) {
  WalkLine above = built({{5, -5}, {5, 5}});
  above.level = 1;
  EXPECT_EQ(walk_network({mapped({{0, 0}, {10, 0}}), above}).size(), 2u);
  above.line = {{10, 0}, {10, 5}};
  const auto links = walk_network({mapped({{0, 0}, {10, 0}}), above});
  EXPECT_EQ(links[0].to_node, links[1].from_node);
}

TEST(WalkNetwork, WhatIsBuiltMeetsWhatItCrosses) {
  EXPECT_EQ(walk_network({mapped({{0, 0}, {10, 0}}), built({{5, -5}, {5, 5}})}).size(), 4u);
  EXPECT_EQ(walk_network({built({{0, 0}, {10, 0}}), built({{5, -5}, {5, 5}})}).size(), 4u);
  // Beside an end it is that end.
  const auto links = walk_network({mapped({{0, 0}, {10, 0}}), built({{9.8, -5}, {9.8, 5}})});
  ASSERT_EQ(links.size(), 3u);
  EXPECT_EQ(links[0].to_node, links[1].to_node);
}

TEST(WalkNetwork, AnEndThatRoundingLeftBesideALineMeetsIt) {
  for (const double beside : {-1e-9, 0.0, 1e-9, 5e-3}) {
    const Line across{{3, 40}, {3 - beside, 0}}, along{{0, beside}, {10, 0}};
    EXPECT_EQ(walk_network({built(across), built(along)}).size(), 3u);
    EXPECT_EQ(walk_network({mapped(along), built(across)}).size(), 3u);
  }
  EXPECT_EQ(walk_network({built({{3, 40}, {3, 0.1}}), built({{0, 0}, {10, 0}})}).size(), 2u);
}

TEST(WalkNetwork, ALooseEndIsLedOnToTheNearestLineAhead) {
  const auto links = walk_network(
      {mapped({{0, 0}, {8, 0}}, 3), built({{10, -5}, {10, 5}}), built({{-9, 0}, {-9, 5}})});
  ASSERT_EQ(links.size(), 4u);
  EXPECT_NEAR(length(links[0].geometry), 10, 1e-9);
  EXPECT_EQ(links[0].to_node, links[1].to_node);
  // One on another level comes after one on the same, and is none of what is built.
  WalkLine above = built({{9, -5}, {9, 5}});
  above.level = 1;
  EXPECT_NEAR(length(walk_network({mapped({{0, 0}, {8, 0}}, 3), above})[0].geometry), 9, 1e-9);
  EXPECT_NEAR(
      length(walk_network({mapped({{0, 0}, {8, 0}}, 3), above, built({{10, -5}, {10, 5}})})[0]
                 .geometry),
      10, 1e-9);
  WalkLine below = built({{0, 0}, {8, 0}});
  below.reach_end = 3;
  EXPECT_NEAR(length(walk_network({below, above})[0].geometry), 8, 1e-9);
}

TEST(WalkNetwork, AnEndThatIsLedOnIsANodeWhereAnotherIsLedOnToIt) {
  // The first is led on to the second, and the third to the first.
  const auto links = walk_network(
      {mapped({{0, 0}, {10, 0}}, 3), built({{12, -9}, {12, 9}}), mapped({{10, -30}, {10, -2}}, 2)});
  std::set<std::pair<double, double>> ends;
  for (const WalkLink& link : links)
    if (link.line == 0) ends.insert({link.geometry.front().x, link.geometry.back().x});
  EXPECT_EQ(ends, (std::set<std::pair<double, double>>{{0, 10}, {10, 12}}));
  EXPECT_EQ(links.size(), 5u);
}

TEST(WalkNetwork, WhatLeadsBeyondTheLastWalkIsCutOff) {
  const auto cut = walk_network({mapped({{0, 0}, {20, 0}}, 0, 6), built({{15, -5}, {15, 5}})});
  ASSERT_EQ(cut.size(), 3u);
  EXPECT_NEAR(length(cut[0].geometry), 15, 1e-9);
  EXPECT_EQ(walk_network({mapped({{0, 0}, {20, 0}}, 0, 4), built({{15, -5}, {15, 5}})}).size(), 4u);
}

TEST(WalkNetwork, ALooseEndDoesNotTurnBackToWhatItsLineCrosses) {
  const auto links = walk_network({mapped({{0, 0}, {20, 0}}, 12), built({{18.5, -5}, {18.5, 5}})});
  ASSERT_EQ(links.size(), 4u);
  for (const WalkLink& link : links) EXPECT_NE(link.from_node, link.to_node);
}

TEST(WalkNetwork, TwoLinesOfOneShapeAreOneLinkAndThoseWithoutLengthNone) {
  EXPECT_EQ(walk_network({built({{0, 0}, {9, 0}}), built({{0, 0}, {9, 0}})}).size(), 1u);
  EXPECT_TRUE(walk_network({built({{0, 0}, {0, 0}}), mapped({{1, 1}})}).empty());
  EXPECT_TRUE(walk_network({}).empty());
}

TEST(WalkNetwork, EndsNearerThanACentimetreAreOneNode) {
  const auto links =
      walk_network({mapped({{0, 0}, {10, 0}}), mapped({{10, 1e-6}, {20, 0}}),
                    mapped({{10 + 1e-6, 0}, {10, -9}}), built({{10, 0}, {10 + 1e-6, 0}})});
  ASSERT_EQ(links.size(), 3u);
  EXPECT_EQ(links[0].to_node, links[1].from_node);
  EXPECT_EQ(links[0].to_node, links[2].from_node);
  EXPECT_TRUE(same(links[0].geometry.back(), links[1].geometry.front()));
  // The order of lines says nothing about the node.
  const auto turned = walk_network({mapped({{10, 1e-6}, {20, 0}}), mapped({{0, 0}, {10, 0}})});
  EXPECT_EQ(turned[1].to_node, links[0].to_node);
  EXPECT_EQ(turned[0].from_node, links[0].to_node);
}

TEST(WalkNetwork, EndsOfTwoLevelsThatAreNearAreTwoNodes) {
  WalkLine above = mapped({{10, 1e-6}, {20, 0}});
  above.level = 1;
  const auto links = walk_network({mapped({{0, 0}, {10, 0}}), above});
  ASSERT_EQ(links.size(), 2u);
  EXPECT_NE(links[0].to_node, links[1].from_node);
}

TEST(WalkNetwork, ALoopIsALinkUnlessItLiesWithinACentimetre) {
  const auto links = walk_network({mapped({{0, 0}, {9, 0}, {9, 9}, {0, 1e-3}})});
  ASSERT_EQ(links.size(), 1u);
  EXPECT_EQ(links[0].from_node, links[0].to_node);
  EXPECT_TRUE(walk_network({mapped({{0, 0}, {2e-3, 0}, {2e-3, 2e-3}, {0, 1e-3}})}).empty());
}

TEST(WalkNetwork, OfRandomLinesNodesAreEndsLengthStaysAndIdsAreOnce) {
  std::mt19937 random(48);
  std::uniform_real_distribution<double> place(0, 100);
  std::vector<WalkLine> lines;
  double metres = 0;
  for (int i = 0; i < 60; ++i) {
    Line line;
    for (int p = 0; p < 4; ++p) line.push_back({place(random), place(random)});
    lines.push_back(i % 2 == 0 ? mapped(line) : built(line));
    metres += length(line);
  }
  const auto links = walk_network(lines);
  double sum = 0;
  std::set<std::int64_t> ids;
  for (const WalkLink& link : links) {
    sum += length(link.geometry);
    EXPECT_TRUE(ids.insert(link.id).second);
    EXPECT_GE(link.from_node, 0);
    EXPECT_GT(length(link.geometry), 0.01);
  }
  // A crossing beside an end or a vertex bends its line there.
  EXPECT_NEAR(sum, metres, 60);
  EXPECT_GT(links.size(), 500u);
}

}  // namespace
}  // namespace streetgen
