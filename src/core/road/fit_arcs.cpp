#include "road/fit_arcs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "geometry/polyline.hpp"
#include "road/heading.hpp"
#include "support/eigen.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

constexpr int rounds = 12, closing_rounds = 6;
constexpr double ended = 1e-9;     // metres and radians
constexpr double shortest = 0.05;  // metres of an arc
constexpr double farthest_turn = 0.95 * M_PI;
// Shares by which an arc may be sharper than it should.  One sharper by a hundredth counts as a
// point that is as far off as it may be.
constexpr double too_sharp = 1e-3;

// An arc has two unknowns, its length and its curvature.  The end has x, y and a heading.
constexpr int end_rows = 3;
constexpr int most_unknowns = 2 * most_arcs, most_rows = most_unknowns + end_rows;
using Matrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, most_rows, most_rows>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_rows, 1>;

class ArcFit {
 public:
  ArcFit(const PathGuide& guide, std::size_t arcs)
      : guide_(guide), unknowns_(2 * static_cast<int>(arcs)), weights_(guide.points.size(), 1) {
    double s = 0;
    for (std::size_t i = 0; i < guide.points.size(); ++i) {
      if (i > 0) s += distance(guide.points[i - 1], guide.points[i]);
      stations_.push_back(s);
    }
  }

  std::optional<FittedArcs> best(std::vector<ChainArc> arcs) {
    constexpr double well_within = 0.95, better = 0.95, calmer = 0.4;
    std::optional<FittedArcs> least;
    double damping = 1;
    for (int round = 0, last_better = 0; round < rounds; ++round, damping *= calmer) {
      approach(arcs, damping);
      std::vector<ChainArc> closed = arcs;
      if (!close(closed)) continue;
      const double worst = worst_of(closed);
      if (!least || worst < better * least->worst) last_better = round;
      if (!least || worst < least->worst) least = FittedArcs{std::move(closed), worst};
      if (least->worst < well_within || round > last_better + 2) break;
    }
    return least;
  }

  // Points that lie farther off weigh more from now on.
  double worst_of(const std::vector<ChainArc>& arcs) {
    for (const ChainArc& arc : arcs)
      if (!(arc.length >= shortest) || std::abs(arc.curvature * arc.length) > farthest_turn)
        return infinite;
    const ArcChain chain(guide_.from, arcs);
    if (!(chain.length() < 2 * guide_.length + 1)) return infinite;
    std::vector<double> shares;
    for (std::size_t m = 0; m < stations_.size(); ++m)
      shares.push_back(std::abs(aside(chain, chain.at(stations_[m]), m)) / guide_.reach[m]);
    double worst = *std::max_element(shares.begin(), shares.end());
    for (std::size_t m = 0; m < shares.size() && worst > 0; ++m)
      weights_[m] = std::sqrt(weights_[m] * (0.3 + shares[m] / worst));
    for (const ChainArc& arc : arcs) {
      const double over = std::abs(arc.curvature) / guide_.most_curvature - 1;
      if (over > too_sharp) worst += 100 * over;
    }
    return worst;
  }

 private:
  // Metres to the left of the chain, beside the place where the point was last seen or near that.
  // It is seen beside the next place from now on.
  double aside(const ArcChain& chain, const ArcChain::Place& place, std::size_t m) {
    const Point off = guide_.points[m] - place.point;
    const double ahead = dot(place.way, off);
    stations_[m] = std::clamp(place.s + ahead, 0.0, chain.length());
    return cross(place.way, off) - chain.arcs()[place.arc].curvature * ahead * ahead / 2;
  }

  // What is left to the end, and how the end moves by each unknown.
  struct Gap {
    std::array<double, end_rows> left;
    std::array<std::array<double, most_unknowns>, end_rows> slopes;
  };
  Gap gap_of(const ArcChain& chain) {
    const ArcChain::Place end = chain.end();
    Gap gap;
    gap.left = {guide_.to.point.x - end.point.x, guide_.to.point.y - end.point.y,
                guide_.to.heading - chain.heading_at_end()};
    chain.slopes(end, moves_);
    for (int i = 0; i < unknowns_; ++i) {
      const ChainArc& arc = chain.arcs()[i / 2];
      gap.slopes[0][i] = moves_[i].x;
      gap.slopes[1][i] = moves_[i].y;
      gap.slopes[2][i] = i % 2 == 0 ? arc.curvature : arc.length;
    }
    return gap;
  }

  // A change of length counts by its metres, one of curvature by how far it moves the middle.
  double cost(int unknown) const {
    const double moves = guide_.length * guide_.length / 4;
    return unknown % 2 == 0 ? 1 : moves * moves;
  }

