#include "streetgen/block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "geometry/arrangement.hpp"
#include "geometry/box.hpp"
#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "network/face.hpp"
#include "random_town.hpp"
#include "rounds.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace block_test {

Streets with_kerbs(const std::vector<StreetAxis>& axes, const StreetSettings& settings = {}) {
  return streets(axes, settings, {}, {}, true);
}

StreetAxis street(std::int64_t id, Line line, double width = 6, int level = 0) {
  return {id, std::move(line), level, width, width, 4};
}

// Four streets about a rectangle of 100 m by 60.
std::vector<StreetAxis> rectangle(double width = 6) {
  return {street(1, {{0, 0}, {100, 0}}, width), street(2, {{100, 0}, {100, 60}}, width),
          street(3, {{100, 60}, {0, 60}}, width), street(4, {{0, 60}, {0, 0}}, width)};
}

BlocksInput input_of(const Streets& town, int level = 0) {
  BlocksInput input;
  for (const Edge& edge : town.network.edges)
    input.edges.push_back(edge.level == level ? edge.line : Line{});
  for (const Kerb& kerb : town.kerbs)
    if (kerb.level == level) input.kerbs.push_back(kerb);
  return input;
}

std::vector<Block> blocks_of(const std::vector<StreetAxis>& axes,
                             const StreetSettings& settings = {}) {
  return blocks(input_of(with_kerbs(axes, settings))).blocks;
}

// Each face less the surfaces of the level, told by a place in each piece of them all.
std::vector<double> ground_in_faces(const Streets& town, int level) {
  const NetworkFaces found = find_faces(town.network, level);
  MultiPolygon roadway;
  for (const Section& section : town.sections)
    if (town.network.edges[section.edge].level == level)
      roadway.insert(roadway.end(), section.surface.begin(), section.surface.end());
  for (const Intersection& intersection : town.intersections)
    if (intersection.level == level)
      roadway.insert(roadway.end(), intersection.surface.begin(), intersection.surface.end());
  std::vector<double> grounds;
  for (const Face& face : found.faces) {
    Polygon rings;
    for (const FaceRing& ring : face.rings) rings.push_back(ring.line);
    std::vector<LineView> lines(rings.begin(), rings.end());
    MultiPolygon near;
    for (const Polygon& polygon : roadway)
      if (box_of({polygon}).meets(box_of({rings}))) near.push_back(polygon);
    for (const Polygon& polygon : near) lines.insert(lines.end(), polygon.begin(), polygon.end());
    const Arrangement pieces(lines);
    std::vector<bool> kept;
    for (const Point& place : pieces.places())
      kept.push_back(inside(place, rings) && !inside(place, near));
    grounds.push_back(area(pieces.joined(kept)));
  }
  return grounds;
}

void expect_ground(const Streets& town, const std::string& what, int level = 0) {
  Geos geos;
  const std::vector<Block> found = blocks(input_of(town, level)).blocks;
  const std::vector<double> grounds = ground_in_faces(town, level);
  ASSERT_EQ(found.size(), grounds.size()) << what;
  for (std::size_t b = 0; b < found.size(); ++b) {
    EXPECT_NEAR(area(found[b].surface), grounds[b], 1e-3)
        << what << " block " << b << " " << method_name(found[b].method);
    EXPECT_TRUE(geos.valid(geos.surface(found[b].surface).get())) << what << " block " << b;
    EXPECT_EQ(found[b].surface.empty(), found[b].kind == BlockKind::roadway) << what;
  }
}

TEST(Block, OfFourStreetsIsTheGroundBetweenTheirKerbs) {
  const std::vector<Block> found = blocks_of(rectangle());
  ASSERT_EQ(found.size(), 1u);
  // Arcs of 4 m at the corners.
  EXPECT_NEAR(area(found[0].surface), 94 * 54 - (4 - M_PI) * 4 * 4, 0.5);
  EXPECT_EQ(found[0].kind, BlockKind::block);
  EXPECT_EQ(found[0].method, Method::hypothesis);
  ASSERT_EQ(found[0].sides.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(found[0].sides[i].side.edge, i);
    EXPECT_TRUE(found[0].sides[i].side.left);
    EXPECT_EQ(found[0].sides[i].ring, 1);
  }
}

