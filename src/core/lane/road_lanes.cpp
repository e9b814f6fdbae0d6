#include "streetgen/road_lanes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/polyline.hpp"
#include "lane/lane_limit.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double step = 2;  // metres between two looks across the road
// Metres from the ends.  A surface ends across its axis, whose heading the chain leaves a little.
constexpr double inside = 0.3;
constexpr double least_width = 1e-3;      // metres
constexpr double straight_border = 0.01;  // metres by which borders may leave what is written

// A lane grows by so much from one look to the next, at most: a share and metres.
constexpr double wider = 1.3, wider_by = 0.5;

// A stretch of the line across the road, metres to the left.
struct Span {
  double left = 0, right = 0;
  double middle() const { return (left + right) / 2; }
};

// The crossings of the line through the place, metres to the left of it.
void append_crossings(const Line& line, const ChainPlace& place, std::vector<double>& at) {
  const Point way{std::cos(place.heading), std::sin(place.heading), 0}, left = left_normal(way);
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Point a = line[i] - place.point, b = line[i + 1] - place.point;
    const double da = dot(a, way), db = dot(b, way);
    if ((da <= 0) == (db <= 0)) continue;
    at.push_back(dot(a, left) + (dot(b, left) - dot(a, left)) * da / (da - db));
  }
}

// The one that is nearest to what is expected.
std::optional<Span> span_of(const LaneGround& lane, const ChainPlace& place, double expected) {
  std::optional<Span> nearest;
  const auto take = [&](const Span& span) {
    const auto off = [&](const Span& s) { return std::abs(s.middle() - expected); };
    if (!nearest || off(span) < off(*nearest)) nearest = span;
  };
  std::vector<double> at;
  for (const Polygon& part : lane.surface)
    for (const Ring& ring : part) append_crossings(ring, place, at);
  std::sort(at.begin(), at.end());
  for (std::size_t i = 0; i + 1 < at.size(); i += 2) take({at[i + 1], at[i]});
  if (!lane.surface.empty()) return nearest;
  append_crossings(lane.line, place, at);
  for (const double middle : at) take({middle + lane.width / 2, middle - lane.width / 2});
  return nearest;
}

std::vector<double> looks(const std::vector<PlanPiece>& chain) {
  std::vector<double> out;
  for (const PlanPiece& piece : chain) {
    const int parts =
        std::max(piece.straight() ? 1 : 2, static_cast<int>(std::ceil(piece.length / step)));
    for (int i = 0; i < parts; ++i) out.push_back(piece.s + piece.length * i / parts);
  }
  out.push_back(length(chain));
  return out;
}

// At an end a lane was seen a little inside, at `from`: it goes on from there as from the next
// station.
void lead_to_end(const Span& next, double away, double from, Span& end) {
  constexpr double steepest = 0.5;  // metres aside by metre
  for (double Span::*side : {&Span::left, &Span::right}) {
    const double slope = (end.*side - next.*side) / away;
    if (std::abs(slope) <= steepest) end.*side += slope * from;
  }
}

// At each station, where the lane is seen.
std::vector<std::optional<Span>> seen_spans(const LaneGround& lane,
                                            const std::vector<PlanPiece>& chain,
                                            const std::vector<double>& stations) {
  const double end = length(chain), from = std::min(inside, end / 4);
  const ChainPlace start = place_at(chain, 0);
  const Point left{-std::sin(start.heading), std::cos(start.heading), 0};
  double expected = dot(lane.line.front() - start.point, left);
  double widest = lane.width;
  std::vector<std::optional<Span>> seen;
  for (const double s : stations) {
    seen.push_back(span_of(lane, place_at(chain, std::clamp(s, from, end - from)), expected));
    // In a bend one may look along the lane behind it.
    if (seen.back() && lane.width > 0 &&
        seen.back()->left - seen.back()->right > widest * wider + wider_by)
      seen.back().reset();
    if (!seen.back()) continue;
    expected = seen.back()->middle();
    widest = std::max(lane.width, seen.back()->left - seen.back()->right);
  }
  const std::size_t last = stations.size() - 1;
  const double first_away = stations[1] - from, last_away = end - from - stations[last - 1];
  const std::optional<Span> first = seen.front();
  if (seen[0] && seen[1] && first_away > from) lead_to_end(*seen[1], first_away, from, *seen[0]);
  if (seen[last] && seen[last - 1] && last_away > from)
    lead_to_end(last == 1 ? *first : *seen[last - 1], last == 1 ? end - 2 * from : last_away, from,
                *seen[last]);
  return seen;
}

// A lane that is not seen has its span at the station before, else behind.
void fill(const LaneGround& lane, const ChainPlace& start,
          std::vector<std::optional<Span>>& spans) {
  const Point left{-std::sin(start.heading), std::cos(start.heading), 0};
  const double middle = dot(lane.line.front() - start.point, left);
  const auto first =
      std::find_if(spans.begin(), spans.end(), [](const auto& span) { return span.has_value(); });
  Span last =
      first == spans.end() ? Span{middle + lane.width / 2, middle - lane.width / 2} : **first;
  for (auto& span : spans) span = last = span.value_or(last);
}

