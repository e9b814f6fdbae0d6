#include "streetgen/lane.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/geos.hpp"
#include "geometry/offset.hpp"
#include "geometry/polyline.hpp"
#include "lane/carried_marks.hpp"
#include "lane/lane_change.hpp"
#include "lane/lane_extent.hpp"
#include "lane/lane_layout.hpp"
#include "lane/lane_taper.hpp"
#include "lane/lane_wishes.hpp"
#include "lane/marking.hpp"
#include "roadway/round_kink.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/progress.hpp"
#include "streetgen/surface.hpp"

namespace streetgen {

namespace {

LaneStrip strip_of(const Streets& streets, int e) {
  const SectionLimit &start = streets.limits[2 * e], &end = streets.limits[2 * e + 1];
  const LaneExtent reach = lane_extent(streets, e);
  const Roadway& roadway = streets.roadways[e];
  LaneStrip strip{distinct(planar(streets.network.edges[e].line)),
                  roadway.width / 2,
                  roadway.width_end / 2,
                  reach.from,
                  reach.to,
                  start.border_line,
                  end.border_line,
                  {},
                  roadway.roadway_offset};
  if (!limits_crossed(streets, e)) {
    strip.profile = roadway.profile;
    strip.merging = roadway.merging;
    return strip;
  }
  const auto across = [&](double abscissa) {
    const auto end = [&](int i, double at) {
      return border_line(strip.axis, at, 2 * strip.half_at(at), strip.roadway_offset)[i];
    };
    return Line{end(0, abscissa + start.askew), end(1, abscissa - start.askew)};
  };
  strip.from_border = across(strip.from);
  strip.to_border = across(strip.to);
  return strip;
}

constexpr double no_loop = 1e-3;  // of a ring's area, by which its ground may differ

// A quadrilateral that turns left at each corner needs no proof of validity.
bool convex(const Ring& ring) {
  if (ring.size() != 5) return false;
  for (int i = 0; i < 4; ++i)
    if (cross(ring[i + 1] - ring[i], ring[(i + 2) % 4] - ring[i + 1]) <= 0) return false;
  return true;
}

// Between the lines along its two sides.  Where a lane begins without width they touch: that ring
// is no surface, but its ground is, if there is no loop in it.
MultiPolygon lane_surface(Geos& geos, const Line& left, const Line& right, const Line& middle,
                          double width) {
  Ring ring;
  ring.reserve(left.size() + right.size() + 1);
  ring = right;
  ring.insert(ring.end(), left.rbegin(), left.rend());
  ring.push_back(ring.front());
  MultiPolygon surface(1);
  surface.front().push_back(std::move(ring));
  if (convex(surface.front().front()) || geos.valid(surface)) return surface;
  const double of_ring = signed_area(surface.front().front());
  MultiPolygon ground = geos.polygons(geos.unite({surface}).get());
  if (of_ring > 0 && std::abs(area(ground) - of_ring) < no_loop * of_ring) return ground;
  const std::vector<double> half(middle.size(), width / 2);
  return variable_buffer(middle, half);
}

// The lanes of one edge with the lines between them.
struct LanesOfEdge {
  std::vector<Lane> lanes;
  std::vector<LaneSeparator> separators;
};

// A lane in its place across the roadway; a merging lane with its stretch.
struct PlacedLane {
  LaneWish wish;
  int ordinality = 0;
  LaneSide side = LaneSide::centre;
  const MergingStretch* stretch = nullptr;
};

LaneWish merging_wish(const MergingStretch& stretch) {
  const bool right = (stretch.side < 0) == stretch.along_axis;
  LaneWish wish{LaneKind::merging, stretch.along_axis, false, stretch.width / stretch.lanes};
  if (stretch.leaves)
    wish.turns = right ? turn::slight_right : turn::slight_left;
  else
    wish.turns = right ? turn::merge_left : turn::merge_right;
  return wish;
}

// From the left kerb to the right one, merging lanes outside.
std::vector<PlacedLane> placed_lanes(const LaneStrip& strip, const std::vector<LaneWish>& wishes,
                                     LaneOrder order) {
  const int count = static_cast<int>(wishes.size());
  std::vector<PlacedLane> placed;
  int last = count;
  const auto add_merging = [&](int side) {
    for (const MergingStretch& stretch : strip.merging)
      for (int i = 0; stretch.side == side && i < stretch.lanes; ++i)
        placed.push_back(
            {merging_wish(stretch), ++last, side > 0 ? LaneSide::left : LaneSide::right, &stretch});
  };
  add_merging(+1);
  for (int p = 1; p <= count; ++p)
    placed.push_back({wishes[p - 1], ordinality_of(p, count, order), side_of(p, count)});
  add_merging(-1);
  return placed;
}

// The part of a strip on which a merging lane lies.
LaneStrip part_of(const LaneStrip& strip, const MergingStretch& stretch) {
  LaneStrip part = strip;
  const auto across = [&](double abscissa) {
    const WidthProfile::Place place = strip.profile.at(abscissa);
    return border_line(strip.axis, abscissa, place.left + place.right,
                       (place.left - place.right) / 2);
  };
  if (!stretch.begins_at_limit()) {
    part.from = stretch.from;
    part.from_border = across(part.from);
  }
  if (!stretch.ends_at_limit()) {
    part.to = stretch.to;
    part.to_border = across(part.to);
  }
  return part;
}

// Of a lane between two lines; none where it keeps its place and its width.
WidthProfile borders_between(const LaneStrip& strip, const LaneShares& left,
                             const LaneShares& right) {
  WidthProfile borders;
  if (strip.profile.empty() && strip.half_start == strip.half_end) return borders;
  const auto add = [&](double abscissa) {
    borders.places.push_back(
        {abscissa, strip.offset_at(abscissa, left), -strip.offset_at(abscissa, right)});
  };
  add(strip.from);
  for (const WidthProfile::Place& place : strip.profile.places)
    if (place.abscissa > strip.from && place.abscissa < strip.to) add(place.abscissa);
  add(strip.to);
  return borders;
}

struct LineBetween {
  SeparatorKind kind = SeparatorKind::edge;
  bool dashed = false;
};

// Into and out of a lane that both directions use one may cross the line, a centre line too.
LineBetween line_between(const std::vector<PlacedLane>& lanes, int position) {
  if (position == 0 || position == static_cast<int>(lanes.size())) return {};
  const LaneWish &left = lanes[position - 1].wish, &right = lanes[position].wish;
  if (left.both_ways || right.both_ways) {
    const bool parts = left.both_ways != right.both_ways && drives(left.kind) && drives(right.kind);
    return {parts ? SeparatorKind::centre : SeparatorKind::same_direction, true};
  }
  if (left.along_axis == right.along_axis) return {SeparatorKind::same_direction, true};
  const auto driven = std::count_if(lanes.begin(), lanes.end(),
                                    [](const PlacedLane& lane) { return drives(lane.wish.kind); });
  return {SeparatorKind::centre, driven <= 2};
}

// One direction may drive on a lane of its own.
bool has_own_lane(const std::vector<LaneWish>& wishes, bool along_axis) {
  return std::any_of(wishes.begin(), wishes.end(), [&](const LaneWish& wish) {
    return drives(wish.kind) && !wish.both_ways && wish.along_axis == along_axis;
  });
}

LanesOfEdge lanes_of(Geos& geos, const LaneStrip& strip, const std::vector<LaneWish>& wishes,
                     const TaperedLanes& tapered, bool with_surface, const LaneSettings& settings) {
  const std::vector<PlacedLane> placed = placed_lanes(strip, wishes, settings.order);
  const int count = static_cast<int>(placed.size());
  const std::vector<double> own = lane_shares(wishes, strip.width(), settings.narrowest);
  const std::vector<LaneShares> shares = tapered_shares(strip, own, tapered);
  const auto strip_at = [&](int p) {
    return placed[p - 1].stretch ? part_of(strip, *placed[p - 1].stretch) : strip;
  };
  const bool parted = has_own_lane(wishes, true) && has_own_lane(wishes, false);
  LanesOfEdge out;
  std::vector<Line> borders;
  for (const LaneShares& border : shares) borders.push_back(line_at_shares(strip, border));
  for (const std::size_t outer : {std::size_t{0}, borders.size() - 1})
    if (is_kerb(shares[outer]))
      borders[outer] = with_round_kinks(borders[outer], settings.kerb_radius_minimal,
                                        {strip.from_border, strip.to_border});
  for (int p = 1, ordinary = 0; p <= count; ++p) {
    const auto& [wish, ordinality, side, stretch] = placed[p - 1];
    LaneShares middle;
    for (std::size_t i = 0; i < shares[p].size(); ++i)
      middle.push_back((shares[p - 1][i] + shares[p][i]) / 2);
    Lane lane;
    lane.ordinality = ordinality;
    lane.position = p;
    lane.side = side;
    lane.along_axis = wish.along_axis;
    lane.both_ways = wish.both_ways;
    lane.middle = wish.both_ways && drives(wish.kind) && parted;
    lane.kind = wish.kind;
    lane.turns = wish.turns;
    if (stretch == nullptr) {
      lane.width = (own[ordinary + 1] - own[ordinary]) * strip.width();
      ++ordinary;
      lane.axis_offset = strip.offset_at(strip.from, middle);
      lane.line = line_at_shares(strip, middle);
      lane.borders = borders_between(strip, shares[p - 1], shares[p]);
      if (with_surface)
        lane.surface = lane_surface(geos, borders[p - 1], borders[p], lane.line, lane.width);
    } else {
      const LaneStrip part = strip_at(p);
      const double widest = (stretch->full_from + stretch->full_to) / 2;
      lane.width = wish.width;
      lane.axis_offset = strip.offset_at(std::clamp(widest, part.from, part.to), middle);
      lane.line = line_at_shares(part, middle);
      lane.borders = borders_between(part, shares[p - 1], shares[p]);
      if (!stretch->begins_at_limit()) lane.start = stretch->from;
      if (!stretch->ends_at_limit()) lane.end = stretch->to;
      if (with_surface)
        lane.surface = lane_surface(geos, line_at_shares(part, shares[p - 1]),
                                    line_at_shares(part, shares[p]), lane.line, lane.width);
    }
    out.lanes.push_back(std::move(lane));
  }
  for (int p = 0; p <= count; ++p) {
    LaneSeparator separator;
    separator.position = p;
    const LineBetween between = line_between(placed, p);
    separator.kind = between.kind;
    separator.dashed = between.dashed;
    if (separator.kind == SeparatorKind::edge && !settings.edge_lines) continue;
    separator.axis_offset = strip.offset_at(strip.from, shares[p]);
    separator.line = std::move(borders[p]);
    separator.painted = with_surface;
    // Beside a merging lane as far as the outer one of both goes.
    if (p > 0 && p < count)
      for (const int outer : {p, p + 1})
        if (placed[outer - 1].stretch && (outer == p) == (placed[outer - 1].stretch->side > 0))
          separator.line = line_at_shares(strip_at(outer), shares[p]);
    out.separators.push_back(std::move(separator));
  }
  return out;
}

// The lane along a line by hand.
void draw(Lane& lane, const LaneStrip& strip, const Line& by_hand, bool with_surface) {
  if (lane.borders.empty())
    for (const double abscissa : {strip.from, strip.to})
      lane.borders.places.push_back(
          {abscissa, lane.width / 2 + lane.axis_offset, lane.width / 2 - lane.axis_offset});
  lane.line = distinct(planar(by_hand));
  if (nearest_abscissa(lane.line.front(), strip.axis) >
      nearest_abscissa(lane.line.back(), strip.axis))
    lane.line = reversed(std::move(lane.line));
  const Point &left = strip.from_border[0], &right = strip.from_border[1];
  lane.axis_offset =
      dot(lane.line.front() - (left + right) * 0.5, unit(left - right)) + strip.roadway_offset;
  if (with_surface)
    lane.surface =
        variable_buffer(lane.line, std::vector<double>(lane.line.size(), lane.width / 2));
}

// Without paint; where traffic waits is known all the same.
void leave_bare(int edge, std::vector<LaneSeparator>& separators, std::vector<Marking>& markings) {
  for (LaneSeparator& separator : separators) separator.painted = false;
  for (auto line = markings.rbegin(); line != markings.rend() && line->edge == edge; ++line)
    line->surface.clear();
}

class LaneBuilder {
 public:
  LaneBuilder(const Streets& streets, const std::vector<LanesOfAxis>& axes,
              std::vector<LaneOverride> overrides, const LaneSettings& settings,
              const std::vector<ControlPoint>& controls,
              const std::vector<Circulation>& circulations, const PaintRules& paint)
      : streets_(streets),
        settings_(settings),
        changes_(paint.changes, paint.leaving),
        bare_(paint.bare.begin(), paint.bare.end()),
        wishes_(axes, std::move(overrides), circulations, settings),
        carried_(streets.network, streets.roadways, wishes_, settings),
        controls_(end_controls(streets.network, control_edges(),
                               with_ring_entries(streets.network, axes, controls),
                               settings.controls, paint.junctions)
                      .ends) {}

