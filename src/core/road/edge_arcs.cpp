#include "road/edge_arcs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "road/fit_radii.hpp"

namespace streetgen {

namespace {

constexpr double sharpest_turn = M_PI / 2;  // beyond it no edge goes on from another
constexpr double share_of_segment = 0.25;   // of the segment at a node, for its tangent
constexpr double least_piece = 1e-3;        // metres
constexpr double near_bend = 1;             // metres along the axis, from an override to its bend
constexpr double filled = 1 - 1e-12;        // of a segment that two radii fill

// The direction in which an edge leaves its node: unit.
Point leaving(const Network& network, const EdgeEnd& end) {
  const Line& line = network.edges[end.edge].line;
  return end.at_start ? unit(planar(line[1]) - planar(line[0]))
                      : unit(planar(line[line.size() - 2]) - planar(line.back()));
}

double first_segment(const Network& network, const EdgeEnd& end) {
  const Line& line = network.edges[end.edge].line;
  return end.at_start ? distance(line[0], line[1]) : distance(line[line.size() - 2], line.back());
}

// The second point of an edge that leaves its node along the tangent of both edges there.
std::optional<Point> tangent_point(const Network& network, const EdgeEnd& own, const EdgeEnd& other,
                                   double shift) {
  if (network.edges[own.edge].level != network.edges[other.edge].level) return std::nullopt;
  const Point out = leaving(network, own), in = leaving(network, other) * -1;
  const double turn = std::abs(std::atan2(cross(in, out), dot(in, out)));
  if (turn < 1e-9 || turn > sharpest_turn) return std::nullopt;
  const double along =
      std::min(share_of_segment * first_segment(network, own), shift / std::sin(turn / 2));
  if (along < least_piece) return std::nullopt;
  const Line& line = network.edges[own.edge].line;
  return planar(own.at_start ? line.front() : line.back()) + unit(in + out) * along;
}

bool turns_back(const Point& in, const Point& out) {
  return dot(in, out) < 0 && std::abs(cross(in, out)) <= straight_sine * norm(in) * norm(out);
}

using Radii = std::vector<std::optional<double>>;

// The radii by hand of an edge, by point of its line.
Radii radii_by_hand(const Line& line, const Edge& edge, const std::vector<RoadOverride>& wanted) {
  Radii radii(line.size());
  const double share = length(line) / (edge.end_abscissa - edge.start_abscissa);
  for (const RoadOverride& wish : wanted) {
    const double place = (wish.abscissa - edge.start_abscissa) * share;
    double abscissa = 0, nearest = near_bend;
    std::size_t bend = 0;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      abscissa += distance(line[i - 1], line[i]);
      if (std::abs(abscissa - place) > nearest) continue;
      nearest = std::abs(abscissa - place);
      bend = i;
    }
    if (bend > 0) radii[bend] = wish.radius;
  }
  return radii;
}

// A bend whose radius grows as far as somebody asked. Without a wish it keeps the room of a quarter
// of each of its segments, or less where its arc wants less, so that no wish takes its arc away.
Bend bend_with_wish(const Line& line, std::size_t i, const std::optional<double>& wish,
                    double shift) {
  const Point in = line[i] - line[i - 1], out = line[i + 1] - line[i];
  Bend bend;
  if (turns_back(in, out)) return bend;
  const Point before = unit(in), after = unit(out);
  bend.tangent = half_turn_tangent(std::abs(cross(before, after)), dot(before, after));
  if (wish)
    bend.bound = *wish;
  else if (bend.tangent > straight_sine)
    bend.bound = std::min(radius_of_shift(bend.tangent, shift),
                          share_of_segment * std::min(norm(in), norm(out)) / bend.tangent);
  return bend;
}

// Radii by hand that want more of a segment than there is become the greatest that fit.
void make_wishes_fit(const Line& line, Radii& radii, double shift) {
  std::vector<double> lengths{distance(line[0], line[1])};
  std::vector<Bend> bends;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    lengths.push_back(distance(line[i], line[i + 1]));
    bends.push_back(bend_with_wish(line, i, radii[i], shift));
  }
  const std::vector<double> fitting = fit_radii(lengths, bends);
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    if (radii[i] && fitting[i - 1] < *radii[i]) radii[i] = fitting[i - 1] * filled;
}

}  // namespace

std::vector<std::vector<EdgeEnd>> ends_by_node(const Network& network) {
  std::vector<std::vector<EdgeEnd>> ends(network.nodes.size());
  for (int e = 0; e < static_cast<int>(network.edges.size()); ++e) {
    ends[network.edges[e].from_node].push_back({e, true});
    ends[network.edges[e].to_node].push_back({e, false});
  }
  return ends;
}

EdgeArcs::EdgeArcs(const Network& network, std::vector<std::vector<EdgeEnd>> ends, double shift,
                   const std::vector<RoadOverride>& overrides)
    : network_(network), ends_(std::move(ends)), shift_(shift), overrides_(network.edges.size()) {
  if (overrides.empty()) return;
  std::multimap<std::int64_t, const RoadOverride*> by_axis;
  for (const RoadOverride& wish : overrides) by_axis.emplace(wish.axis_id, &wish);
  for (std::size_t e = 0; e < network.edges.size(); ++e) {
    const Edge& edge = network.edges[e];
    const auto [first, last] = by_axis.equal_range(edge.axis_id);
    for (auto wish = first; wish != last; ++wish)
      if (wish->second->abscissa > edge.start_abscissa &&
          wish->second->abscissa < edge.end_abscissa)
        overrides_[e].push_back(*wish->second);
  }
}

std::optional<Point> EdgeArcs::tangent_at(int node, const EdgeEnd& own) const {
  if (ends_[node].size() != 2) return std::nullopt;
  const EdgeEnd& first = ends_[node][0];
  const EdgeEnd& other = slot(first) == slot(own) ? ends_[node][1] : first;
  return tangent_point(network_, own, other, shift_);
}

std::optional<ArcRoad> EdgeArcs::of(int e) const {
  const Edge& edge = network_.edges[e];
  Line bends = distinct(planar(edge.line));
  ArcRoadFit fit;
  fit.shift = shift_;
  if (!overrides_[e].empty()) fit.radii = radii_by_hand(bends, edge, overrides_[e]);
  const auto insert = [&](std::ptrdiff_t at, const Point& point) {
    bends.insert(bends.begin() + at, point);
    if (!fit.radii.empty()) fit.radii.insert(fit.radii.begin() + at, std::nullopt);
  };
  if (const auto point = tangent_at(edge.from_node, {e, true})) insert(1, *point);
  if (const auto point = tangent_at(edge.to_node, {e, false}))
    insert(static_cast<std::ptrdiff_t>(bends.size()) - 1, *point);
  if (bends.size() == 2) return std::nullopt;
  if (!fit.radii.empty()) make_wishes_fit(bends, fit.radii, shift_);
  return ArcRoad::fit(bends, fit);
}

}  // namespace streetgen
