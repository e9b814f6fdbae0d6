#include "mesh/border_net.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

// Metres. Borders of neighbours keep about a micrometre apart at most; their vertices are one.
constexpr double weld_reach = 5e-6;

}  // namespace

std::size_t BorderNet::Hash::operator()(const std::pair<double, double>& place) const {
  const std::hash<double> hash;
  return hash(place.first) * 0x9e3779b97f4a7c15 + hash(place.second);
}

BorderNet::BorderNet(const std::vector<const MultiPolygon*>& surfaces) {
  weld(surfaces);
  for (const MultiPolygon* surface : surfaces) {
    std::vector<int>& own = sides_of_.emplace_back();
    for (const Polygon& polygon : *surface)
      for (const Ring& ring : polygon)
        for (std::size_t i = 1; i < ring.size(); ++i) {
          const int a = vertex(ring[i - 1]), b = vertex(ring[i]);
          if (a != b) own.push_back(side(a, b));
        }
  }
  meet_vertices();
  keep_pieces();
}

// In the order of their coordinates, so that the first of several in one place is always the same.
void BorderNet::weld(const std::vector<const MultiPolygon*>& surfaces) {
  std::vector<std::pair<double, double>> places;
  for (const MultiPolygon* surface : surfaces)
    for (const Polygon& polygon : *surface)
      for (const Ring& ring : polygon)
        for (const Point& p : ring) places.emplace_back(p.x, p.y);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::unordered_map<std::pair<double, double>, std::vector<int>, Hash> cells;
  for (const auto& place : places) {
    const Point p{place.first, place.second, 0};
    const double column = std::floor(p.x / weld_reach), row = std::floor(p.y / weld_reach);
    int known = -1;
    for (double i = -1; i <= 1 && known < 0; ++i)
      for (double j = -1; j <= 1 && known < 0; ++j) {
        const auto cell = cells.find({column + i, row + j});
        if (cell == cells.end()) continue;
        for (const int other : cell->second)
          if (known < 0 && distance(points_[other], p) <= weld_reach) known = other;
      }
    if (known >= 0) {
      numbers_[place] = known;
    } else {
      cells[{column, row}].push_back(vertex(p));
    }
  }
}

int BorderNet::vertex(const Point& place) {
  const auto [found, added] =
      numbers_.try_emplace({place.x, place.y}, static_cast<int>(points_.size()));
  if (added) points_.push_back(planar(place));
  return found->second;
}

int BorderNet::side(int a, int b) {
  if (a > b) std::swap(a, b);
  const std::size_t key = static_cast<std::size_t>(a) << 32 | static_cast<std::uint32_t>(b);
  const auto [found, added] = known_sides_.try_emplace(key, static_cast<int>(sides_.size()));
  if (added) sides_.push_back({a, b, {}});
  return found->second;
}

// Vertices of a neighbour on a side become the side's own.
void BorderNet::meet_vertices() {
  std::vector<Box> boxes;
  for (const Side& side : sides_) boxes.push_back(box_of(points_[side.from], points_[side.to]));
  const BoxIndex index(boxes);
  for (int vertex = 0; vertex < static_cast<int>(points_.size()); ++vertex) {
    poll_cancel();
    const Point& p = points_[vertex];
    index.each_near(box_of(p, p), weld_reach, [&](int number) {
      Side& side = sides_[number];
      if (vertex == side.from || vertex == side.to) return;
      const Point &a = points_[side.from], &b = points_[side.to];
      const double share = dot(p - a, b - a) / dot(b - a, b - a);
      if (share > 0 && share < 1 && distance_to_segment(p, a, b) <= weld_reach)
        side.between.emplace_back(share, vertex);
    });
  }
}

// The pieces between the vertices are the sides from now on. A surface on both sides of a piece
// goes over it.
void BorderNet::keep_pieces() {
  std::vector<Side> whole;
  whole.swap(sides_);
  known_sides_.clear();
  for (Side& side : whole) std::sort(side.between.begin(), side.between.end());
  for (std::vector<int>& own : sides_of_) {
    std::vector<int> pieces;
    for (const int number : own) {
      int last = whole[number].from;
      for (const auto& [share, vertex] : whole[number].between) {
        pieces.push_back(side(last, vertex));
        last = vertex;
      }
      pieces.push_back(side(last, whole[number].to));
    }
    std::sort(pieces.begin(), pieces.end());
    own.clear();
    for (std::size_t i = 0, next; i < pieces.size(); i = next) {
      for (next = i; next < pieces.size() && pieces[next] == pieces[i];) ++next;
      if ((next - i) % 2 == 1) own.push_back(pieces[i]);
    }
  }
}

int BorderNet::divide(int number, double share) {
  const Point a = from(number), b = to(number), p = a + (b - a) * share;
  if (distance(p, a) <= vertex_reach) return sides_[number].from;
  if (distance(p, b) <= vertex_reach) return sides_[number].to;
  for (const auto& [other, vertex] : sides_[number].between)
    if (distance(p, points_[vertex]) <= vertex_reach) return vertex;
  const int added = vertex(p);
  std::vector<std::pair<double, int>>& between = sides_[number].between;
  between.insert(std::lower_bound(between.begin(), between.end(), std::pair(share, added)),
                 {share, added});
  return added;
}

std::vector<int> BorderNet::along(int number) const {
  std::vector<int> vertices{sides_[number].from};
  for (const auto& [share, vertex] : sides_[number].between) vertices.push_back(vertex);
  vertices.push_back(sides_[number].to);
  return vertices;
}

std::vector<BorderNet::Segment> BorderNet::border(std::size_t surface) const {
  std::vector<Segment> segments;
  for (const int number : sides_of_[surface]) {
    const std::vector<int> vertices = along(number);
    for (std::size_t i = 1; i < vertices.size(); ++i)
      segments.emplace_back(vertices[i - 1], vertices[i]);
  }
  return segments;
}

}  // namespace streetgen
