#include "geometry/narrow_gap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/box_hierarchy.hpp"
#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"
#include "support/disjoint_sets.hpp"

namespace streetgen {

namespace {

constexpr double least_run = 1e-4;     // metres: no hole has shorter runs only
constexpr double largest_disc = 1000;  // metres, of its radius
constexpr std::size_t few = 4096;      // pairs of sides that are looked at one by one

// A segment of a ring, the surface on its left.
struct SurfaceSide {
  Point from, to;
  int surface, ring;

  Point at(double share) const { return from + (to - from) * share; }
};

struct Piece {
  Point from, to;
};

// Part of a ring between places where it meets other rings, be it of its own surface's other parts:
// all of it borders on the outside of the union, or nothing.
struct Run {
  int surface;
  int first, last;  // of the pieces, and the end
};

// The boxes in an order in which those that follow each other lie close: halves of halves.
void order_by_place(const std::vector<Box>& boxes, std::vector<int>::iterator first,
                    std::vector<int>::iterator last) {
  if (last - first <= 2) return;
  Box all;
  for (auto i = first; i != last; ++i) all = all.joined_with(boxes[*i]);
  const bool wide = all.max_x - all.min_x > all.max_y - all.min_y;
  const auto middle = first + (last - first) / 2;
  std::nth_element(first, middle, last, [&](int i, int j) {
    const Box &a = boxes[i], &b = boxes[j];
    return wide ? a.min_x + a.max_x < b.min_x + b.max_x : a.min_y + a.max_y < b.min_y + b.max_y;
  });
  order_by_place(boxes, first, middle);
  order_by_place(boxes, middle, last);
}

double share_of(const SurfaceSide& side, const Point& p) {
  const Point along = side.to - side.from;
  return std::clamp(dot(p - side.from, along) / dot(along, along), 0.0, 1.0);
}

class Borders {
 public:
  explicit Borders(const std::vector<const MultiPolygon*>& surfaces) : surfaces_(surfaces) {
    std::vector<Box> boxes, ring_boxes, surface_boxes;
    std::size_t count = 0;
    for (const MultiPolygon* surface : surfaces)
      for (const Polygon& polygon : *surface)
        for (const Ring& ring : polygon) count += ring.size();
    boxes.reserve(count);
    sides_.reserve(count);
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
      surface_boxes.push_back(box_of(*surfaces[k]));
      for (const Polygon& polygon : *surfaces[k])
        for (const Ring& ring : polygon) {
          const int number = static_cast<int>(rings_.size());
          rings_.push_back(static_cast<int>(sides_.size()));
          ring_boxes.emplace_back();
          for (const Point& p : ring) ring_boxes.back().add(p);
          for (std::size_t i = 1; i < ring.size(); ++i) {
            sides_.push_back({ring[i - 1], ring[i], static_cast<int>(k), number});
            boxes.push_back(box_of(ring[i - 1], ring[i]));
          }
        }
    }
    rings_.push_back(static_cast<int>(sides_.size()));
    const BoxIndex rings(ring_boxes);
    for (int r = 0; r < static_cast<int>(ring_boxes.size()); ++r) {
      poll_cancel();
      rings.each_near(ring_boxes[r], same_place, [&](int other) {
        if (other < r) meet_rings(other, r, ring_boxes[r].shared_with(ring_boxes[other]), boxes);
      });
    }
    sort_met();
    std::vector<int> order(ring_boxes.size());
    std::iota(order.begin(), order.end(), 0);
    order_by_place(ring_boxes, order.begin(), order.end());
    std::vector<Box> ordered;
    ordered.reserve(count + count / 4);
    indexed_.reserve(count);
    for (const int r : order)
      for (int i = rings_[r]; i < rings_[r + 1]; ++i) {
        ordered.push_back(boxes[i]);
        indexed_.push_back(i);
      }
    index_ = BoxHierarchy(std::move(ordered));
    surface_index_ = BoxIndex(surface_boxes);
    auto met = met_.cbegin();
    for (std::size_t r = 1; r < rings_.size(); ++r) add_runs(rings_[r - 1], rings_[r], met);
  }

  const std::vector<Run>& runs() const { return runs_; }
  const Piece& first_piece(const Run& run) const { return pieces_[run.first]; }
  const Piece& last_piece(const Run& run) const { return pieces_[run.last - 1]; }
  template <class Use>
  void each_piece(const Run& run, Use use) const {
    std::for_each(pieces_.begin() + run.first, pieces_.begin() + run.last, use);
  }