// A lane that is not there has no width beside the next lane, and lies on its surface alone.
void close(const std::vector<std::optional<Span>>& next, bool on_left,
           std::vector<std::optional<Span>>& spans) {
  for (std::size_t i = 0; i < spans.size(); ++i) {
    if (spans[i]) continue;
    const double edge = on_left ? next[i]->left : next[i]->right;
    spans[i] = {edge, edge};
  }
}

// By lane and station.
std::vector<std::vector<std::optional<Span>>> spans_of(const std::vector<LaneGround>& lanes,
                                                       const std::vector<PlanPiece>& chain,
                                                       const std::vector<double>& stations) {
  std::vector<std::vector<std::optional<Span>>> spans;
  std::size_t first = lanes.size();
  for (std::size_t p = 0; p < lanes.size(); ++p) {
    poll_cancel();
    spans.push_back(seen_spans(lanes[p], chain, stations));
    if (lanes[p].width <= 0) continue;
    fill(lanes[p], place_at(chain, 0), spans.back());
    first = std::min(first, p);
  }
  if (first == lanes.size()) {
    first = 0;
    fill(lanes[0], place_at(chain, 0), spans[0]);
  }
  for (std::size_t p = first; p-- > 0;) close(spans[p + 1], true, spans[p]);
  for (std::size_t p = first + 1; p < lanes.size(); ++p) close(spans[p - 1], false, spans[p]);
  return spans;
}

// The part of its ground that a lane has.
Span part_of(const Span& span, LanePart part) {
  if (part == LanePart::left_half) return {span.left, span.middle()};
  if (part == LanePart::right_half) return {span.middle(), span.right};
  return span;
}

// The stations that are needed for borders that are straight between them.
std::vector<std::size_t> needed(const std::vector<double>& stations,
                                const std::vector<std::vector<double>>& borders) {
  std::vector<std::size_t> out{0};
  std::vector<std::size_t> ends{stations.size() - 1};
  while (!ends.empty()) {
    const std::size_t first = out.back(), last = ends.back();
    std::size_t farthest = first;
    double most = straight_border;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double share = (stations[i] - stations[first]) / (stations[last] - stations[first]);
      for (const auto& border : borders) {
        const double off =
            std::abs(border[i] - border[first] - share * (border[last] - border[first]));
        if (off > most) most = off, farthest = i;
      }
    }
    if (farthest != first) {
      ends.push_back(farthest);
    } else {
      out.push_back(last);
      ends.pop_back();
    }
  }
  return out;
}

}  // namespace

LaneLimit lane_limit(const RoadLanes& road, std::size_t lane, bool at_start) {
  const std::vector<double>&left = road.borders[lane], &right = road.borders[lane + 1];
  const std::size_t last = road.stations.size() - 1;
  const std::size_t at = at_start ? 0 : last, a = at_start ? 0 : last - 1, b = a + 1;
  const auto middle = [&](std::size_t i) { return (left[i] + right[i]) / 2; };
  const double slope = (middle(b) - middle(a)) / (road.stations[b] - road.stations[a]);
  const double curvature =
      at_start ? road.chain.front().curvature : road.chain.back().curvature_end;
  const ChainPlace place = place_at(road.chain, road.stations[at]);
  const double off = middle(at), heading = place.heading;
  return {{place.point + Point{-std::sin(heading), std::cos(heading), 0} * off,
           heading + std::atan2(slope, 1 - curvature * off)},
          left[at] - right[at]};
}

RoadLanes road_lanes(const Line& axis, const std::vector<LaneGround>& lanes, double tolerance) {
  // The inner border of a tighter arc would turn back.
  double half_width = 0;
  for (const LaneGround& lane : lanes)
    half_width += lane.width / (lane.part == LanePart::whole ? 2 : 4);
  return road_lanes(plan_view(axis, tolerance, {}, std::max(least_curve_radius, half_width)),
                    lanes);
}

RoadLanes road_lanes(std::vector<PlanPiece> chain, const std::vector<LaneGround>& lanes) {
  RoadLanes road;
  road.chain = std::move(chain);
  if (road.chain.empty() || lanes.empty()) return road;
  const std::vector<double> stations = looks(road.chain);
  std::vector<std::vector<double>> borders(lanes.size() + 1, std::vector<double>(stations.size()));
  const auto spans = spans_of(lanes, road.chain, stations);
  for (std::size_t p = 0; p < lanes.size(); ++p)
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const Span span = part_of(*spans[p][i], lanes[p].part);
      borders[p][i] = p == 0 ? span.left : (borders[p][i] + span.left) / 2;
      borders[p + 1][i] = span.right;
    }
  for (std::size_t p = 0; p < lanes.size(); ++p)
    for (std::size_t i = 0; i < stations.size(); ++i)
      borders[p + 1][i] = std::min(borders[p + 1][i], borders[p][i] - least_width);
  const std::vector<std::size_t> kept = needed(stations, borders);
  for (const std::size_t i : kept) road.stations.push_back(stations[i]);
  for (const auto& border : borders) {
    road.borders.emplace_back();
    for (const std::size_t i : kept) road.borders.back().push_back(border[i]);
  }
  for (std::size_t p = 0; p < lanes.size(); ++p) {
    road.starts.push_back(lane_limit(road, p, true));
    road.ends.push_back(lane_limit(road, p, false));
  }
  return road;
}

}  // namespace streetgen
