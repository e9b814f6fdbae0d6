#include "road/bend_loop.hpp"

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
  Cutting(const std::vector<RawBorderPiece>& border, const std::vector<RoadPiece>& road,
          double offset, double slack)
      : border_(border), road_(road), reach_(std::abs(offset) * (1 - 1e-9)), slack_(slack) {
    turned_before_.push_back(0);
    for (const RawBorderPiece& piece : border)
      turned_before_.push_back(turned_before_.back() + (piece.turned_over ? 1 : 0));
  }

  std::vector<BorderPart> parts() {
    if (turned_before_.back() == 0) {
      for (std::size_t i = 0; i < border_.size(); ++i) keep(i, 0);
      return std::move(parts_);
    }
    prepare();
    double from = 0;
    for (std::size_t i = 0; i < border_.size();) {
      poll_cancel();
      if (const auto loop = loop_from(i, from)) {
        if (loop->at > from) parts_.push_back({i, from, loop->at});
        i = loop->next;
        from = loop->again;
      } else {
        keep(i++, from);
        from = 0;
      }
    }
    trim_start();
    trim_end();
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
    for (const RawBorderPiece& piece : border_) boxes.push_back(piece.piece.box());
    boxes_ = std::move(boxes);
    border_index_ = BoxIndex(boxes_);
  }

  void keep(std::size_t i, double from) { parts_.push_back({i, from, border_[i].piece.length}); }

  // The longest loop that begins on piece i behind `from`.
  std::optional<Loop> loop_from(std::size_t i, double from) const {
    const std::vector<int> near = border_index_.near(boxes_[i], 0);
    for (auto other = near.rbegin(); other != near.rend(); ++other) {
      const std::size_t j = *other;
      if (*other <= static_cast<int>(i) + 1) break;
      if (turned_before_[j] == turned_before_[i + 1]) continue;
      std::vector<PieceCrossing> places = crossings(border_[i].piece, border_[j].piece);
      std::sort(places.begin(), places.end(),
                [](const PieceCrossing& a, const PieceCrossing& b) { return a.b > b.b; });
      for (const PieceCrossing& place : places)
        if (place.a >= from && far_enough_at(i, j, place.a) && turned_over(i, j))
          return Loop{place.a, j, place.b};
    }
    return {};
  }

  // The border goes through where a loop begins and ends.
  bool far_enough_at(std::size_t i, std::size_t j, double at) const {
    return !road_index_.comes_within(road_, border_[i].piece.point(at), reach_ - slack_,
                                     border_[i].of, border_[j].of);
  }

  bool middle_too_near(std::size_t k, std::size_t i, std::size_t j) const {
    const RoadPiece& piece = border_[k].piece;
    return road_index_.comes_within(road_, piece.point(piece.length / 2), reach_, border_[i].of,
                                    border_[j].of);
  }

  // Places that mostly tell are asked first.
  bool turned_over(std::size_t i, std::size_t j) const {
    for (const std::size_t k : {i + 1, j - 1, (i + j) / 2})
      if (!middle_too_near(k, i, j)) return false;
    for (std::size_t k = i + 2; k + 1 < j; ++k) {
      poll_cancel();
      if (!middle_too_near(k, i, j)) return false;
    }
    return true;
  }

  bool too_near(const BorderPart& part, double at) const {
    return road_index_.comes_within(road_, border_[part.index].piece.point(at), reach_, 0,
                                    road_.size());
  }

  // Between a place of the part that is too near and one that is not: where it is far enough.
  double far_enough(const BorderPart& part, double near, double far) const {
    for (int step = 0; step < 60; ++step) {
      const double middle = (near + far) / 2;
      (too_near(part, middle) ? near : far) = middle;
    }
    return far;
  }

  // The loop, of the parts in this order, that an end of the road leaves open: all up to
  // the last piece that is turned over.
  template <class Parts>
  std::size_t open_loop(Parts part, Parts end) const {
    std::size_t seen = 0, open = 0;
    for (; part != end && too_near(*part, (part->from + part->to) / 2); ++part) {
      ++seen;
      if (border_[part->index].turned_over) open = seen;
    }
    return open;
  }

  void trim_start() {
    std::size_t gone = open_loop(parts_.begin(), parts_.end());
    if (gone == 0) return;
    while (gone < parts_.size() && too_near(parts_[gone], parts_[gone].to)) ++gone;
    parts_.erase(parts_.begin(), parts_.begin() + gone);
    if (parts_.empty()) return;
    BorderPart& part = parts_.front();
    if (too_near(part, part.from)) part.from = far_enough(part, part.from, part.to);
  }

  void trim_end() {
    const std::size_t gone = open_loop(parts_.rbegin(), parts_.rend());
    if (gone == 0) return;
    parts_.resize(parts_.size() - gone);
    while (!parts_.empty() && too_near(parts_.back(), parts_.back().from)) parts_.pop_back();
    if (parts_.empty()) return;
    BorderPart& part = parts_.back();
    if (too_near(part, part.to)) part.to = far_enough(part, part.to, part.from);
  }

  const std::vector<RawBorderPiece>& border_;
  const std::vector<RoadPiece>& road_;
  double reach_, slack_;
  std::vector<std::size_t> turned_before_;  // how many of the pieces before each
  std::vector<BorderPart> parts_;
  std::vector<Box> boxes_;
  BoxIndex border_index_;
  PieceIndex road_index_;
};

}  // namespace

std::vector<BorderPart> without_bend_loops(const std::vector<RawBorderPiece>& border,
                                           const std::vector<RoadPiece>& road, double offset,
                                           double slack) {
  return Cutting(border, road, offset, slack).parts();
}

}  // namespace streetgen
