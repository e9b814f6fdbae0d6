// Lanes of edges, the lines between them, what is painted.  StreetGen paper, 2.5 and 2.7.2.
//
// Lanes fill the roadway of an edge from kerb to kerb between its two section limits, as
// offset curves of the axis.  Where the roadway is wider than their stated widths, or than lanes
// without one grow, the rest lies beside them.  Where the width of an axis changes, their shares of
// it stay.  Where the street goes on with another width past a side street, the lanes that begin or
// end there take the change, and the others keep their width: on the side that turn marks say, else
// the outer one. Merging lanes lie outside of the others, whose places do not depend on them. Where
// the limits of an edge crossed, its lanes cover the piece between the two wanted limits, in the
// direction of the axis, and have no surface. The line of a lane may be drawn by hand: it is taken
// as it is, and the lane's surface is the ground within half the lane's width of it, flat at its
// ends, wherever its neighbours are.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "streetgen/control_point.hpp"
#include "streetgen/geometry.hpp"
#include "streetgen/street.hpp"
#include "streetgen/width_profile.hpp"

namespace streetgen {

// Merging lanes lie beside the others on a part of an edge only, where a ramp is.
enum class LaneKind { general, bus, carpool, cycle, parking, merging, closed };
using LaneKinds = std::bitset<7>;
constexpr std::size_t index_of(LaneKind kind) { return static_cast<std::size_t>(kind); }
// Of traffic: nobody drives along a parking lane, nor on one that is closed.
inline bool carries_traffic(LaneKind kind) {
  return kind != LaneKind::parking && kind != LaneKind::closed;
}
// The lanes that lists of turns, widths and lane changes of a source count: of motor traffic.
inline bool drives(LaneKind kind) {
  return kind == LaneKind::general || kind == LaneKind::bus || kind == LaneKind::carpool;
}
// Not of all traffic, but of some.
inline bool of_some_alone(const LaneKinds& kinds) {
  return kinds.any() && !kinds[index_of(LaneKind::general)];
}
// A carpool lane leads where a general lane would.
inline LaneKind leads_as(LaneKind kind) {
  return kind == LaneKind::carpool ? LaneKind::general : kind;
}
enum class LaneSide { left, centre, right };  // of the roadway, in the direction of the axis

// The order in which lanes are numbered: from the middle outwards, 1 the centre lane where there is
// one.
enum class LaneOrder {
  left_first,   // the published data
  right_first,  // the paper
};
enum class DrivingSide { left, right };

// The movements that a lane allows, as bits; 0: nothing is said.
namespace turn {
constexpr unsigned reverse = 1, sharp_left = 2, left = 4, slight_left = 8, through = 16,
                   slight_right = 32, right = 64, sharp_right = 128, merge_left = 256,
                   merge_right = 512;
constexpr unsigned leftwards = sharp_left | left | slight_left,
                   rightwards = slight_right | right | sharp_right,
                   merges = merge_left | merge_right;
}  // namespace turn

// One lane as it is known before it has a place.
struct LaneWish {
  LaneKind kind = LaneKind::general;
  bool along_axis = true;
  bool both_ways = false;  // both directions use it; it counts as along the axis
  double width = 0;        // metres; 0: an equal share of what the others leave
  double widest = 0;       // metres that such a share grows to; 0: however wide
  unsigned turns = 0;
  bool yields = false;  // the width is that of its kind: it gives way to widths that are stated
};

// The lanes of one axis, each list from left to right in its driving direction; those of both
// directions lie between the others, from left to right in the direction of the axis.
struct AxisLanes {
  std::vector<LaneWish> forward, backward, both_ways{};
};

// By hand: of the lane `ordinality` of the edge of the axis that holds `abscissa`.
struct LaneOverride {
  std::int64_t axis_id = 0;
  double abscissa = 0;  // metres along the axis
  int ordinality = 0;
  enum class Direction { as_is, along, against, both } direction = Direction::as_is;
  double width = 0;  // metres; 0: as it is
  // The centre line, turned where it runs against the axis: its end lies before its start there.
  // At least two distinct, finite points; empty: as it is.
  Line line{};
};

// A decision by hand: whether traffic may leave a lane for the lane beside it. The decision holds
// on the edge of the axis that has `abscissa`.
struct LaneChange {
  std::int64_t axis_id = 0;
  double abscissa = 0;   // metres along the axis
  int from = 0, to = 0;  // ordinalities
  bool allowed = true;
};

// Whether traffic may leave a lane to its left and to its right, in its driving direction, by a
// source. A lane of which the source says nothing has none.
struct LeavingLane {
  bool left = true, right = true;
};
using LeavingLanes = std::vector<std::optional<LeavingLane>>;

// The lanes of one axis for driving: each list goes from left to right in its driving direction.
struct LeavingOfAxis {
  std::int64_t axis_id = 0;
  LeavingLanes forward, backward;
};

// Decisions and sources that change paint alone.  A decision by hand goes before a source.  Of two
// decisions on one thing the later one holds.
struct PaintRules {
  std::vector<JunctionDecision> junctions;
  std::vector<LaneChange> changes;
  std::vector<LeavingOfAxis> leaving{};  // by axis_id, each at most once
  std::vector<std::int64_t> bare{};      // axes of streets on whose lanes nothing is painted
};

struct LaneSettings {
  LaneOrder order = LaneOrder::left_first;
  DrivingSide driving_side = DrivingSide::right;
  double narrowest = 2;            // metres: lanes of unknown width get less only for want of room
  bool edge_lines = false;         // separators along the kerbs too
  double kerb_radius_minimal = 0;  // metres, as the kerbs of the sections have it
  ControlRules controls{};
  double line_before_kerb = 0.5;  // metres from a line to the roadway before which it lies
};

struct Lane {
  int edge = 0;
  int ordinality = 0;  // from 1, by LaneOrder; merging lanes after all others
  int position = 0;    // from 1, at the left kerb
  LaneSide side = LaneSide::centre;
  bool along_axis = true;
  bool both_ways = false;
  // Both directions use it, and each has lanes of its own beside it: it is for those who turn off.
  bool middle = false;
  LaneKind kind = LaneKind::general;
  double width = 0;        // metres, at the start limit, without what begins or ends there
  double axis_offset = 0;  // of its centre line, metres to the left of the axis, at the start limit
  Line line;               // the centre line, in the point order of the axis
  // The lanes of an edge tile its section, but for what they leave at the kerbs; where a
  // ring would not be simple, or a line was drawn by hand, the buffer of the centre line.  Empty
  // where the limits crossed.
  MultiPolygon surface;
  unsigned turns = 0;
  Method method = Method::hypothesis;  // or crossed_limits, or by_hand
  // Metres along the edge where a merging lane begins and ends within the section; none: at the
  // limit.
  std::optional<double> start{}, end{};
  // Its borders lie here between its neighbours, also where its line is by hand.  Without them it
  // is as wide as `width` about `axis_offset` all along.
  WidthProfile borders{};

