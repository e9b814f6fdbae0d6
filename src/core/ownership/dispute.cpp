#include "ownership/dispute.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/box_hierarchy.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "geometry/voronoi_border.hpp"
#include "layout/surface_ring.hpp"
#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

constexpr double sample_spacing = 1.0;  // metres along the axes

// Whether the two lie on either side of the line through from and to.  Noise tells no side of what
// lies on the line, as where two stretches overlap on one edge.
bool parted_by(const Point& from, const Point& to, const Point& a, const Point& b) {
  const double off_a = cross(to - from, a - from), off_b = cross(to - from, b - from);
  return off_a * off_b < 0 &&
         std::min(std::abs(off_a), std::abs(off_b)) > same_place * distance(from, to);
}

bool segments_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  return parted_by(a, b, c, d) && parted_by(c, d, a, b);
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
      if (box_of(line[i - 1], line[i]).meets(within))
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
  const BoxHierarchy index(std::move(boxes));
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

// Into how many parts a segment is divided.  The bounds lie beside round lengths, which are drawn
// so and come with noise.
int parts_of(double segment) {
  return std::max(1, static_cast<int>(segment / sample_spacing + 0.5137));
}

// Places on a piece of a line, a part of a segment of its axis.
struct Division {
  double step;        // metres
  double offset = 0;  // metres: the first place lies this far before the piece
  double scale = 1;
};

Division division_of(const Stretch& stretch, std::size_t piece, double size) {
  const EndSegments& ends = stretch.segments;
  const bool first = piece == 1 && ends.first > 0,
             last = piece + 1 == stretch.line->size() && ends.last > 0;
  if (first && stretch.line->size() == 2) {
    const double kept = ends.first - ends.before - ends.beyond;
    if (kept < same_place) return {size / parts_of(size)};
    return {ends.first / parts_of(ends.first), ends.before, size / kept};
  }
  const double segment = first ? ends.first : last ? ends.last : size;
  return {segment / parts_of(segment), first ? segment - size : 0};
}

// About every metre, in equal parts of each segment of the axis, wherever the axis is cut and
// whatever part of it the stretch is: the same from either end.  Both ends of an edge, too.
template <class Use>
void each_sample_place(const Stretch& stretch, Use use) {
  const Line& line = *stretch.line;
  const auto inside = [&](double at) {
    return at > stretch.from + same_place && at < stretch.to - same_place;
  };
  bool any = stretch.from <= same_place;
  if (any) use(line.front());
  double walked = 0;
  for (std::size_t i = 1; i < line.size() && walked <= stretch.to; ++i) {
    const double size = distance(line[i - 1], line[i]);
    if (walked + size >= stretch.from) {
      const auto [step, offset, scale] = division_of(stretch, i, size);
      const double begin = std::max(0.0, stretch.from - walked) / scale + offset;
      for (double k = std::floor(begin / step);; ++k) {
        const double at = (k * step - offset) * scale;
        if (at > size - same_place || walked + at > stretch.to) break;
        if (at < same_place || !inside(walked + at)) continue;
        any = true;
        use(line[i - 1] + (line[i] - line[i - 1]) * (at / size));
      }
    }
    walked += size;
    if (i + 1 == line.size() || !inside(walked)) continue;
    any = true;
    use(line[i]);
  }
  if (stretch.to >= length(line) - same_place)
    use(line.back());
  else if (!any)
    use(position_at(line, (stretch.from + stretch.to) / 2).point);
}

// How far from the box a place of the claim may count: a section lies within half its width of its
// axis, an intersection may not.
double margin_of(const Claim& claim) {
  return claim.skeleton.size() > 1 ? infinite : claim.width / 2 + 2 * sample_spacing;
}

std::vector<Point> places_near(const Claim& claim, const Box& within) {
  std::vector<Point> places;
  const double margin = margin_of(claim);
  for (const Stretch& stretch : claim.skeleton)
    each_sample_place(stretch, [&](const Point& place) {
      const Point p = planar(place);
      if (within.holds(p, margin)) places.push_back(p);
    });
  return places;
}

