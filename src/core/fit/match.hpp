// Which axis takes an observation.
#pragma once

#include <vector>

#include "fit/course.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/fit.hpp"

namespace streetgen {

// An observation at a segment of a course.
struct FitMatch {
  int axis = -1;  // -1: no axis takes it
  int segment = 0, stretch = -1;
  int side = 1;              // +1: it lies to the left
  double along = 0;          // share of the segment, 0 to 1
  double abscissa = 0;       // metres along the axis of the input
  double offset = 0;         // metres from the axis, left positive
  Point normal;              // unit, to the left
  bool at_junction = false;  // it lies beside a node, where no section is
};

class FitMatcher {
 public:
  FitMatcher(const std::vector<FitAxis>& axes, const Unknowns& unknowns,
             const std::vector<Observation>& observations, const FitRules& rules);

  // Where an observation lies with values of the unknowns: at the section whose kerb is nearest.
  FitMatch match(int observation, const std::vector<double>& values) const;
  // The same at the segment of an earlier match.
  void renew(int observation, const std::vector<double>& values, FitMatch& match) const;

 private:
  struct Segment {
    int axis, segment;
  };
  bool place_at(const Point& place, const std::vector<double>& values, const Segment& segment,
                FitMatch& match) const;
  double score(const Observation& observation, const std::vector<double>& values,
               const FitMatch& match) const;

  const std::vector<FitAxis>& axes_;
  const Unknowns& unknowns_;
  const std::vector<Observation>& observations_;
  const FitRules& rules_;
  std::vector<Segment> segments_;
  std::vector<std::size_t> first_near_;  // of each observation in near_, and one beyond the last
  std::vector<int> near_;                // indices of segments
};

}  // namespace streetgen
