#include "ownership.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "box_index.hpp"
#include "cut.hpp"
#include "nearest.hpp"
#include "overlap.hpp"
#include "polyline.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/progress.hpp"

namespace streetgen {

namespace {

constexpr double sample_spacing = 1.0;  // metres along the axes
constexpr double negligible = 5e-4;     // square metres: no ground worth a dispute
constexpr double crumb = 1e-6;          // square metres: no part worth keeping

bool before(const Claim& a, const Claim& b) {
  return std::tuple(a.importance, -a.width, a.axis_id, a.place) <
         std::tuple(b.importance, -b.width, b.axis_id, b.place);
}

bool segments_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double o1 = cross(b - a, c - a), o2 = cross(b - a, d - a);
  const double o3 = cross(d - c, a - c), o4 = cross(d - c, b - c);
  return o1 * o2 < 0 && o3 * o4 < 0;
}

// A segment of a claim's skeleton, with the ends of the stretch that it belongs to.
struct SkeletonSegment {
  Point from, to, first, last;
};

std::vector<SkeletonSegment> skeleton_within(const Claim& claim, const Box& within) {
  std::vector<SkeletonSegment> segments;
  for (const Stretch& stretch : claim.skeleton) {
    if (stretch.from >= stretch.to) continue;
    const Line line = substring(*stretch.line, stretch.from, stretch.to);
    for (std::size_t i = 1; i < line.size(); ++i)
      if (box_of(line[i - 1], line[i]).meets(within, 0))
        segments.push_back({line[i - 1], line[i], line.front(), line.back()});
  }
  return segments;
}

// Inside both, not at an end that they share.
bool skeletons_cross(const Claim& a, const Claim& b, const Box& within) {
  const std::vector<SkeletonSegment> of_a = skeleton_within(a, within),
                                     of_b = skeleton_within(b, within);
  std::vector<Box> boxes;
  for (const SkeletonSegment& segment : of_b) boxes.push_back(box_of(segment.from, segment.to));
  const BoxIndex index(boxes);
  for (const SkeletonSegment& s : of_a) {
    poll_cancel();
    const bool crossed = index.any_near(box_of(s.from, s.to), 0, [&](int i) {
      const SkeletonSegment& t = of_b[i];
      if (!segments_cross(s.from, s.to, t.from, t.to)) return false;
      const Point u = s.to - s.from, v = t.to - t.from;
      const Point at = s.from + u * (cross(t.from - s.from, v) / cross(u, v));
      return std::min({distance(at, s.first), distance(at, s.last), distance(at, t.first),
                       distance(at, t.last)}) > 0.01;
    });
    if (crossed) return true;
  }
  return false;
}

// Every metre of the edge, whatever part of it the stretch is: an edit at one end of an edge
// moves no border at the other.
std::vector<double> sample_places(const Stretch& stretch, double total) {
  std::vector<double> places;
  for (double k = std::ceil(stretch.from / sample_spacing); k * sample_spacing <= stretch.to; ++k)
    places.push_back(k * sample_spacing);
  if (stretch.to >= total) places.push_back(total);
  if (places.empty()) places.push_back((stretch.from + stretch.to) / 2);
  return places;
}

void sample(const Claim& claim, const Box& within, double margin, bool first,
            std::vector<Site>& sites) {
  for (const Stretch& stretch : claim.skeleton) {
    const Line& line = *stretch.line;
    double walked = 0;
    std::size_t segment = 1;
    for (const double at : sample_places(stretch, length(line))) {
      while (segment + 1 < line.size() &&
             walked + distance(line[segment - 1], line[segment]) < at) {
        walked += distance(line[segment - 1], line[segment]);
        ++segment;
      }
      const double size = distance(line[segment - 1], line[segment]);
      const double t = size > 0 ? std::clamp((at - walked) / size, 0.0, 1.0) : 0;
      const Point p = planar(line[segment - 1] + (line[segment] - line[segment - 1]) * t);
      if (within.holds(p, margin)) sites.push_back({p, first});
    }
  }
}

std::vector<std::pair<int, int>> overlapping_boxes(const std::vector<Claim>& claims,
                                                   const std::vector<Ground>& grounds) {
  std::vector<Box> boxes(claims.size());
  std::vector<int> order;
  for (std::size_t i = 0; i < claims.size(); ++i) {
    if (claims[i].surface->empty()) continue;
    boxes[i] = grounds[i].box();
    order.push_back(static_cast<int>(i));
  }
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return boxes[i].min_x < boxes[j].min_x; });
  std::vector<std::pair<int, int>> pairs;
  std::vector<int> active;
  for (const int i : order) {
    std::size_t kept = 0;
    for (const int j : active) {
      if (boxes[j].max_x < boxes[i].min_x) continue;
      active[kept++] = j;
      if (tile(claims[i], claims[j]) && boxes[i].meets(boxes[j], -1e-6))
        pairs.emplace_back(std::min(i, j), std::max(i, j));
    }
    active.resize(kept);
    active.push_back(i);
    poll_cancel();
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// On edges that nearly coincide GEOS may drop ground or leave it, without an error: areas tell.
MultiPolygon overlaid_without(Geos& geos, const MultiPolygon& surface, const MultiPolygon& ground) {
  const Geos::Geometry whole = geos.surface(surface), taken = geos.surface(ground);
  const MultiPolygon rest = geos.polygons(geos.difference(whole.get(), taken.get()).get());
  const double expected = area(surface) - area(ground), found = area(rest);
  const auto left = [&] {
    const Geos::Geometry kept = geos.surface(rest);
    return area(geos.polygons(geos.intersection(kept.get(), taken.get()).get()));
  };
  if (found < expected - negligible || (found > expected + negligible && left() > negligible))
    return geos.polygons(geos.difference_on_grid(whole.get(), taken.get()).get());
  return rest;
}

// A surface that nearly touches itself may fall into parts that do.
bool valid(Geos& geos, const MultiPolygon& surface) {
  return surface.empty() || geos.valid(geos.surface(surface).get());
}

MultiPolygon without(Geos& geos, const MultiPolygon& surface, const MultiPolygon& ground) {
  std::optional<Cut> parts = cut(surface, ground);
  if (parts && valid(geos, parts->rest)) return std::move(parts->rest);
  return overlaid_without(geos, surface, ground);
}

MultiPolygon shared_ground(Geos& geos, const MultiPolygon& a, const MultiPolygon& b) {
  std::optional<Cut> parts = cut(a, b);
  if (parts && valid(geos, parts->shared)) return std::move(parts->shared);
  const Geos::Geometry of_a = geos.surface(a), of_b = geos.surface(b);
  return geos.polygons(geos.intersection(of_a.get(), of_b.get()).get());
}

// Contested ground by the claim whose axes are nearer: that of the first, that of the second.
Cut by_distance(Geos& geos, const Claim& first, const Claim& second, const MultiPolygon& ground,
                const Box& box) {
  std::vector<Site> sites;
  const double margin = std::max(first.width, second.width) / 2 + 2 * sample_spacing;
  // Of sites in one place the claim that comes before keeps it.
  const bool first_wins = before(first, second);
  sample(first_wins ? first : second, box, margin, first_wins, sites);
  sample(first_wins ? second : first, box, margin, !first_wins, sites);
  const auto count =
      std::count_if(sites.begin(), sites.end(), [](const Site& s) { return s.first; });
  if (count == 0) return {{}, ground};
  if (count == static_cast<std::ptrdiff_t>(sites.size())) return {ground, {}};
  const MultiPolygon nearer = nearest_to_first(sites, 2 * margin);
  std::optional<Cut> parts = cut(ground, nearer);
  if (parts && valid(geos, parts->shared) && valid(geos, parts->rest)) return std::move(*parts);
  MultiPolygon of_first = shared_ground(geos, ground, nearer);
  MultiPolygon of_second = without(geos, ground, of_first);
  return {std::move(of_first), std::move(of_second)};
}

// Ground won where axes cross.
struct Won {
  int winner = 0, loser = 0;
  MultiPolygon ground;
};

// A crossing wins ground by rank, all else by distance: between three surfaces each may have lost
// the same ground to the next. What nobody holds goes back to the winner at the crossing.
void return_lost_ground(Geos& geos, std::vector<Claim>& claims, std::vector<Won> won,
                        const std::vector<std::pair<int, int>>& disputes) {
  if (won.empty()) return;
  std::map<int, std::vector<int>> rivals;
  for (const auto& [i, j] : disputes) {
    rivals[i].push_back(j);
    rivals[j].push_back(i);
  }
  std::sort(won.begin(), won.end(), [&](const Won& a, const Won& b) {
    if (a.winner != b.winner) return before(claims[a.winner], claims[b.winner]);
    return before(claims[a.loser], claims[b.loser]);
  });
  for (const Won& each : won) {
    poll_cancel();
    MultiPolygon rest = each.ground;
    const auto take_off = [&](int holder) {
      const Geos::Geometry open = geos.surface(rest), held = geos.surface(*claims[holder].surface);
      rest = geos.polygons(geos.difference_on_grid(open.get(), held.get()).get());
    };
    take_off(each.winner);
    for (const int rival : rivals[each.winner]) take_off(rival);
    if (area(rest) <= negligible) continue;
    MultiPolygon& surface = *claims[each.winner].surface;
    surface = geos.polygons(geos.unite({surface, rest}).get());
  }
}

}  // namespace

