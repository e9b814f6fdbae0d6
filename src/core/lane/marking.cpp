#include "lane/marking.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/closed_ring.hpp"
#include "geometry/offset.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/surface.hpp"

namespace streetgen {

namespace {

// Metres.
constexpr double stripe = 0.1, dash = 1.5, gap = 5;
constexpr double longest_dashed = 1e5;             // beyond it dashes would be without number
constexpr double yield_dash = 0.5, stop_room = 1;  // of a section, for the line
constexpr double arrow_before_end = 5;             // a crossing before the line has its room
constexpr double shortest_band = 1e-9;
constexpr double before_mid_block = 3;  // from signals in mid-block: half a crossing, and room
constexpr double least_paint = 0.5;     // lanes narrower than this bear none

bool painted(const Lane& lane) { return carries_traffic(lane.kind) && lane.width >= least_paint; }

// Gives the pieces of a line between abscissas that grow, in one walk.
template <class Use>
void cut(const Line& line, const std::vector<std::pair<double, double>>& spans, Use use) {
  std::size_t segment = 1;
  double before = 0, size = distance(line[0], line[1]);
  Line piece;
  const auto advance_to = [&](double abscissa) {
    while (segment + 1 < line.size() && before + size < abscissa) {
      if (!piece.empty()) piece.push_back(line[segment]);
      before += size;
      ++segment;
      size = distance(line[segment - 1], line[segment]);
    }
    const double t = size > 0 ? std::clamp((abscissa - before) / size, 0.0, 1.0) : 0;
    piece.push_back(line[segment - 1] + (line[segment] - line[segment - 1]) * t);
  };
  for (const auto& [from, to] : spans) {
    piece.clear();
    advance_to(from);
    advance_to(to);
    use(piece);
  }
}

Ring quad(const Point& from, const Point& to, const Point& across) {
  return {from - across, to - across, to + across, from + across, from - across};
}

void append_band(const Line& line, double half, MultiPolygon& out) {
  // Most dashes are straight.
  if (line.size() == 2) {
    const Point along = line[1] - line[0];
    if (norm(along) > shortest_band)
      out.emplace_back().push_back(quad(line[0], line[1], left_normal(unit(along)) * half));
    return;
  }
  const Line middle = distinct(line);
  if (middle.size() < 2) return;
  const double total = length(middle);
  const KerbLine right = kerb_line(middle, 0, total, half, half, -1);
  const KerbLine left = kerb_line(middle, total, 0, half, half, +1);
  Ring ring = right.line;
  ring.insert(ring.end(), left.line.begin(), left.line.end());
  ring = closed(std::move(ring));
  if (ring.empty()) return;
  if (middle.size() == 2 || (right.whole && left.whole && Geos().valid(MultiPolygon{{ring}}))) {
    out.emplace_back().push_back(std::move(ring));
    return;
  }
  const MultiPolygon built = variable_buffer(middle, std::vector<double>(middle.size(), half));
  out.insert(out.end(), built.begin(), built.end());
}

// As many dashes as fit, as far from one end as from the other.
std::vector<std::pair<double, double>> dashes(double total, double on, double off) {
  const int count = std::max(1, static_cast<int>((total + off) / (on + off)));
  const double start = std::max(0.0, (total - count * (on + off) + off) / 2);
  std::vector<std::pair<double, double>> spans;
  spans.reserve(count);
  for (int i = 0; i < count; ++i)
    spans.emplace_back(start + i * (on + off), std::min(total, start + i * (on + off) + on));
  return spans;
}

void append_stripe(const Line& line, bool dashed, MultiPolygon& out) {
  const double total = length(line);
  if (!dashed || total > longest_dashed) {
    append_band(line, stripe / 2, out);
    return;
  }
  const auto spans = dashes(total, dash, gap);
  out.reserve(out.size() + spans.size());
  cut(line, spans, [&](const Line& piece) { append_band(piece, stripe / 2, out); });
}

// Whether all of the line goes within a sixth of a turn of one direction, so that it gets on by
// half of its length at least and never comes back.
bool goes_on(const Line& line) {
  double turned = 0, least = 0, most = 0;
  Point before;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point along = line[i] - line[i - 1];
    if (norm(along) == 0) continue;
    turned += norm(before) == 0 ? 0 : std::atan2(cross(before, along), dot(before, along));
    least = std::min(least, turned);
    most = std::max(most, turned);
    before = along;
  }
  return most - least < 2 * M_PI / 3 - same_angle;
}

// The line across the lanes that come by an end: `lower` is its importance less than that of the
// most important edge at the node.
std::optional<MarkingKind> end_marking(const EndControl& control, const NodeRank& rank, int lower,
                                       bool goes_first, bool slips_in, bool at_ring) {
  const std::optional<JunctionKind> by_hand = control.decided;
  if (by_hand == JunctionKind::right_before_left) return std::nullopt;
  if (control.own == ControlKind::stop) return MarkingKind::stop;
  const bool at_yield =
      control.own == ControlKind::yield || control.own == ControlKind::mini_roundabout;
  // Signals at a ring say when traffic enters.
  if (at_yield && !(at_ring && control.at_signals())) return MarkingKind::yield;
  if (control.at_signals()) return control.within ? std::nullopt : std::optional(MarkingKind::stop);
  if (goes_first) return std::nullopt;
  if (by_hand == JunctionKind::stop) {
    const bool all = rank.lowest == rank.importance && control.at_node != ControlKind::stop;
    return all || lower > 0 ? std::optional(MarkingKind::stop) : std::nullopt;
  }
  if (lower > 1 && by_hand != JunctionKind::priority) return MarkingKind::stop;
  return lower > 0 || control.waits || slips_in ? std::optional(MarkingKind::yield) : std::nullopt;
}

// Across a lane where it ends, or so many metres before that.
WaitingPlaces::Place before_end(const LaneStrip& strip, const Lane& lane, bool at_start,
                                double before) {
  const double total = length(lane.line);
  const Line end = at_start
                       ? substring(lane.line, before, before + stop_line_width)
                       : substring(lane.line, total - before, total - before - stop_line_width);
  const Line& border = at_start ? strip.from_border : strip.to_border;
  const Point middle = end.front() + (end.back() - end.front()) * 0.5;
  if (before == 0) return {middle, unit(border[1] - border[0])};
  const Point away = left_normal(unit(end.back() - end.front()));
  return {middle, at_start ? away * -1 : away};
}

// The metres along the way of a lane to its line; where the way ends if it lies beyond that.
std::optional<double> waits_at(const std::vector<Marking>& lines, const Lane& lane,
                               const Line& way) {
  for (auto line = lines.rbegin(); line != lines.rend() && line->edge == lane.edge; ++line)
    if (line->position == lane.position && line->along_axis == lane.along_axis &&
        line->kind != MarkingKind::arrow)
      return nearest_abscissa((line->line.front() + line->line.back()) * 0.5, way);
  return std::nullopt;
}

}  // namespace

