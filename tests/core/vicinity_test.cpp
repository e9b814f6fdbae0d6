#include "../../src/core/vicinity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../../src/core/around.hpp"
#include "../../src/core/hole.hpp"
#include "../../src/core/polyline.hpp"

namespace streetgen {
namespace {

class RandomNode {
 public:
  explicit RandomNode(unsigned seed) : random_(seed) {
    const int degree = 2 + static_cast<int>(random_() % 4);
    std::vector<Arm> arms;
    for (int i = 0; i < degree; ++i) arms.push_back(arm());
    for (const std::size_t i : counter_clockwise(arms)) arms_.push_back(arms[i]);
    for (std::size_t i = 0; i < arms_.size(); ++i) {
      Arm &a = arms_[i], &b = arms_[(i + 1) % arms_.size()];
      const SolvedCorner corner = solve_corner(a, b, {number(0, 12)});
      widen_limits(a, b, corner);
      gaps_.push_back(corner.gap);
    }
    for (Arm& arm : arms_) arm.border = border_across(arm, arm.limit);
  }
  const std::vector<Arm>& arms() const { return arms_; }
  const std::vector<Gap>& gaps() const { return gaps_; }

 private:
  double number(double from, double to) {
    return from + (to - from) * static_cast<double>(random_() % 100000) / 100000;
  }
  Arm arm() {
    Line line{{0, 0, 0}};
    double angle = number(0, 2 * M_PI);
    for (int i = 0; i < 3; ++i) {
      const double length = number(3, 30);
      line.push_back(line.back() + Point{std::cos(angle), std::sin(angle), 0} * length);
      angle += number(-1, 1);
    }
    const double half = number(1, 8);
    return {line, half, half, 0, {}};
  }
  std::mt19937_64 random_;
  std::vector<Arm> arms_;
  std::vector<Gap> gaps_;
};

bool holds(const Box& box, const MultiPolygon& surface) {
  const Box built = box_of(surface);
  return surface.empty() || (box.holds({built.min_x, built.min_y, 0}, 0) &&
                             box.holds({built.max_x, built.max_y, 0}, 0));
}

TEST(Vicinity, AnExtentHoldsTheSurfaceThatIsBuilt) {
  Geos geos;
  for (unsigned seed = 1; seed <= 300; ++seed) {
    const RandomNode node(seed);
    EXPECT_TRUE(holds(intersection_extent(node.arms(), node.gaps()),
                      build_intersection(geos, node.arms(), node.gaps()).surface))
        << "seed " << seed;
    for (const Arm& arm : node.arms()) {
      const double start = length(arm.line) / 4, end = length(arm.line) / 2;
      const Built section =
          build_section(geos, arm, start, end, border_across(arm, start), border_across(arm, end));
      EXPECT_TRUE(holds(section_extent(arm, start, end), section.surface)) << "seed " << seed;
    }
  }
}

// A row of squares, one wide: b touches a, c lies within a hole's extent of b, d touches c.
TEST(Vicinity, RingsGoFromTheAskedOneToWhatMayMatterToIt) {
  const auto square = [](double x) {
    Box box;
    box.add({x, 0, 0});
    box.add({x + 1, 1, 0});
    return box;
  };
  const double c = 1.5 + hole_extent;
  const std::vector<Box> extents{square(c + 2), square(c + 1), square(c), square(1), square(0)};
  EXPECT_EQ(rings(extents, {false, false, false, false, true}),
            (std::vector<int>{far_away, 3, 2, 1, 0}));
}

}  // namespace
}  // namespace streetgen