bool tile(const Claim& a, const Claim& b) {
  return a.level == b.level || std::find_first_of(a.edges.begin(), a.edges.end(), b.edges.begin(),
                                                  b.edges.end()) != a.edges.end();
}

std::vector<std::pair<int, int>> disputes(const std::vector<Claim>& claims) {
  std::vector<Ground> grounds;
  for (const Claim& claim : claims) grounds.emplace_back(*claim.surface);
  std::vector<std::pair<int, int>> pairs;
  for (const auto& pair : overlapping_boxes(claims, grounds)) {
    poll_cancel();
    if (overlap(grounds[pair.first], grounds[pair.second])) pairs.push_back(pair);
  }
  return pairs;
}

void settle_ownership(Geos& geos, std::vector<Claim>& claims,
                      const std::vector<std::pair<int, int>>& disputes) {
  // By rival, so that the ground goes in one order.
  std::map<int, std::map<int, MultiPolygon>> lost;
  std::map<int, double> whole;
  std::vector<Won> won;
  const auto judge = [&](int i, int j) {
    poll_cancel();
    tell_progress("owners", i, claims.size());
    const MultiPolygon ground = shared_ground(geos, *claims[i].surface, *claims[j].surface);
    if (area(ground) <= negligible) return;
    const Box box = box_of(ground);
    if (skeletons_cross(claims[i], claims[j], box)) {
      const auto [winner, loser] = before(claims[i], claims[j]) ? std::pair(i, j) : std::pair(j, i);
      lost[loser][winner] = ground;
      won.push_back({winner, loser, ground});
      return;
    }
    Cut parts = by_distance(geos, claims[i], claims[j], ground, box);
    if (!parts.shared.empty()) lost[j][i] = std::move(parts.shared);
    if (!parts.rest.empty()) lost[i][j] = std::move(parts.rest);
  };
  // What a winner gets back depends on the settled ground of all its rivals.
  std::vector<bool> wanted;
  for (const Claim& claim : claims) wanted.push_back(claim.wanted);
  std::vector<std::pair<int, int>> open = disputes;
  for (std::size_t judged = 1; judged > 0;) {
    const auto rest = std::stable_partition(open.begin(), open.end(), [&](const auto& pair) {
      return !wanted[pair.first] && !wanted[pair.second];
    });
    judged = open.end() - rest;
    std::for_each(rest, open.end(), [&](const auto& pair) { judge(pair.first, pair.second); });
    open.erase(rest, open.end());
    std::vector<bool> winner(claims.size(), false);
    for (const Won& each : won) winner[each.winner] = winner[each.winner] || wanted[each.winner];
    for (const auto& [i, j] : disputes)
      if (winner[i] || winner[j]) wanted[i] = wanted[j] = true;
  }
  for (std::size_t i = 0; i < claims.size(); ++i) claims[i].wanted = wanted[i];
  for (const auto& [i, grounds] : lost) {
    poll_cancel();
    whole[i] = area(*claims[i].surface);
    MultiPolygon rest = *claims[i].surface;
    for (const auto& [rival, ground] : grounds) rest = without(geos, rest, ground);
    rest.erase(std::remove_if(rest.begin(), rest.end(),
                              [](const Polygon& part) { return area({part}) <= crumb; }),
               rest.end());
    *claims[i].surface = std::move(rest);
  }
  return_lost_ground(geos, claims, std::move(won), disputes);
  for (const auto& [i, size] : whole)
    claims[i].contested_area = std::max(0.0, size - area(*claims[i].surface));
}

}  // namespace streetgen
