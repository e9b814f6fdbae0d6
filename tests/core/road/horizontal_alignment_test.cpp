#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/polyline.hpp"
#include "random_line.hpp"
#include "streetgen/alignment.hpp"
#include "streetgen/error.hpp"

namespace streetgen {
namespace horizontal_alignment_test {

// Where a car ends that turns by a curvature: the rule of Simpson over the heading, apart from the
// quadrature of the code.
AlignmentPlace driven(const AlignmentElement& e) {
  constexpr int steps = 20000;
  const double rate = (e.curvature_end - e.curvature_start) / e.length;
  const auto heading = [&](double s) {
    return e.heading + e.curvature_start * s + rate * s * s / 2;
  };
  AlignmentPlace place{e.start, heading(e.length), e.curvature_end};
  for (int i = 0; i <= steps; ++i) {
    const double weight = (i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2) * e.length / steps / 3;
    place.point.x += weight * std::cos(heading(i * e.length / steps));
    place.point.y += weight * std::sin(heading(i * e.length / steps));
  }
  return place;
}

TEST(HorizontalAlignment, AnElementEndsWhereACarComesThatTurnsByItsCurvature) {
  for (double k0 : {0.0, 0.01, -0.004, 0.2})
    for (double k1 : {0.0, 0.02, -0.05, 0.2}) {
      const AlignmentElement e{0, {3, -2, 0}, 0.7, 60, k0, k1};
      const AlignmentPlace end = element_place(e, e.length), car = driven(e);
      EXPECT_LT(distance(end.point, car.point), 1e-9) << k0 << " " << k1;
      EXPECT_NEAR(end.heading, car.heading, 1e-12);
      EXPECT_NEAR(end.curvature, k1, 1e-15);
    }
}

TEST(HorizontalAlignment, TheSeriesOfAClothoidGivesItsEnd) {
  // x = L sum (-1)^n tau^2n / ((4n + 1) (2n)!), y with 4n + 3 and (2n + 1)!.
  const double length = 100;
  for (double tau : {0.05, 0.5, M_PI / 2}) {
    double x = 0, y = 0, term = 1;
    for (int n = 0; n < 30; ++n) {
      const double sign = n / 2 % 2 == 0 ? 1 : -1;
      (n % 2 == 0 ? x : y) += sign * term / (2 * n + 1);
      term *= tau / (n + 1);
    }
    const AlignmentPlace end = element_place({0, {}, 0, length, 0, 2 * tau / length}, length);
    EXPECT_NEAR(end.point.x, length * x, 1e-11);
    EXPECT_NEAR(end.point.y, length * y, 1e-11);
  }
}

// Curves that fit: the tangents of both ends take at most 0.45 of a side each.
std::vector<VertexCurve> fitting_curves(std::mt19937& random, const Line& line) {
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<VertexCurve> curves(line.size());
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const Point a = line[i] - line[i - 1], b = line[i + 1] - line[i];
    const double turn = std::abs(std::atan2(cross(a, b), dot(a, b)));
    const double room = 0.45 * std::min(norm(a), norm(b));
    VertexCurve curve{300 * share(random), 0, 0};
    curve.clothoid_in = curve.radius * share(random) * 1.5;
    curve.clothoid_out = curve.radius * share(random) * 1.5;
    const CurveShape shape = curve_shape(turn, curve);
    // All lengths of a curve grow with it.
    const double scale =
        std::min(1.0, room / std::max({shape.tangent_in, shape.tangent_out, 1e-9}));
    curves[i] = {curve.radius * scale, curve.clothoid_in * scale, curve.clothoid_out * scale};
  }
  return curves;
}

TEST(HorizontalAlignment, JointsKeepPositionHeadingAndCurvature) {
  std::mt19937 random(11);
  for (int round = 0; round < 300; ++round) {
    const Line line = random_line(random, {8, 2.4});
    const std::vector<VertexCurve> curves = fitting_curves(random, line);
    const std::vector<AlignmentElement> elements = horizontal_alignment(line, curves);
    for (std::size_t i = 0; i + 1 < elements.size(); ++i) {
      const AlignmentPlace end = element_place(elements[i], elements[i].length);
      EXPECT_LT(distance(end.point, elements[i + 1].start), 1e-9);
      EXPECT_NEAR(std::remainder(end.heading - elements[i + 1].heading, 2 * M_PI), 0, 1e-9);
      // A curve without a clothoid begins with the curvature of its arc.
      const bool jump = std::abs(end.curvature - elements[i + 1].curvature_start) > 1e-9;
      if (jump) {
        EXPECT_TRUE(elements[i].kind() != ElementKind::clothoid &&
                    elements[i + 1].kind() != ElementKind::clothoid);
      }
    }
    const AlignmentPlace last = element_place(elements.back(), elements.back().length);
    EXPECT_LT(distance(last.point, line.back()), 1e-9);
  }
}

TEST(HorizontalAlignment, ReversedItIsTheSameRoad) {
  std::mt19937 random(5);
  for (int round = 0; round < 50; ++round) {
    const Line line = random_line(random, {6, 2});
    std::vector<VertexCurve> curves = fitting_curves(random, line);
    const auto there = horizontal_alignment(line, curves);
    std::reverse(curves.begin(), curves.end());
    for (VertexCurve& curve : curves) std::swap(curve.clothoid_in, curve.clothoid_out);
    const auto back = horizontal_alignment(reversed(line), curves);
    const double length = alignment_length(there);
    ASSERT_NEAR(length, alignment_length(back), 1e-8);
    for (double s = 0; s <= length; s += length / 50)
      EXPECT_LT(distance(alignment_place(there, s).point, alignment_place(back, length - s).point),
                1e-7);
  }
}

TEST(HorizontalAlignment, ClothoidsThatTurnTooFarMeetWithoutAnArc) {
  const Line line{{0, 0}, {500, 0}, {500 + 500 * std::cos(0.3), 500 * std::sin(0.3)}};
  const auto elements = horizontal_alignment(line, {{}, {300, 290, 290}, {}});
  ASSERT_EQ(elements.size(), 4u);
  EXPECT_EQ(elements[1].kind(), ElementKind::clothoid);
  EXPECT_EQ(elements[2].kind(), ElementKind::clothoid);
  // A = R sqrt(theta), so L = A^2 / R = R theta.
  EXPECT_NEAR(elements[1].length, 300 * 0.3, 1e-9);
}

TEST(HorizontalAlignment, ChordsKeepTheTolerance) {
  const Line line{{0, 0}, {500, 0}, {800, 400}, {1400, 400}};
  const auto elements = horizontal_alignment(line, {{}, {130, 70, 70}, {250, 90, 0}, {}});
  for (double tolerance : {0.01, 0.5}) {
    const std::vector<double> at = chord_abscissas(elements, tolerance);
    double farthest = 0;
    for (std::size_t i = 1; i < at.size(); ++i) {
      const Point a = alignment_place(elements, at[i - 1]).point;
      const Point b = alignment_place(elements, at[i]).point;
      for (int k = 1; k < 10; ++k)
        farthest = std::max(
            farthest,
            distance_to_segment(
                alignment_place(elements, at[i - 1] + (at[i] - at[i - 1]) * k / 10).point, a, b));
    }
    EXPECT_LE(farthest, tolerance * 1.0001);
    EXPECT_GT(farthest, tolerance * 0.3);
  }
}

TEST(HorizontalAlignment, CurvesThatDoNotFitAreRefused) {
  const Line line{{0, 0}, {100, 0}, {100, 100}};
  EXPECT_THROW(horizontal_alignment(line, {{}, {101, 0, 0}, {}}), Error);
  EXPECT_NO_THROW(horizontal_alignment(line, {{}, {100, 0, 0}, {}}));
  EXPECT_THROW(horizontal_alignment({{0, 0}, {1, 0}, {0, 0}}, {{}, {0.1, 0, 0}, {}}), Error);
  EXPECT_THROW(horizontal_alignment({{0, 0}, {0, 0}}, {{}, {}}), Error);
  EXPECT_THROW(horizontal_alignment(line, {{}, {NAN, 0, 0}, {}}), Error);
}

TEST(CurvatureSpectrum, AWaveHasItsEnergyInItsBand) {
  for (double cycles : {0.5, 1.5, 3.0, 6.0, 12.0}) {
    Line line;
    for (double x = 0; x < 20000; x += 2)
      line.push_back(
          {x, 0.002 / cycles / cycles * 1000 * std::sin(2 * M_PI * cycles * x / 1000), 0});
    const std::vector<double> shares = curvature_spectrum(line, 10, 2000);
    ASSERT_EQ(shares.size(), 5u);
    const std::size_t band = cycles < 1 ? 0 : cycles < 2 ? 1 : cycles < 4 ? 2 : cycles < 8 ? 3 : 4;
    EXPECT_GT(shares[band], 0.75) << cycles;
  }
  EXPECT_TRUE(curvature_spectrum({{0, 0}, {9000, 0}}, 10, 2000).empty());
}

}  // namespace horizontal_alignment_test
}  // namespace streetgen
