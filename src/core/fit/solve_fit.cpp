#include "fit/solve_fit.hpp"

#include <algorithm>
#include <cmath>

#include "fit/residual.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/progress.hpp"
#include "support/eigen.hpp"

namespace streetgen {

namespace {

constexpr double widest_scale = 3.2;  // metres times factor: where the loss begins
constexpr int matched_anew = 25;      // rounds in which observations may change their axis
constexpr double least_step = 1e-7;   // metres: a smaller one ends the rounds
constexpr double fine_step = 1e-5;    // the same once matches stay
constexpr double least_damping = 1e-12;
constexpr double least_gain = 1e-6;  // share of the cost: a smaller one ends the rounds

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

// The sums of one segment over unknowns that its observations share, so that each observation adds
// to few numbers.
struct Sums {
  std::vector<int> unknowns;  // ascending
  std::vector<double> squares, slopes;

  int place(int unknown) {
    const auto at = std::lower_bound(unknowns.begin(), unknowns.end(), unknown);
    if (at != unknowns.end() && *at == unknown) return static_cast<int>(at - unknowns.begin());
    widen(at - unknowns.begin(), unknown);
    return place(unknown);
  }
  void add(const Residual& residual) {
    const double weight = residual.weight * residual.loss.weight(residual.value);
    std::array<int, 10> places;
    for (int i = 0; i < residual.count; ++i) place(residual.unknown[i]);
    for (int i = 0; i < residual.count; ++i) places[i] = place(residual.unknown[i]);
    const std::size_t n = unknowns.size();
    for (int i = 0; i < residual.count; ++i) {
      slopes[places[i]] += weight * residual.value * residual.slope[i];
      for (int j = 0; j < residual.count; ++j)
        squares[places[i] * n + places[j]] += weight * residual.slope[i] * residual.slope[j];
    }
  }

 private:
  void widen(std::ptrdiff_t at, int unknown) {
    const std::size_t before = unknowns.size(), n = before + 1;
    unknowns.insert(unknowns.begin() + at, unknown);
    slopes.insert(slopes.begin() + at, 0);
    std::vector<double> wider(n * n, 0);
    for (std::size_t i = 0; i < before; ++i)
      for (std::size_t j = 0; j < before; ++j)
        wider[(i + (i >= static_cast<std::size_t>(at))) * n + j +
              (j >= static_cast<std::size_t>(at))] = squares[i * before + j];
    squares = std::move(wider);
  }
};

struct NormalEquations {
  Matrix squares;
  Vector slopes;
};

class Rounds {
 public:
  Rounds(const std::vector<FitAxis>& axes, const Unknowns& unknowns,
         const std::vector<Observation>& observations, const FitMatcher& matcher,
         const FitRules& rules)
      : axes_(axes),
        unknowns_(unknowns),
        observations_(observations),
        matcher_(matcher),
        rules_(rules),
        sums_of_axis_(axes.size()) {
    for (std::size_t a = 0; a < axes.size(); ++a)
      sums_of_axis_[a].resize(unknowns.courses[a].vertices.size());
  }

  NormalEquations equations(const std::vector<double>& values, const std::vector<FitMatch>& matches,
                            double scale) {
    for (auto& segments : sums_of_axis_)
      for (Sums& sums : segments) sums = {};
    Residual residual;
    for (std::size_t i = 0; i < matches.size(); ++i) {
      if (i % 4096 == 0) poll_cancel();
      const FitMatch& match = matches[i];
      if (match.axis < 0) continue;
      if (residual_of(observations_[i], match, axes_[match.axis], unknowns_.courses[match.axis],
                      values, rules_, scale, residual))
        sums_of_axis_[match.axis][match.segment].add(residual);
    }
    std::vector<Eigen::Triplet<double>> squares;
    Vector slopes = Vector::Zero(unknowns_.count());
    const auto append = [&](const Sums& sums) {
      const std::size_t n = sums.unknowns.size();
      for (std::size_t i = 0; i < n; ++i) {
        slopes[sums.unknowns[i]] += sums.slopes[i];
        for (std::size_t j = 0; j <= i; ++j)
          squares.emplace_back(sums.unknowns[i], sums.unknowns[j], sums.squares[i * n + j]);
      }
    };
    for (const auto& segments : sums_of_axis_)
      for (const Sums& sums : segments) append(sums);
    Sums sums;
    each_regulariser(axes_, unknowns_, values, rules_, [&](const Residual& regulariser) {
      sums = {};
      sums.add(regulariser);
      append(sums);
    });
    NormalEquations equations{Matrix(unknowns_.count(), unknowns_.count()), std::move(slopes)};
    equations.squares.setFromTriplets(squares.begin(), squares.end());
    return equations;
  }