  Lanes run() {
    const WaitingPlaces waiting(streets_, wishes_, settings_.line_before_kerb);
    const SlipLaneEnds slip_lanes(streets_, wishes_);
    const std::vector<NodeRank> ranks = ranks_of(streets_, ends_that_go_first(slip_lanes));
    Lanes out;
    for (int e = 0; e < static_cast<int>(streets_.network.edges.size()); ++e) {
      if (!meets_affected(e)) continue;
      poll_cancel();
      tell_progress("lanes", e, streets_.network.edges.size());
      const LaneStrip strip = strip_of(streets_, e);
      const bool crossed = limits_crossed(streets_, e);
      auto [wishes, decisions] = wishes_.of(streets_.network.edges[e]);
      carried_.carry(e, wishes);
      const TaperedLanes tapered = tapered_lanes(strip.profile, wishes);
      LanesOfEdge made = lanes_of(geos_, strip, wishes, tapered, !crossed, settings_);
      std::size_t ordinary = 0;
      for (Lane& lane : made.lanes) {
        const bool merging = lane.kind == LaneKind::merging;
        const auto decision = merging ? LaneWishes::Decision{} : decisions[ordinary++];
        lane.edge = e;
        lane.method = decision.by_hand ? Method::by_hand
                      : crossed        ? Method::crossed_limits
                                       : Method::hypothesis;
        if (decision.line != nullptr) draw(lane, strip, *decision.line, !crossed);
      }
      for (LaneSeparator& separator : made.separators) separator.edge = e;
      changes_.settle(streets_.network.edges[e], made.lanes, made.separators);
      append_end_markings(streets_, ranks, controls_, waiting, slip_lanes, strip, crossed,
                          made.lanes, settings_.driving_side, out.markings);
      if (bare_.count(streets_.network.edges[e].axis_id) > 0)
        leave_bare(e, made.separators, out.markings);
      else if (!crossed)
        append_arrows(arrow_paint_, streets_, ranks, controls_, made.lanes, out.markings);
      std::move(made.lanes.begin(), made.lanes.end(), std::back_inserter(out.lanes));
      std::move(made.separators.begin(), made.separators.end(), std::back_inserter(out.separators));
    }
    return out;
  }

