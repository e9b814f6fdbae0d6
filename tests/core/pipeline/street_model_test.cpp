#include "streetgen/street_model.hpp"

#include <gtest/gtest.h>

#include "random_town.hpp"
#include "rounds.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace street_model_test {

StreetModelInput random_input(unsigned seed) {
  StreetModelInput input;
  input.axes = random_town(seed, 30);
  input.settings.crossing = Crossing::split;
  for (const StreetAxis& axis : input.axes)
    input.lanes.push_back({axis.axis_id, {{LaneWish{}}, {LaneWish{}}}});
  return input;
}

// Debug and sanitized builds check the invariants of every step here.
TEST(StreetModel, RunsEveryStepInOrder) {
  for (int seed = 1; seed <= rounds(5); ++seed) {
    const StreetModelInput input = random_input(seed);
    const StreetModel model = street_model(input);
    const Streets alone = streets(input.axes, input.settings);
    ASSERT_EQ(model.streets.sections.size(), alone.sections.size()) << "seed " << seed;
    for (std::size_t i = 0; i < alone.sections.size(); ++i)
      EXPECT_EQ(area(model.streets.sections[i].surface), area(alone.sections[i].surface));
    EXPECT_EQ(model.lanes.lanes.size(), 2 * model.streets.network.edges.size());
    EXPECT_FALSE(model.interconnections.empty());
    for (const Interconnection& path : model.interconnections)
      EXPECT_NE(model.lanes.lanes[path.lane_in].edge, model.lanes.lanes[path.lane_out].edge);
  }
}

TEST(StreetModel, HasNoRowWithoutAxes) {
  const StreetModel model = street_model({});
  EXPECT_TRUE(model.streets.network.nodes.empty());
  EXPECT_TRUE(model.lanes.lanes.empty());
  EXPECT_TRUE(model.interconnections.empty());
}

}  // namespace street_model_test
}  // namespace streetgen