  double cost(const std::vector<double>& values, std::vector<FitMatch>& matches,
              double scale) const {
    double cost = 0;
    Residual residual;
    for (std::size_t i = 0; i < matches.size(); ++i) {
      if (i % 4096 == 0) poll_cancel();
      FitMatch& match = matches[i];
      if (match.axis < 0) continue;
      if (rules_.axes_move) matcher_.renew(static_cast<int>(i), values, match);
      if (residual_of(observations_[i], match, axes_[match.axis], unknowns_.courses[match.axis],
                      values, rules_, scale, residual))
        cost += residual.cost();
    }
    each_regulariser(axes_, unknowns_, values, rules_,
                     [&](const Residual& regulariser) { cost += regulariser.cost(); });
    return cost;
  }

 private:
  const std::vector<FitAxis>& axes_;
  const Unknowns& unknowns_;
  const std::vector<Observation>& observations_;
  const FitMatcher& matcher_;
  const FitRules& rules_;
  std::vector<std::vector<Sums>> sums_of_axis_;
};

// The values after a step, none beyond its bounds.
std::vector<double> stepped(const Unknowns& unknowns, const std::vector<double>& values,
                            const Vector& step) {
  std::vector<double> next(values);
  for (int i = 0; i < unknowns.count(); ++i)
    next[i] = std::clamp(values[i] + step[i], unknowns.least[i], unknowns.greatest[i]);
  return next;
}

// An unknown at its bound that would go beyond stays, and the others find their step without it.
void hold_at_bounds(const Unknowns& unknowns, const std::vector<double>& values,
                    NormalEquations& equations) {
  std::vector<bool> held(unknowns.count());
  for (int i = 0; i < unknowns.count(); ++i) {
    const double slope = equations.slopes[i];
    held[i] = (values[i] <= unknowns.least[i] && slope > 0) ||
              (values[i] >= unknowns.greatest[i] && slope < 0);
    if (held[i]) equations.slopes[i] = 0;
  }
  for (int column = 0; column < equations.squares.outerSize(); ++column)
    for (Matrix::InnerIterator entry(equations.squares, column); entry; ++entry)
      if (entry.row() != entry.col() && (held[entry.row()] || held[entry.col()]))
        entry.valueRef() = 0;
}

double farthest(const std::vector<double>& a, const std::vector<double>& b) {
  double far = 0;
  for (std::size_t i = 0; i < a.size(); ++i) far = std::max(far, std::abs(a[i] - b[i]));
  return far;
}

}  // namespace

double fit_cost(const std::vector<FitAxis>& axes, const Unknowns& unknowns,
                const std::vector<Observation>& observations, const FitMatcher& matcher,
                const FitRules& rules, const std::vector<double>& values,
                std::vector<FitMatch>& matches, double scale, std::vector<double>* slopes) {
  Rounds rounds(axes, unknowns, observations, matcher, rules);
  const double cost = rounds.cost(values, matches, scale);
  if (slopes != nullptr) {
    const Vector half = rounds.equations(values, matches, scale).slopes;
    slopes->assign(half.data(), half.data() + half.size());
    for (double& slope : *slopes) slope *= 2;
  }
  return cost;
}

SolvedFit solve_fit(const std::vector<FitAxis>& axes, const Unknowns& unknowns,
                    const std::vector<Observation>& observations, const FitMatcher& matcher,
                    const FitRules& rules) {
  SolvedFit fit{unknowns.origin, std::vector<FitMatch>(observations.size()), 0};
  Rounds rounds(axes, unknowns, observations, matcher, rules);
  double scale = std::max(rules.scale, widest_scale), damping = 1e-6;
  Eigen::SimplicialLDLT<Matrix> solver;
  for (; fit.iterations < rules.iterations; ++fit.iterations) {
    tell_progress("rounds of the fit", fit.iterations, rules.iterations);
    if (fit.iterations <= matched_anew)
      for (std::size_t i = 0; i < observations.size(); ++i) {
        if (i % 4096 == 0) poll_cancel();
        fit.matches[i] = matcher.match(static_cast<int>(i), fit.values);
      }
    const double before = rounds.cost(fit.values, fit.matches, scale);
    NormalEquations equations = rounds.equations(fit.values, fit.matches, scale);
    hold_at_bounds(unknowns, fit.values, equations);
    double moved = 0, gain = 0;
    for (int attempt = 0; attempt < 12; ++attempt) {
      Matrix damped = equations.squares;
      for (int i = 0; i < unknowns.count(); ++i)
        damped.coeffRef(i, i) += damping * std::max(damped.coeff(i, i), 1.0);
      solver.compute(damped);
      if (solver.info() == Eigen::Success) {
        const Vector step = solver.solve(-equations.slopes);
        std::vector<double> next = stepped(unknowns, fit.values, step);
        std::vector<FitMatch> matches = fit.matches;
        const double after = rounds.cost(next, matches, scale);
        if (after <= before) {
          gain = before - after;
          moved = farthest(next, fit.values);
          fit.values = std::move(next);
          fit.matches = std::move(matches);
          damping = std::max(damping / 10, least_damping);
          break;
        }
      }
      damping *= 10;
    }
    if (scale > rules.scale)
      scale = std::max(scale / 2, rules.scale);
    else if (moved < least_step ||
             (fit.iterations > matched_anew && (moved < fine_step || gain < least_gain * before)))
      break;
  }
  return fit;
}

}  // namespace streetgen