 private:
  bool meets_affected(int e) const {
    const Edge& edge = streets_.network.edges[e];
    return streets_.affected_nodes[edge.from_node] || streets_.affected_nodes[edge.to_node];
  }

  std::vector<ControlEdge> control_edges() const {
    std::vector<ControlEdge> edges;
    for (int e = 0; e < static_cast<int>(streets_.network.edges.size()); ++e) {
      const Edge& edge = streets_.network.edges[e];
      const Roadway& roadway = streets_.roadways[e];
      EdgeWays ways{false, false, wishes_.on_ring(edge)};
      for (const LaneWish& lane : wishes_.of(edge).lanes) {
        if (!carries_traffic(lane.kind)) continue;
        ways.along = ways.along || lane.both_ways || lane.along_axis;
        ways.against = ways.against || lane.both_ways || !lane.along_axis;
      }
      edges.push_back(
          control_edge(ways, roadway.importance, roadway.width, roadway.width_end, edge.line));
    }
    return edges;
  }

  // Those by which traffic comes to its node, and is not that of a slip lane, which waits anyway.
  std::vector<bool> ends_that_go_first(const SlipLaneEnds& slip_lanes) const {
    std::vector<bool> first;
    const std::vector<Edge>& edges = streets_.network.edges;
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
      const std::vector<LaneWish> lanes = wishes_.of(edges[e]).lanes;
      for (const bool at_start : {true, false}) {
        const bool comes = std::any_of(lanes.begin(), lanes.end(), [&](const LaneWish& lane) {
          return carries_traffic(lane.kind) && (lane.both_ways || lane.along_axis != at_start);
        });
        first.push_back(comes && !slip_lanes.waits(e, at_start));
      }
    }
    return first;
  }

