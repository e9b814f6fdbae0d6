// A path from lane to lane as few lines and arcs, which set out and arrive as the lanes lead.
#include <optional>
#include <utility>

#include "geometry/polyline.hpp"
#include "road/fit_arcs.hpp"
#include "road/path_guide.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/plan_view.hpp"

namespace streetgen {

namespace {

// The fewest arcs within what the guide allows.  Where more arcs come no nearer, fewer will do
// that leave it by a little, which is more for many arcs.
std::optional<FittedArcs> few_arcs(const PathGuide& guide) {
  constexpr double nearer = 0.7, wider = 1.4;
  std::optional<FittedArcs> best = fit_one_arc(guide);
  double allowed = 1;
  for (const int count : {2, 3, 4, 5, 6, 8, most_arcs}) {
    if (best && best->worst <= 1) break;
    poll_cancel();
    auto fitted = fit_arcs(guide, first_arcs(guide, count));
    if (fitted && (!best || fitted->worst < nearer * best->worst))
      best = std::move(fitted);
    else if (best && best->worst <= allowed)
      break;
    allowed *= wider;
  }
  return best;
}

}  // namespace

std::vector<PlanPiece> path_view(const Line& path, const ChainPlace& from, const ChainPlace& to,
                                 double tolerance, double lane_width) {
  const Line ends{planar(from.point), planar(to.point)};
  if (same(ends[0], ends[1])) return {};
  Line line = distinct(planar(path_beside(path, from, to)));
  if (line.size() < 2) line = ends;
  const auto arcs = few_arcs(path_guide(line, from, to, tolerance, lane_width));
  if (arcs) return ArcChain({ends[0], from.heading}, arcs->arcs).pieces();
  return plan_view(ends, tolerance, {from.heading, to.heading});
}

}  // namespace streetgen
