// The borders of the surfaces of one level as sides that neighbours share.
#pragma once

#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// Vertices are numbered. A side runs from the lower number to the higher one, so that what is
// computed along it does not depend on the surface that asks.
class BorderNet {
 public:
  using Segment = std::pair<int, int>;  // vertices

  explicit BorderNet(const std::vector<const MultiPolygon*>& surfaces);

  const Point& point(int vertex) const { return points_[vertex]; }
  // The number of the vertex in that place, a new one where there is none.
  int vertex(const Point& place);
  // The number of a place that is a vertex.
  int known_vertex(const Point& place) const { return numbers_.at({place.x, place.y}); }

  // The sides about a surface, by its place in the list.
  const std::vector<int>& sides(std::size_t surface) const { return sides_of_[surface]; }
  std::size_t side_count() const { return sides_.size(); }
  const Point& from(int side) const { return points_[sides_[side].from]; }
  const Point& to(int side) const { return points_[sides_[side].to]; }
  // Makes a vertex at a share of the side, or takes one of the side within a centimetre.
  int divide(int side, double share);
  // The vertices along a side, both ends included.
  std::vector<int> along(int side) const;
  // The border of a surface, with all vertices on it.
  std::vector<Segment> border(std::size_t surface) const;

 private:
  struct Side {
    int from, to;
    std::vector<std::pair<double, int>> between;  // shares of the side, ascending
  };
  struct Hash {
    std::size_t operator()(const std::pair<double, double>& place) const;
  };

  void weld(const std::vector<const MultiPolygon*>& surfaces);
  int side(int a, int b);
  void meet_vertices();
  void keep_pieces();

  std::vector<Point> points_;
  std::unordered_map<std::pair<double, double>, int, Hash> numbers_;
  std::vector<Side> sides_;
  std::unordered_map<std::size_t, int> known_sides_;
  std::vector<std::vector<int>> sides_of_;
};

// Metres. What would get a vertex so near to another one takes that one.
constexpr double vertex_reach = 0.01;

}  // namespace streetgen
