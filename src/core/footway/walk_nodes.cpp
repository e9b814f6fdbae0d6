#include "footway/walk_nodes.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "geometry/box.hpp"
#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

// The ends of pieces from west to east, and the first of those that are one node with each.
class Ends {
 public:
  explicit Ends(const std::vector<WalkPiece>& pieces) {
    std::map<Place, std::set<int>> levels;
    for (const WalkPiece& piece : pieces)
      for (const Point& end : {piece.geometry.front(), piece.geometry.back()})
        levels[place_of(end)].insert(piece.level);
    std::vector<Box> boxes;
    for (const auto& [place, of_it] : levels) {
      places_.push_back({place.first, place.second});
      boxes.push_back(box_of(places_.back(), places_.back()));
    }
    first_.resize(places_.size());
    std::iota(first_.begin(), first_.end(), 0);
    const BoxIndex index(boxes);
    int end = 0;
    for (const auto& [place, of_it] : levels) {
      poll_cancel();
      for (const int other : index.near(boxes[end], one_place))
        if (other > end && distance(places_[end], places_[other]) < one_place &&
            share(of_it, levels.at(place_of(places_[other]))))
          join(end, other);
      ++end;
    }
  }

  const Point& node(const Point& end) const {
    const auto at =
        std::lower_bound(places_.begin(), places_.end(), end,
                         [](const Point& a, const Point& b) { return place_of(a) < place_of(b); });
    return places_[first(static_cast<int>(at - places_.begin()))];
  }

 private:
  static bool share(const std::set<int>& levels, const std::set<int>& others) {
    return std::any_of(levels.begin(), levels.end(),
                       [&](int level) { return others.count(level) > 0; });
  }
  int first(int end) const {
    while (first_[end] != end) end = first_[end];
    return end;
  }
  void join(int a, int b) {
    a = first(a);
    b = first(b);
    first_[std::max(a, b)] = std::min(a, b);
  }

  std::vector<Point> places_;
  std::vector<int> first_;
};

bool within_one_place(const Line& line) {
  return std::all_of(line.begin(), line.end(),
                     [&](const Point& p) { return distance(p, line.front()) < one_place; });
}

}  // namespace

void join_near_ends(std::vector<WalkPiece>& pieces) {
  const Ends ends(pieces);
  for (WalkPiece& piece : pieces) {
    Line& line = piece.geometry;
    line.front() = ends.node(line.front());
    line.back() = ends.node(line.back());
    line = distinct(std::move(line));
  }
  pieces.erase(
      std::remove_if(pieces.begin(), pieces.end(),
                     [](const WalkPiece& piece) { return within_one_place(piece.geometry); }),
      pieces.end());
}

}  // namespace streetgen
