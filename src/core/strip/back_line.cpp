#include "strip/back_line.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "geometry/closed_ring.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "strip/bend.hpp"

namespace streetgen {

namespace {

constexpr double parallel_sine = 1e-6;
constexpr int looked_at = 32;  // vertices about a segment, before others are

void append_until(Line& line, const Line& way, const BackLine::Place& place) {
  line.insert(line.end(), way.begin(), way.begin() + place.way_before + 1);
}

// The line behind a segment.
struct BackSide {
  int segment;
  Point from, to, along;
  Line start;  // where it begins: more than one place about a bend
  int previous = -1, next = -1;
  bool there = true;
};

Line corner_between(const std::vector<KerbSegment>& segments, const BackSide& a,
                    const BackSide& b) {
  const KerbSegment &first = segments[a.segment], &second = segments[b.segment];
  if (same(first.to, second.from)) {
    if (is_outer_bend(first.along, second.along)) {
      Line bend{a.to};
      append_arc(bend, second.from, a.to, b.from, false, bend_quarter);
      bend.push_back(b.from);
      return bend;
    }
  }
  const double sine = cross(a.along, b.along);
  if (std::abs(sine) < parallel_sine)
    return distance(a.to, b.from) > same_place ? Line{a.to, b.from} : Line{b.from};
  return {a.from + a.along * (cross(b.from - a.from, b.along) / sine)};
}

// The sides between which the line turns; those that lie backwards are left out.
class Corners {
 public:
  Corners(const std::vector<KerbSegment>& segments, const FrontPassed& passed, bool is_closed)
      : segments_(segments) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
      if (!passed.bounds_back[i]) continue;
      const auto& [from, to, width_from, width_to, kerb, along] = segments[i];
      const Point normal = left_normal(along);
      const Point begin = from + normal * width_from, end = to + normal * width_to;
      sides_.push_back({static_cast<int>(i), begin, end, unit(end - begin), {}});
    }
    for (int i = 1; i < count(); ++i) join(i - 1, i);
    if (is_closed && count() > 1) join(count() - 1, 0);
    leave_out();
  }

  void append_to(Line& line, std::vector<int>& segment_of,
                 std::vector<std::pair<Point, Point>>& side_of) const {
    for (const BackSide& side : sides_) {
      if (!side.there) continue;
      Line places = side.start;
      // An open line goes on beyond its ends, so that ways to there meet it.
      if (side.previous < 0) places = {side.from - side.along * beyond(side)};
      if (side.next < 0) places.push_back(side.to + side.along * beyond(side));
      for (const Point& place : places) {
        line.push_back(place);
        segment_of.push_back(side.segment);
        side_of.emplace_back(place, place);
      }
      side_of[line.size() - (side.next < 0 ? 2 : 1)] = {side.from, side.to};
    }
  }

 private:
  int count() const { return static_cast<int>(sides_.size()); }
  double beyond(const BackSide& side) const {
    const KerbSegment& segment = segments_[side.segment];
    return 2 * std::max(segment.width_from, segment.width_to) + coordinate_margin;
  }

  void join(int a, int b) {
    sides_[b].start = corner_between(segments_, sides_[a], sides_[b]);
    sides_[a].next = b;
    sides_[b].previous = a;
  }

  // Metres that the line goes backwards along a side; a side about a bend stays.
  double backwards(int i) const {
    const BackSide& side = sides_[i];
    const int before = side.previous, after = side.next;
    if (!side.there || before < 0 || after < 0 || before == after) return 0;
    if (side.start.size() > 1 || sides_[after].start.size() > 1) return 0;
    return -dot(sides_[after].start.front() - side.start.back(), side.along);
  }

  // The one first that lies the farthest backwards, whichever way the kerbs are walked along.
  void leave_out() {
    std::set<std::pair<double, int>> ahead;
    std::vector<double> known(sides_.size());
    const auto look_at = [&](int i) {
      ahead.erase({known[i], i});
      known[i] = backwards(i);
      if (known[i] > same_place) ahead.insert({known[i], i});
    };
    for (int i = 0; i < count(); ++i) look_at(i);
    while (!ahead.empty()) {
      const int i = ahead.rbegin()->second;
      const int before = sides_[i].previous, after = sides_[i].next;
      sides_[i].there = false;
      join(before, after);
      for (const int each : {before, i, after}) look_at(each);
    }
  }

  const std::vector<KerbSegment>& segments_;
  std::vector<BackSide> sides_;
};

}  // namespace

BackLine::BackLine(const std::vector<KerbSegment>& segments, const FrontPassed& passed,
                   bool is_closed)
    : is_closed_(is_closed) {
  Corners(segments, passed, is_closed).append_to(line_, segment_of_, side_of_);
}

