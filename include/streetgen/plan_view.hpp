// Reference lines of roads as OpenDRIVE has them: chains of lines, arcs and clothoids without a
// kink.
#pragma once

#include <optional>
#include <vector>

#include "streetgen/alignment.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// A place of a chain, and its direction there.
struct ChainPlace {
  Point point;
  double heading = 0;  // radians, counter-clockwise from east
};

// A line, an arc where the curvature is not zero, or a clothoid where it changes.
struct PlanPiece {
  double s = 0;  // metres along the chain, where it begins
  ChainPlace start;
  double length = 0;     // metres, positive
  double curvature = 0;  // where it begins, one by metres, positive to the left
  double curvature_end = 0;

  bool straight() const { return curvature == 0 && curvature_end == 0; }
};

// Metres.  Roads and paths have no tighter arc, where the model's have none.
constexpr double least_curve_radius = 3.1;

struct ChainEnds {
  std::optional<double> heading_from, heading_to;  // radians; none: those of the line
};

// A chain of pieces that goes on in place and heading from one to the next, and leaves the line by
// `tolerance` metres at most, nor the line it.  It begins and ends where the line does, with the
// headings that are given, else those of its first and last side.  A kink becomes an arc; a line
// that turns back on itself gets two on the way about.  A line without two distinct points has no
// piece.  Arcs at kinks are as wide as `least_radius`, where the sides have room for it and the arc
// leaves the kink by a metre at most.  ASAM OpenDRIVE 1.7, section 8.
std::vector<PlanPiece> plan_view(const Line& line, double tolerance, const ChainEnds& ends = {},
                                 double least_radius = 0);

// The curve of a path from lane to lane, as few lines and arcs: it begins and ends at places with
// their headings, also where the ends of the path lie beside them or lead elsewhere.  It stays
// within `tolerance` metres of the path, moved so that it begins and ends there.  An end that
// leads elsewhere gives it the room that its arc needs, within some metres of that end; and where
// more arcs come no nearer to the path, it has fewer.  Arcs are wider than `least_curve_radius` and
// half the lane, but where the path turns as far within 2 m.  A curve of no length has no piece.
std::vector<PlanPiece> path_view(const Line& path, const ChainPlace& from, const ChainPlace& to,
                                 double tolerance, double lane_width);

// A path that is moved aside to begin and end beside two places: by as much as these lie beside its
// ends, less and less towards the other one.
Line path_beside(const Line& path, const ChainPlace& from, const ChainPlace& to);

// The part of an alignment beside which a line lies: from the place nearest to its first point to
// that nearest to its last one, turned round where the line goes against the alignment.  None where
// a point lies more than `reach` metres beside the alignment or beyond it, where the line goes back
// along it, and where the part has a gap or a kink.
std::vector<PlanPiece> course_beside(const std::vector<AlignmentElement>& alignment,
                                     const Line& line, double reach);

double length(const std::vector<PlanPiece>& chain);

// At s metres along it, clamped.  A chain without a piece: degenerate.
ChainPlace place_at(const std::vector<PlanPiece>& chain, double s);

// The place of a point beside a chain.
struct ChainStation {
  double s = 0;        // metres along the chain to its place that is nearest
  double aside = 0;    // metres to the left of the chain there
  double heading = 0;  // of the chain there, radians
  double beyond = 0;   // metres straight on behind its end, negative before it begins; else 0
};

// The first one counts of two places that are as near.  A chain without a piece: degenerate.
ChainStation station_of(const std::vector<PlanPiece>& chain, const Point& point);

}  // namespace streetgen
