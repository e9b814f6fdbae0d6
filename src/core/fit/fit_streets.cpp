#include <algorithm>
#include <cmath>
#include <tuple>

#include "fit/loss.hpp"
#include "fit/solve_fit.hpp"
#include "streetgen/error.hpp"
#include "streetgen/fit.hpp"

namespace streetgen {

namespace {

constexpr double taper_share = 0.7;  // of an axis along which kerbs tell of a change of width
constexpr std::size_t taper_observations = 20;

void require_finite(const std::vector<FitAxis>& axes,
                    const std::vector<Observation>& observations) {
  const auto refuse = [](const std::string& what, std::size_t i) {
    throw Error(ErrorKind::invalid_input, what + " " + std::to_string(i + 1) + " is not finite");
  };
  for (std::size_t i = 0; i < axes.size(); ++i) {
    bool sound = std::isfinite(axes[i].width_start + axes[i].width_end + axes[i].roadway_offset);
    for (const Point& p : axes[i].line) sound = sound && std::isfinite(p.x + p.y);
    if (!sound) refuse("axis", i);
    if (distinct(axes[i].line).size() < 2)
      throw Error(ErrorKind::degenerate, "axis " + std::to_string(i + 1) + " has no length");
  }
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const Observation& one = observations[i];
    if (!std::isfinite(one.place.x + one.place.y + one.confidence + one.weight + one.width))
      refuse("observation", i);
  }
}

void sort_by_place(std::vector<Observation>& observations) {
  const auto key = [](const Observation& o) {
    return std::make_tuple(o.place.x, o.place.y, o.kind, o.relation, o.confidence, o.weight,
                           o.width);
  };
  std::sort(observations.begin(), observations.end(),
            [&](const Observation& a, const Observation& b) { return key(a) < key(b); });
}

double kerb_distance(const FitAxis& axis, const Course& course, const std::vector<double>& values,
                     const FitMatch& match) {
  const FittedCourse fitted(axis, course, values);
  return std::abs(std::abs(match.offset) - fitted.to_kerb(match.abscissa, match.side));
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (double value : values) sum += value;
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : sum / values.size();
}

double median_of(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const std::size_t middle = values.size() / 2;
  std::nth_element(values.begin(), values.begin() + middle, values.end());
  return values[middle];
}

// How far values reach that are spread evenly, by the middle nine tenths of them: a few beyond do
// not count.
double span_of(std::vector<double> values) {
  constexpr double middle = 0.9;
  std::sort(values.begin(), values.end());
  const auto left = static_cast<std::size_t>(values.size() * (1 - middle) / 2);
  return (values[values.size() - 1 - left] - values[left]) / middle;
}

// The place where most of the values lie, as a loss that narrows finds it from their median.
double robust_middle(const std::vector<double>& values, const std::vector<double>& weights,
                     const FitRules& rules) {
  double middle = median_of(values);
  for (double scale = 3.2; scale > 1e-3; scale = scale > rules.scale ? scale / 2 : scale / 1.5) {
    const Loss loss{rules.loss, std::max(scale, rules.scale)};
    double sum = 0, total = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double weight = weights[i] * loss.weight(rules.observation * (values[i] - middle));
      sum += weight * values[i];
      total += weight;
    }
    middle = sum / total;
  }
  return middle;
}

class Fit {
 public:
  Fit(const std::vector<FitAxis>& axes, const std::vector<Observation>& observations,
      const FitRules& rules)
      : axes_(axes),
        observations_(observations),
        rules_(rules),
        unknowns_(vertices_of(axes, rules)),
        matcher_(axes, unknowns_, observations, rules) {
    before_ = matches(unknowns_.origin);
    find_tapers();
  }

  Fitted solved() {
    add_widths(axes_, taken_, tapers_, rules_, unknowns_);
    const SolvedFit fit = solve_fit(axes_, unknowns_, observations_, matcher_, rules_);
    Fitted fitted;
    fitted.iterations = fit.iterations;
    fitted.axes.resize(axes_.size());
    const std::vector<FitMatch> after = matches(fit.values);
    tell_distances(unknowns_.origin, before_, &FittedAxis::before, fitted.before, fitted);
    tell_distances(fit.values, after, &FittedAxis::after, fitted.after, fitted);
    for (const FitMatch& match : after) {
      if (match.axis < 0) continue;
      ++fitted.used;
      ++fitted.axes[match.axis].used;
    }
    for (std::size_t a = 0; a < axes_.size(); ++a) give(a, fit.values, fitted.axes[a]);
    fit_sidewalks(fit.values, after, fitted);
    return fitted;
  }

 private:
  std::vector<FitMatch> matches(const std::vector<double>& values) const {
    std::vector<FitMatch> all;
    for (std::size_t i = 0; i < observations_.size(); ++i)
      all.push_back(matcher_.match(static_cast<int>(i), values));
    return all;
  }

