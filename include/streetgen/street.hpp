// The input of streets, and their results: corners, section limits, sections and
// intersections.  StreetGen paper, sections 2.4 and 2.5; docs/concepts/geometry.md shows each step.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "streetgen/beside.hpp"
#include "streetgen/control_point.hpp"
#include "streetgen/geometry.hpp"
#include "streetgen/kerb.hpp"
#include "streetgen/method.hpp"
#include "streetgen/network.hpp"
#include "streetgen/ramp.hpp"
#include "streetgen/road.hpp"
#include "streetgen/width_profile.hpp"

namespace streetgen {

// The kerbs that change linearly where two axes of different width meet, seen along an axis;
// the other one steps at the node.
enum class TransitionKind { symmetric, left, right };

struct Transition {
  TransitionKind kind = TransitionKind::symmetric;
  std::optional<double> length{};  // metres; none: as the taper ratio has it
};

// Metres along the street for each metre that a kerb moves sideways, by speed, km/h.  An entry
// holds up to the next one, the first also before itself; without one, 10.  1:10 is common within
// towns, 1:20 to 1:40 outside.
using TaperRatio = std::map<double, double>;

struct StreetAxis {
  std::int64_t axis_id = 0;
  Line line;
  int level = 0;
  double width = 0;           // kerb to kerb at the start, metres
  double width_end = 0;       // kerb to kerb at the end; equal to width where it does not change
  double radius = 0;          // wanted corner radius, metres; 0: no arc
  int importance = 99;        // 1 is the highest
  double speed = 50;          // km/h
  double roadway_offset = 0;  // metres from the axis to the middle of the roadway, left positive
  bool leads_forward = true, leads_backward = true;  // whether traffic runs along it, against it
  bool on_ring = false;     // its source says that it is part of a roundabout
  std::int64_t street = 0;  // a number of its name, 0: none
  bool changed = true;      // false: as it was when the streets about it were computed
  bool outer = false;       // beyond reach of the change: the others are computed with it
  std::vector<ControlPoint> controls{};  // that stand on it: signals in mid-block cut it
  // The areas that were surveyed as roadway about it, whose parts may overlap: its surfaces end at
  // their border, as far as it lies within them.
  MultiPolygon area{};
  // Wanted at its ends instead of StreetSettings::transition.
  std::optional<Transition> transition_start{}, transition_end{};
};

// A corner takes one of the radii of its two axes, or their mean.  major is that of the more
// important axis, and of equally important ones that of the wider.
enum class RadiusRule { min, max, mean, major };
// An axis may be too short for the wanted radius: the first remedy, before the other one.
enum class ShortAxis { reduce, follow };

// The polyline of an edge becomes a line of straight pieces and arcs by these.
struct Smoothing {
  double shift = 0.5;       // metres by which the line may leave a point of the polyline, positive
  double tolerance = 0.01;  // metres by which chords may leave an arc, positive
};

// The model's settings that the geometry needs, each with the name of its setting.  Measures are
// finite and not negative, tolerance is positive.
struct StreetSettings {
  double tolerance = 0.5;  // metres
  Crossing crossing = Crossing::over;
  ControlRules controls{};
  std::optional<Smoothing> smoothing{};  // none: edges are polylines, but round roundabouts
  // Round a roundabout, where no smoothing is wanted, an edge is an arc of a circle if that leaves
  // none of its points by more.  0: nowhere.
  double ring_shift = 0;         // metres
  double max_arc_distance = 60;  // metres from the node to an arc's centre
  double radius_minimal = 0.15;  // metres, the kerb stone's radius
  double reach = 60;             // metres along the network: how far a corner follows its axes
  // The arc of a corner ends no farther from the crossing of its kerbs, and closes no more ground
  // from there on, and two arcs on one kerb share it; the paper has no such bounds: both may be
  // infinite.
  double corner_length = 15;  // metres along the kerbs
  double corner_area = 50;    // square metres
  // Both sections begin here where kerbs part farther away, and a line parts them up to there; the
  // paper has no such bound: it may be infinite.
  double limit_distance = 25;  // metres from the node
  // A corner between nearly parallel kerbs closes the ground from the crossing of the kerbs on.
  // Two bounds of that ground; the paper has none. The last value is the width of a median that
  // stays ground.
  double follow_length = 10;          // metres along the kerbs; may be infinite
  double follow_area = 20;            // square metres; may be infinite
  double median_width_minimal = 0.5;  // metres, positive
  // Ground between two carriageways of one street is a median up to this width, kerb to kerb.
  double median_width_maximal = 20;  // metres
  // The ground in a face between axes that is smaller than this stays ground where it has room for
  // a disc of 1 m: the face's corners are noses where their fillets would take that. The middle of
  // two dual carriageways that cross is roadway. 0: neither, as the paper has it.
  double island_area = 1000;         // square metres
  double island_area_minimal = 3.5;  // square metres; see least_island()
  double island_nose_radius = 0.75;  // metres
  // Kinks of kerbs become arcs of this radius, where no limit lies and no corner is wanted without
  // an arc.  0: none.
  double kerb_radius_minimal = 0.5;  // metres
  ShortAxis short_axis = ShortAxis::reduce;
  // Two axes of different width meet by it where neither wants its own; where both do, that of the
  // smaller axis_id holds.  It is seen along the axis that wants it, here along the smaller
  // axis_id.
  Transition transition;
  TaperRatio taper_ratio{{0, 10}, {70, 20}, {90, 30}, {110, 40}};
  RadiusRule radius_rule = RadiusRule::min;
  bool round_dead_ends = false;
  double max_hole_area = 0.5;  // square metres; least_island() counts where that is more
  // Ground no wider than this between two streets of one level that run beside each other is
  // roadway.  0: none.
  double slit_width = 0.2;  // metres
  // More surfaces that come into a square of 10 m of a fixed grid share the ground there by rank.
  int overlaps_maximal = 30;
  double kerb_stone_width = 0.3;  // metres, positive: the strip behind a kerb

