#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "geometry/enclosing_circle.hpp"
#include "geometry/fit_circle.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "network/face.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/roundabout.hpp"

namespace streetgen {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double beside_circle = 0.1;  // of the radius: what is nearer lies on the circle
constexpr double step = 1;             // metres between the places that are compared with it
constexpr std::size_t most_places = 2000;

Network network_of(const std::vector<RingAxis>& axes, const RingSettings& settings) {
  std::vector<NetworkAxis> lines;
  for (const RingAxis& axis : axes) lines.push_back({axis.axis_id, axis.line, axis.level});
  return network(lines, settings.tolerance, settings.crossing);
}

// Places on a closed line, so many metres apart.
Line places_on(const Ring& ring) {
  const double size = length(ring);
  const auto count = static_cast<std::size_t>(
      std::clamp(size / step, 32.0, static_cast<double>(most_places)));
  Line places;
  double done = 0;
  std::size_t segment = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = size * i / count;
    while (segment + 2 < ring.size() && done + distance(ring[segment], ring[segment + 1]) < at)
      done += distance(ring[segment], ring[segment + 1]), ++segment;
    places.push_back(ring[segment] + unit(ring[segment + 1] - ring[segment]) * (at - done));
  }
  return places;
}

class RingFinder {
 public:
  RingFinder(const std::vector<RingAxis>& axes, const RingSettings& settings)
      : settings_(settings), network_(network_of(axes, settings)) {
    for (const RingAxis& axis : axes) one_way_[axis.axis_id] = axis.one_way;
    ends_.resize(network_.nodes.size());
    for (int e = 0; e < static_cast<int>(network_.edges.size()); ++e) {
      ends_[network_.edges[e].from_node].push_back({e, true});
      ends_[network_.edges[e].to_node].push_back({e, false});
    }
  }

  std::vector<NetworkRing> find() {
    std::set<int> levels;
    for (const Edge& edge : network_.edges) levels.insert(edge.level);
    std::vector<NetworkRing> rings;
    for (const int level : levels)
      for (const Face& face : find_faces(network_, level).faces) {
        poll_cancel();
        add_ring(face, level, rings);
      }
    return rings;
  }

 private:
  struct End {
    int edge;
    bool at_start;
  };

  void add_ring(const Face& face, int level, std::vector<NetworkRing>& rings) const {
    const double greatest = settings_.radius_greatest, least = settings_.radius_least;
    if (face.area > pi * greatest * greatest ||
        face.area < settings_.shape_least * pi * least * least)
      return;
    NetworkRing ring;
    ring.level = level;
    ring.inside = static_cast<int>(face.rings.size()) - 1;
    const std::vector<EdgeSide> sides = sides_about(face, ring);
    if (sides.empty()) return;
    const Circle around = enclosing_circle(ring.line);
    if (around.radius > greatest) return;
    ring.fill = std::min(1.0, face.area / (pi * around.radius * around.radius));
    const Line places = places_on(ring.line);
    const auto circle = fit_circle(places.data(), places.size());
    if (ring.fill < settings_.shape_least || !circle || circle->radius < least) return;
    ring.centre = circle->centre;
    ring.radius = circle->radius;
    const auto near = std::count_if(places.begin(), places.end(), [&](const Point& p) {
      return std::abs(distance(p, ring.centre) - ring.radius) <= beside_circle * ring.radius;
    });
    ring.on_circle = static_cast<double>(near) / places.size();
    add_edges(sides, ring);
    add_arms(sides, ring);
    rings.push_back(std::move(ring));
  }

  // Without edges that hang into the face, which has them on both sides; fills line and inside.
  std::vector<EdgeSide> sides_about(const Face& face, NetworkRing& ring) const {
    std::map<std::pair<int, int>, int> times;
    std::map<std::pair<int, bool>, double> covered;
    for (const EdgeSide& side : face.rings.front().sides) {
      ++times[{side.edge, side.part}];
      covered[{side.edge, side.left}] += std::abs(side.end - side.start);
    }
    std::vector<EdgeSide> sides;
    for (const EdgeSide& side : face.rings.front().sides) {
      if (times[{side.edge, side.part}] > 1) {
        ring.inside += side.left;
        continue;
      }
      const Edge& edge = network_.edges[side.edge];
      // Where streets cross without a node another face may have the rest of a side: then neither is
      // a ring.
      if (covered[{side.edge, side.left}] < length(edge.line) - 2 * coordinate_margin) return {};
      sides.push_back(side);
      const Line piece = side.left ? substring(edge.line, side.start, side.end)
                                   : substring(edge.line, side.end, side.start);
      for (const Point& p : piece)
        if (ring.line.empty() || !same(ring.line.back(), p)) ring.line.push_back(planar(p));
    }
    if (!ring.line.empty() && !same(ring.line.back(), ring.line.front()))
      ring.line.push_back(ring.line.front());
    return ring.line.size() > 3 ? sides : std::vector<EdgeSide>{};
  }

  RingEdge edge_of(int e, bool along_axis) const {
    const Edge& edge = network_.edges[e];
    return {edge.axis_id, edge.start_abscissa, edge.end_abscissa, along_axis};
  }

  void add_edges(const std::vector<EdgeSide>& sides, NetworkRing& ring) const {
    const double size = length(ring.line);
    for (const EdgeSide& side : sides) {
      const bool along = side.left == settings_.counter_clockwise;
      // An edge that others cross has several parts.
      if (&side == &sides.front() || side.edge != (&side - 1)->edge)
        ring.edges.push_back(edge_of(side.edge, along));
      const OneWay one_way = one_way_.at(network_.edges[side.edge].axis_id);
      if (one_way == OneWay::no) continue;
      ((one_way == OneWay::along) == along ? ring.one_way : ring.against) +=
          std::abs(side.end - side.start) / size;
    }
  }

  void add_arms(const std::vector<EdgeSide>& sides, NetworkRing& ring) const {
    std::set<int> about, seen;
    for (const EdgeSide& side : sides) about.insert(side.edge);
    int single = 0;
    for (const EdgeSide& side : sides) {
      const Edge& edge = network_.edges[side.edge];
      const int node = side.left ? edge.from_node : edge.to_node;
      if (!seen.insert(node).second) continue;
      int arms = 0;
      for (const End& end : ends_[node]) {
        if (about.count(end.edge) > 0) continue;
        ring.arms.push_back(edge_of(end.edge, !end.at_start));
        ++arms;
      }
      ring.arm_nodes += arms > 0;
      single += arms == 1;
    }
    if (ring.arm_nodes > 0) ring.single_arm = static_cast<double>(single) / ring.arm_nodes;
  }

  const RingSettings& settings_;
  Network network_;
  std::map<std::int64_t, OneWay> one_way_;
  std::vector<std::vector<End>> ends_;  // by node
};

}  // namespace

std::vector<NetworkRing> network_rings(const std::vector<RingAxis>& axes,
                                       const RingSettings& settings) {
  return RingFinder(axes, settings).find();
}

}  // namespace streetgen