std::vector<NodeRank> ranks_of(const Streets& streets, const std::vector<bool>& comes) {
  std::vector<NodeRank> ranks(streets.network.nodes.size());
  for (std::size_t e = 0; e < streets.network.edges.size(); ++e)
    for (const bool at_start : {true, false}) {
      const Edge& edge = streets.network.edges[e];
      NodeRank& rank = ranks[at_start ? edge.from_node : edge.to_node];
      ++rank.degree;
      if (!comes[2 * e + (at_start ? 0 : 1)]) continue;
      rank.importance = std::min(rank.importance, streets.roadways[e].importance);
      rank.lowest = std::max(rank.lowest, streets.roadways[e].importance);
    }
  for (const Ramp& ramp : streets.ramps)
    if (ramp.on &&
        ramp.merging + std::max(0, ramp.lanes_after - ramp.lanes_before) >= ramp.lanes_ramp)
      ranks[ramp.node].merging_link = ramp.link;
  return ranks;
}

MultiPolygon paint_of(const LaneSeparator& separator) {
  if (!separator.painted) return {};
  MultiPolygon surface;
  if (separator.leftwards == separator.rightwards) {
    append_stripe(separator.line, separator.dashed, surface);
  } else {
    for (const int side : {+1, -1}) {
      const Line beside = offset_line(separator.line, side * stripe, side * stripe);
      if (beside.size() > 1)
        append_stripe(beside, side > 0 ? separator.rightwards : separator.leftwards, surface);
    }
  }
  if (goes_on(separator.line)) return surface;
  // Dashes of a line that comes back may lie on each other.
  Geos geos;
  return geos.valid(surface) ? surface : geos.polygons(geos.unite({surface}).get());
}

