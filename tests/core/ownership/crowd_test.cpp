#include "ownership/crowd.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/polyline.hpp"
#include "geometry/surface_union.hpp"
#include "rounds.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "streetgen/interconnection.hpp"
#include "streetgen/streets.hpp"
#include "streetgen/surface.hpp"

namespace streetgen {
namespace crowd_test {

// Stops work that asks more often than this whether to stop: a measure of work that is the same on
// every machine.
class Budget {
 public:
  explicit Budget(long polls) {
    left_ = polls;
    set_cancel_check([]() noexcept { return --left_ < 0; });
  }
  ~Budget() { set_cancel_check(nullptr); }
  Budget(const Budget&) = delete;
  Budget& operator=(const Budget&) = delete;

 private:
  static inline long left_ = 0;
};

StreetAxis axis(std::int64_t id, const Line& line) { return {id, line, 0, 6, 6, 4, 5, 50}; }

std::vector<StreetAxis> from_one_point(int count) {
  std::vector<StreetAxis> axes;
  for (int i = 0; i < count; ++i) {
    const double way = 2 * M_PI * i / count;
    axes.push_back(axis(i + 1, {{0, 0, 0}, {100 * std::cos(way), 100 * std::sin(way), 0}}));
  }
  return axes;
}

// Roadways so far apart, of axes that are no twins: they lie 2 m apart.
std::vector<StreetAxis> beside_each_other(int count, double apart) {
  std::vector<StreetAxis> axes;
  for (int i = 0; i < count; ++i) {
    axes.push_back(axis(i + 1, {{0, i * 2.0, 0}, {100, i * 2.0, 0}}));
    axes.back().roadway_offset = i * (apart - 2);
  }
  return axes;
}

std::vector<MultiPolygon> surfaces_of(const Streets& streets) {
  std::vector<MultiPolygon> all;
  for (const Section& section : streets.sections) all.push_back(section.surface);
  for (const Intersection& at : streets.intersections) all.push_back(at.surface);
  return all;
}

double summed_area(const std::vector<MultiPolygon>& surfaces) {
  double sum = 0;
  for (const MultiPolygon& surface : surfaces) sum += area(surface);
  return sum;
}

int crowded(const Streets& streets) {
  int count = 0;
  for (const Section& section : streets.sections) count += section.method == Method::crowded;
  return count;
}

TEST(Crowd, SquaresAreThoseIntoWhichMoreCome) {
  std::mt19937_64 random(7);
  std::vector<Box> boxes;
  for (int i = 0; i < 300; ++i) {
    const Point p{random() % 3000 / 10.0 - 150, random() % 3000 / 10.0 - 150, 0};
    boxes.push_back(box_of(p, {p.x + random() % 300 / 10.0, p.y + random() % 300 / 10.0, 0}));
  }
  boxes.emplace_back();  // of a surface without ground
  const auto found =
      crowds(boxes, 5, [&](int i, const Box& square) { return boxes[i].meets(square); });
  std::size_t expected = 0;
  for (double x = -200; x < 200; x += 10)
    for (double y = -200; y < 200; y += 10) {
      const Box square{x, y, x + 10, y + 10};
      std::vector<int> members;
      for (int i = 0; i < 300; ++i)
        if (boxes[i].meets(square)) members.push_back(i);
      if (members.size() <= 5) continue;
      ++expected;
      EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                              [&](const Crowd& crowd) {
                                return crowd.square.min_x == x && crowd.square.min_y == y &&
                                       crowd.members == members;
                              }))
          << x << " " << y;
    }
  EXPECT_GT(expected, 5u);
  EXPECT_EQ(found.size(), expected);
}

TEST(Crowd, AxesFromOnePointShareTheDisc) {
  const Budget budget(3000000);
  const Streets star = streets(from_one_point(120), {});
  const std::vector<MultiPolygon> surfaces = surfaces_of(star);
  Geos geos;
  const double ground = area(geos.polygons(geos.unite(surfaces).get()));
  EXPECT_NEAR(ground, M_PI * 100 * 100, 20);
  EXPECT_NEAR(summed_area(surfaces), ground, 0.001);
  EXPECT_GT(crowded(star), 100);
}

TEST(Crowd, ParallelAxesShareTheirBand) {
  const Budget budget(3000000);
  const int axes = 50 + rounds(250);
  const Streets band = streets(beside_each_other(axes, 0.01), {});
  EXPECT_NEAR(summed_area(surfaces_of(band)), 100 * (6 + 0.01 * (axes - 1)), 0.001);
  EXPECT_EQ(crowded(band), axes);
}

TEST(Crowd, OfEqualAxesTheFirstHasTheGround) {
  const Budget budget(3000000);
  StreetSettings sharp;
  sharp.kerb_radius_minimal = 0;
  const Streets bundle = streets(beside_each_other(300, 0), sharp);
  EXPECT_NEAR(summed_area(surfaces_of(bundle)), 600, 0.001);
  EXPECT_GT(area(bundle.sections.front().surface), 590);
  for (std::size_t i = 1; i < bundle.sections.size(); ++i)
    EXPECT_TRUE(bundle.sections[i].surface.empty());
}

TEST(Crowd, TheBoundIsASetting) {
  StreetSettings settings;
  EXPECT_EQ(crowded(streets(beside_each_other(20, 0.01), settings)), 0);
  settings.overlaps_maximal = 10;
  EXPECT_EQ(crowded(streets(beside_each_other(20, 0.01), settings)), 20);
}

TEST(Crowd, UnionOfManyPiecesAboutOnePoint) {
  const Budget budget(300000);
  std::vector<MultiPolygon> pieces;
  for (const StreetAxis& street : from_one_point(400))
    pieces.push_back(section_surface(street.line, 6, 0, 100));
  Geos geos;
  EXPECT_NEAR(area(united(geos, pieces)), area(geos.polygons(geos.unite(pieces).get())), 0.01);
}

TEST(Crowd, NoPairsOfLanesOverTheBound) {
  const std::vector<StreetAxis> axes = from_one_point(12);
  const Streets star = streets(axes, {});
  std::vector<LanesOfAxis> wishes;
  for (const StreetAxis& street : axes)
    wishes.push_back({street.axis_id, {{LaneWish{}}, {LaneWish{}}}});
  const std::vector<Lane> made = lanes(star, wishes, {}, {}).lanes;
  InterconnectionSettings settings;
  settings.most = 12 * 11;
  EXPECT_EQ(interconnections(star, axes, made, {}, settings).size(), 12u * 11);
  settings.most = 12 * 11 - 1;
  EXPECT_TRUE(interconnections(star, axes, made, {}, settings).empty());
  settings.most = 12 * 11;
  settings.u_turn = true;
  // Back again at the twelve far ends alone.
  EXPECT_EQ(interconnections(star, axes, made, {}, settings).size(), 12u);
}

}  // namespace crowd_test
}  // namespace streetgen
