#include "ownership/hole.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <tuple>
#include <unordered_map>

#include "geometry/arrangement.hpp"
#include "geometry/border_stretches.hpp"
#include "geometry/box_hierarchy.hpp"
#include "geometry/box_index.hpp"
#include "geometry/fill_holes.hpp"
#include "geometry/hairline.hpp"
#include "geometry/narrow_gap.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/surface_union.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"
#include "support/disjoint_sets.hpp"

namespace streetgen {

namespace {

// Across each gap between lines that nearly touch, so that they close rings.
std::vector<Line> bridges_between(const std::vector<LineView>& lines) {
  std::vector<std::pair<Point, Point>> sides;
  std::vector<Box> boxes;
  for (const LineView& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) {
      sides.emplace_back(line[i - 1], line[i]);
      boxes.push_back(box_of(line[i - 1], line[i]));
    }
  const BoxHierarchy near(std::move(boxes));
  std::vector<Line> bridges;
  for (const LineView& line : lines)
    for (const Point& p : line)
      near.any_near(box_of(p, p), same_place, [&](std::size_t i) {
        const Point across = nearest_on_segment(p, sides[i].first, sides[i].second);
        const double gap = distance(p, across);
        if (gap > 0 && gap <= same_place) bridges.push_back({p, across});
        return false;
      });
  return bridges;
}

// Metres of the hole's ring that run along the surface.
double shared_border(const Ring& hole, const MultiPolygon& surface) {
  double shared = 0;
  for (std::size_t i = 1; i < hole.size(); ++i) {
    const Point middle = (hole[i - 1] + hole[i]) * 0.5;
    const auto along = [&](const Polygon& polygon) {
      return std::any_of(polygon.begin(), polygon.end(),
                         [&](const Ring& ring) { return comes_within(middle, ring, same_place); });
    };
    if (std::any_of(surface.begin(), surface.end(), along))
      shared += distance(hole[i - 1], hole[i]);
  }
  return shared;
}

using ClaimsOnEdge = std::unordered_map<int, std::vector<int>>;

ClaimsOnEdge claims_on_edges(const std::vector<Claim>& claims) {
  ClaimsOnEdge on_edge;
  for (int i = 0; i < static_cast<int>(claims.size()); ++i)
    for (const int edge : claims[i].edges) on_edge[edge].push_back(i);
  return on_edge;
}

// Claims of one level that may close the ring of a small hole: where it turns two surfaces overlap,
// or an edge leaves a surface and comes back to it, or two edges lead to the same one. Those near a
// dispute go with it that share an edge with its claims.
std::vector<std::vector<int>> groups_of(const std::vector<Claim>& claims,
                                        const std::vector<Box>& boxes, const ClaimsOnEdge& on_edge,
                                        const std::vector<std::pair<int, int>>& disputes) {
  const int count = static_cast<int>(claims.size());
  Groups joined(count);
  std::vector<bool> member(count);
  const auto join = [&](int i, int j) {
    if (claims[i].level != claims[j].level) return;
    if (claims[i].surface->empty() || claims[j].surface->empty()) return;
    joined.join(i, j);
    member[i] = member[j] = true;
  };
  for (const auto& [i, j] : disputes) {
    join(i, j);
    const Box place = boxes[i].shared_with(boxes[j]).grown(hole_extent);
    for (const int claim : {i, j})
      for (const int edge : claims[claim].edges)
        for (const int neighbour : on_edge.at(edge))
          if (boxes[neighbour].meets(place)) join(claim, neighbour);
  }
  for (int i = 0; i < count; ++i) {
    const auto join_all_on = [&](int edge) {
      for (const int claim : on_edge.at(edge)) join(i, claim);
    };
    std::map<int, int> shared;  // an edge, by the later claim at its other end
    for (const int edge : claims[i].edges) {
      const std::vector<int>& there = on_edge.at(edge);
      if (std::count(there.begin(), there.end(), i) > 1) {
        join_all_on(edge);
        continue;
      }
      for (const int other : there) {
        if (other <= i || claims[other].level != claims[i].level) continue;
        const auto [first, only] = shared.emplace(other, edge);
        if (only) continue;
        join_all_on(first->second);
        join_all_on(edge);
      }
    }
  }
  std::map<int, std::vector<int>> by_name;
  for (int i = 0; i < count; ++i)
    if (member[i]) by_name[joined.of(i)].push_back(i);
  std::vector<std::vector<int>> groups;
  for (auto& [name, group] : by_name) groups.push_back(std::move(group));
  return groups;
}

// Those of a group that a hole beside a wanted one may touch.
std::vector<int> near_wanted(const std::vector<int>& group, const std::vector<Claim>& claims,
                             const std::vector<Box>& boxes) {
  std::vector<Box> wanted;
  for (const int i : group)
    if (claims[i].wanted) wanted.push_back(boxes[i].grown(hole_extent));
  const BoxIndex index(wanted);
  std::vector<int> near;
  for (const int i : group)
    if (index.any_near(boxes[i], 0, [](int) { return true; })) near.push_back(i);
  return near;
}

}  // namespace

std::vector<Hole> holes_between(const std::vector<Claim>& claims,
                                const std::vector<std::pair<int, int>>& disputes, double max_area) {
  std::vector<Box> boxes, solid_boxes;
  std::vector<int> solid;  // the claims with ground
  for (int i = 0; i < static_cast<int>(claims.size()); ++i) {
    boxes.push_back(box_of(*claims[i].surface));
    if (claims[i].surface->empty()) continue;
    solid_boxes.push_back(boxes.back());
    solid.push_back(i);
  }
  const BoxIndex index(solid_boxes);
  // Faces near the place that no member holds; one that leaves it may be held beyond by others.
  const auto holes_near = [&](const Box& place, const std::vector<int>& members) {
    std::vector<LineView> lines;
    const auto near = [&](const Point& from, const Point& to) {
      return box_of(from, to).meets(place);
    };
    for (const int i : members) append_stretches(*claims[i].surface, near, lines);
    const std::vector<Line> bridges = bridges_between(lines);
    lines.insert(lines.end(), bridges.begin(), bridges.end());
    const Arrangement faces(lines);
    std::vector<bool> open;
    for (int walk = 0; walk < static_cast<int>(faces.places().size()); ++walk) {
      const double size = signed_area(faces.border(walk));
      open.push_back(size > 0 && size < max_area &&
                     std::none_of(members.begin(), members.end(), [&](int i) {
                       return inside(faces.places()[walk], *claims[i].surface);
                     }));
    }
    std::vector<Ring> holes;
    for (Polygon& hole : faces.joined(open)) {
      Ring ring = without_hairlines(hole.front());
      const double size = signed_area(ring);
      if (size >= least_hole && size < max_area) holes.push_back(std::move(ring));
    }
    return holes;
  };
  const auto members_near = [&](const std::vector<int>& group, const Box& place) {
    std::vector<int> members;
    std::copy_if(group.begin(), group.end(), std::back_inserter(members),
                 [&](int i) { return boxes[i].meets(place, same_place); });
    return members;
  };
  // By a surface of the level, or by one of another that tiles with one of the level.
  const auto covered = [&](const Ring& ring, const std::vector<int>& around) {
    const MultiPolygon hole{{ring}};
    const PreparedSurface ground(hole);
    const std::vector<int> near = index.near(ground.box(), same_place);
    return std::any_of(near.begin(), near.end(), [&](int k) {
      const int i = solid[k];
      return std::find(around.begin(), around.end(), i) == around.end() &&
             std::any_of(around.begin(), around.end(),
                         [&](int j) { return tile(claims[i], claims[j]); }) &&
             overlap(ground, PreparedSurface(*claims[i].surface));
    });
  };
  std::vector<Hole> holes;
  // Two places may show one hole.
  const auto known = [&](const Ring& ring) {
    return std::any_of(holes.begin(), holes.end(),
                       [&](const Hole& hole) { return same(hole.ring, ring); });
  };
  for (const std::vector<int>& whole :
       groups_of(claims, boxes, claims_on_edges(claims), disputes)) {
    poll_cancel();
    const std::vector<int> group = near_wanted(whole, claims, boxes);
    std::vector<const MultiPolygon*> surfaces;
    for (const int i : group) surfaces.push_back(claims[i].surface);
    for (const Box& place : narrow_gaps(surfaces, max_area))
      for (const Ring& found :
           holes_near(place.grown(coordinate_margin), members_near(group, place))) {
        const Box box = box_of({{found}}).grown(coordinate_margin);
        std::vector<int> around = members_near(group, box);
        std::sort(around.begin(), around.end(),
                  [&](int i, int j) { return before(claims[i], claims[j]); });
        if (std::none_of(around.begin(), around.end(), [&](int i) { return claims[i].wanted; }))
          continue;
        // Once more from its neighbours alone: the same whatever else was there.
        for (const Ring& ring : holes_near(box, around))
          if (std::all_of(ring.begin(), ring.end(),
                          [&](const Point& p) { return box.holds(p, 0); }) &&
              !known(ring) && !covered(ring, around))
            holes.push_back({ring, around});
      }
  }
  return holes;
}

namespace {

// Settling may have moved the surface's vertices: each takes along the nearest of the ring's, but
// no other, since the two sides of a hairline lie as near.
Ring on_vertices(const Ring& ring, const MultiPolygon& surface) {
  Ring moved = ring;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point p = ring[i];
    Point nearest = p;
    double away = same_place;
    for (const Polygon& polygon : surface)
      for (const Ring& of_surface : polygon)
        for (const Point& vertex : of_surface)
          if (const double off = distance(p, vertex); off <= away) {
            nearest = vertex;
            away = off;
          }
    if (std::none_of(ring.begin(), ring.end(),
                     [&](const Point& other) { return distance(other, nearest) < away; }))
      moved[i] = nearest;
  }
  return moved;
}

}  // namespace

void give_holes(Geos& geos, std::vector<Claim>& claims, const std::vector<Hole>& holes) {
  for (const Hole& hole : holes) {
    MultiPolygon* owner = nullptr;
    double longest = 0;
    for (const int i : hole.around) {
      const double shared = shared_border(hole.ring, *claims[i].surface);
      // Both sides of a notch are as long but for rounding.
      if (shared <= longest + (owner != nullptr ? coordinate_margin : 0)) continue;
      longest = shared;
      owner = claims[i].surface;
    }
    if (owner == nullptr) continue;
    *owner = united_as_they_lie(geos, {*owner, {{on_vertices(hole.ring, *owner)}}});
    fill_holes(*owner, least_part);
  }
}

}  // namespace streetgen
