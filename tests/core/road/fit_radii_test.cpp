#include "road/fit_radii.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "random_line.hpp"
#include "rounds.hpp"
#include "streetgen/arc_road.hpp"

namespace streetgen {
namespace fit_radii_test {

// By the definition: bisects for the greatest radius that all free bends can share, and fixes the
// bends that can have no more.
std::vector<double> radii_by_bisection(const std::vector<double>& lengths,
                                       const std::vector<Bend>& bends) {
  const std::size_t n = bends.size();
  std::vector<double> radii(n, 0);
  std::vector<bool> settled(n, false);
  for (std::size_t i = 0; i < n; ++i)
    if (bends[i].fixed) radii[i] = *bends[i].fixed, settled[i] = true;
  const auto feasible = [&](const std::vector<double>& wanted) {
    for (std::size_t s = 0; s < lengths.size(); ++s) {
      double taken = 0;
      if (s > 0) taken += wanted[s - 1] * bends[s - 1].tangent;
      if (s < n) taken += wanted[s] * bends[s].tangent;
      if (taken > lengths[s] * (1 + 1e-12)) return false;
    }
    return true;
  };
  while (std::count(settled.begin(), settled.end(), false) > 0) {
    const auto at_level = [&](double level) {
      std::vector<double> wanted = radii;
      for (std::size_t i = 0; i < n; ++i)
        if (!settled[i]) wanted[i] = std::min(level, bends[i].bound);
      return wanted;
    };
    double low = 0, high = 1e7;
    for (int step = 0; step < 200; ++step) {
      const double middle = (low + high) / 2;
      (feasible(at_level(middle)) ? low : high) = middle;
    }
    const std::vector<double> level = at_level(low);
    bool any = false;
    for (std::size_t i = 0; i < n; ++i) {
      if (settled[i]) continue;
      std::vector<double> more = level;
      more[i] *= 1 + 1e-10;
      if (feasible(more) && more[i] < bends[i].bound) continue;
      radii[i] = level[i], settled[i] = true, any = true;
    }
    if (!any) break;
  }
  return radii;
}

struct Problem {
  std::vector<double> lengths;
  std::vector<Bend> bends;
};

Problem random_problem(std::mt19937& random) {
  const int points = 3 + static_cast<int>(random() % 10);
  const Line line = random_line(random, {points, 2.9, random() % 3 == 0 ? 0.3 : 0});
  std::uniform_real_distribution<double> share(0, 1);
  const double cap = random() % 2 ? 4000 : 200 * share(random);
  const double shift = random() % 2 ? 5 * share(random) : 1e9;
  Problem problem;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    problem.lengths.push_back(space::distance(line[i], line[i + 1]));
    if (i == 0) continue;
    const double turn = angle_between(line[i] - line[i - 1], line[i + 1] - line[i]);
    const double bound = std::min(cap, shift / (1 / std::cos(turn / 2) - 1));
    problem.bends.push_back({std::tan(turn / 2), bound, {}});
  }
  // Fixed radii take at most half of each segment, so they fit.
  for (std::size_t i = 0; i < problem.bends.size(); ++i)
    if (random() % 5 == 0)
      problem.bends[i].fixed = share(random) / 2 / problem.bends[i].tangent *
                               std::min(problem.lengths[i], problem.lengths[i + 1]);
  return problem;
}

TEST(FitRadii, AreThoseOfTheDefinition) {
  std::mt19937 random(7);
  for (int i = 0; i < rounds(20000); ++i) {
    const Problem problem = random_problem(random);
    const std::vector<double> found = fit_radii(problem.lengths, problem.bends);
    const std::vector<double> expected = radii_by_bisection(problem.lengths, problem.bends);
    for (std::size_t k = 0; k < found.size(); ++k)
      ASSERT_NEAR(found[k], expected[k], 1e-9 * expected[k] + 1e-12)
          << "line " << i << " bend " << k;
  }
}

TEST(FitRadii, TheSmallestIsTheClosedForm) {
  std::mt19937 random(8);
  for (int i = 0; i < rounds(20000); ++i) {
    Problem problem = random_problem(random);
    const std::size_t n = problem.bends.size();
    for (Bend& bend : problem.bends) bend.bound = 1e9, bend.fixed.reset();
    double smallest = std::min(problem.lengths.front() / problem.bends.front().tangent,
                               problem.lengths.back() / problem.bends.back().tangent);
    for (std::size_t k = 1; k < n; ++k)
      smallest = std::min(
          smallest, problem.lengths[k] / (problem.bends[k - 1].tangent + problem.bends[k].tangent));
    const std::vector<double> found = fit_radii(problem.lengths, problem.bends);
    ASSERT_NEAR(*std::min_element(found.begin(), found.end()), smallest, 1e-9 * smallest);
  }
}

TEST(FitRadii, OfARoadAreThoseOfItsPolyline) {
  std::mt19937 random(9);
  for (int i = 0; i < rounds(500); ++i) {
    const Line line = random_line(random, {9, 2.5, i % 2 ? 0.2 : 0});
    ArcRoadFit fit;
    fit.cap = 300;
    fit.shift = 2;
    fit.radii.resize(line.size());
    fit.radii[4] = 0.3;
    Problem problem;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      problem.lengths.push_back(space::distance(line[k], line[k + 1]));
      if (k == 0) continue;
      const double turn = angle_between(line[k] - line[k - 1], line[k + 1] - line[k]);
      problem.bends.push_back(
          {std::tan(turn / 2), std::min(300.0, 2 / (1 / std::cos(turn / 2) - 1)), fit.radii[k]});
    }
    bool fits = true;
    for (const std::size_t k : {3u, 4u})
      fits = fits && 0.3 * problem.bends[3].tangent < problem.lengths[k];
    if (!fits) continue;
    const std::vector<double> expected = radii_by_bisection(problem.lengths, problem.bends);
    const ArcRoad road = ArcRoad::fit(line, fit);
    ASSERT_EQ(road.arcs().size(), expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      ASSERT_EQ(road.arcs()[k].vertex, k + 1);
      ASSERT_NEAR(road.arcs()[k].radius, expected[k], 1e-9 * expected[k] + 1e-12);
    }
  }
}

}  // namespace fit_radii_test
}  // namespace streetgen