TEST(Block, ThatIsRoadwayAllOverStays) {
  const std::vector<Block> found = blocks_of(rectangle(70));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].surface.empty());
  EXPECT_EQ(found[0].method, Method::covered);
  EXPECT_EQ(found[0].kind, BlockKind::roadway);
}

TEST(Block, GoesAboutADeadEndAndAnIslandOfStreets) {
  std::vector<StreetAxis> axes = rectangle();
  axes.push_back(street(5, {{0, 0}, {20, 20}}));
  axes.push_back(street(6, {{50, 20}, {70, 20}, {70, 40}, {50, 40}, {50, 20}}));
  axes.push_back(street(7, {{80, 20}, {80, 40}}));
  const Streets town = with_kerbs(axes);
  expect_ground(town, "islands");
  const std::vector<Block> found = blocks(input_of(town)).blocks;
  ASSERT_EQ(found.size(), 2u);
  ASSERT_EQ(found[0].surface.size(), 1u);
  EXPECT_EQ(found[0].surface[0].size(), 3u);
  EXPECT_EQ(found[0].sides.back().ring, 3);
  // One arc of 2 m, where the loop begins and ends; kerb_radius_minimal rounds the other three
  // corners.
  EXPECT_NEAR(area(found[1].surface), 14 * 14 - (4 - M_PI) * 4 - 3 * (4 - M_PI) / 16, 0.1);
  EXPECT_EQ(found[1].kind, BlockKind::island);
}

TEST(Block, WithinARoundaboutIsAnIsland) {
  const Streets town = with_kerbs(rectangle());
  BlocksInput input = input_of(town);
  EXPECT_EQ(blocks(input).blocks[0].kind, BlockKind::block);
  input.on_rings.assign(input.edges.size(), true);
  EXPECT_EQ(blocks(input).blocks[0].kind, BlockKind::island);
  input.on_rings[0] = false;
  EXPECT_EQ(blocks(input).blocks[0].kind, BlockKind::block);
  input.on_rings[0] = true;
  input.settings.island_area = 0;
  EXPECT_EQ(blocks(input).blocks[0].kind, BlockKind::block);
}

TEST(Block, BetweenCarriagewaysIsAStrip) {
  const std::vector<Block> found =
      blocks_of({street(1, {{0, 0}, {200, 0}}), street(2, {{0, 0}, {0, 12}}),
                 street(3, {{200, 0}, {200, 12}}), street(4, {{0, 12}, {200, 12}})});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind, BlockKind::strip);
}

// Where three bridges end at a street of the ground, the intersection lies on their level.
TEST(Block, IsBoundByTheAxisWhereAStreetHasNoRoadwayOnItsLevel) {
  std::vector<StreetAxis> axes = rectangle();
  axes.push_back(street(5, {{50, 0}, {50, 30}}));
  axes.push_back(street(6, {{50, 30}, {50, 60}}));
  for (int i = 0; i < 3; ++i) axes.push_back(street(7 + i, {{50, 30}, {60. + 9 * i, 20}}, 6, 1));
  const Streets town = with_kerbs(axes);
  expect_ground(town, "bridges");
  const std::vector<Block> found = blocks(input_of(town)).blocks;
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].method, Method::axis_bound);
  EXPECT_EQ(found[1].method, Method::axis_bound);
}

// Ends of kerbs that follow each other may lie up to some micrometres apart.
TEST(Block, IsTheSameWhateverTheOrderOfKerbs) {
  std::vector<StreetAxis> axes = rectangle();
  axes.push_back(street(5, {{20, 25}, {40, 25}}));
  axes.push_back(street(6, {{60, 35}, {80, 35}}));
  BlocksInput input = input_of(with_kerbs(axes));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> apart(-5e-7, 5e-7);
  for (Kerb& kerb : input.kerbs)
    for (Point* end : {&kerb.line.front(), &kerb.line.back()})
      *end = *end + Point{apart(random), apart(random), 0};
  const std::vector<Block> first = blocks(input).blocks;
  ASSERT_EQ(first.size(), 1u);
  ASSERT_EQ(first[0].surface.at(0).size(), 3u);
  for (int round = 0; round < 20; ++round) {
    std::shuffle(input.kerbs.begin(), input.kerbs.end(), random);
    const std::vector<Block> again = blocks(input).blocks;
    ASSERT_EQ(again.size(), 1u);
    for (std::size_t r = 0; r < 3; ++r) {
      const Ring &ring = again[0].surface.at(0).at(r), &same_ring = first[0].surface[0][r];
      EXPECT_TRUE(std::equal(ring.begin(), ring.end(), same_ring.begin(), same_ring.end(),
                             [](const Point& a, const Point& b) { return same(a, b); }))
          << round << ' ' << r;
    }
  }
}

