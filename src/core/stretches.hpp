// Parts of borders.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// The stretches of the surface's rings whose sides, told by their ends, are near.
template <class Near>
void append_stretches(const MultiPolygon& surface, const Near& near, std::vector<Line>& lines) {
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon) {
      bool goes_on = false;
      for (std::size_t i = 1; i < ring.size(); ++i) {
        const bool is_near = near(ring[i - 1], ring[i]);
        if (is_near && !goes_on) lines.push_back({ring[i - 1]});
        if (is_near) lines.back().push_back(ring[i]);
        goes_on = is_near;
      }
    }
}

}  // namespace streetgen
