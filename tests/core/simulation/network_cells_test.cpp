#include "streetgen/network_cells.hpp"

#include <gtest/gtest.h>

#include "simulation/made_network.hpp"
#include "streetgen/error.hpp"

namespace streetgen {
namespace simulation_test {

TEST(NetworkCells, CutLinksAndLeadFromOneToTheNext) {
  NetworkMaker maker;
  const int from = maker.lane(34), to = maker.lane(4), across = maker.movement(from, to, 12);
  const NetworkCells cells = cells_of(maker.network(), 10);
  EXPECT_EQ(cells.first, (std::vector<std::int32_t>{0, 3, 4, 5}));
  EXPECT_DOUBLE_EQ(cells.cells[2].from, 34 * 2 / 3.);
  EXPECT_DOUBLE_EQ(cells.cells[2].to, 34);
  ASSERT_EQ(cells.next.of(2).size(), 1);
  EXPECT_EQ(cells.next.of(2)[0], cells.first[across]);
  EXPECT_EQ(cells.next.of(cells.first[across])[0], cells.first[to]);
  EXPECT_EQ(cells.before.of(cells.first[to])[0], cells.first[across]);
  EXPECT_TRUE(cells.next.of(cells.first[to]).empty());
  EXPECT_TRUE(cells.before.of(0).empty());
}

TEST(NetworkCells, KnowThoseBeside) {
  NetworkMaker maker;
  const int right = maker.lane(40), left = maker.lane(20);
  maker.beside(right, {left, true, true, false, 20, 40, 0, 20});
  maker.beside(left, {right, false, false, false, 0, 20, 20, 40});
  const NetworkCells cells = cells_of(maker.network(), 10);
  EXPECT_EQ(cells.left[1].cell, -1);
  EXPECT_EQ(cells.left[3].cell, 5);
  EXPECT_TRUE(cells.left[3].may_change);
  EXPECT_EQ(cells.right[4].cell, 2);
  EXPECT_FALSE(cells.right[4].may_change);
}

TEST(NetworkCells, RefuseASizeThatIsNone) {
  NetworkMaker maker;
  maker.lane(40);
  for (const double size : {0., -1., 1e9}) EXPECT_THROW(cells_of(maker.network(), size), Error);
}

TEST(NetworkCells, RefuseMoreThanAMachineHolds) {
  NetworkMaker maker;
  maker.lane(1500000);
  EXPECT_THROW(cells_of(maker.network(), 0.1), Error);
  EXPECT_EQ(cells_of(maker.network(), 100).cells.size(), 15000u);
}

}  // namespace simulation_test
}  // namespace streetgen
