#include "streetgen/progress.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "streetgen/interconnection.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace progress_test {

struct Told {
  std::string step;
  std::size_t done, of;
};
std::vector<Told> heard;

void hear(const char* step, std::size_t done, std::size_t of) noexcept {
  heard.push_back({step, done, of});
}

// Streets that cross each other, and overlap beside their crossings.
std::vector<StreetAxis> grid(int count) {
  std::vector<StreetAxis> axes;
  for (int i = 0; i < count; ++i)
    for (const bool east : {true, false}) {
      StreetAxis axis;
      const double at = 12.0 * i, end = 12.0 * count;
      axis.axis_id = static_cast<std::int64_t>(axes.size()) + 1;
      axis.line = east ? Line{{0, at, 0}, {end, at, 0}} : Line{{at, 0, 0}, {at, end, 0}};
      axis.width = axis.width_end = 12.5;
      axis.radius = 6;
      axes.push_back(axis);
    }
  return axes;
}

TEST(Progress, EachStepIsToldInItsTurnAndGoesForward) {
  heard.clear();
  set_progress_listener(hear);
  StreetSettings settings;
  settings.crossing = Crossing::split;
  const Streets town = streets(grid(4), settings);
  set_progress_listener(nullptr);
  std::vector<std::string> steps;
  for (std::size_t i = 0; i < heard.size(); ++i) {
    EXPECT_LT(heard[i].done, heard[i].of);
    if (steps.empty() || steps.back() != heard[i].step)
      steps.push_back(heard[i].step);
    else
      EXPECT_LE(heard[i - 1].done, heard[i].done) << heard[i].step;
  }
  EXPECT_EQ(steps, (std::vector<std::string>{"corners", "sections", "intersections", "owners"}));
}

TEST(Progress, IsToldToNobodyWhereNobodyListens) {
  heard.clear();
  streets(grid(2), {});
  EXPECT_TRUE(heard.empty());
}

}  // namespace progress_test
}  // namespace streetgen
