#include "rivalry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "box_runs.hpp"
#include "nearest.hpp"
#include "polyline.hpp"
#include "ring.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double beyond = 1e-3;  // metres: a border goes on so far past the ground's, to meet it

bool segments_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double o1 = cross(b - a, c - a), o2 = cross(b - a, d - a);
  const double o3 = cross(d - c, a - c), o4 = cross(d - c, b - c);
  return o1 * o2 < 0 && o3 * o4 < 0;
}

// A segment of a claim's skeleton, with the ends of the stretch that it belongs to.
struct SkeletonSegment {
  Point from, to, first, last;
};

std::vector<SkeletonSegment> skeleton_within(const Claim& claim, const Box& within) {
  std::vector<SkeletonSegment> segments;
  for (const Stretch& stretch : claim.skeleton) {
    if (stretch.from >= stretch.to) continue;
    const Line line = substring(*stretch.line, stretch.from, stretch.to);
    for (std::size_t i = 1; i < line.size(); ++i)
      if (box_of(line[i - 1], line[i]).meets(within, 0))
        segments.push_back({line[i - 1], line[i], line.front(), line.back()});
  }
  return segments;
}

// Inside both, not at an end that they share.
bool skeletons_cross(const Claim& a, const Claim& b, const Box& within) {
  const std::vector<SkeletonSegment> of_a = skeleton_within(a, within),
                                     of_b = skeleton_within(b, within);
  std::vector<Box> boxes;
  for (const SkeletonSegment& segment : of_b) boxes.push_back(box_of(segment.from, segment.to));
  const BoxRuns index(std::move(boxes));
  for (const SkeletonSegment& s : of_a) {
    poll_cancel();
    const bool crossed = index.any_near(box_of(s.from, s.to), 0, [&](std::size_t i) {
      const SkeletonSegment& t = of_b[i];
      if (!segments_cross(s.from, s.to, t.from, t.to)) return false;
      const Point u = s.to - s.from, v = t.to - t.from;
      const Point at = s.from + u * (cross(t.from - s.from, v) / cross(u, v));
      return std::min({distance(at, s.first), distance(at, s.last), distance(at, t.first),
                       distance(at, t.last)}) > 0.01;
    });
    if (crossed) return true;
  }
  return false;
}

std::vector<Straight> pieces_of(const Claim& claim, const Point& origin) {
  std::vector<Straight> pieces;
  for (const Stretch& stretch : claim.skeleton)
    append_pieces(*stretch.line, stretch.from, stretch.to, origin, pieces);
  return pieces;
}

// A section lies within half its width of its axis, an intersection may not.
double reach_of(const Claim& claim) {
  constexpr double margin = 1;  // metres
  return claim.node ? std::numeric_limits<double>::infinity() : claim.width / 2 + margin;
}

// The parts of the segment on the ground of both; where one ends on a border of the ground, it goes
// a little on. Segments that go on from each other keep their common end.
void append_shared(const Ground& a, const Ground& b, const Point& from, const Point& to,
                   std::vector<Line>& parts) {
  const Point along = to - from, past = along * (beyond / norm(along));
  const auto shared = [&](const Point& p) { return a.holds(p) && b.holds(p); };
  std::vector<double> cuts;
  const auto cut = [&](const Point& start, const Point& end) {
    a.cut(start, end, cuts);
    b.cut(start, end, cuts);
  };
  cut(from - past, to + past);
  if (cuts.empty()) {
    if (shared(from + along * 0.5)) parts.push_back({from, to});
    return;
  }
  cuts = {0, 1};
  cut(from, to);
  std::sort(cuts.begin(), cuts.end());
  const auto on_both = [&](std::size_t i) {
    return i < cuts.size() && shared(from + along * ((cuts[i - 1] + cuts[i]) / 2));
  };
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (!on_both(i)) continue;
    const double first = cuts[i - 1];
    while (on_both(i + 1)) ++i;
    const double last = cuts[i];
    Line part;
    const Point start = from + along * first - past, end = from + along * last + past;
    if (first > 0 || !shared(start)) part.push_back(start);
    if (first == 0) part.push_back(from);
    if (last == 1) part.push_back(to);
    if (last < 1 || !shared(end)) part.push_back(end);
    parts.push_back(std::move(part));
  }
}

}  // namespace

bool before(const Claim& a, const Claim& b) {
  return std::tuple(a.importance, -a.width, a.axis_id, a.place) <
         std::tuple(b.importance, -b.width, b.axis_id, b.place);
}

Rivalry::Rivalry(const Party& a, const Party& b) {
  Box within = a.ground->box().shared_with(b.ground->box());
  const bool first_wins = before(*a.claim, *b.claim);
  const Party &winner = first_wins ? a : b, &loser = first_wins ? b : a;
  const bool takes_node = loser.claim->node && winner.ground->holds(*loser.claim->node);
  crossed_ = !takes_node && skeletons_cross(*a.claim, *b.claim, within);
  first_owns_all_ = crossed_ && first_wins;
  if (crossed_) return;
  // Border there is on the ground of both.
  for (const Ground* ground : {a.ground, b.ground})
    if (const Box held = ground->box_within(within); held.min_x <= held.max_x) within = held;
  const Point origin{within.min_x, within.min_y, 0};
  const std::vector<Straight> of_winner = pieces_of(*winner.claim, origin),
                              of_loser = pieces_of(*loser.claim, origin);
  if (of_winner.empty() && of_loser.empty()) return;
  first_leads_ = first_wins;
  nearest_.emplace(of_winner, of_loser, origin, within,
                   std::min(reach_of(*winner.claim), reach_of(*loser.claim)));
  for (const auto& [from, to] : nearest_->border())
    append_shared(*a.ground, *b.ground, from, to, border_);
}

bool Rivalry::first_owns(const Point& place) const {
  return nearest_ ? nearest_->leader_owns(place) == first_leads_ : first_owns_all_;
}

}  // namespace streetgen
