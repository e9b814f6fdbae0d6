#include "ownership/street_claim.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace streetgen {
namespace street_claim_test {

// Whether the node at the first place comes before the one at the second.
bool comes_before(const std::vector<StreetAxis>& axes, const Point& first, const Point& second) {
  const StreetSettings settings;
  Layout layout(axes, settings, {});
  const auto& nodes = layout.streets.network.nodes;
  layout.streets.affected_nodes.assign(nodes.size(), true);
  const auto claim_at = [&](const Point& place) {
    const auto node = std::find_if(nodes.begin(), nodes.end(), [&](const Node& n) {
      return n.point.x == place.x && n.point.y == place.y;
    });
    return claim_of_intersection(layout, static_cast<int>(node - nodes.begin()));
  };
  return before(claim_at(first), claim_at(second));
}

// Side streets of 30 m and of 80 m at two nodes of one axis of 210 m.
TEST(Claim, OfNeighboursOnOneLongAxisGoByTheirOtherAxesUnderAnyNumbers) {
  const Point first{100, 0, 0}, second{110, 0, 0};
  std::vector<std::int64_t> numbers{1, 2, 3};
  do {
    const std::vector<StreetAxis> axes{
        {numbers[0], {{0, 0, 0}, first, second, {210, 0, 0}}, 0, 7, 7, 4},
        {numbers[1], {first, {100, 30, 0}}, 0, 7, 7, 4},
        {numbers[2], {{110, -80, 0}, second}, 0, 7, 7, 4}};
    EXPECT_FALSE(comes_before(axes, first, second)) << numbers[0] << numbers[1];
    EXPECT_TRUE(comes_before(axes, second, first)) << numbers[0] << numbers[1];
  } while (std::next_permutation(numbers.begin(), numbers.end()));
}

}  // namespace street_claim_test
}  // namespace streetgen
