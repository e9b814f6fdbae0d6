// Parts of borders.
#pragma once

#include <vector>

#include "geometry/arrangement.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

inline void append_rings(const MultiPolygon& surface, std::vector<LineView>& lines) {
  for (const Polygon& polygon : surface) lines.insert(lines.end(), polygon.begin(), polygon.end());
}

// The stretches of the surface's rings whose sides, told by their ends, are near.
template <class Near>
void append_stretches(const MultiPolygon& surface, const Near& near, std::vector<LineView>& lines) {
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon)
      for (std::size_t first = 0, i = 1; i <= ring.size(); ++i) {
        if (i < ring.size() && near(ring[i - 1], ring[i])) continue;
        if (i - first > 1) lines.emplace_back(&ring[first], i - first);
        first = i;
      }
}

}  // namespace streetgen
