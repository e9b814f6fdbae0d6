#include "lane/waiting_place.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/polyline.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace waiting_place_test {

const AxisLanes two_way{std::vector<LaneWish>(1), std::vector<LaneWish>(1)};
const AxisLanes forward{std::vector<LaneWish>(1), {}};

LaneSettings keeps(DrivingSide side) {
  LaneSettings settings;
  settings.driving_side = side;
  return settings;
}

// The one line of a yielding street, axis 3; its middle, and how far its front is from the kerbs of
// the streets crossed, 8 m wide along the x axis.
struct Line3 {
  Point middle;
  double to_kerb = 0;
};
Line3 line_of(const std::vector<StreetAxis>& axes, const std::vector<LanesOfAxis>& lanes_of,
              const StreetSettings& streets_settings = {}, const LaneSettings& settings = {}) {
  const Streets made = streets(axes, streets_settings);
  std::vector<Line3> found;
  for (const Marking& marking : lanes(made, lanes_of, {}, settings).markings) {
    if (made.network.edges[marking.edge].axis_id != 3 || marking.kind == MarkingKind::arrow)
      continue;
    const Point along =
        left_normal(unit(marking.line.back() - marking.line.front())) * (stop_line_width / 2);
    double nearest = INFINITY;
    for (const Point& end : marking.line)
      for (const Point& corner : {end - along, end + along})
        nearest = std::min(nearest, std::abs(corner.y) - 4);
    found.push_back({(marking.line.front() + marking.line.back()) * 0.5, nearest});
  }
  EXPECT_EQ(found.size(), 1U);
  return found.empty() ? Line3{} : found.front();
}

// A road along the x axis, 8 m wide, and a street 6 m wide that comes by so many degrees, from 100
// m off.
std::vector<StreetAxis> skew(double degrees, bool reversed_street = false) {
  const double angle = degrees * M_PI / 180;
  Line street{{0, 0, 0}, {-100 * std::cos(angle), -100 * std::sin(angle), 0}};
  if (reversed_street) street = reversed(street);
  return {{1, {{-200, 0, 0}, {0, 0, 0}}, 0, 8, 8, 5, 3},
          {2, {{0, 0, 0}, {200, 0, 0}}, 0, 8, 8, 5, 3},
          {3, street, 0, 6, 6, 5, 4}};
}
const std::vector<LanesOfAxis> all_two_way{{1, two_way}, {2, two_way}, {3, two_way}};

TEST(WaitingPlace, IsHalfAMetreBeforeTheKerbOfTheStreetCrossed) {
  for (const double radius : {1.0, 6.0, 12.0}) {
    std::vector<StreetAxis> axes = skew(90);
    for (StreetAxis& axis : axes) axis.radius = radius;
    const Line3 line = line_of(axes, all_two_way);
    EXPECT_NEAR(line.to_kerb, 0.5, 1e-6) << radius;
    EXPECT_NEAR(line.middle.x, 1.5, 1e-6) << radius;
    EXPECT_NEAR(line.middle.y, -4.75, 1e-6) << radius;
  }
}

TEST(WaitingPlace, IsWhereTheNearerCornerOfALaneMeetsTheKerb) {
  for (const double degrees : {30.0, 45.0, 60.0, 120.0, 150.0}) {
    const double sine = std::abs(std::sin(degrees * M_PI / 180));
    EXPECT_NEAR(line_of(skew(degrees), all_two_way).to_kerb, 0.5 * sine, 1e-6) << degrees;
  }
}

TEST(WaitingPlace, IsTheSameHoweverTheStreetIsDrawn) {
  for (const double degrees : {30.0, 70.0, 90.0, 140.0}) {
    const Line3 one = line_of(skew(degrees), all_two_way),
                other = line_of(skew(degrees, true), all_two_way);
    EXPECT_NEAR(distance(one.middle, other.middle), 0, 1e-6) << degrees;
  }
}

TEST(WaitingPlace, IsMirroredWhereTrafficKeepsLeft) {
  for (const double degrees : {30.0, 70.0, 90.0, 140.0}) {
    const Line3 right = line_of(skew(degrees), all_two_way),
                left = line_of(skew(180 - degrees), all_two_way, {}, keeps(DrivingSide::left));
    EXPECT_NEAR(right.middle.x, -left.middle.x, 1e-6) << degrees;
    EXPECT_NEAR(right.middle.y, left.middle.y, 1e-6) << degrees;
  }
}

TEST(WaitingPlace, FollowsTheSetting) {
  LaneSettings settings;
  settings.line_before_kerb = 1.25;
  EXPECT_NEAR(line_of(skew(90), all_two_way, {}, settings).to_kerb, 1.25, 1e-6);
}

// Two carriageways, each 6 m wide, come together on a road by so many degrees.
TEST(WaitingPlace, IsWhereCarriagewaysBeginToShareGround) {
  for (const double degrees : {15.0, 20.0, 25.0}) {
    const double half = degrees / 2 * M_PI / 180;
    const auto from = [&](double side) {
      return Point{side * 150 * std::sin(half), -150 * std::cos(half), 0};
    };
    const std::vector<StreetAxis> axes{{1, {{-200, 0, 0}, {0, 0, 0}}, 0, 8, 8, 5, 3},
                                       {2, {{0, 0, 0}, {200, 0, 0}}, 0, 8, 8, 5, 3},
                                       {3, {from(+1), {0, 0, 0}}, 0, 6, 6, 5, 4},
                                       {4, {{0, 0, 0}, from(-1)}, 0, 6, 6, 5, 4}};
    const Line3 line = line_of(axes, {{1, two_way}, {2, two_way}, {3, forward}, {4, forward}});
    // The kerbs of both meet on the y axis; sections that share ground make lanes bend a little.
    EXPECT_NEAR(norm(line.middle), 3 / std::tan(half) + 0.75, 0.1) << degrees;
  }
}

// The side street leaves a road by one side only.
TEST(WaitingPlace, OfAStreetThatGoesOnIsBeforeTheStem) {
  const std::vector<StreetAxis> axes{{3, {{0, -200, 0}, {0, 0, 0}}, 0, 14, 14, 5, 4},
                                     {2, {{0, 0, 0}, {0, 200, 0}}, 0, 14, 14, 5, 4},
                                     {1, {{0, 0, 0}, {-200, 0, 0}}, 0, 8, 8, 5, 3}};
  const AxisLanes four{std::vector<LaneWish>(2), std::vector<LaneWish>(2)};
  const Streets made = streets(axes, {});
  int lines = 0;
  for (const Marking& marking :
       lanes(made, {{1, two_way}, {2, four}, {3, four}}, {}, {}).markings) {
    if (made.network.edges[marking.edge].axis_id != 3 || marking.kind == MarkingKind::arrow)
      continue;
    ++lines;
    EXPECT_NEAR(marking.line.front().y, -4.75, 1e-6);
  }
  EXPECT_EQ(lines, 2);
}

}  // namespace waiting_place_test
}  // namespace streetgen