// Told by the line behind the segment, which stays the same where its neighbours cut it.
Point BackLine::crossing(const Point& from, const Point& ahead, int vertex) const {
  auto [a, b] = side_of_[vertex];
  if (same(a, b)) b = line_[(vertex + 1) % count()];
  const double side_a = cross(ahead, a - from), side_b = cross(ahead, b - from);
  return a + (b - a) * (side_a / (side_a - side_b));
}

std::optional<BackLine::Place> BackLine::meeting(const Line& way, int segment) const {
  const int edges = is_closed_ ? count() : count() - 1;
  if (edges < 1) return std::nullopt;
  const int nearest = static_cast<int>(
      std::lower_bound(segment_of_.begin(), segment_of_.end(), segment) - segment_of_.begin());
  for (int reach = looked_at;; reach *= 8) {
    const bool all = 2 * reach >= edges;
    const int from = all ? 0 : nearest - reach, to = all ? edges : nearest + reach;
    std::optional<Place> first;
    for (std::size_t w = 1; w < way.size() && !first; ++w) {
      const Point ahead = way[w] - way[w - 1];
      double least = 0;
      for (int k = from; k < to; ++k) {
        if (!is_closed_ && (k < 0 || k >= edges)) continue;
        const int i = (k + edges) % edges;
        const Point &a = line_[i], &b = line_[(i + 1) % count()];
        const double side_a = cross(ahead, a - way[w - 1]), side_b = cross(ahead, b - way[w - 1]);
        if ((side_a < 0) == (side_b < 0)) continue;
        const Point place = crossing(way[w - 1], ahead, i);
        const double share = dot(place - way[w - 1], ahead) / dot(ahead, ahead);
        const double slack = rounding / norm(ahead);
        if (share < -slack || share > 1 + slack || (first && share >= least)) continue;
        first = Place{distance(place, a) <= same_place   ? a
                      : distance(place, b) <= same_place ? b
                                                         : place,
                      i, static_cast<int>(w) - 1};
        least = share;
      }
    }
    if (first || all) return first;
  }
}

// A place at a vertex lies on both sides there, and rounding tells which of them a way meets.
bool BackLine::faces(const Place& place, const Point& along) const {
  const auto goes_back = [&](int vertex) {
    const Point behind = line_[(vertex + 1) % count()] - line_[(vertex + count()) % count()];
    return dot(behind, along) < facing_cosine * norm(behind) * norm(along);
  };
  const auto lies_at = [&](int vertex) {
    return distance(place.point, line_[vertex % count()]) == 0 &&
           (is_closed_ || (vertex > 0 && vertex + 1 < count()));
  };
  const int before = place.before;
  return goes_back(before) && (!lies_at(before) || goes_back(before - 1)) &&
         (!lies_at(before + 1) || goes_back(before + 1));
}

Line BackLine::between(const Place& from, const Place& to) const {
  Line part{from.point};
  const int last = to.before < from.before ? to.before + count() : to.before;
  for (int i = from.before + 1; i <= last; ++i) part.push_back(line_[i % count()]);
  part.push_back(to.point);
  return part;
}

Ring ring_behind(const Line& kerb, const KerbGround& ground, const BackLine& back, int first,
                 int last) {
  Line to_start{kerb.front()}, to_end{kerb.back()};
  to_start.insert(to_start.end(), ground.start.begin(), ground.start.end());
  to_end.insert(to_end.end(), ground.end.begin(), ground.end.end());
  const auto start = back.meeting(to_start, first), end = back.meeting(to_end, last);
  if (start.has_value() != end.has_value() || (!start && ground.is_open)) return {};
  // The front has not met a kerb across, where the way meets the back of that one first.
  if (start && (back.faces(*start, kerb[1] - kerb[0]) ||
                back.faces(*end, kerb.back() - kerb[kerb.size() - 2])))
    return {};
  Line behind;
  if (start) {
    append_until(behind, to_end, *end);
    const Line part = back.between(*start, *end);
    behind.insert(behind.end(), part.rbegin(), part.rend());
    Line down;
    append_until(down, to_start, *start);
    behind.insert(behind.end(), down.rbegin(), down.rend());
  } else {
    behind = std::move(to_end);
    behind.insert(behind.end(), to_start.rbegin(), to_start.rend());
  }
  Ring ring = kerb;
  for (const Point& place : behind)
    if (distance(place, ring.back()) > same_place) ring.push_back(place);
  ring.push_back(ring.front());
  return closed(std::move(ring));
}

}  // namespace streetgen