  // Whether the run may border on a hole in which no disc of the radius has room.
  bool narrow(const Run& run, double radius) const {
    poll_cancel();
    const auto size = [](const Piece& p) { return distance(p.from, p.to); };
    const auto first = pieces_.begin() + run.first, last = pieces_.begin() + run.last;
    const Piece& longest = *std::max_element(
        first, last, [&](const Piece& p, const Piece& q) { return size(p) < size(q); });
    if (free_beside(longest, run.surface, radius)) return false;
    if (covered(place_beside(longest, beside_border), run.surface)) return false;
    return std::none_of(
        first, last, [&](const Piece& piece) { return free_beside(piece, run.surface, radius); });
  }

 private:
  struct Meeting {
    int side;
    double share;  // of the side
  };

  // What they share lies in the box.
  void meet_rings(int r, int s, const Box& shared, const std::vector<Box>& boxes) {
    const std::vector<int> ours = sides_in(shared, r, boxes);
    if (ours.empty()) return;
    const std::vector<int> theirs = sides_in(shared, s, boxes);
    if (ours.size() * theirs.size() <= few) {
      for (const int j : theirs)
        for (const int i : ours)
          if (boxes[i].meets(boxes[j], same_place)) meet(i, j);
      return;
    }
    std::vector<Box> our_boxes;
    for (const int i : ours) our_boxes.push_back(boxes[i]);
    const BoxIndex index(our_boxes);
    for (const int j : theirs) {
      poll_cancel();
      index.each_near(boxes[j], same_place, [&](int k) { meet(ours[k], j); });
    }
  }

  std::vector<int> sides_in(const Box& box, int r, const std::vector<Box>& boxes) const {
    std::vector<int> there;
    for (int i = rings_[r]; i < rings_[r + 1]; ++i)
      if (boxes[i].meets(box, same_place)) there.push_back(i);
    return there;
  }

  void meet(int i, int j) {
    const SurfaceSide &s = sides_[i], &t = sides_[j];
    const auto end_on = [&](int on, const Point& end, int other, double share) {
      const SurfaceSide& side = sides_[on];
      if (distance_to_segment(end, side.from, side.to) > same_place) return;
      met_.push_back({on, share_of(side, end)});
      met_.push_back({other, share});
    };
    end_on(i, t.from, j, 0);
    end_on(i, t.to, j, 1);
    end_on(j, s.from, i, 0);
    end_on(j, s.to, i, 1);
    if (const auto at = crossing(s.from, s.to, t.from, t.to)) {
      met_.push_back({i, share_of(s, *at)});
      met_.push_back({j, share_of(t, *at)});
    }
  }

  // By side, and by share of it: a side has few.
  void sort_met() {
    std::vector<int> last(sides_.size() + 1);
    for (const Meeting& meeting : met_) ++last[meeting.side + 1];
    std::partial_sum(last.begin(), last.end(), last.begin());
    std::vector<Meeting> sorted(met_.size());
    for (const Meeting& meeting : met_) sorted[last[meeting.side]++] = meeting;
    met_ = std::move(sorted);
    for (auto first = met_.begin(); first != met_.end();) {
      const auto end = met_.begin() + last[first->side];
      std::sort(first, end, [](const Meeting& a, const Meeting& b) { return a.share < b.share; });
      first = end;
    }
  }

  // `met` is the first meeting of the ring, and then of the next.
  void add_runs(int first, int last, std::vector<Meeting>::const_iterator& met) {
    const auto first_met = met;
    while (met != met_.end() && met->side < last) ++met;
    if (met == first_met) return;
    const int surface = sides_[first].surface;
    const std::size_t first_run = runs_.size();
    const int first_piece = static_cast<int>(pieces_.size());
    int begun = first_piece;  // before the first meeting; its end is the last run
    const auto end_run = [&] {
      const int end = static_cast<int>(pieces_.size());
      if (begun < end) runs_.push_back({surface, begun, end});
      begun = end;
    };
    auto next = first_met;
    for (int i = first; i < last; ++i) {
      const SurfaceSide& side = sides_[i];
      const double size = distance(side.from, side.to);
      double at = 0;
      const auto go_on = [&](double share) {
        if ((share - at) * size <= same_place) return;
        pieces_.push_back({side.at(at), side.at(share)});
        at = share;
      };
      for (; next != met && next->side == i; ++next) {
        go_on(next->share);
        end_run();
      }
      go_on(1);
    }
    const int left = static_cast<int>(pieces_.size()) - begun;
    const bool starts_at_meeting = first_met->side == first && first_met->share <= 0;
    if (left == 0 || runs_.size() == first_run || starts_at_meeting) return end_run();
    std::rotate(pieces_.begin() + first_piece, pieces_.begin() + begun, pieces_.end());
    for (std::size_t r = first_run; r < runs_.size(); ++r) {
      runs_[r].last += left;
      if (r > first_run) runs_[r].first += left;
    }
  }

