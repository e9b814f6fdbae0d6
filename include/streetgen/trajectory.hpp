// The path of a vehicle from one lane to another.  StreetGen paper, 2.7.3.
//
// Lanes are polylines of at least two distinct, finite points in their driving direction: the
// path starts at the end of one and ends at the start of the other, exactly.
#pragma once

#include <optional>

#include "streetgen/geometry.hpp"

namespace streetgen {

enum class TrajectoryRule {
  bezier,  // quadratic, the paper's
  arcs,    // at most two arcs and two straight pieces, tangent to both lanes and to each other
};

// |cos| of the angle between two lanes that count as parallel; every trajectory of the published
// Paris 6e agrees.
constexpr double parallel_cosine = 0.85;

struct Trajectory {
  Point control;  // of the Bezier curve; of the arcs: where the tangents meet
  Line line;      // no farther than the tolerance from the curve
};

// The control point of the paper, u and v the directions of the lanes where the path touches
// them, parallel when |cos(u, v)| >= 0.85 (with which the published data agrees to the last row):
//   not parallel           half way from the crossing of the lanes' straight continuations to
//   `centre` parallel               the middle of start and end: the path is straight parallel and
//   opposite  half way from that middle to `centre`
// Where that path is tighter than `least_radius` by quarter_radius and the continuations meet
// ahead, the control point slides from half way towards their crossing, by eighths, until the path
// is wide enough, else to where it is widest; least_radius 0: the paper's rule everywhere. A given
// `control` makes the path the Bezier curve with that control point, by either rule. tolerance > 0,
// metres; a curve has at most 1000 chords.
Trajectory trajectory(const Line& lane_in, const Line& lane_out, const Point& centre,
                      TrajectoryRule rule, double tolerance, double least_radius = 0,
                      const std::optional<Point>& control = {});

// Tangent to both lanes: the Bezier curve about the crossing of the lanes' straight continuations
// where it lies ahead and the path does not turn back, else, and by rule arcs, the arcs.
Trajectory tangent_trajectory(const Line& lane_in, const Line& lane_out, TrajectoryRule rule,
                              double tolerance);

// The least radius of the circles through successive quarter points of the path; infinite for a
// straight path or one without length.
double quarter_radius(const Line& path);

// Degrees, 0 to 180: the greatest turn between two chords of the path that follow each other. A
// circle of 3 m within a tolerance of 0.05 m has chords that turn by 21 degrees; a cusp turns by up
// to 180.
double sharpest_turn(const Line& path);

}  // namespace streetgen
