#include "streetgen/height_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

class Curve {
 public:
  Curve(const std::vector<double>& s, const std::vector<double>& z, double tolerance)
      : s_(s), z_(z), tolerance_(tolerance), breaks_(s.size()), grades_(s.size()) {
    for (std::size_t i = 1; i + 1 < s_.size(); ++i) {
      // The grade of the parabola through three heights.
      const double before = length(i - 1), behind = length(i);
      grades_[i] = (slope(i - 1) * behind + slope(i) * before) / (before + behind);
      breaks_[i] =
          off(i, slope(i - 1)) * before > tolerance_ || off(i, slope(i)) * behind > tolerance_;
    }
  }

  std::vector<HeightPiece> pieces() const {
    std::vector<HeightPiece> out;
    for (std::size_t from = 0; from + 1 < s_.size();) {
      poll_cancel();
      const std::size_t to = farthest(from);
      out.push_back(piece(from, to));
      from = to;
    }
    return out;
  }

 private:
  double length(std::size_t i) const { return s_[i + 1] - s_[i]; }
  double slope(std::size_t i) const { return (z_[i + 1] - z_[i]) / length(i); }
  // The share of a length by which a cubic leaves its chord, at most.
  double off(std::size_t i, double chord) const { return std::abs(grades_[i] - chord) / 4; }

  // At a break and at an end grades are those of the chord, or of the parabola that ends there.
  double grade(std::size_t at, std::size_t chord, std::size_t other) const {
    if (at > 0 && at + 1 < s_.size() && !breaks_[at]) return grades_[at];
    const bool bends = other > 0 && other + 1 < s_.size() && !breaks_[other];
    return bends ? 2 * slope(chord) - grades_[other] : slope(chord);
  }

  HeightPiece piece(std::size_t from, std::size_t to) const {
    const double over = s_[to] - s_[from], rise = (z_[to] - z_[from]) / over;
    const double first = grade(from, from, from + 1), last = grade(to, to - 1, to - 1);
    return {s_[from], z_[from], first, (3 * rise - 2 * first - last) / over,
            (first + last - 2 * rise) / (over * over)};
  }

  bool passes(std::size_t from, std::size_t to) const {
    const HeightPiece p = piece(from, to);
    for (std::size_t i = from + 1; i < to; ++i) {
      const double on = s_[i] - p.s;
      if (breaks_[i] || std::abs(p.a + on * (p.b + on * (p.c + on * p.d)) - z_[i]) > tolerance_)
        return false;
    }
    return true;
  }

  // A piece that passes a height mostly passes those before it.
  std::size_t farthest(std::size_t from) const {
    std::size_t reached = from + 1, step = 1;
    while (reached + step < s_.size() && passes(from, reached + step)) reached += step, step *= 2;
    for (; step > 0; step /= 2)
      if (reached + step < s_.size() && passes(from, reached + step)) reached += step;
    return reached;
  }

  const std::vector<double>&s_, &z_;
  double tolerance_;
  std::vector<bool> breaks_;
  std::vector<double> grades_;
};

}  // namespace

std::vector<HeightPiece> height_curve(const std::vector<double>& stations,
                                      const std::vector<double>& heights, double tolerance) {
  if (stations.size() < 2) return {};
  return Curve(stations, heights, tolerance).pieces();
}

}  // namespace streetgen