  void find_tapers() {
    taken_.resize(axes_.size(), false);
    std::vector<std::vector<double>> kerbs(axes_.size());
    for (std::size_t i = 0; i < before_.size(); ++i) {
      const FitMatch& match = before_[i];
      if (match.axis < 0 || observations_[i].kind == ObservationKind::sidewalk_back) continue;
      taken_[match.axis] = true;
      if (observations_[i].kind == ObservationKind::kerb)
        kerbs[match.axis].push_back(match.abscissa);
    }
    for (std::size_t a = 0; a < axes_.size(); ++a)
      tapers_.push_back(kerbs[a].size() >= taper_observations &&
                        span_of(kerbs[a]) >= taper_share * unknowns_.courses[a].total);
  }

  void tell_distances(const std::vector<double>& values, const std::vector<FitMatch>& matches,
                      double FittedAxis::*of_axis, KerbDistance& of_all, Fitted& fitted) const {
    std::vector<double> all;
    std::vector<std::vector<double>> by_axis(axes_.size());
    for (std::size_t i = 0; i < matches.size(); ++i) {
      const FitMatch& match = matches[i];
      if (match.axis < 0 || observations_[i].kind != ObservationKind::kerb) continue;
      const double off =
          kerb_distance(axes_[match.axis], unknowns_.courses[match.axis], values, match);
      all.push_back(off);
      by_axis[match.axis].push_back(off);
    }
    of_all = {mean_of(all), median_of(all)};
    for (std::size_t a = 0; a < axes_.size(); ++a) fitted.axes[a].*of_axis = mean_of(by_axis[a]);
  }

  void give(std::size_t a, const std::vector<double>& values, FittedAxis& given) const {
    const FittedCourse fitted(axes_[a], unknowns_.courses[a], values);
    given.width_start = fitted.width_start();
    given.width_end = fitted.width_end();
    given.roadway_offset = fitted.offset();
    given.sidewalk_left = axes_[a].sidewalk_left;
    given.sidewalk_right = axes_[a].sidewalk_right;
    bool moved = false;
    Line line;
    for (std::size_t i = 0; i < unknowns_.courses[a].vertices.size(); ++i) {
      const int x = unknowns_.courses[a].vertices[i].x;
      moved = moved || (x != not_free && std::hypot(values[x], values[x + 1]) > 1e-6);
      line.push_back(fitted.vertex(i));
    }
    given.line = moved ? std::move(line) : axes_[a].line;
  }

  void fit_sidewalks(const std::vector<double>& values, const std::vector<FitMatch>& matches,
                     Fitted& fitted) const {
    std::vector<std::array<std::pair<std::vector<double>, std::vector<double>>, 2>> backs(
        axes_.size());
    for (std::size_t i = 0; i < matches.size(); ++i) {
      const FitMatch& match = matches[i];
      if (match.axis < 0 || observations_[i].kind != ObservationKind::sidewalk_back) continue;
      const FittedCourse course(axes_[match.axis], unknowns_.courses[match.axis], values);
      auto& [widths, weights] = backs[match.axis][match.side > 0 ? 0 : 1];
      widths.push_back(std::abs(match.offset) - course.to_kerb(match.abscissa, match.side));
      weights.push_back(observations_[i].weight * observations_[i].confidence);
    }
    for (std::size_t a = 0; a < axes_.size(); ++a)
      for (int side = 0; side < 2; ++side) {
        const auto& [widths, weights] = backs[a][side];
        if (widths.empty() || !axes_[a].moves) continue;
        double& width = side == 0 ? fitted.axes[a].sidewalk_left : fitted.axes[a].sidewalk_right;
        width = std::max(0.0, robust_middle(widths, weights, rules_));
      }
  }

  const std::vector<FitAxis>& axes_;
  const std::vector<Observation>& observations_;
  const FitRules& rules_;
  Unknowns unknowns_;
  FitMatcher matcher_;
  std::vector<FitMatch> before_;
  std::vector<bool> taken_, tapers_;
};

}  // namespace

Fitted fit_streets(const std::vector<FitAxis>& axes, std::vector<Observation> observations,
                   const FitRules& rules) {
  require_finite(axes, observations);
  sort_by_place(observations);
  return Fit(axes, observations, rules).solved();
}

std::vector<TakenObservation> taken_observations(const std::vector<FitAxis>& axes,
                                                 const std::vector<Observation>& observations,
                                                 const FitRules& rules) {
  require_finite(axes, observations);
  const Unknowns unknowns = vertices_of(axes, rules);
  const FitMatcher matcher(axes, unknowns, observations, rules);
  std::vector<TakenObservation> taken;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const FitMatch match = matcher.match(static_cast<int>(i), unknowns.origin);
    TakenObservation one;
    if (observations[i].confidence == 0) {
      one.fate = ObservationFate::not_sure;
    } else if (match.axis < 0) {
      one.fate = match.at_junction ? ObservationFate::at_junction : ObservationFate::no_street;
    } else {
      const FittedCourse course(axes[match.axis], unknowns.courses[match.axis], unknowns.origin);
      one = {ObservationFate::taken,
             match.axis,
             match.stretch,
             match.abscissa,
             match.offset,
             std::abs(match.offset) - course.to_kerb(match.abscissa, match.side)};
    }
    taken.push_back(one);
  }
  return taken;
}

}  // namespace streetgen
