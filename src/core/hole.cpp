#include "hole.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>

#include "box_index.hpp"
#include "groups.hpp"
#include "narrow.hpp"
#include "overlap.hpp"
#include "polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double least_hole = 1e-6;  // square metres: below it is the noise of coordinates
constexpr double touching = 1e-6;    // metres

std::vector<Ring> small_holes(const MultiPolygon& ground, double max_area) {
  std::vector<Ring> holes;
  for (const Polygon& polygon : ground)
    for (std::size_t i = 1; i < polygon.size(); ++i) {
      const double size = std::abs(signed_area(polygon[i]));
      if (size >= least_hole && size < max_area) holes.push_back(polygon[i]);
    }
  return holes;
}

// Metres of the hole's ring that run along the surface.
double shared_border(const Ring& hole, const MultiPolygon& surface) {
  double shared = 0;
  for (std::size_t i = 1; i < hole.size(); ++i) {
    const Point middle = (hole[i - 1] + hole[i]) * 0.5;
    const auto along = [&](const Polygon& polygon) {
      return std::any_of(polygon.begin(), polygon.end(),
                         [&](const Ring& ring) { return comes_within(middle, ring, touching); });
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

// Claims of one level joined by disputes, with those near a dispute that share an edge with its
// claims: the ring of a small hole turns where two surfaces overlap.
void add_disputing(const std::vector<Claim>& claims, const std::vector<Box>& boxes,
                   const ClaimsOnEdge& on_edge, const std::vector<std::pair<int, int>>& disputes,
                   std::vector<std::set<int>>& groups) {
  Groups joined(static_cast<int>(claims.size()));
  for (const auto& [i, j] : disputes)
    if (claims[i].level == claims[j].level) joined.join(i, j);
  std::map<int, std::set<int>> by_name;
  for (const auto& [i, j] : disputes) {
    const Box place = boxes[i].shared_with(boxes[j]).grown(hole_extent);
    for (const int claim : {i, j}) {
      std::set<int>& group = by_name[joined.of(claim)];
      group.insert(claim);
      for (const int edge : claims[claim].edges)
        for (const int neighbour : on_edge.at(edge))
          if (claims[neighbour].level == claims[claim].level && boxes[neighbour].meets(place, 0))
            group.insert(neighbour);
    }
  }
  for (auto& [of, group] : by_name) groups.push_back(std::move(group));
}

// What closes a ring with nothing in dispute: a claim that an edge leaves and comes back to, or two
// with more than one edge between them, and all of their level on those edges.
void add_rings(const std::vector<Claim>& claims, const ClaimsOnEdge& on_edge,
               std::vector<std::set<int>>& groups) {
  for (int i = 0; i < static_cast<int>(claims.size()); ++i) {
    const auto add = [&](const std::vector<int>& edges) {
      std::set<int> group;
      for (const int edge : edges)
        for (const int claim : on_edge.at(edge))
          if (claims[claim].level == claims[i].level) group.insert(claim);
      groups.push_back(std::move(group));
    };
    std::map<int, std::vector<int>> shared;  // edges, by the later claim at their other end
    for (const int edge : claims[i].edges) {
      const std::vector<int>& there = on_edge.at(edge);
      if (std::count(there.begin(), there.end(), i) > 1) {
        add({edge});
        continue;
      }
      for (const int other : there)
        if (other > i && claims[other].level == claims[i].level) shared[other].push_back(edge);
    }
    for (const auto& [other, edges] : shared)
      if (edges.size() > 1) add(edges);
  }
}

// Those of a group that a hole beside a wanted one may touch.
std::vector<int> near_wanted(const std::set<int>& group, const std::vector<Claim>& claims,
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

void fill_holes(MultiPolygon& surface, double max_area) {
  for (Polygon& polygon : surface)
    for (std::size_t i = polygon.size() - 1; i > 0; --i)
      if (std::abs(signed_area(polygon[i])) < max_area) polygon.erase(polygon.begin() + i);
}

std::vector<Hole> holes_between(Geos& geos, const std::vector<Claim>& claims,
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
  const auto united = [&](const auto& members) {
    std::vector<const MultiPolygon*> surfaces;
    for (const int i : members) surfaces.push_back(claims[i].surface);
    return geos.polygons(geos.unite_valid(surfaces).get());
  };
  const auto members_near = [&](const std::vector<int>& group, const Box& place) {
    std::vector<int> members;
    std::copy_if(group.begin(), group.end(), std::back_inserter(members),
                 [&](int i) { return boxes[i].meets(place, touching); });
    return members;
  };
  // By a surface of the level, or by one of another that tiles with one of the level.
  const auto covered = [&](const Ring& ring, const std::vector<int>& around) {
    const MultiPolygon hole{{reversed(ring)}};
    const Ground ground(hole);
    const std::vector<int> near = index.near(ground.box(), touching);
    return std::any_of(near.begin(), near.end(), [&](int k) {
      const int i = solid[k];
      return std::find(around.begin(), around.end(), i) == around.end() &&
             std::any_of(around.begin(), around.end(),
                         [&](int j) { return tile(claims[i], claims[j]); }) &&
             overlap(ground, Ground(*claims[i].surface));
    });
  };
  std::vector<Hole> holes;
  // Two groups may share the neighbours of one hole.
  const auto known = [&](const Ring& ring) {
    const Box box = box_of({{ring}});
    return std::any_of(holes.begin(), holes.end(), [&](const Hole& hole) {
      const Box other = box_of({{hole.ring}});
      return other.grown(touching).holds({box.min_x, box.min_y, 0}, 0) &&
             box.grown(touching).holds({other.min_x, other.min_y, 0}, 0) &&
             other.grown(touching).holds({box.max_x, box.max_y, 0}, 0);
    });
  };
  const ClaimsOnEdge on_edge = claims_on_edges(claims);
  std::vector<std::set<int>> groups;
  add_disputing(claims, boxes, on_edge, disputes, groups);
  add_rings(claims, on_edge, groups);
  for (const std::set<int>& whole : groups) {
    poll_cancel();
    const std::vector<int> group = near_wanted(whole, claims, boxes);
    std::vector<const MultiPolygon*> surfaces;
    for (const int i : group) surfaces.push_back(claims[i].surface);
    for (const Box& place : narrow_places(surfaces, max_area))
      for (const Ring& found : small_holes(united(members_near(group, place)), max_area)) {
        const Box box = box_of({{found}});
        std::vector<int> around = members_near(group, box);
        std::sort(around.begin(), around.end(), [&](int i, int j) {
          return std::tie(claims[i].axis_id, claims[i].place) <
                 std::tie(claims[j].axis_id, claims[j].place);
        });
        // Once more from its neighbours alone: the same whatever else was united.
        for (const Ring& ring : small_holes(united(around), max_area))
          if (std::any_of(around.begin(), around.end(), [&](int i) { return claims[i].wanted; }) &&
              box.holds(ring.front(), touching) && !known(ring) && !covered(ring, around))
            holes.push_back({ring, around});
      }
  }
  return holes;
}

namespace {

// Its vertices are those of the surface where they lie on one: a union may have moved them.
Ring on_vertices(Ring ring, const MultiPolygon& surface) {
  for (Point& p : ring)
    for (const Polygon& polygon : surface)
      for (const Ring& of_surface : polygon)
        for (const Point& vertex : of_surface)
          if (distance(p, vertex) <= touching) p = vertex;
  return ring;
}

}  // namespace

void give_holes(Geos& geos, std::vector<Claim>& claims, const std::vector<Hole>& holes) {
  for (const Hole& hole : holes) {
    MultiPolygon* owner = nullptr;
    double longest = 0;
    for (const int i : hole.around) {
      const double shared = shared_border(hole.ring, *claims[i].surface);
      if (shared <= longest) continue;
      longest = shared;
      owner = claims[i].surface;
    }
    if (owner == nullptr) continue;
    *owner = geos.polygons(geos.unite({*owner, {{on_vertices(hole.ring, *owner)}}}).get());
    fill_holes(*owner, least_hole);
  }
}

}  // namespace streetgen