void append_end_markings(const Streets& streets, const std::vector<NodeRank>& ranks,
                         const std::vector<EndControl>& controls, const WaitingPlaces& waiting,
                         const SlipLaneEnds& slip_lanes, const LaneStrip& strip,
                         bool limits_crossed, const std::vector<Lane>& lanes,
                         DrivingSide driving_side, std::vector<Marking>& out) {
  if (lanes.empty()) return;
  const int e = lanes.front().edge;
  const Edge& edge = streets.network.edges[e];
  const double room = limits_crossed ? 0 : strip.to - strip.from;
  for (const bool at_start : {true, false}) {
    const int node = at_start ? edge.from_node : edge.to_node;
    const EndControl& control = controls[2 * e + (at_start ? 0 : 1)];
    if (ranks[node].degree < 3 && !control.at_signals()) continue;
    const bool at_ring = waiting.enters_ring(e, at_start);
    const std::optional<MarkingKind> kind =
        end_marking(control, ranks[node], streets.roadways[e].importance - ranks[node].importance,
                    waiting.on_ring(e) || ranks[node].merging_link == e,
                    slip_lanes.waits(e, at_start), at_ring);
    if (!kind) continue;
    const bool has_room = room >= (at_ring ? 1 : 2) * stop_room;
    const double shared = ranks[node].degree < 3
                              ? before_mid_block
                              : streets.limits[2 * e + (at_start ? 0 : 1)].shared;
    for (const Lane& lane : lanes) {
      const bool comes = lane.both_ways || lane.along_axis != at_start;
      if (!comes || !lane.reaches(at_start) || !painted(lane)) continue;
      std::optional<WaitingPlaces::Place> place;
      if (at_ring || has_room)
        place = waiting.before_roadway(strip, lane, at_start, limits_crossed);
      if (!place && has_room)
        place = before_end(strip, lane, at_start,
                           std::min(shared, std::max(0.0, length(lane.line) - 2 * stop_room)));
      if (!place) continue;
      const Point across = place->rightwards * (lane.width / 2), middle = place->middle;
      // Against the axis one drives on its other side.
      const bool right_half = at_start != (driving_side == DrivingSide::right);
      const double width = lane.both_ways ? lane.width / 2 : lane.width;
      Marking marking;
      marking.kind = *kind;
      marking.edge = lane.edge;
      marking.position = lane.position;
      marking.along_axis = !at_start;
      marking.node = node;
      marking.line = {lane.both_ways && right_half ? middle : middle - across,
                      lane.both_ways && !right_half ? middle : middle + across};
      const auto spans = *kind == MarkingKind::stop
                             ? std::vector<std::pair<double, double>>{{0, width}}
                             : dashes(width, yield_dash, yield_dash);
      for (const auto& [from, to] : spans) {
        const Line piece = substring(marking.line, from, to);
        marking.surface.push_back(
            {quad(piece.front(), piece.back(), left_normal(unit(across)) * (stop_line_width / 2))});
      }
      out.push_back(std::move(marking));
    }
  }
}

void append_arrows(ArrowPaint& paint, const Streets& streets, const std::vector<NodeRank>& ranks,
                   const std::vector<EndControl>& controls, const std::vector<Lane>& lanes,
                   std::vector<Marking>& out) {
  for (const Lane& lane : lanes) {
    if (lane.both_ways || !lane.reaches(!lane.along_axis) || !painted(lane)) continue;
    const int slot = 2 * lane.edge + (lane.along_axis ? 1 : 0);
    const double reach = ArrowPaint::length_on(lane);
    const Line way = lane.along_axis ? lane.line : reversed(lane.line);
    const Edge& edge = streets.network.edges[lane.edge];
    const int node = lane.along_axis ? edge.to_node : edge.from_node;
    if (lane.turns == 0 && (ranks[node].degree < 3 || !controls[slot].at_signals())) continue;
    const double total =
        waits_at(out, lane, way).value_or(length(way) - streets.limits[slot].shared);
    if (total < reach) continue;
    const double tip =
        total > 2 * (reach + arrow_before_end) ? total - arrow_before_end : (total + reach) / 2;
    Marking marking;
    marking.kind = MarkingKind::arrow;
    marking.edge = lane.edge;
    marking.position = lane.position;
    marking.along_axis = lane.along_axis;
    marking.node = node;
    const Point foot = position_at(way, tip - reach).point, head = position_at(way, tip).point;
    if (distance(foot, head) < 0.9 * reach) continue;
    marking.line = {foot, head};
    marking.surface = paint.on(lane, lane.turns, marking.line);
    out.push_back(std::move(marking));
  }
}

}  // namespace streetgen