  bool reaches(bool at_start) const { return !(at_start ? start : end).has_value(); }
};

// A lane for both directions lies between two centre lines, but for cycle and parking lanes.
enum class SeparatorKind { centre, same_direction, edge };

// The line between the lanes `position` and `position + 1`; 0 and the number of lanes: a kerb.
struct LaneSeparator {
  int edge = 0;
  int position = 0;
  SeparatorKind kind = SeparatorKind::same_direction;
  bool dashed = false;
  // Whether traffic may cross it to its left, and to its right, seen along the axis.  Where one
  // alone is so, a solid line on the side of those who may not stands beside a dashed one.
  bool leftwards = false, rightwards = false;
  double axis_offset = 0;  // metres to the left of the axis, at the start limit
  Line line;               // in the point order of the axis
  bool painted = false;    // not where the limits crossed, nor on a street without paint
};

// Its paint, dash by dash; solid on more than 100 km; empty where it is not painted.  A city has
// millions of dashes: they are made one separator at a time.
MultiPolygon paint_of(const LaneSeparator& separator);

enum class MarkingKind { stop, yield, arrow };

constexpr double stop_line_width = 0.5;  // metres along the lane, of yield lines too

struct Marking {
  MarkingKind kind = MarkingKind::arrow;
  int edge = 0;
  int position = 0;        // of the lane
  bool along_axis = true;  // the traffic that it speaks to
  int node = 0;            // where that traffic goes
  Line line;               // stop and yield lines: across the lane; arrows: from foot to tip
  MultiPolygon surface;    // empty on a street without paint
};

struct Lanes {
  std::vector<Lane> lanes;                // by (edge, position)
  std::vector<LaneSeparator> separators;  // by (edge, position)
  std::vector<Marking> markings;          // by edge; at most one of a kind per lane and direction
};

// By axis_id, each at most once; an axis that has none gets one lane along it.
struct LanesOfAxis {
  std::int64_t axis_id = 0;
  AxisLanes lanes;
  bool on_ring = false;  // by its source; what comes to it from the side yields
};

// On the edge of the axis that holds `abscissa` traffic goes round a roundabout.
struct Circulation {
  std::int64_t axis_id = 0;
  double abscissa = 0;     // metres along the axis
  bool along_axis = true;  // it drives along the axis
  bool turned = false;     // all lanes of the edge are its own: no source states a direction
};

// Deterministic and independent of the order of axes.  Of two overrides of one lane the later holds
// in what it says; one of a lane that is not there does nothing.  Lanes come out for the edges that
// meet at affected nodes.  Control points decide the lines painted across the ends of lanes, kinds
// of junctions by hand before them.  The line between two lanes is painted as it may be crossed.
// Arrows lie on lanes with turn marks, and on those without that come to signals beside others.
Lanes lanes(const Streets& streets, const std::vector<LanesOfAxis>& axes,
            std::vector<LaneOverride> overrides, const LaneSettings& settings,
            const std::vector<ControlPoint>& controls = {},
            const std::vector<Circulation>& circulations = {}, const PaintRules& paint = {});

// The lanes of one axis alone, from its start to its end; lines and surfaces only.
std::vector<Lane> axis_lanes(const Line& axis, double width, double width_end,
                             const AxisLanes& wanted, const LaneSettings& settings);

// The line at a signed offset (metres, left of the axis positive), changing linearly to
// `offset_end`, as a kerb runs: mitred in inner bends, round about outer ones, without the loops
// that a bend tighter than the offset would make.
Line offset_line(const Line& axis, double offset, double offset_end);

}  // namespace streetgen
