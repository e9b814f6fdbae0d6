#include "streetgen/cluster.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

namespace {

constexpr int most_turns = 32;

class Bisection {
 public:
  explicit Bisection(const std::vector<Point>& points)
      : points_(points), cluster_(points.size()), along_(points.size()), order_(points.size()) {
    std::iota(order_.begin(), order_.end(), 0);
  }

  std::vector<int> run(int k) {
    split(order_.begin(), order_.end(), k, 1);
    return std::move(cluster_);
  }

 private:
  using Member = std::vector<int>::iterator;

  void split(Member begin, Member end, int k, int first) {
    if (k == 1) {
      for (Member i = begin; i != end; ++i) cluster_[*i] = first;
      return;
    }
    const int half = k / 2;
    const Member cut = begin + static_cast<long long>(end - begin) * half / k;
    divide(begin, cut, end, longest(begin, end));
    for (int turn = 0; turn < most_turns; ++turn)
      if (!divide(begin, cut, end, centre(cut, end) - centre(begin, cut))) break;
    split(begin, cut, half, first);
    split(cut, end, k - half, first + half);
  }

  // The first along the direction come before the cut.  Whether any changed its side.
  bool divide(Member begin, Member cut, Member end, const Point& direction) {
    poll_cancel();
    for (Member i = begin; i != end; ++i)
      along_[*i] = dot(points_[*i] - points_[*begin], direction);
    const auto before = [&](int i, int j) {
      return along_[i] != along_[j] ? along_[i] < along_[j] : i < j;
    };
    const int last = *std::max_element(begin, cut, before),
              next = *std::min_element(cut, end, before);
    if (before(last, next)) return false;
    std::nth_element(begin, cut, end, before);
    return true;
  }

  Point centre(Member begin, Member end) const {
    const Point origin = points_[*begin];
    Point sum;
    for (Member i = begin; i != end; ++i) sum = sum + (points_[*i] - origin);
    return origin + sum * (1.0 / static_cast<double>(end - begin));
  }

  // The direction of the greatest variance, eastwards.
  Point longest(Member begin, Member end) const {
    const Point middle = centre(begin, end);
    double xx = 0, xy = 0, yy = 0;
    for (Member i = begin; i != end; ++i) {
      const Point p = points_[*i] - middle;
      xx += p.x * p.x, xy += p.x * p.y, yy += p.y * p.y;
    }
    const double angle = std::atan2(2 * xy, xx - yy) / 2;
    return {std::cos(angle), std::sin(angle), 0};
  }

  const std::vector<Point>& points_;
  std::vector<int> cluster_;
  std::vector<double> along_;
  std::vector<int> order_;
};

}  // namespace

std::vector<int> clusters(const std::vector<Point>& points, int k) {
  if (k < 1 || static_cast<std::size_t>(k) > points.size())
    throw Error(ErrorKind::invalid_input,
                "k is " + std::to_string(k) + ", expected 1 to " + std::to_string(points.size()));
  return Bisection(points).run(k);
}

}  // namespace streetgen
