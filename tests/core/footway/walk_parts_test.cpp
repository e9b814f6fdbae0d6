#include <gtest/gtest.h>

#include "streetgen/walk_network.hpp"

namespace streetgen {
namespace {

TEST(WalkParts, LinksThatShareNodesAreOnePart) {
  EXPECT_EQ(walk_parts({{1, 2}, {3, 4}, {2, 5}, {6, 3}, {7, 7}}),
            (std::vector<int>{0, 1, 0, 1, 4}));
  EXPECT_EQ(walk_parts({{1, 2}, {3, 4}, {2, 3}}), (std::vector<int>{0, 0, 0}));
  EXPECT_TRUE(walk_parts({}).empty());
}

}  // namespace
}  // namespace streetgen
