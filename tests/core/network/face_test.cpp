#include "network/face.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <tuple>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "rounds.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

namespace streetgen {
namespace face_test {

NetworkFaces faces_of(const std::vector<Line>& edges) {
  return find_faces({edges.begin(), edges.end()});
}

std::string text(const std::vector<EdgeSide>& sides) {
  std::string words;
  for (const EdgeSide& side : sides)
    words += std::to_string(side.edge) + (side.left ? "l" : "r") + std::to_string(side.part) + " ";
  return words;
}

// Streets of a rectangle, 4 by 3, counter-clockwise from the origin.
const std::vector<Line> rectangle{
    {{0, 0}, {4, 0}}, {{4, 0}, {4, 3}}, {{4, 3}, {0, 3}}, {{0, 3}, {0, 0}}};

// All that must hold of any faces: each part of a side is walked once, and as many faces are there
// as Euler's formula counts for the segments of their rings.
void expect_whole(const NetworkFaces& found, const std::string& what) {
  std::set<std::tuple<int, bool, int>> sides;
  std::set<std::pair<double, double>> places;
  std::size_t count = 0, segments = 0, rings = found.outside.size();
  const auto look = [&](const FaceRing& ring) {
    for (const EdgeSide& side : ring.sides) sides.insert({side.edge, side.left, side.part});
    count += ring.sides.size();
    segments += ring.line.size() - 1;
    for (const Point& p : ring.line) places.insert({p.x, p.y});
  };
  for (const FaceRing& ring : found.outside) look(ring);
  for (const Face& face : found.faces) {
    EXPECT_GT(face.area, 0) << what;
    double area = 0;
    for (const FaceRing& ring : face.rings) {
      look(ring);
      area += signed_area(ring.line);
    }
    EXPECT_NEAR(face.area, area, 1e-6 * (1 + area)) << what;
    rings += face.rings.size() - 1;
  }
  EXPECT_EQ(sides.size(), count) << what;
  // Every other ring goes about something that hangs together.
  EXPECT_EQ(places.size() + found.faces.size(), segments / 2 + rings) << what;
}

TEST(Face, IsWhatStreetsEnclose) {
  const NetworkFaces found = faces_of(rectangle);
  ASSERT_EQ(found.faces.size(), 1u);
  EXPECT_DOUBLE_EQ(found.faces[0].area, 12);
  EXPECT_EQ(text(found.faces[0].rings[0].sides), "0l1 1l1 2l1 3l1 ");
  ASSERT_EQ(found.outside.size(), 1u);
  EXPECT_EQ(text(found.outside[0].sides), "0r1 3r1 2r1 1r1 ");
  EXPECT_DOUBLE_EQ(signed_area(found.outside[0].line), -12);
}

TEST(Face, WalksADeadEndToItsEndAndBack) {
  std::vector<Line> edges = rectangle;
  edges.push_back({{4, 0}, {2, 1}});
  edges.push_back({{0, 0}, {-1, -1}});
  const NetworkFaces found = faces_of(edges);
  ASSERT_EQ(found.faces.size(), 1u);
  EXPECT_DOUBLE_EQ(found.faces[0].area, 12);
  EXPECT_EQ(text(found.faces[0].rings[0].sides), "0l1 4l1 4r1 1l1 2l1 3l1 ");
  EXPECT_EQ(text(found.outside[0].sides), "0r1 5l1 5r1 3r1 2r1 1r1 ");
}

TEST(Face, OfALoopAndWhatHangsOnIt) {
  const NetworkFaces found =
      faces_of({{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}, {{0, 0}, {1, 2}, {2, 1}, {0, 0}}});
  ASSERT_EQ(found.faces.size(), 2u);
  EXPECT_DOUBLE_EQ(found.faces[0].area, 14.5);
  EXPECT_EQ(text(found.faces[0].rings[0].sides), "0l1 1l1 ");
  EXPECT_DOUBLE_EQ(found.faces[1].area, 1.5);
  EXPECT_EQ(text(found.faces[1].rings[0].sides), "1r1 ");
}

TEST(Face, HoldsIslandsThatHoldFaces) {
  std::vector<Line> edges = rectangle;
  edges.push_back({{1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}});  // an island
  edges.push_back({{1.4, 1.4}, {1.6, 1.6}});                  // within the island
  edges.push_back({{3, 1}, {3, 2}});                          // a line beside it
  edges.push_back({{9, 9}, {8, 8}});                          // in no face
  const NetworkFaces found = faces_of(edges);
  ASSERT_EQ(found.faces.size(), 2u);
  EXPECT_DOUBLE_EQ(found.faces[0].area, 11);
  ASSERT_EQ(found.faces[0].rings.size(), 3u);
  EXPECT_EQ(text(found.faces[0].rings[1].sides), "4r1 ");
  EXPECT_EQ(text(found.faces[0].rings[2].sides), "6l1 6r1 ");
  EXPECT_DOUBLE_EQ(found.faces[1].area, 1);
  EXPECT_EQ(text(found.faces[1].rings[1].sides), "5l1 5r1 ");
  EXPECT_EQ(found.outside.size(), 2u);
}

TEST(Face, HasAVertexWhereStreetsCrossWithoutANode) {
  const NetworkFaces found =
      faces_of({{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}, {{2, -1}, {2, 5}}});
  ASSERT_EQ(found.faces.size(), 2u);
  EXPECT_EQ(text(found.faces[0].rings[0].sides), "0l1 1l2 0l3 ");
  EXPECT_EQ(text(found.faces[1].rings[0].sides), "0l2 1r2 ");
  EXPECT_DOUBLE_EQ(found.faces[0].area, 8);
  const EdgeSide left = found.faces[1].rings[0].sides[0], right = found.faces[1].rings[0].sides[1];
  EXPECT_EQ(std::pair(left.start, left.end), std::pair(2.0, 10.0));
  EXPECT_EQ(std::pair(right.start, right.end), std::pair(1.0, 5.0));
  EXPECT_EQ(text(found.outside[0].sides), "0r1 0r3 1l3 1r3 0r2 1r1 1l1 ");
}

TEST(Face, OfStreetsThatLieOnEachOther) {
  std::vector<Line> edges = rectangle;
  edges.push_back({{4, 0}, {0, 0}});
  const NetworkFaces found = faces_of(edges);
  ASSERT_EQ(found.faces.size(), 1u);
  EXPECT_DOUBLE_EQ(found.faces[0].area, 12);
  EXPECT_EQ(text(found.faces[0].rings[0].sides), "0l1 4r1 1l1 2l1 3l1 ");
  EXPECT_EQ(text(found.outside[0].sides), "0r1 4l1 3r1 2r1 1r1 ");
}

TEST(Face, OfANetworkThatIsOneLineIsNone) {
  const NetworkFaces found = faces_of({{{0, 0}, {5, 1}, {9, 0}}});
  EXPECT_TRUE(found.faces.empty());
  ASSERT_EQ(found.outside.size(), 1u);
  EXPECT_EQ(text(found.outside[0].sides), "0l1 0r1 ");
  EXPECT_TRUE(faces_of({}).faces.empty());
  EXPECT_TRUE(faces_of({{}, {{1, 1}}, {{2, 2}, {2, 2}}}).outside.empty());
}

TEST(Face, IsOfOneLevel) {
  Network network;
  network.nodes.resize(1);
  for (const int level : {0, 1})
    for (const Line& line : rectangle) network.edges.push_back({1, 0, 0, level, 0, 1, line});
  const NetworkFaces found = find_faces(network, 1);
  ASSERT_EQ(found.faces.size(), 1u);
  EXPECT_EQ(text(found.faces[0].rings[0].sides), "4l1 5l1 6l1 7l1 ");
}

std::vector<Line> random_edges(unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<Point> places;
  for (int i = 0; i < 12; ++i)
    places.push_back({650000 + random() % 1000 / 7.0, 6860000 + random() % 1000 / 7.0, 0});
  std::vector<Line> edges;
  for (int i = 0; i < 25; ++i) {
    Line line;
    for (std::size_t k = 0; k < 2 + random() % 3; ++k) line.push_back(places[random() % 12]);
    if (random() % 5 == 0) line.push_back(line.front());
    edges.push_back(line);
  }
  return edges;
}

// Lines that cross, touch, lie on each other and go back on themselves.
TEST(Face, OfAnyLinesAreThoseOfAPolygonizer) {
  Geos geos;
  for (int seed = 1; seed <= rounds(200); ++seed) {
    const NetworkFaces found = faces_of(random_edges(seed));
    expect_whole(found, std::to_string(seed));
    std::set<std::pair<std::pair<double, double>, std::pair<double, double>>> sides;
    const auto look = [&](const FaceRing& ring) {
      for (std::size_t i = 1; i < ring.line.size(); ++i) {
        const Point &a = ring.line[i - 1], &b = ring.line[i];
        sides.insert(std::minmax(std::pair(a.x, a.y), std::pair(b.x, b.y)));
      }
    };
    for (const Face& face : found.faces) std::for_each(face.rings.begin(), face.rings.end(), look);
    std::for_each(found.outside.begin(), found.outside.end(), look);
    std::vector<std::pair<Point, Point>> segments;
    for (const auto& [a, b] : sides)
      segments.push_back({{a.first, a.second, 0}, {b.first, b.second, 0}});
    double all = 0;
    for (const Face& face : found.faces) all += face.area;
    const MultiPolygon polygons = geos.faces(segments);
    EXPECT_EQ(found.faces.size(), polygons.size()) << seed;
    EXPECT_NEAR(all, area(polygons), 1e-6 * all) << seed;
  }
}

// What a ring names, without where it begins.
std::multiset<std::string> names(const NetworkFaces& found, bool mirrored) {
  std::multiset<std::string> all;
  for (const Face& face : found.faces) {
    std::set<std::tuple<int, bool, int>> sides;
    for (const FaceRing& ring : face.rings)
      for (const EdgeSide& side : ring.sides)
        sides.insert({side.edge, side.left != mirrored, side.part});
    std::string name;
    for (const auto& [edge, left, part] : sides)
      name += std::to_string(edge) + (left ? "l" : "r") + std::to_string(part) + " ";
    all.insert(name);
  }
  return all;
}

// Exact on the grid: by whole metres and quarter turns.
TEST(Face, IsTheSameMirroredTurnedAndMoved) {
  for (int seed = 1; seed <= rounds(50); ++seed) {
    std::vector<Line> edges = random_edges(seed), mirrored = edges, turned = edges, moved = edges;
    for (Line& line : edges)
      for (Point& p : line) p = {std::floor(p.x - 650000), std::floor(p.y - 6860000), 0};
    mirrored = turned = moved = edges;
    for (Line& line : mirrored)
      for (Point& p : line) p.x = -p.x;
    for (Line& line : turned)
      for (Point& p : line) p = left_normal(p);
    for (Line& line : moved)
      for (Point& p : line) p = p + Point{1e9, -1e9, 0};
    const auto expected = names(faces_of(edges), false);
    EXPECT_EQ(names(faces_of(mirrored), true), expected) << seed;
    EXPECT_EQ(names(faces_of(turned), false), expected) << seed;
    EXPECT_EQ(names(faces_of(moved), false), expected) << seed;
  }
}

// A face keeps its ring whatever else the network has: edits look at some faces alone.
TEST(Face, OfItsOwnEdgesIsTheSame) {
  for (int seed = 1; seed <= rounds(50); ++seed) {
    const std::vector<Line> edges = random_edges(seed);
    const NetworkFaces all = faces_of(edges);
    for (const Face& face : all.faces) {
      std::vector<Line> own(edges.size());
      for (const FaceRing& ring : face.rings)
        for (const EdgeSide& side : ring.sides) own[side.edge] = edges[side.edge];
      const NetworkFaces alone = faces_of(own);
      EXPECT_TRUE(std::any_of(alone.faces.begin(), alone.faces.end(), [&](const Face& other) {
        return std::abs(other.area - face.area) < 1e-6;
      })) << seed;
    }
  }
}

TEST(Face, OfACityIsFoundAndCancelled) {
  std::vector<Line> edges;
  const int count = 100;
  for (int x = 0; x < count; ++x)
    for (int y = 0; y < count; ++y) {
      const double left = 100.0 * x, low = 100.0 * y;
      if (x + 1 < count) edges.push_back({{left, low}, {left + 100, low}});
      if (y + 1 < count) edges.push_back({{left, low}, {left, low + 100}});
    }
  const NetworkFaces found = faces_of(edges);
  EXPECT_EQ(found.faces.size(), 99u * 99u);
  expect_whole(found, "grid");
  set_cancel_check([]() noexcept { return true; });
  EXPECT_THROW(faces_of(edges), Error);
  set_cancel_check(nullptr);
}

}  // namespace face_test
}  // namespace streetgen
