#include "alignment/bend_loop.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

class Cutting {
 public:
  Cutting(const std::vector<BorderPiece>& border, const std::vector<RoadPiece>& road,
          double offset)
      : border_(border), road_(road), reach_(std::abs(offset) * (1 - 1e-9)) {
    turned_before_.push_back(0);
    for (const BorderPiece& piece : border)
      turned_before_.push_back(turned_before_.back() + (piece.turned_over ? 1 : 0));
  }

  std::vector<BorderPart> parts() {
    if (turned_before_.back() == 0) {
      for (std::size_t i = 0; i < border_.size(); ++i) keep(i, 0);
      return std::move(parts_);
    }
    prepare();
    std::size_t first = 0, last = border_.size();
    while (first < last && border_[first].turned_over) ++first;
    while (last > first && border_[last - 1].turned_over) --last;
    double from = 0;
    for (std::size_t i = first; i < last;) {
      poll_cancel();
      if (const auto loop = loop_from(i, from, last)) {
        if (loop->at > from) parts_.push_back({i, from, loop->at});
        i = loop->next;
        from = loop->again;
      } else {
        keep(i++, from);
        from = 0;
      }
    }
    if (first > 0) trim_start();
    if (last < border_.size()) trim_end();
    return std::move(parts_);
  }

 private:
  struct Loop {
    double at;         // where it leaves its piece
    std::size_t next;  // the piece on which it comes back
    double again;      // and where
  };

  void prepare() {
    road_index_ = PieceIndex(road_);
    std::vector<Box> boxes;
    boxes.reserve(border_.size());
    for (const BorderPiece& piece : border_) boxes.push_back(piece.piece.box());
    boxes_ = std::move(boxes);
    border_index_ = BoxIndex(boxes_);
  }

  void keep(std::size_t i, double from) { parts_.push_back({i, from, border_[i].piece.length}); }

  // The longest loop that begins on piece i behind `from`.
  std::optional<Loop> loop_from(std::size_t i, double from, std::size_t last) const {
    const std::vector<int> near = border_index_.near(boxes_[i], 0);
    for (auto other = near.rbegin(); other != near.rend(); ++other) {
      const std::size_t j = *other;
      if (*other <= static_cast<int>(i) + 1) break;
      if (j >= last || turned_before_[j] == turned_before_[i + 1]) continue;
      std::vector<PieceCrossing> places = crossings(border_[i].piece, border_[j].piece);
      std::sort(places.begin(), places.end(),
                [](const PieceCrossing& a, const PieceCrossing& b) { return a.b > b.b; });
      for (const PieceCrossing& place : places)
        if (place.a >= from && turned_over(i, j)) return Loop{place.a, j, place.b};
    }
    return {};
  }

  bool turned_over(std::size_t i, std::size_t j) const {
    for (std::size_t k = i + 1; k < j; ++k) {
      const RoadPiece& piece = border_[k].piece;
      if (!road_index_.comes_within(road_, piece.point(piece.length / 2), reach_, border_[i].of,
                                    border_[j].of))
        return false;
    }
    return true;
  }

  // Where a part leaves the disc about an end of the road, metres along its piece, ascending.
  std::vector<double> leaves(const BorderPart& part, const Point& end) const {
    RoadPiece circle;
    circle.radius = reach_;
    circle.origin = end + Point{reach_, 0, 0};
    circle.forward = {0, 1, 0};
    circle.inward = {-1, 0, 0};
    circle.length = 2 * M_PI * reach_;
    std::vector<double> found;
    for (const PieceCrossing& place : crossings(border_[part.index].piece, circle))
      if (place.a > part.from && place.a < part.to) found.push_back(place.a);
    std::sort(found.begin(), found.end());
    return found;
  }

  void trim_start() {
    const Point start = road_.front().origin;
    std::size_t gone = 0;
    for (; gone < parts_.size(); ++gone) {
      const RoadPiece& piece = border_[parts_[gone].index].piece;
      const std::vector<double> places = leaves(parts_[gone], start);
      if (!places.empty()) parts_[gone].from = places.back();
      if (!places.empty() || distance(piece.point(parts_[gone].from), start) >= reach_) break;
    }
    parts_.erase(parts_.begin(), parts_.begin() + gone);
  }

  void trim_end() {
    const Point end = road_.back().end();
    while (!parts_.empty()) {
      const RoadPiece& piece = border_[parts_.back().index].piece;
      const std::vector<double> places = leaves(parts_.back(), end);
      if (!places.empty()) parts_.back().to = places.front();
      if (!places.empty() || distance(piece.point(parts_.back().to), end) >= reach_) break;
      parts_.pop_back();
    }
  }

  const std::vector<BorderPiece>& border_;
  const std::vector<RoadPiece>& road_;
  double reach_;
  std::vector<std::size_t> turned_before_;  // how many of the pieces before each
  std::vector<BorderPart> parts_;
  std::vector<Box> boxes_;
  BoxIndex border_index_;
  PieceIndex road_index_;
};

}  // namespace

std::vector<BorderPart> without_bend_loops(const std::vector<BorderPiece>& border,
                                           const std::vector<RoadPiece>& road, double offset) {
  return Cutting(border, road, offset).parts();
}

}  // namespace streetgen
