#include "network/leaving_order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

constexpr double nearest = 1, farthest = 32;  // metres from the node

// Counter-clockwise from one direction to another, 0 to 2 pi; 0 where noise parts them.
double turn_between(double from, double to) {
  const double turn = std::fmod(to - from + 4 * M_PI, 2 * M_PI);
  return turn > 2 * M_PI - same_angle ? 0 : turn;
}

class LeavingOrder {
 public:
  LeavingOrder(std::size_t count, const Heading& heading, const WayRank& before)
      : heading_(heading), before_(before), order_(count) {
    std::iota(order_.begin(), order_.end(), 0);
  }

  std::vector<std::size_t> find() {
    const std::size_t count = order_.size();
    std::vector<double> turn(count);
    for (const std::size_t i : order_) turn[i] = heading_(i, nearest);
    sort_by(turn, 0, count);
    // Ways that leave together may lie on both sides of the seam of the circle.  One to the west
    // comes first, whatever noise says of it.
    while (count > 0 && (turn[order_.back()] > M_PI - same_angle ||
                         turn[order_.front()] + 2 * M_PI - turn[order_.back()] <= same_angle)) {
      turn[order_.back()] -= 2 * M_PI;
      std::rotate(order_.begin(), order_.end() - 1, order_.end());
    }
    each_run(turn, 0, count, 2 * nearest);
    for (const auto& [first, last] : never_part_)
      if (last - first < count && nearer_behind(first, last))
        std::reverse(order_.begin() + first, order_.begin() + last);
    return order_;
  }

 private:
  void sort_by(const std::vector<double>& turn, std::size_t first, std::size_t last) {
    std::sort(order_.begin() + first, order_.begin() + last, [&](std::size_t i, std::size_t j) {
      return turn[i] != turn[j] ? turn[i] < turn[j] : i < j;
    });
  }

  // Ways in order, of which each leaves with the next one.
  void each_run(const std::vector<double>& turn, std::size_t first, std::size_t last, double at) {
    while (first < last) {
      std::size_t end = first + 1;
      while (end < last && turn[order_[end]] - turn[order_[end - 1]] <= same_angle) ++end;
      if (end - first > 1) part(first, end, at);
      first = end;
    }
  }

  void part(std::size_t first, std::size_t last, double at) {
    if (at > farthest) {
      std::sort(order_.begin() + first, order_.begin() + last, before_);
      never_part_.push_back({first, last});
      return;
    }
    std::vector<double> turn(order_.size());
    const double ahead = heading_(order_[first], at);
    for (std::size_t k = first; k < last; ++k)
      turn[order_[k]] = std::remainder(heading_(order_[k], at) - ahead, 2 * M_PI);
    sort_by(turn, first, last);
    each_run(turn, first, last, 2 * at);
  }

  // Whether of the neighbours of a run the one after it is nearer, where they first differ.
  bool nearer_behind(std::size_t first, std::size_t last) const {
    const std::size_t count = order_.size(), way = order_[first];
    const std::size_t in_front = order_[(first + count - 1) % count], behind = order_[last % count];
    for (double at = nearest; at <= farthest; at *= 2) {
      const double own = heading_(way, at);
      const double to_front = turn_between(heading_(in_front, at), own);
      const double to_behind = turn_between(own, heading_(behind, at));
      if (std::abs(to_front - to_behind) > same_angle) return to_behind < to_front;
    }
    return false;
  }

  const Heading& heading_;
  const WayRank& before_;
  std::vector<std::size_t> order_;
  std::vector<std::pair<std::size_t, std::size_t>> never_part_;  // from and before these places
};

}  // namespace

std::vector<std::size_t> leaving_order(std::size_t count, const Heading& heading,
                                       const WayRank& before) {
  return LeavingOrder(count, heading, before).find();
}

}  // namespace streetgen
