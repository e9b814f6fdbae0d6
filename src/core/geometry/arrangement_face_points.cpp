#include <algorithm>
#include <utility>

#include "geometry/arrangement.hpp"
#include "geometry/box.hpp"
#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"
#include "support/disjoint_sets.hpp"

namespace streetgen {

namespace {

// From the middle of a side to its left, up to what lies across; a side may run along the way.
class WayAcross {
 public:
  WayAcross(const Point& from, const Point& to)
      : middle_((from + to) * 0.5),
        across_(left_normal(unit(to - from))),
        width_(1e-6 * distance(from, to)) {}

  struct End {
    const Point* point;
    double beside;  // metres from the way, to its left
  };
  End end(const Point& p) const { return {&p, cross(across_, p - middle_)}; }

  void meet(const End& a, const End& b) {
    if (std::min(a.beside, b.beside) >= width_ || std::max(a.beside, b.beside) <= -width_) return;
    const double off_a = dot(*a.point - middle_, across_), off_b = dot(*b.point - middle_, across_);
    const auto off_at = [&](double beside) {
      const double share = (beside - a.beside) / (b.beside - a.beside);
      return off_a + (off_b - off_a) * std::clamp(share, 0.0, 1.0);
    };
    const auto [nearest, farthest] = std::minmax({off_at(-width_), off_at(width_)});
    if (farthest > 0) reach_ = std::min(reach_, nearest);
  }

  Box about() const {
    Box box;
    box.add(middle_);
    return box.grown(reach_ + width_);
  }
  double reach() const { return reach_; }
  Point place() const { return middle_ + across_ * (reach_ / 2); }

 private:
  Point middle_, across_;
  double width_;
  double reach_ = 1;  // metres, where nothing lies across
};

}  // namespace

// The one around everything: left of the steepest way from the leftmost node.
int Arrangement::outer_walk() const {
  std::size_t steepest = 0;
  for (std::size_t h = 2; h < halves_.size() && halves_[h].from == 0; h += 2)
    if (side(nodes_[0].cell, nodes_[halves_[steepest].to].cell, nodes_[halves_[h].to].cell) > 0)
      steepest = h;
  return halves_.empty() ? -1 : halves_[steepest].walk;
}

// Half way from the middle of a long part of the walk to what lies across the face, where that is
// not too near to tell one side of it from the other. Across lies the walk itself, or another
// island or what that is an island in.
void Arrangement::place_walks() {
  constexpr double clear = 1e-3;  // metres
  constexpr std::size_t most_tries = 64;
  const int count = static_cast<int>(walks_.size()), outer = outer_walk();
  Groups connected(count);
  std::pair<int, int> joined;
  for (const int h : walked_)
    if (const std::pair<int, int> pair(halves_[h].walk, halves_[h ^ 1].walk); pair != joined) {
      joined = pair;
      connected.join(pair.first, pair.second);
    }
  bool islands = false;
  for (int w = 1; w < count; ++w) islands = islands || connected.of(w) > 0;
  std::vector<Point> positions;  // of nodes, from the origin
  positions.reserve(nodes_.size());
  for (const Node& node : nodes_)
    positions.push_back({node.cell.x * step_, node.cell.y * step_, 0});
  std::vector<Box> boxes(islands ? count : 0);  // of walks
  if (islands)
    for (const int h : walked_) boxes[halves_[h].walk].add(positions[halves_[h].from]);
  const BoxIndex about(boxes);
  std::vector<int> tried;  // halves of a walk
  places_.reserve(count);
  for (int w = 0, first = 0; w < count; first = walks_[w++]) {
    poll_cancel();
    if (w == outer) {
      places_.push_back(origin_ - Point{1, 1, 0});
      continue;
    }
    const auto longest = [&, first] {
      int part = -1;
      double size = -1;
      for (int i = first; i < walks_[w]; ++i) {
        const Half& half = halves_[walked_[i]];
        const double own = distance(positions[half.from], positions[half.to]);
        if (own <= size || std::find(tried.begin(), tried.end(), walked_[i]) != tried.end())
          continue;
        size = own;
        part = walked_[i];
      }
      return part;
    };
    tried.clear();
    Point place;
    double widest = 0;
    for (int part = longest(); part >= 0 && tried.size() < most_tries; part = longest()) {
      tried.push_back(part);
      WayAcross way(positions[halves_[part].from], positions[halves_[part].to]);
      const auto meet = [&](int start, int end) {
        WayAcross::End from = way.end(positions[halves_[walked_[start]].from]);
        for (int i = start; i < end; ++i) {
          const WayAcross::End to = way.end(positions[halves_[walked_[i]].to]);
          if ((walked_[i] | 1) != (part | 1)) way.meet(from, to);
          from = to;
        }
      };
      meet(first, walks_[w]);
      for (const int other : about.near(way.about(), 0))
        if (connected.of(other) != connected.of(w))
          meet(other > 0 ? walks_[other - 1] : 0, walks_[other]);
      if (way.reach() <= widest) continue;
      widest = way.reach();
      place = way.place();
      if (widest >= clear) break;
    }
    places_.push_back(origin_ + place);
  }
}

}  // namespace streetgen