TEST(Block, HasTheKindDecidedByHand) {
  BlocksInput input = input_of(with_kerbs(rectangle()));
  input.overrides = {{{50, 30}, BlockKind::strip}, {{50, 31}, BlockKind::island}, {{0, 30}}};
  EXPECT_EQ(blocks(input).blocks[0].kind, BlockKind::island);
}

TEST(Block, OfNoStreetsOrOneLineIsNone) {
  EXPECT_TRUE(blocks({}).blocks.empty());
  EXPECT_TRUE(blocks_of({street(1, {{0, 0}, {100, 10}, {200, 0}})}).empty());
}

// Streets far worse than real ones: of any angle, overlapping, with and without nodes.
TEST(Block, OfAnyTownIsItsFaceLessTheRoadway) {
  for (int seed = 1; seed <= rounds(25); ++seed)
    for (const Crossing crossing : {Crossing::over, Crossing::split}) {
      StreetSettings settings;
      settings.crossing = crossing;
      expect_ground(with_kerbs(random_town(seed, 24), settings), std::to_string(seed));
    }
}

TEST(Block, OfAnyTownOnTwoLevelsIsItsFaceLessTheRoadway) {
  for (int seed = 1; seed <= rounds(25); ++seed) {
    std::vector<StreetAxis> axes = random_town(seed, 24);
    for (StreetAxis& axis : axes) axis.level = axis.axis_id % 3 == 0;
    const Streets town = with_kerbs(axes);
    for (const int level : {0, 1}) expect_ground(town, std::to_string(seed), level);
  }
}

// What an edit gives for one block: the edges about it, and which of their sides stay.
BlocksInput alone(const BlocksInput& all, const Blocks& found, std::size_t b) {
  BlocksInput own = all;
  own.edges.assign(all.edges.size(), {});
  for (const BlockSide& side : found.blocks[b].sides)
    own.edges[side.side.edge] = all.edges[side.side.edge];
  for (Kerb& kerb : own.kerbs)
    if (own.edges[kerb.edge].empty()) kerb.edge = -1;
  const auto keep = [&](const EdgeSide& side) {
    if (!own.edges[side.edge].empty()) own.kept.push_back(side);
  };
  for (std::size_t other = 0; other < found.blocks.size(); ++other)
    for (const BlockSide& side : found.blocks[other].sides)
      if (other != b) keep(side.side);
  for (const EdgeSide& side : found.outside) keep(side);
  return own;
}

TEST(Block, IsTheSameOfItsOwnEdges) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const BlocksInput all = input_of(with_kerbs(random_town(seed, 24)));
    const Blocks found = blocks(all);
    for (std::size_t b = 0; b < found.blocks.size(); ++b) {
      const Blocks own = blocks(alone(all, found, b));
      ASSERT_EQ(own.blocks.size(), 1u) << seed << " block " << b;
      EXPECT_TRUE(same(own.blocks[0].surface, found.blocks[b].surface)) << seed << " block " << b;
      EXPECT_EQ(own.blocks[0].method, found.blocks[b].method) << seed;
      ASSERT_EQ(own.blocks[0].sides.size(), found.blocks[b].sides.size());
      for (std::size_t s = 0; s < own.blocks[0].sides.size(); ++s)
        EXPECT_EQ(own.blocks[0].sides[s].side.edge, found.blocks[b].sides[s].side.edge);
      EXPECT_TRUE(own.outside.empty());
    }
  }
}

}  // namespace block_test
}  // namespace streetgen