  // Square metres: ground under this that roadway encloses is roadway.
  double least_island() const { return std::max(max_hole_area, island_area_minimal); }
};

// By hand: where the limit at one end of an edge lies, the edge of the axis that holds `abscissa`.
// It stays on its edge, 0.1 m and more from a node where other edges meet; on an edge that the snap
// made longer or shorter it lies in proportion.  A computed limit that it passes meets it there,
// two by hand that pass each other meet in between (crossed_limits).  One at a dead end, or on no
// edge, changes nothing.
struct SectionLimitOverride {
  std::int64_t axis_id = 0;
  double abscissa = 0;  // metres along the axis
  bool at_start = true;
};

// By hand: the radius wanted, metres, of the corner counter-clockwise from axis_a to axis_b at the
// node within three tolerances of `place`, the nearest that has one. Where axes that go on beyond
// the node make two such corners: the one on whose side of the node `place` lies, both where it
// lies on the node. 0: no arc. One that does not fit becomes the largest that does, its centre
// within max_arc_distance, or no arc. One without its corner changes nothing.
struct CornerOverride {
  Point place;
  std::int64_t axis_a = 0;
  std::int64_t axis_b = 0;
  double radius = 0;
};

// The later one of two overrides that name one thing holds.
struct StreetOverrides {
  std::vector<SectionLimitOverride> limits;
  std::vector<CornerOverride> corners;
  std::vector<RoadOverride> bends{};
};

// Counter-clockwise from edge a to edge b around the node.
struct Corner {
  int node = 0;
  int edge_a = 0;
  bool at_start_a = true;  // the end of edge a that touches the node
  int edge_b = 0;
  bool at_start_b = true;
  double radius_wanted = 0;
  double radius = 0;  // 0 without an arc
  std::optional<Point> centre;
  std::optional<Arc> arc;  // from the border of a to the border of b
  Method method = Method::hypothesis;
  bool covered = false;  // roadway lies behind the arc, which is no kerb; in the end there is none
};

struct SectionLimit {
  int edge = 0;
  bool at_start = true;
  double wanted_abscissa = 0;  // by the corners or by hand, metres along the edge
  double abscissa = 0;
  Point point;
  Line border_line;  // two points, from the left kerb to the right kerb of the edge's direction
  Method method = Method::hypothesis;
  double shared = 0;  // metres from here on that the section shares with a neighbour
  // Metres along the edge that the border line's left end lies beyond the abscissa, and its right
  // end before it.
  double askew = 0;
};

struct Section {
  int edge = 0;
  MultiPolygon surface;  // empty when the limits crossed
  Method method = Method::hypothesis;
  double contested_area = 0;  // square metres left to other surfaces
  // From node to node, abscissas along the edge, changes of width between limits included; corners
  // are left out. None where the roadway is as wide as the axis says.
  WidthProfile borders{};
};

struct Intersection {
  int node = 0;
  int level = 0;
  MultiPolygon surface;
  Method method = Method::hypothesis;
  double contested_area = 0;
};

// Values that an edge has from its axis.
struct Roadway {
  double width = 0;  // kerb to kerb at the start of the edge, metres
  double width_end = 0;
  int importance = 99;
  double roadway_offset = 0;  // metres from the line to the middle of the roadway, left positive
  WidthProfile profile{};     // where a change of width goes on within the section
  std::vector<MergingStretch> merging{};  // in the order of the edge; none where limits crossed
};

// A surface as it was before the change.  The comparison tells what else the change moves.
struct FormerSurface {
  MultiPolygon ground;
  bool contested = false;  // part of its ground belonged to another surface
  int level = 0;
};
struct FormerLimit {
  double wanted_abscissa = 0;  // metres along the edge
  double abscissa = 0;
  Line border_line;
};
struct FormerEdge {
  std::int64_t axis_id = 0;
  double start_abscissa = 0, end_abscissa = 0;  // metres along the axis
  Line line;
  FormerLimit start, end;
  FormerSurface section;
  WidthProfile borders{};  // of the section
  Beside beside_left = Beside::outer, beside_right = Beside::outer;
  std::vector<double> median_left{}, median_right{};  // stretches, as in BesideEdges::medians
};
struct FormerNode {
  Point point;
  FormerSurface intersection;
};
// A section or an intersection beyond reach: it stays as it is.
struct Neighbour {
  std::vector<Point> nodes;  // of the section's two ends, or that of the intersection
  MultiPolygon ground;
  int level = 0;
};
struct Former {
  std::vector<FormerEdge> edges;
  std::vector<FormerNode> nodes;  // with an intersection
  // For kerbs: all that may touch what comes out, also of axes that are not given.  None: unknown,
  // and claims tell.
  std::optional<std::vector<Neighbour>> neighbours{};
  // Whether what is computed counts where the change spreads beyond what is written; else it is
  // ChangeSpreads, as soon as that is known.
  bool may_spread = true;
};

// The edges of the network along which a change goes on, by 2 * edge for traffic along the axis, by
// 2 * edge + 1 against it.
struct Leads {
  // Whether what changes where traffic comes onto the edge may change the node that it comes to.
  std::vector<bool> on;
  // Whether what meets the node that traffic comes to may change the one that it leaves, where less
  // than so much lies between the limits, metres.
  std::vector<bool> back;
  double back_within = 0;
};
using LeadsOn = std::function<Leads(const Network& network, const std::vector<Roadway>& roadways)>;

// A run for these axes is due at the same time.
class ChangeSpreads : public std::exception {
 public:
  explicit ChangeSpreads(std::vector<std::int64_t> axes) : axes_(std::move(axes)) {}
  const char* what() const noexcept override { return "the change spreads along other axes"; }
  const std::vector<std::int64_t>& axes() const noexcept { return axes_; }