// Takes off the places beside which the other skeleton runs, nearer than places lie apart, but for
// a node: the places of two such lines alternate, and the border between them has teeth.
void leave_out_beside(const Claim& other, const Box& within, const std::optional<Point>& node,
                      std::vector<Point>& places) {
  const std::vector<SkeletonSegment> segments =
      skeleton_within(other, within.grown(margin_of(other)));
  std::vector<Box> boxes;
  for (const SkeletonSegment& segment : segments) boxes.push_back(box_of(segment.from, segment.to));
  const BoxHierarchy index(std::move(boxes));
  const auto runs_beside = [&](const Point& place) {
    if (node && distance(place, *node) <= same_place) return false;
    return index.any_near(box_of(place, place), sample_spacing, [&](std::size_t i) {
      const auto& [from, to, first, last] = segments[i];
      const Point foot = nearest_on_segment(place, from, to);
      return distance(foot, place) < sample_spacing && distance(foot, first) > same_place &&
             distance(foot, last) > same_place;
    });
  };
  places.erase(std::remove_if(places.begin(), places.end(), runs_beside), places.end());
}

// Of sites in one place the claim that comes before keeps it, and where levels meet, whose border
// is a kerb, that claim keeps all ground about axes that run one beside the other.
std::vector<Site> sites_of(const Claim& winner, const Claim& loser, bool first_wins,
                           const Box& within) {
  const std::vector<Point> of_winner = places_near(winner, within);
  std::vector<Point> of_loser = places_near(loser, within);
  if (winner.level != loser.level) leave_out_beside(winner, within, loser.node, of_loser);
  std::vector<Site> sites;
  sites.reserve(of_winner.size() + of_loser.size());
  for (const Point& place : of_winner) sites.push_back({place, first_wins});
  for (const Point& place : of_loser) sites.push_back({place, !first_wins});
  return sites;
}

// The parts of the segment on the ground of both; where one ends on a border of the ground, it goes
// a little on. Segments that go on from each other keep their common end.  A part that ends at a
// vertex goes through it: beyond the vertex it may run along the border.
void append_shared(const PreparedSurface& a, const PreparedSurface& b, const Point& from,
                   const Point& to, std::vector<Line>& parts) {
  const Point along = to - from, past = along * (coordinate_margin / norm(along));
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
    const auto append_vertex = [&](double at) {
      const Point place = from + along * at;
      const Point* vertex = a.vertex_at(place);
      if (vertex == nullptr) vertex = b.vertex_at(place);
      if (vertex != nullptr) part.push_back(planar(*vertex));
    };
    const Point start = from + along * first - past, end = from + along * last + past;
    if (first > 0 || !shared(start)) part.push_back(start);
    first == 0 ? part.push_back(from) : append_vertex(first);
    last == 1 ? part.push_back(to) : append_vertex(last);
    if (last < 1 || !shared(end)) part.push_back(end);
    parts.push_back(std::move(part));
  }
}

}  // namespace

Dispute::Dispute(const Disputant& a, const Disputant& b) {
  Box within = a.ground->box().shared_with(b.ground->box());
  const bool first_wins = before(*a.claim, *b.claim);
  const Disputant &winner = first_wins ? a : b, &loser = first_wins ? b : a;
  // A node on the border would be lost by noise.
  const bool takes_node = loser.claim->node && winner.ground->reaches(*loser.claim->node);
  crossed_ = !takes_node && skeletons_cross(*a.claim, *b.claim, within);
  first_owns_all_ = crossed_ && first_wins;
  if (crossed_) return;
  // Border there is on the ground of both.
  for (const PreparedSurface* ground : {a.ground, b.ground, a.ground, b.ground})
    if (const Box held = ground->box_within(within); held.min_x <= held.max_x) within = held;
  const std::vector<Site> sites = sites_of(*winner.claim, *loser.claim, first_wins, within);
  if (sites.empty()) return;
  nearest_.emplace(sites, within);
  for (const auto& [from, to] : nearest_->border()) {
    poll_cancel();
    append_shared(*a.ground, *b.ground, from, to, border_);
  }
}

bool Dispute::first_owns(const Point& place) const {
  return nearest_ ? nearest_->first_owns(place) : first_owns_all_;
}

}  // namespace streetgen
