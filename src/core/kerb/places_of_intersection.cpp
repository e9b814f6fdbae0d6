#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "kerb/kerb_place.hpp"

namespace streetgen {

namespace {

constexpr int none = -1;

class NodeCorners {
 public:
  NodeCorners(const Layout& layout, int node, const std::vector<int>& corner_from)
      : layout_(layout),
        junction_(layout.junctions[node]),
        corner_from_(corner_from),
        stubs_(junction_.ends.size()) {
    for (std::size_t i = 0; i < stubs_.size(); ++i) {
      const Arm& arm = layout.arm(junction_.ends[i]);
      const double half = std::max(arm.half_start, arm.half_end) + std::abs(arm.roadway_offset);
      stubs_[i] = substring(arm.line, 0, arm.limit + half);
    }
  }

  // Places `count` pieces from `first` on, which follow each other without sharing.
  void place_run(const BorderLoop& loop, std::size_t first, std::size_t count,
                 std::vector<KerbPlace>& places) const {
    const auto at = [&](std::size_t i) { return (first + i) % loop.size(); };
    if (loop[first].joins_level) {
      const KerbPlace across = across_arm(loop[first]);
      for (std::size_t i = 0; i < count; ++i) places[at(i)] = across;
      return;
    }
    const int whole = gap_between(loop[first].from, loop[at(count - 1)].to);
    for (std::size_t i = 0; i < count; ++i) {
      const BorderPiece& piece = loop[at(i)];
      places[at(i)] =
          whole != none ? of_gap(whole, piece, true) : of_gap(gap_beside(piece), piece, false);
    }
  }

 private:
  int next(int arm) const { return (arm + 1) % static_cast<int>(stubs_.size()); }

  KerbPlace across_arm(const BorderPiece& piece) const {
    const Point middle = (piece.from + piece.to) * 0.5;
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < stubs_.size(); ++i)
      if (to_border(i, middle) < to_border(nearest, middle)) nearest = i;
    const EdgeEnd& end = junction_.ends[nearest];
    return {end.edge, end.at_start ? KerbSide::across_start : KerbSide::across_end,
            Method::level_change};
  }

  double to_border(std::size_t arm, const Point& p) const {
    return distance_to_line(p, layout_.arm(junction_.ends[arm]).border);
  }

  // The gap where kerbs lead from the right border of an arm to the left border of the arm before
  // it.
  int gap_between(const Point& from, const Point& to) const {
    for (int a = 0; a < static_cast<int>(stubs_.size()); ++a)
      if (distance(to, border(a).front()) <= crack &&
          distance(from, border(next(a)).back()) <= crack)
        return a;
    return none;
  }

  const Line& border(int arm) const { return layout_.arm(junction_.ends[arm]).border; }

  // The gap beside the nearest arm, on the side where the piece lies; where the node is as near,
  // between the arms that it lies between.
  int gap_beside(const BorderPiece& piece) const {
    const Point middle = (piece.from + piece.to) * 0.5;
    int nearest = 0;
    double least = distance_to_line(middle, stubs_[0]);
    for (int i = 1; i < static_cast<int>(stubs_.size()); ++i) {
      const double away = distance_to_line(middle, stubs_[i]);
      if (away < least) {
        least = away;
        nearest = i;
      }
    }
    const Line& stub = stubs_[nearest];
    if (distance(middle, stub.front()) <= least + same_place) return gap_about(middle);
    const LinePosition at = position_at(stub, nearest_abscissa(middle, stub));
    const bool left =
        cross(local_direction(stub, nearest_abscissa(middle, stub)), middle - at.point) > 0;
    const int arms = static_cast<int>(stubs_.size());
    return left ? nearest : (nearest + arms - 1) % arms;
  }

  // The gap counter-clockwise from the arm from which the place lies the least turn on.
  int gap_about(const Point& place) const {
    const auto turn_from = [&](const Line& stub) {
      const Point along = local_direction(stub, 0), out = place - stub.front();
      const double turn = std::atan2(cross(along, out), dot(along, out));
      return turn < 0 ? turn + 2 * M_PI : turn;
    };
    const auto least =
        std::min_element(stubs_.begin(), stubs_.end(),
                         [&](const Line& a, const Line& b) { return turn_from(a) < turn_from(b); });
    return static_cast<int>(least - stubs_.begin());
  }

  KerbPlace of_gap(int gap, const BorderPiece& piece, bool whole) const {
    const EdgeEnd& end = junction_.ends[gap];
    KerbPlace place{end.edge, end.at_start ? KerbSide::corner_at_start : KerbSide::corner_at_end};
    place.beside = layout_.streets.beside.corners[slot(end)];
    const int corner = corner_from_[slot(end)];
    if (!whole)
      place.method = Method::contested;
    else if (junction_.transition)
      place.method = Method::transition;
    else if (corner != none)
      place.method = layout_.streets.corners[corner].method;
    if (corner != none && on_arc(layout_.streets.corners[corner], piece)) place.corner = corner;
    return place;
  }

  static bool on_arc(const Corner& corner, const BorderPiece& piece) {
    if (!corner.arc || !corner.centre) return false;
    const Point& middle = corner.arc->middle;
    const double reach = distance(middle, corner.arc->start) + same_place;
    const auto on_it = [&](const Point& p) {
      return std::abs(distance(p, *corner.centre) - corner.radius) <= same_place &&
             distance(p, middle) <= reach;
    };
    return on_it(piece.from) && on_it(piece.to);
  }

  const Layout& layout_;
  const Junction& junction_;
  const std::vector<int>& corner_from_;
  std::vector<Line> stubs_;  // by arm: from the node to beyond its limit
};

}  // namespace

BorderLoop cut_at_dead_ends(const Layout& layout, int node, const BorderLoop& loop) {
  BorderLoop cut;
  for (BorderPiece piece : loop) {
    for (const EdgeEnd& end : layout.junctions[node].ends) {
      const Point& tip = layout.arm(end).line.back();
      const Point at = nearest_on_segment(tip, piece.from, piece.to);
      if (piece.shared || distance(at, tip) > same_place ||
          distance(at, piece.from) <= same_place || distance(at, piece.to) <= same_place)
        continue;
      BorderPiece first = piece;
      first.to = piece.from = at;
      cut.push_back(first);
    }
    cut.push_back(piece);
  }
  return cut;
}

std::vector<KerbPlace> places_of_intersection(const Layout& layout, int node,
                                              const std::vector<int>& corner_from,
                                              const BorderLoop& loop) {
  const NodeCorners corners(layout, node, corner_from);
  std::vector<KerbPlace> places(loop.size());
  const auto goes_on = [&](std::size_t i) {
    const BorderPiece &piece = loop[i], &before = loop[(i + loop.size() - 1) % loop.size()];
    return !before.shared && before.joins_level == piece.joins_level;
  };
  std::size_t start = 0;
  while (start < loop.size() && (loop[start].shared || goes_on(start))) ++start;
  if (start == loop.size()) {
    if (!loop[0].shared) corners.place_run(loop, 0, loop.size(), places);
    return places;
  }
  for (std::size_t i = 0; i < loop.size();) {
    const std::size_t first = (start + i) % loop.size();
    std::size_t count = 1;
    if (!loop[first].shared) {
      while (i + count < loop.size() && !loop[(first + count) % loop.size()].shared &&
             goes_on((first + count) % loop.size()))
        ++count;
      corners.place_run(loop, first, count, places);
    }
    i += count;
  }
  return places;
}

}  // namespace streetgen