 private:
  std::vector<std::int64_t> axes_;
};

struct Streets {
  Network network;
  std::vector<Roadway> roadways;  // one per edge
  std::vector<Ramp> ramps;        // by node
  std::vector<Corner> corners;
  std::vector<SectionLimit> limits;  // two per edge: 2 * edge, 2 * edge + 1
  BesideEdges beside;                // what lies beside edges; unknown beyond reach of the change
  // All that changed axes can change, and only for that sections and intersections come out: their
  // edges and nodes, edges that they cut otherwise and where these meet others, corners that follow
  // an axis to there, limits that move, and claims on the same ground whose surface is not what it
  // was.  Where all axes changed, everything.
  std::vector<bool> affected_edges, affected_nodes;
  // Edges of axes that did not change along which the change leaves what is written: they move
  // where axes beyond reach meet them, look at them or claim the same ground.  A run for their axes
  // is due.
  std::vector<bool> spreads_to;
  std::vector<Section> sections;            // one per affected edge
  std::vector<Intersection> intersections;  // one per affected node of degree two and more
  // The kerbs of all whose border a change can move: those that are affected, and
  // those beside ground that changed.  Empty where kerbs are not wanted.
  std::vector<Kerb> kerbs;
  std::vector<bool> edges_with_kerbs, nodes_with_kerbs;  // those whose kerbs come out, if wanted
};

// Whether the two limits of the edge meet: it has no section.
bool limits_crossed(const Streets& streets, int edge);

}  // namespace streetgen