  static Point place_beside(const Piece& piece, double off) {
    const Point outwards = left_normal(unit(piece.to - piece.from)) * -off;
    return (piece.from + piece.to) * 0.5 + outwards;
  }

  // Beyond a crack in its own surface, however narrow, there is no room.
  bool free_beside(const Piece& piece, int surface, double radius) const {
    if (radius > largest_disc) return false;
    const Point centre = place_beside(piece, radius + beside_border), along = piece.to - piece.from;
    return !index_.any_near(box_of(centre, centre), radius + same_place, [&](std::size_t i) {
      const SurfaceSide& side = sides_[indexed_[i]];
      const double away = distance_to_segment(centre, side.from, side.to);
      return away < radius || (away < radius + same_place && side.surface == surface &&
                               dot(side.to - side.from, along) < 0);
    });
  }

  bool covered(const Point& p, int but) const {
    return surface_index_.any_near(box_of(p, p), 0,
                                   [&](int k) { return k != but && inside(p, *surfaces_[k]); });
  }

  const std::vector<const MultiPolygon*>& surfaces_;
  BoxIndex surface_index_;
  std::vector<SurfaceSide> sides_;
  std::vector<int> rings_;    // their first sides, and the end
  std::vector<Meeting> met_;  // where sides of different rings meet, by side
  std::vector<int> indexed_;  // sides, by place
  BoxHierarchy index_;        // of these
  std::vector<Piece> pieces_;
  std::vector<Run> runs_;
};

// Of each run the places where it starts and ends, told apart by number.
std::vector<std::array<int, 2>> places_of_ends(const Borders& borders,
                                               const std::vector<Run>& runs) {
  std::vector<std::pair<Point, int>> ends;
  for (const Run& run : runs)
    for (const Point& end : {borders.first_piece(run).from, borders.last_piece(run).to})
      ends.emplace_back(end, static_cast<int>(ends.size()));
  std::sort(ends.begin(), ends.end(),
            [](const auto& a, const auto& b) { return a.first.x < b.first.x; });
  Groups joined(static_cast<int>(ends.size()));
  for (std::size_t k = 0; k < ends.size(); ++k)
    for (std::size_t l = k; l-- > 0 && ends[k].first.x - ends[l].first.x <= least_run;)
      if (distance(ends[k].first, ends[l].first) <= least_run)
        joined.join(ends[k].second, ends[l].second);
  std::vector<std::array<int, 2>> places;
  for (int i = 0; i < static_cast<int>(runs.size()); ++i)
    places.push_back({joined.of(2 * i), joined.of(2 * i + 1)});
  return places;
}

// Those that may be part of a ring: at both ends another one goes on.
std::vector<bool> on_rings(const std::vector<std::array<int, 2>>& ends) {
  std::map<int, std::vector<int>> at;  // the runs that end there
  for (int i = 0; i < static_cast<int>(ends.size()); ++i)
    for (const int place : ends[i]) at[place].push_back(i);
  std::vector<bool> kept(ends.size(), true);
  std::vector<int> loose;
  for (const auto& [place, runs] : at)
    if (runs.size() == 1) loose.push_back(place);
  while (!loose.empty()) {
    const std::vector<int>& last = at[loose.back()];
    loose.pop_back();
    if (last.empty()) continue;
    const int run = last.front();
    kept[run] = false;
    for (const int place : ends[run]) {
      std::vector<int>& runs = at[place];
      runs.erase(std::find(runs.begin(), runs.end(), run));
      if (runs.size() == 1) loose.push_back(place);
    }
  }
  return kept;
}

}  // namespace

std::vector<Box> narrow_gaps(const std::vector<const MultiPolygon*>& surfaces, double max_area) {
  const Borders borders(surfaces);
  const double radius = std::sqrt(max_area / M_PI);
  std::vector<Run> runs;
  std::copy_if(borders.runs().begin(), borders.runs().end(), std::back_inserter(runs),
               [&](const Run& run) { return borders.narrow(run, radius); });
  const auto ends = places_of_ends(borders, runs);
  const std::vector<bool> kept = on_rings(ends);
  Groups joined(2 * static_cast<int>(runs.size()));
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (kept[i]) joined.join(ends[i][0], ends[i][1]);
  std::map<int, Box> boxes;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (kept[i])
      borders.each_piece(runs[i], [&, &box = boxes[joined.of(ends[i][0])]](const Piece& piece) {
        box.add(piece.from);
        box.add(piece.to);
      });
  std::vector<Box> out;
  for (const auto& [place, box] : boxes) out.push_back(box);
  return out;
}

}  // namespace streetgen
