#include "streetgen/lane.hpp"

#include <algorithm>
#include <tuple>

#include "geometry/geos.hpp"
#include "geometry/offset.hpp"
#include "geometry/polyline.hpp"
#include "roadway/round_kink.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/progress.hpp"
#include "streetgen/surface.hpp"
#include "traffic/circulation.hpp"
#include "traffic/lane_layout.hpp"
#include "traffic/lane_taper.hpp"
#include "traffic/marking.hpp"

namespace streetgen {

namespace {

// Metres; where wanted limits nearly meet, lanes still have a direction.
constexpr double least_length = 0.01;

LaneStrip strip_of(const Streets& streets, int e) {
  const SectionLimit &start = streets.limits[2 * e], &end = streets.limits[2 * e + 1];
  const Roadway& roadway = streets.roadways[e];
  LaneStrip strip{distinct(planar(streets.network.edges[e].line)),
                  roadway.width / 2,
                  roadway.width_end / 2,
                  start.abscissa,
                  end.abscissa,
                  start.border_line,
                  end.border_line,
                  {},
                  roadway.roadway_offset};
  if (!limits_crossed(streets, e)) {
    strip.profile = roadway.profile;
    return strip;
  }
  const double total = length(strip.axis);
  std::tie(strip.from, strip.to) = std::minmax({start.wanted_abscissa, end.wanted_abscissa});
  if (strip.to - strip.from < least_length) {
    strip.from = std::max(0.0, (strip.from + strip.to - least_length) / 2);
    strip.to = std::min(total, strip.from + least_length);
  }
  strip.from_border = border_line(strip.axis, strip.from, 2 * strip.half_at(strip.from),
                                  strip.roadway_offset);
  strip.to_border = border_line(strip.axis, strip.to, 2 * strip.half_at(strip.to), strip.roadway_offset);
  return strip;
}

// A quadrilateral that turns left at each corner needs no proof of validity.
bool convex(const Ring& ring) {
  if (ring.size() != 5) return false;
  for (int i = 0; i < 4; ++i)
    if (cross(ring[i + 1] - ring[i], ring[(i + 2) % 4] - ring[i + 1]) <= 0) return false;
  return true;
}

// Between the lines along its two sides.
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
  const std::vector<double> half(middle.size(), width / 2);
  return variable_buffer(middle, half);
}

bool drives(const LaneWish& wish) {
  return wish.kind == LaneKind::general || wish.kind == LaneKind::bus;
}

struct LineBetween {
  SeparatorKind kind = SeparatorKind::edge;
  bool dashed = false;
};

// Into and out of a lane that both directions use one may cross the line, a centre line too.
LineBetween line_between(const std::vector<LaneWish>& wishes, int position) {
  if (position == 0 || position == static_cast<int>(wishes.size())) return {};
  const LaneWish &left = wishes[position - 1], &right = wishes[position];
  if (left.both_ways || right.both_ways) {
    const bool parts = left.both_ways != right.both_ways && drives(left) && drives(right);
    return {parts ? SeparatorKind::centre : SeparatorKind::same_direction, true};
  }
  if (left.along_axis == right.along_axis) return {SeparatorKind::same_direction, true};
  return {SeparatorKind::centre, std::count_if(wishes.begin(), wishes.end(), drives) <= 2};
}

// The lanes of one edge with the lines between them.
struct EdgeLanes {
  std::vector<Lane> lanes;
  std::vector<LaneSeparator> separators;
};

EdgeLanes lanes_of(Geos& geos, const LaneStrip& strip, const std::vector<LaneWish>& wishes,
                   const TaperedLanes& tapered, bool with_surface, const LaneSettings& settings) {
  const int count = static_cast<int>(wishes.size());
  const std::vector<double> own = lane_shares(wishes, strip.width(), settings.narrowest);
  const std::vector<LaneShares> shares = tapered_shares(strip, own, tapered);
  const auto offset_of = [&](const LaneShares& at) { return strip.offset_at(strip.from, at); };
  EdgeLanes out;
  std::vector<Line> borders;
  for (const LaneShares& border : shares) borders.push_back(line_at_shares(strip, border));
  for (Line* kerb : {&borders.front(), &borders.back()})
    *kerb =
        with_round_kinks(*kerb, settings.kerb_radius_minimal, {strip.from_border, strip.to_border});
  for (int p = 1; p <= count; ++p) {
    const LaneWish& wish = wishes[p - 1];
    LaneShares middle;
    for (std::size_t i = 0; i < shares[p].size(); ++i)
      middle.push_back((shares[p - 1][i] + shares[p][i]) / 2);
    Lane lane;
    lane.ordinality = ordinality_of(p, count, settings.order);
    lane.position = p;
    lane.side = side_of(p, count);
    lane.along_axis = wish.along_axis;
    lane.both_ways = wish.both_ways;
    lane.kind = wish.kind;
    lane.width = (own[p] - own[p - 1]) * strip.width();
    lane.axis_offset = offset_of(middle);
    lane.line = line_at_shares(strip, middle);
    lane.turns = wish.turns;
    if (with_surface)
      lane.surface = lane_surface(geos, borders[p - 1], borders[p], lane.line, lane.width);
    out.lanes.push_back(std::move(lane));
  }
  for (int p = 0; p <= count; ++p) {
    LaneSeparator separator;
    separator.position = p;
    const LineBetween between = line_between(wishes, p);
    separator.kind = between.kind;
    separator.dashed = between.dashed;
    if (separator.kind == SeparatorKind::edge && !settings.edge_lines) continue;
    separator.axis_offset = offset_of(shares[p]);
    separator.line = std::move(borders[p]);
    separator.painted = with_surface;
    out.separators.push_back(std::move(separator));
  }
  return out;
}

// The lane along a line by hand.
void draw(Lane& lane, const LaneStrip& strip, const Line& by_hand, bool with_surface) {
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

class Builder {
 public:
  Builder(const Streets& streets, std::vector<LanesOfAxis> axes,
          std::vector<LaneOverride> overrides, const LaneSettings& settings,
          const std::vector<ControlPoint>& controls, const std::vector<Circulation>& circulations)
      : streets_(streets),
        axes_(std::move(axes)),
        overrides_(std::move(overrides)),
        settings_(settings),
        controls_(end_controls(streets.network, axes_, controls, settings.control_distance)),
        circulations_(circulations) {
    std::sort(axes_.begin(), axes_.end(),
              [](const LanesOfAxis& a, const LanesOfAxis& b) { return a.axis_id < b.axis_id; });
    std::stable_sort(
        overrides_.begin(), overrides_.end(),
        [](const LaneOverride& a, const LaneOverride& b) { return a.axis_id < b.axis_id; });
  }

  Lanes run() {
    const std::vector<NodeRank> ranks = ranks_of(streets_);
    Lanes out;
    for (int e = 0; e < static_cast<int>(streets_.network.edges.size()); ++e) {
      if (!meets_affected(e)) continue;
      poll_cancel();
      tell_progress("lanes", e, streets_.network.edges.size());
      const LaneStrip strip = strip_of(streets_, e);
      const bool crossed = limits_crossed(streets_, e);
      std::vector<LaneWish> wishes = wishes_of(e);
      const std::vector<Decision> decisions = decide(e, wishes);
      const TaperedLanes tapered = tapered_lanes(strip.profile, wishes);
      EdgeLanes made = lanes_of(geos_, strip, wishes, tapered, !crossed, settings_);
      for (Lane& lane : made.lanes) {
        const Decision& decision = decisions[lane.position - 1];
        lane.edge = e;
        lane.method = decision.by_hand ? Method::by_hand
                      : crossed        ? Method::crossed_limits
                                       : Method::hypothesis;
        if (decision.line != nullptr) draw(lane, strip, *decision.line, !crossed);
      }
      for (LaneSeparator& separator : made.separators) separator.edge = e;
      if (!crossed) {
        append_end_markings(streets_, ranks, controls_, strip, made.lanes,
                            settings_.driving_side, out.markings);
        append_arrows(geos_, streets_.network.edges[e], made.lanes, out.markings);
      }
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

  std::vector<LaneWish> wishes_of(int e) const {
    const Edge& edge = streets_.network.edges[e];
    const auto found = std::lower_bound(
        axes_.begin(), axes_.end(), edge.axis_id,
        [](const LanesOfAxis& a, std::int64_t axis_id) { return a.axis_id < axis_id; });
    std::vector<LaneWish> wishes = found != axes_.end() && found->axis_id == edge.axis_id
                                       ? across(found->lanes, settings_.driving_side)
                                       : across({}, settings_.driving_side);
    if (const Circulation* circulation = circulations_.of(edge)) turn_round(*circulation, wishes);
    return wishes;
  }

  TaperedLanes tapered_lanes(const WidthProfile& profile,
                             const std::vector<LaneWish>& wishes) const {
    TaperedLanes tapered;
    const auto at_end = [&](bool at_start, const WidthProfile::Beyond& beyond) {
      if (beyond.edge < 0) return ChangingLanes{};
      std::vector<LaneWish> there = wishes_of(beyond.edge);
      decide(beyond.edge, there);
      return changing_lanes({wishes, at_start}, {there, beyond.at_start}, settings_.driving_side);
    };
    tapered.start = at_end(true, profile.beyond_start);
    tapered.end = at_end(false, profile.beyond_end);
    return tapered;
  }

  struct Decision {
    bool by_hand = false;
    const Line* line = nullptr;
  };

  // What overrides say of each lane; widths and directions go into its wish.
  std::vector<Decision> decide(int e, std::vector<LaneWish>& wishes) const {
    const Edge& edge = streets_.network.edges[e];
    const int count = static_cast<int>(wishes.size());
    std::vector<Decision> decisions(count);
    auto by_hand = std::lower_bound(
        overrides_.begin(), overrides_.end(), edge.axis_id,
        [](const LaneOverride& o, std::int64_t axis_id) { return o.axis_id < axis_id; });
    for (; by_hand != overrides_.end() && by_hand->axis_id == edge.axis_id; ++by_hand) {
      if (by_hand->abscissa < edge.start_abscissa || by_hand->abscissa >= edge.end_abscissa)
        continue;
      for (int p = 1; p <= count; ++p) {
        if (ordinality_of(p, count, settings_.order) != by_hand->ordinality) continue;
        LaneWish& wish = wishes[p - 1];
        if (by_hand->direction != LaneOverride::Direction::as_is) {
          wish.along_axis = by_hand->direction != LaneOverride::Direction::against;
          wish.both_ways = by_hand->direction == LaneOverride::Direction::both;
        }
        if (by_hand->width > 0) wish.width = by_hand->width;
        if (!by_hand->line.empty()) decisions[p - 1].line = &by_hand->line;
        decisions[p - 1].by_hand = true;
      }
    }
    return decisions;
  }

  const Streets& streets_;
  std::vector<LanesOfAxis> axes_;
  std::vector<LaneOverride> overrides_;
  const LaneSettings& settings_;
  std::vector<EndControl> controls_;  // by slot
  Circulations circulations_;
  Geos geos_;
};

}  // namespace

Lanes lanes(const Streets& streets, std::vector<LanesOfAxis> axes,
            std::vector<LaneOverride> overrides, const LaneSettings& settings,
            const std::vector<ControlPoint>& controls,
            const std::vector<Circulation>& circulations) {
  return Builder(streets, std::move(axes), std::move(overrides), settings, controls, circulations)
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