  TaperedLanes tapered_lanes(const WidthProfile& profile,
                             const std::vector<LaneWish>& wishes) const {
    TaperedLanes tapered;
    const auto at_end = [&](bool at_start, const WidthProfile::Beyond& beyond) {
      if (beyond.edge < 0) return ChangingLanes{};
      std::vector<LaneWish> there = wishes_.of(streets_.network.edges[beyond.edge]).lanes;
      carried_.carry(beyond.edge, there);
      return changing_lanes({wishes, at_start}, {there, beyond.at_start}, settings_.driving_side);
    };
    tapered.start = at_end(true, profile.beyond_start);
    tapered.end = at_end(false, profile.beyond_end);
    return tapered;
  }

  const Streets& streets_;
  const LaneSettings& settings_;
  LaneChanges changes_;
  std::set<std::int64_t> bare_;  // axes
  LaneWishes wishes_;
  CarriedMarks carried_;
  std::vector<EndControl> controls_;  // by slot
  Geos geos_;
  ArrowPaint arrow_paint_;
};

}  // namespace

Lanes lanes(const Streets& streets, const std::vector<LanesOfAxis>& axes,
            std::vector<LaneOverride> overrides, const LaneSettings& settings,
            const std::vector<ControlPoint>& controls, const std::vector<Circulation>& circulations,
            const PaintRules& paint) {
  return LaneBuilder(streets, axes, std::move(overrides), settings, controls, circulations, paint)
      .run();
}

std::vector<Lane> axis_lanes(const Line& axis, double width, double width_end,
                             const AxisLanes& wanted, const LaneSettings& settings) {
  Geos geos;
  LaneStrip strip{distinct(planar(axis)), width / 2, width_end / 2, 0, 0, {}, {}};
  strip.to = length(strip.axis);
  strip.from_border = border_line(strip.axis, strip.from, width);
  strip.to_border = border_line(strip.axis, strip.to, width_end);
  return lanes_of(geos, strip, across(wanted, settings.driving_side), {}, true, settings).lanes;
}

Line offset_line(const Line& axis, double offset, double offset_end) {
  const Line line = distinct(planar(axis));
  return offset_line(line, 0, length(line), offset, offset_end);
}

}  // namespace streetgen
