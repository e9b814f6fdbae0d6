#include "roadway/shared_kerb.hpp"

#include <algorithm>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "roadway/street_face.hpp"

namespace streetgen {

namespace {

// Whether the kerbs of a corner meet on its own streets.
bool meets(const Layout& layout, const SolvedCorners& corners, const CornerPlace& at) {
  return !corners[at.node].empty() && corners[at.node][at.gap].gap.meets &&
         !layout.junctions[at.node].transition;
}

// The left kerb of a corner's first street, with the corner at its other end.
void share(Layout& layout, const CornerPlace& at, SolvedCorners& corners) {
  const EdgeEnd& end = layout.junctions[at.node].ends[at.gap];
  const double total = length(layout.arm(end).line);
  if (total > layout.settings.reach) return;
  const CornerPlace next = side_after(layout, {end, at}).corner;
  layout.junctions[at.node].followed.push_back(next.node);
  layout.junctions[next.node].followed.push_back(at.node);
  if (at == next || !meets(layout, corners, at) || !meets(layout, corners, next)) return;
  SolvedCorner &a = corners[at.node][at.gap], &b = corners[next.node][next.gap];
  if (a.limit_a + b.limit_b <= total + same_place) return;
  const auto from = kerb_crossing(layout, at), to = kerb_crossing(layout, next);
  if (!from || !to) return;
  const double room = std::max(0.0, total - from->abscissa_a - to->abscissa_b);
  const double left_by_a = room - (a.limit_a - from->abscissa_a),
               left_by_b = room - (b.limit_b - to->abscissa_b);
  a.ends.until_a = from->abscissa_a + std::max(room / 2, left_by_b);
  b.ends.until_b = to->abscissa_b + std::max(room / 2, left_by_a);
}

}  // namespace

void share_kerbs(Layout& layout, SolvedCorners& corners) {
  for (int n = 0; n < static_cast<int>(corners.size()); ++n)
    for (std::size_t i = 0; i < corners[n].size(); ++i) share(layout, {n, i}, corners);
}

}  // namespace streetgen
