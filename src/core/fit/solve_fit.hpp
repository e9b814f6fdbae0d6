// Levenberg-Marquardt by normal equations that are weighted anew in each round.
#pragma once

#include <vector>

#include "fit/match.hpp"

namespace streetgen {

struct SolvedFit {
  std::vector<double> values;     // of the unknowns
  std::vector<FitMatch> matches;  // of the observations
  int iterations = 0;
};

// Observations are matched anew as it converges. The loss is wide at first and narrows to its
// scale, so that kerbs far from the input are found.
SolvedFit solve_fit(const std::vector<FitAxis>& axes, const Unknowns& unknowns,
                    const std::vector<Observation>& observations, const FitMatcher& matcher,
                    const FitRules& rules);

// Cost and its slopes by the unknowns, with matches as they stand.
double fit_cost(const std::vector<FitAxis>& axes, const Unknowns& unknowns,
                const std::vector<Observation>& observations, const FitMatcher& matcher,
                const FitRules& rules, const std::vector<double>& values,
                std::vector<FitMatch>& matches, double scale, std::vector<double>* slopes);

}  // namespace streetgen