  void approach(std::vector<ChainArc>& arcs, double damping) {
    const ArcChain chain(guide_.from, arcs);
    Matrix system = Matrix::Zero(unknowns_ + end_rows, unknowns_ + end_rows);
    Vector right = Vector::Zero(unknowns_ + end_rows);
    for (int i = 0; i < unknowns_; ++i) system(i, i) = damping * cost(i);
    for (std::size_t m = 0; m < stations_.size(); ++m) add_point(chain, m, system, right);
    for (int i = 0; i < unknowns_; ++i)
      for (int k = 0; k < i; ++k) system(k, i) = system(i, k);
    for (int i = 1; i < unknowns_; i += 2)
      add_sharpness(arcs[i / 2].curvature, system(i, i), right(i));
    const Gap gap = gap_of(chain);
    for (int k = 0; k < end_rows; ++k) {
      right(unknowns_ + k) = gap.left[k];
      for (int i = 0; i < unknowns_; ++i)
        system(unknowns_ + k, i) = system(i, unknowns_ + k) = gap.slopes[k][i];
    }
    move(arcs, system.partialPivLu().solve(right));
  }

  // Below the diagonal alone.
  void add_point(const ArcChain& chain, std::size_t m, Matrix& system, Vector& right) {
    const ArcChain::Place place = chain.at(stations_[m]);
    const double weight = weights_[m] / guide_.reach[m];
    const double off = aside(chain, place, m) * weight;
    chain.slopes(place, moves_);
    std::array<double, most_unknowns> row;
    const int moved = 2 * static_cast<int>(place.arc) + 2;
    for (int i = 0; i < moved; ++i) row[i] = cross(place.way, moves_[i]) * weight;
    for (int i = 0; i < moved; ++i) {
      for (int k = 0; k <= i; ++k) system(i, k) += row[i] * row[k];
      right(i) += row[i] * off;
    }
  }

  // A radius that is too small counts as a point that lies far off.
  void add_sharpness(double curvature, double& square, double& right) const {
    constexpr double weight = 100;
    const double most = guide_.most_curvature, over = std::abs(curvature) - most;
    if (over <= 0) return;
    const double slope = weight / (most * most);
    square += slope * slope;
    right -= slope * slope * over * (curvature > 0 ? 1 : -1);
  }

  // The least change that leads the end to its place.  False where it does not come there.
  bool close(std::vector<ChainArc>& arcs) {
    for (int round = 0; round < closing_rounds; ++round) {
      const Gap gap = gap_of(ArcChain(guide_.from, arcs));
      if (std::abs(gap.left[0]) + std::abs(gap.left[1]) + std::abs(gap.left[2]) < ended)
        return true;
      Eigen::Matrix3d system = Eigen::Matrix3d::Zero();
      for (int a = 0; a < end_rows; ++a)
        for (int b = 0; b < end_rows; ++b)
          for (int i = 0; i < unknowns_; ++i)
            system(a, b) += gap.slopes[a][i] * gap.slopes[b][i] / cost(i);
      const Eigen::Vector3d pull =
          system.inverse() * Eigen::Vector3d(gap.left[0], gap.left[1], gap.left[2]);
      Vector step = Vector::Zero(unknowns_);
      for (int i = 0; i < unknowns_; ++i)
        for (int k = 0; k < end_rows; ++k) step(i) += gap.slopes[k][i] * pull(k) / cost(i);
      move(arcs, step);
    }
    return false;
  }

  // Goes a part of the step where it is too long for an arc.
  void move(std::vector<ChainArc>& arcs, const Vector& step) const {
    constexpr double shorter = 0.6, turn = 1;
    double share = 1;
    for (int i = 0; i < unknowns_; i += 2) {
      const double length = arcs[i / 2].length, by = step(i);
      if (by < 0) share = std::min(share, -shorter * length / by);
      if (by > 0) share = std::min(share, guide_.length / by);
      share = std::min(share, turn / std::max(std::abs(step(i + 1)) * length, 1e-9));
    }
    for (int i = 0; i < unknowns_; i += 2) {
      arcs[i / 2].length += share * step(i);
      arcs[i / 2].curvature += share * step(i + 1);
    }
  }

  const PathGuide& guide_;
  int unknowns_;
  std::vector<double> weights_, stations_;  // by point
  std::vector<Point> moves_;
};

}  // namespace

std::optional<FittedArcs> fit_arcs(const PathGuide& guide, std::vector<ChainArc> arcs) {
  return ArcFit(guide, arcs.size()).best(std::move(arcs));
}

std::optional<FittedArcs> fit_one_arc(const PathGuide& guide) {
  constexpr double same_heading = 1e-7, straight = 1e-9;  // radians
  const Point chord = guide.to.point - guide.from.point;
  const double turn = guide.to.heading - guide.from.heading;
  const double half = turn_from(along(guide.from.heading), chord);
  if (std::abs(turn - 2 * half) > same_heading || 2 * std::abs(half) > farthest_turn)
    return std::nullopt;
  const double length =
      std::abs(half) < straight ? norm(chord) : norm(chord) * half / std::sin(half);
  FittedArcs fitted{{{length, turn / length}}, 0};
  ArcFit fit(guide, 1);
  // The first look says beside which places the points lie.
  fit.worst_of(fitted.arcs);
  fitted.worst = fit.worst_of(fitted.arcs);
  return fitted;
}

}  // namespace streetgen
