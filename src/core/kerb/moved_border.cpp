#include "kerb/moved_border.hpp"

#include "geometry/box.hpp"
#include "geometry/tolerance.hpp"
#include "kerb/free_border.hpp"

namespace streetgen {

void MovedBorder::toggle(const MultiPolygon& surface, int level) {
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon)
      for (std::size_t i = 1; i < ring.size(); ++i) {
        const auto [side, came] =
            sides_.insert({1.0 * level, ring[i - 1].x, ring[i - 1].y, ring[i].x, ring[i].y});
        if (!came) sides_.erase(side);
      }
}

void MovedBorder::settle() {
  for (const auto& [level, from_x, from_y, to_x, to_y] : sides_)
    moved_.push_back({{from_x, from_y, 0}, {to_x, to_y, 0}});
  std::vector<Box> boxes;
  for (const auto& [from, to] : moved_) boxes.push_back(box_of(from, to));
  index_ = BoxIndex(boxes);
}

bool MovedBorder::lies_along(const MultiPolygon& surface) const {
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon)
      for (std::size_t i = 1; i < ring.size(); ++i)
        if (index_.any_near(box_of(ring[i - 1], ring[i]), same_place, [&](int k) {
              return streetgen::lie_along(moved_[k].first, moved_[k].second, ring[i - 1], ring[i]);
            }))
          return true;
  return false;
}

}  // namespace streetgen
