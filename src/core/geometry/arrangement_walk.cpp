#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/arrangement.hpp"
#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"
#include "support/disjoint_sets.hpp"

namespace streetgen {

std::vector<int> Arrangement::sides_of(int walk) const {
  return {walked_.begin() + (walk > 0 ? walks_[walk - 1] : 0), walked_.begin() + walks_[walk]};
}

std::vector<int> Arrangement::way(int line) const {
  return {way_sides_.begin() + (line > 0 ? ways_[line - 1] : 0), way_sides_.begin() + ways_[line]};
}

std::vector<double> Arrangement::areas() const {
  std::vector<double> areas;
  areas.reserve(walks_.size());
  for (std::size_t walk = 0, i = 0; walk < walks_.size(); ++walk) {
    const GridCell origin = nodes_[halves_[walked_[i]].from].cell;
    Wide sum = 0;
    for (; i < static_cast<std::size_t>(walks_[walk]); ++i) {
      const Half& half = halves_[walked_[i]];
      sum += twice_area(origin, nodes_[half.from].cell, nodes_[half.to].cell);
    }
    areas.push_back(static_cast<double>(sum) / 2 * step_ * step_);
  }
  return areas;
}

// By walk, the leftmost node of what hangs together with it: the same of all its walks.
std::vector<int> Arrangement::islands() const {
  Groups together(static_cast<int>(nodes_.size()));
  for (std::size_t h = 0; h < halves_.size(); h += 2) together.join(halves_[h].from, halves_[h].to);
  std::vector<int> islands;
  islands.reserve(walks_.size());
  for (std::size_t walk = 0; walk < walks_.size(); ++walk)
    islands.push_back(together.of(halves_[walked_[walks_[walk] - 1]].from));
  return islands;
}

// Of a place that is on no side of the walk.
bool Arrangement::walk_holds(int walk, const GridCell& cell) const {
  bool odd = false;
  for (int i = walk > 0 ? walks_[walk - 1] : 0; i < walks_[walk]; ++i) {
    const GridCell &a = nodes_[halves_[walked_[i]].from].cell,
                   &b = nodes_[halves_[walked_[i]].to].cell;
    if ((a.y > cell.y) != (b.y > cell.y)) odd ^= (side(a, b, cell) > 0) == (b.y > a.y);
  }
  return odd;
}

// The smallest face of another island that holds the leftmost node.
std::vector<int> Arrangement::faces_of_walks() const {
  const std::vector<double> area = areas();
  const std::vector<int> island = islands();
  std::vector<Box> boxes(walks_.size());
  for (const int h : walked_)
    if (area[halves_[h].walk] > 0) boxes[halves_[h].walk].add(nodes_[halves_[h].from].point);
  const BoxIndex index(boxes);
  std::vector<int> faces(walks_.size());
  for (int walk = 0; walk < walk_count(); ++walk) {
    faces[walk] = area[walk] > 0 ? walk : -1;
    if (area[walk] > 0) continue;
    poll_cancel();
    const auto& [cell, point] = nodes_[island[walk]];
    index.each_near(box_of(point, point), step_, [&, &cell = cell](int other) {
      int& face = faces[walk];
      if (island[other] != island[walk] && (face < 0 || area[other] < area[face]) &&
          walk_holds(other, cell))
        face = other;
    });
  }
  return faces;
}

}  // namespace streetgen
