#include "streetgen/forest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "streetgen/error.hpp"

namespace streetgen {
namespace forest_test {

// A value that one feature decides, among noise and wild values; the other features say nothing.
std::vector<ForestSample> stepped(int count, double wild) {
  std::mt19937_64 random(5);
  const auto share = [&] { return (random() >> 11) * 0x1.0p-53; };
  std::vector<ForestSample> samples;
  for (int i = 0; i < count; ++i) {
    const double decides = share();
    const double value = (decides < 0.5 ? 2 : 6) + 0.2 * share();
    samples.push_back({{share(), decides, share()}, share() < wild ? 80 : value});
  }
  return samples;
}

TEST(Forest, LearnsAStepWhateverAFewWildValuesSay) {
  const Forest forest = grow_forest(stepped(300, 0.05));
  for (double a = 0.05; a < 1; a += 0.1) {
    EXPECT_NEAR(forest_value(forest, {a, 0.2, 0.5}), 2.1, 0.15);
    EXPECT_NEAR(forest_value(forest, {a, 0.8, 0.5}), 6.1, 0.15);
  }
}

TEST(Forest, SaysOneNumberWhereFeaturesSayNothing) {
  std::vector<ForestSample> samples = stepped(300, 0);
  for (ForestSample& sample : samples) sample.features[1] = 0;
  std::vector<double> values;
  for (const ForestSample& sample : samples) values.push_back(sample.value);
  std::sort(values.begin(), values.end());
  EXPECT_EQ(grow_forest(samples), (Forest{3, 1, 1, -1, values[values.size() / 2 - 1], 0, 0}));
}

TEST(Forest, IsTheSameWhateverTheOrder) {
  std::vector<ForestSample> samples = stepped(120, 0.1);
  const Forest forest = grow_forest(samples);
  std::mt19937_64 random(9);
  for (int round = 0; round < 5; ++round) {
    std::shuffle(samples.begin(), samples.end(), random);
    EXPECT_EQ(grow_forest(samples), forest);
  }
}

TEST(Forest, OfOneSampleSaysItsValue) {
  EXPECT_EQ(forest_value(grow_forest({{{1, 2}, 4}}), {7, 7}), 4);
  EXPECT_EQ(forest_value(grow_forest({{{1}, 4}, {{1}, 4}}), {0}), 4);
}

TEST(Forest, RefusesWhatIsNone) {
  EXPECT_THROW(grow_forest({}), Error);
  EXPECT_THROW(grow_forest({{{1, 2}, 4}, {{1}, 4}}), Error);
  const Forest forest = grow_forest(stepped(60, 0));
  EXPECT_THROW(forest_value(forest, {1, 2}), Error);
  EXPECT_THROW(forest_value({}, {}), Error);
  // A node that leads back would never end.
  EXPECT_THROW(forest_value({1, 1, 1, 0, 5, 0, 0}, {1}), Error);
  EXPECT_THROW(forest_value({1, 1, 3, 0, 5, 7, 2, -1, 3, 0, 0, -1, 4, 0, 0}, {1}), Error);
  EXPECT_THROW(forest_value({1, 1, 1, 2, 5, 0, 0}, {1}), Error);
  EXPECT_THROW(forest_value({1, 1, 1e9, 0, 5, 0, 0}, {1}), Error);
  EXPECT_EQ(forest_value({1, 1, 3, 0, 5, 1, 2, -1, 3, 0, 0, -1, 4, 0, 0}, {1}), 3);
  for (std::size_t keep = 0; keep < forest.size(); ++keep)
    EXPECT_THROW(forest_value({forest.begin(), forest.begin() + keep}, {1, 2, 3}), Error);
}

}  // namespace forest_test
}  // namespace streetgen
