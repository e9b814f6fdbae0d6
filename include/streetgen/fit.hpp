// The street model fitted to observations: kerbs, sidewalks, markings and objects that were
// surveyed or detected.  StreetGen paper, section 4.8.
//
// Least is the sum over all residuals of weight * loss(factor * residual).  With D the signed
// distance from an axis to an observation that it takes, left positive, and h the distance from the
// axis to its kerb there:
//   kerb            |D| - h
//   object, border  |D| - h
//   object, in      what |D| exceeds h - margin by
//   object, out     what h + margin exceeds |D| by
//   marking         D - the nearest border between two of the equally wide lanes
//   width           width of the roadway there - the width observed
// and the regularisers, which hold the model where it is:
//   width           width - that of the input; half for each end of one that tapers
//   origin          offset of the roadway, or each coordinate of a vertex, - that of the input
//   spacing         length between two vertices - that of the input
//   angle           radians between two pieces of an axis - those of the input
// The factor of an observation is its confidence times that of its kind, and its weight counts as
// so many observations.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// s is the scale.  That of a kind grows with its factor, so that every loss begins at as many
// metres as that of a kerb.  cauchy s^2 log(1 + (r/s)^2), soft_l1 2 s^2 (sqrt(1 + (r/s)^2) - 1),
// squares r^2.
enum class FitLoss { cauchy, soft_l1, squares };

enum class ObservationKind { kerb, sidewalk_back, marking, object, width };
enum class ObservationRelation { border, in, out };

struct Observation {
  Point place;
  ObservationKind kind = ObservationKind::kerb;
  ObservationRelation relation = ObservationRelation::border;  // of an object, to the roadway
  double confidence = 1;                                       // 0 (nothing takes it) to 1
  double weight = 1;                                           // positive
  double width = 0;                                            // metres, of kind width
};

// A piece of an axis between two nodes, and the part of it where its section lies.
struct FitStretch {
  double start = 0, end = 0;                  // metres along the axis
  double from = 0, to = 0;                    // of the section: it alone takes observations
  std::int64_t start_node = 0, end_node = 0;  // 0: one that stays
};

struct FitAxis {
  Line line;  // at least two distinct points
  double width_start = 0, width_end = 0;
  double roadway_offset = 0;  // to the left
  int lanes = 1;
  double sidewalk_left = 0, sidewalk_right = 0;
  std::vector<FitStretch> stretches;  // ascending along the axis
  bool moves = true;                  // false: it stays, and takes its observations from others
};

struct FitRules {
  bool axes_move = false;  // false: widths and offsets alone
  FitLoss loss = FitLoss::cauchy;
  double scale = 0.05;
  double observation = 0.5, observed_width = 2, object = 50;   // factors of observations
  double width = 0.2, origin = 0.5, spacing = 0.5, angle = 2;  // factors of regularisers
  double reach = 8;         // metres from its kerb: farther observations are no street's
  double width_change = 8;  // metres, greatest
  double move = 3;          // metres, greatest, of each coordinate and of the offset
  double width_least = 2, width_greatest = 20;  // of a width that changes
  double piece = 30;                            // metres, of an axis that moves
  double object_margin = 0.25;
  int iterations = 100;  // at most
};

struct FittedAxis {
  Line line;  // that of the input where axes do not move
  double width_start = 0, width_end = 0, roadway_offset = 0;
  double sidewalk_left = 0, sidewalk_right = 0;  // of the input without an observation
  int used = 0;                                  // observations
  // Mean distance of its observed kerbs to its own; not a number without one.
  double before = std::numeric_limits<double>::quiet_NaN(), after = before;
};

// Mean and median distance of the kerbs observed to those of the axes that take them, metres; not a
// number without one.
struct KerbDistance {
  double mean = std::numeric_limits<double>::quiet_NaN(), median = mean;
};

struct Fitted {
  std::vector<FittedAxis> axes;  // one each
  int used = 0;                  // observations that an axis takes
  int iterations = 0;
  KerbDistance before, after;
};

// A width changes along an axis where kerbs are observed along most of it. Equal whatever the order
// of observations. Axes that move share the displacement of each node, and nodes of axes that stay
// do not move. Throws Error for numbers that are not finite.
Fitted fit_streets(const std::vector<FitAxis>& axes, std::vector<Observation> observations,
                   const FitRules& rules);

// The fate of an observation: an axis takes it, or there is a reason why none does.
enum class ObservationFate { taken, no_street, at_junction, not_sure };
struct TakenObservation {
  ObservationFate fate = ObservationFate::no_street;
  int axis = -1, stretch = -1;
  double abscissa = 0;  // metres along the axis
  double offset = 0;    // metres from the axis, left positive
  double off = 0;       // metres beyond the kerb of that side, negative within the roadway
};
// In the order of the observations.
std::vector<TakenObservation> taken_observations(const std::vector<FitAxis>& axes,
                                                 const std::vector<Observation>& observations,
                                                 const FitRules& rules);

}  // namespace streetgen
