#include <gtest/gtest.h>

#include <cmath>

#include "geometry/polyline.hpp"
#include "streetgen/walk_network.hpp"

namespace streetgen {
namespace {

// The corner of a block: one walks along two streets, 1 m behind their kerbs.
std::vector<WalkedKerb> corner() {
  return {{{{0, 0}, {50, 0}}, 1, false, {}},
          {{{50, 0}, {55, 5}}, 1, true, {}},
          {{{55, 5}, {55, 60}}, 1, false, {}}};
}

TEST(BuiltWalks, LieBehindTheKerbAndShareTheirEnds) {
  const auto walks = built_walks(corner(), {});
  ASSERT_EQ(walks.size(), 3u);
  EXPECT_NEAR(walks[0].line.front().y, 1, 1e-9);
  EXPECT_TRUE(same(walks[0].line.back(), walks[1].line.front()));
  EXPECT_TRUE(same(walks[1].line.back(), walks[2].line.front()));
  EXPECT_NEAR(walks[2].line.back().x, 54, 1e-9);
  for (const BuiltWalk& walk : walks) EXPECT_FALSE(walk.loose_start || walk.loose_end);
}

TEST(BuiltWalks, ACornerWhereNobodyWalksBehindOneStreetIsNotWalkedRound) {
  auto kerbs = corner();
  kerbs[2].offset = 0;
  EXPECT_EQ(built_walks(kerbs, {}).size(), 1u);
}

TEST(BuiltWalks, PartsOfOneCornerAreOneWalk) {
  auto kerbs = corner();
  kerbs[1].line = {{50, 0}, {52, 1}};
  kerbs.push_back({{{52, 1}, {55, 5}}, 1, true, {}});
  const auto walks = built_walks(kerbs, {});
  ASSERT_EQ(walks.size(), 3u);
  EXPECT_TRUE(same(walks[1].line.back(), walks[2].line.front()));
}

TEST(BuiltWalks, AMappedStretchHasNoWalkAndWhatEndsThereIsLoose) {
  auto kerbs = corner();
  kerbs[0].mapped = {{0, 50}};
  auto walks = built_walks(kerbs, {});
  ASSERT_EQ(walks.size(), 2u);
  EXPECT_EQ(walks[0].kerb, 1);
  EXPECT_TRUE(walks[0].loose_start);
  EXPECT_FALSE(walks[0].loose_end);
  kerbs[0].mapped = {{0, 20}};
  walks = built_walks(kerbs, {});
  ASSERT_EQ(walks.size(), 3u);
  EXPECT_TRUE(walks[0].loose_start);
  EXPECT_NEAR(length(walks[0].line), 30, 1);
  kerbs[0].mapped = {{0, 50}};
  kerbs[2].mapped = {{0, 55}};
  EXPECT_TRUE(built_walks(kerbs, {}).empty());
}

// The mouth of a street from below, at a street with walks.
std::vector<WalkedKerb> mouth(double offset) {
  return {{{{-60, 0}, {-5, 0}}, 1, false, {}},        {{{-5, 0}, {-3, -2}}, offset, true, {}},
          {{{-3, -2}, {-3, -50}}, offset, false, {}}, {{{3, -50}, {3, -2}}, offset, false, {}},
          {{{3, -2}, {5, 0}}, offset, true, {}},      {{{5, 0}, {60, 0}}, 1, false, {}}};
}

TEST(BuiltWalks, AnArmIsCrossedFromWalkToWalk) {
  // Seen along the kerbs the roadway lies on the right: they run round the block above as they are.
  const auto walks = built_walks(mouth(1), {{3, 2, {}}});
  const BuiltWalk& across = walks.back();
  ASSERT_EQ(across.arm, 0);
  EXPECT_EQ(across.line.size(), 2u);
  EXPECT_NEAR(std::abs(across.line[0].x - across.line[1].x), 4, 3);
}

TEST(BuiltWalks, AnArmWithoutWalksIsCrossedFromTheCornersBeside) {
  const auto walks = built_walks(mouth(0), {{3, 2, {}}});
  ASSERT_EQ(walks.size(), 3u);
  EXPECT_TRUE(same(walks[2].line[0], walks[1].line.front()));
  EXPECT_TRUE(same(walks[2].line[1], walks[0].line.back()));
}

TEST(BuiltWalks, AStreetWithAWalkBesideOneSideIsEnteredFromThere) {
  auto kerbs = mouth(0);
  kerbs[5].offset = 0;
  EXPECT_EQ(built_walks(kerbs, {{3, 2, {}}}).size(), 1u);
  const auto walks = built_walks(kerbs, {{3, 2, {{0, -60}, {0, 4}}}});
  ASSERT_EQ(walks.size(), 2u);
  EXPECT_NEAR(walks[1].line.back().x, 0, 1e-9);
}

TEST(BuiltWalks, TheCrossingBeforeABendLeadsOverTheEndOfTheStreetBeyond) {
  // A street with walks from the left ends at a bend; beyond it one walks on the roadway.
  const std::vector<WalkedKerb> kerbs{{{{-60, 4}, {-5, 4}}, 1, false, {}},
                                      {{{-5, 4}, {-2, 60}}, 0, false, {}},
                                      {{{2, 60}, {2, -4}, {-5, -4}}, 0, true, {}},
                                      {{{-5, -4}, {-60, -4}}, 1, false, {}}};
  const auto walks = built_walks(kerbs, {{0, 3, {{0, 0}, {0, 60}}}});
  ASSERT_EQ(walks.back().line.size(), 3u);
  EXPECT_NEAR(walks.back().line[1].x, 0, 1e-9);
}

TEST(BuiltWalks, ARingOfCornersAloneAndKerbsWithoutNeighboursEnd) {
  EXPECT_TRUE(built_walks({{{{0, 0}, {5, 0}}, 1, true, {}}, {{{5, 0}, {0, 0}}, 1, true, {}}},
                          {{0, 1, {}}, {-1, -1, {}}})
                  .empty());
}

}  // namespace
}  // namespace streetgen
