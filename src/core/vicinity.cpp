#include "vicinity.hpp"

#include <algorithm>

#include "box_index.hpp"
#include "hole.hpp"
#include "polyline.hpp"

namespace streetgen {

namespace {

constexpr double noise = 1e-3;  // metres, of coordinates made in two ways

void add_stretch(Box& box, const Arm& arm, double start, double end) {
  Box axis;
  for (const Point& p : substring(arm.line, start, end)) axis.add(p);
  const Box roadway = axis.grown(std::max(arm.half_start, arm.half_end) + noise);
  box.add({roadway.min_x, roadway.min_y, 0});
  box.add({roadway.max_x, roadway.max_y, 0});
}

}  // namespace

Box section_extent(const Arm& arm, double start, double end) {
  Box box;
  add_stretch(box, arm, start, end);
  return box;
}

Box intersection_extent(const std::vector<Arm>& arms, const std::vector<Gap>& gaps) {
  Box box;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    double reach = arms[i].limit;
    // Limits that crossed lie before what the corners asked for.
    if (!gaps.empty()) {
      const Gap &left = gaps[i], &right = gaps[(i + gaps.size() - 1) % gaps.size()];
      if (left.meets) reach = std::max(reach, left.corner.abscissa_a);
      if (right.meets) reach = std::max(reach, right.corner.abscissa_b);
    }
    add_stretch(box, arms[i], 0, std::min(reach, length(arms[i].line)));
  }
  for (const Gap& gap : gaps) {
    // An arc lies between its ends and its centre.
    if (gap.meets)
      for (const Point& p : {gap.corner.arc.start, gap.corner.arc.end, gap.corner.centre})
        box.add(p);
    for (const Ring& ring : gap.beyond)
      for (const Point& p : ring) box.add(p);
  }
  return box;
}

std::vector<int> rings(const std::vector<Box>& extents, const std::vector<bool>& asked) {
  const BoxIndex index(extents);
  std::vector<int> ring;
  for (const bool is_asked : asked) ring.push_back(is_asked ? 0 : far_away);
  for (int next = 1; next <= last_ring; ++next) {
    const double margin = next == 2 ? hole_extent : 0;
    for (std::size_t i = 0; i < extents.size(); ++i) {
      if (ring[i] >= next) continue;
      for (const int j : index.near(extents[i], margin)) ring[j] = std::min(ring[j], next);
    }
  }
  return ring;
}

}  // namespace streetgen
