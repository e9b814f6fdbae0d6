#include "geometry/box_index.hpp"

#include <gtest/gtest.h>

namespace streetgen {
namespace box_index_test {

const Box square{0, 0, 1, 1};

TEST(BoxIndex, KeepsABoxThatHoldsNothingOut) {
  BoxIndex index({Box{}, square, Box{}});
  index.add(Box{}, 3);
  index.add(square, 4);
  EXPECT_EQ(index.near(square, 0), (std::vector<int>{1, 4}));
  EXPECT_EQ(index.near(square, 1e9), (std::vector<int>{1, 4}));
}

TEST(BoxIndex, OfBoxesThatHoldNothingFindsNone) {
  const BoxIndex index({Box{}, Box{}});
  EXPECT_TRUE(index.near(square, 1e9).empty());
}

TEST(BoxIndex, FindsNothingNearABoxThatHoldsNothing) {
  const BoxIndex index({square, Box{5, 5, 6, 6}});
  EXPECT_TRUE(index.near(Box{}, 10).empty());
  EXPECT_FALSE(index.any_near(Box{}, 10, [](int) { return true; }));
}

// A vertex or a level segment is a place, though it has no ground.
TEST(BoxIndex, FindsABoxWithoutExtent) {
  const BoxIndex index({Box{2, 2, 2, 2}, Box{0, 3, 5, 3}});
  EXPECT_EQ(index.near(square, 2), (std::vector<int>{0, 1}));
}

}  // namespace box_index_test
}  // namespace streetgen
