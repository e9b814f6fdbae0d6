// Places on a grid, and on which side of a line they lie, exactly.
#pragma once

#include <cmath>
#include <cstdint>

namespace streetgen {

struct GridCell {
  std::int64_t x, y;  // steps of the grid
  bool operator<(const GridCell& o) const { return x != o.x ? x < o.x : y < o.y; }
  bool operator==(const GridCell& o) const { return x == o.x && y == o.y; }
};

__extension__ using Wide = __int128;

// Twice the area of a, b, c: positive where c lies left.
inline Wide twice_area(const GridCell& a, const GridCell& b, const GridCell& c) {
  return Wide(b.x - a.x) * (c.y - a.y) - Wide(b.y - a.y) * (c.x - a.x);
}

// The same in doubles, which hold differences of cells exactly, and how far it may be off.
struct About {
  double value, error;
};
inline About about_twice_area(const GridCell& a, const GridCell& b, const GridCell& c) {
  const double left = static_cast<double>(b.x - a.x) * static_cast<double>(c.y - a.y);
  const double right = static_cast<double>(b.y - a.y) * static_cast<double>(c.x - a.x);
  return {left - right, 0x1p-50 * (std::abs(left) + std::abs(right))};
}

inline int sign(Wide value) { return (value > 0) - (value < 0); }

inline int side(const GridCell& a, const GridCell& b, const GridCell& c) {
  const About about = about_twice_area(a, b, c);
  if (about.value > about.error) return 1;
  if (about.value < -about.error) return -1;
  return sign(twice_area(a, b, c));
}

}  // namespace streetgen
