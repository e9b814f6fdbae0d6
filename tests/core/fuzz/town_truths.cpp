#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "shared_area.hpp"
#include "streetgen/streets.hpp"
#include "surfaces.hpp"
#include "truths.hpp"

namespace streetgen::fuzz {

namespace {

struct Surface {
  const MultiPolygon* ground;
  int level;
  std::string name;
};

std::vector<Surface> surfaces_of(const Streets& town) {
  std::vector<Surface> all;
  for (const Section& section : town.sections)
    all.push_back({&section.surface, town.network.edges[section.edge].level,
                   "section of edge " + std::to_string(section.edge)});
  for (const Intersection& intersection : town.intersections)
    all.push_back({&intersection.surface, intersection.level,
                   "intersection at node " + std::to_string(intersection.node)});
  return all;
}

// Ground of two surfaces of one level, beyond what a level's roadway excuses.
void find_overlap(const std::vector<Surface>& surfaces, Faults& faults) {
  std::map<int, double> roadway, shared;
  for (const Surface& surface : surfaces) roadway[surface.level] += area(*surface.ground);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    for (std::size_t j = i + 1; j < surfaces.size(); ++j) {
      const Surface &a = surfaces[i], &b = surfaces[j];
      if (a.level == b.level) shared[a.level] += shared_area(*a.ground, *b.ground);
    }
  for (const auto& [level, ground] : shared)
    if (ground > 1e-6 * roadway[level])
      faults.push_back("overlap of " + std::to_string(ground) + " m2 on " +
                       std::to_string(roadway[level]) + " m2");
}

// Metres from a place to the nearest of the grounds; 0 on it.
double off(const std::vector<const MultiPolygon*>& grounds, const Point& p) {
  double best = std::numeric_limits<double>::infinity();
  for (const MultiPolygon* ground : grounds)
    for (const Polygon& part : *ground) {
      if (inside(p, part)) return 0;
      for (const Ring& ring : part) best = std::min(best, distance_to_line(p, ring));
    }
  return best;
}

// Edges lie on roadway: all of their length but what the contract gives away.
void find_uncovered(const Streets& town, const std::vector<Surface>& surfaces, Faults& faults) {
  constexpr int steps = 64;
  constexpr double rim = 1e-3;  // metres
  std::vector<Box> boxes;
  std::vector<const MultiPolygon*> grounds;
  for (const Surface& surface : surfaces) {
    if (surface.ground->empty()) continue;
    boxes.push_back(box_of(*surface.ground));
    grounds.push_back(surface.ground);
  }
  const BoxIndex index(boxes);
  double whole = 0, bare = 0, farthest = 0;
  std::size_t worst = 0;
  for (std::size_t e = 0; e < town.network.edges.size(); ++e) {
    const Line& line = town.network.edges[e].line;
    const double total = length(line);
    whole += total;
    for (int i = 0; i < steps; ++i) {
      const Point p = planar(position_at(line, total * (i + 0.5) / steps).point);
      std::vector<const MultiPolygon*> near;
      for (const int s : index.near(box_of(p, p), 1)) near.push_back(grounds[s]);
      const double away = off(near, p);
      if (away <= rim) continue;
      bare += total / steps;
      if (away > farthest) farthest = away, worst = e;
    }
  }
  if (bare > 5e-4 * whole)
    faults.push_back(std::to_string(bare) + " m of " + std::to_string(whole) +
                     " m leave the roadway, edge " + std::to_string(worst) + " by " +
                     std::to_string(farthest) + " m");
}

void find_unfinished(const Streets& town, Faults& faults) {
  const auto finite = [](const Line& line) {
    return std::all_of(line.begin(), line.end(),
                       [](const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); });
  };
  for (const SectionLimit& limit : town.limits)
    if (!std::isfinite(limit.abscissa) || !finite({limit.point}) || !finite(limit.border_line))
      faults.push_back("a limit of edge " + std::to_string(limit.edge) + " is not finite");
  for (const Corner& corner : town.corners)
    if (corner.arc && !finite({corner.arc->start, corner.arc->middle, corner.arc->end}))
      faults.push_back("a corner at node " + std::to_string(corner.node) + " is not finite");
}

// All that the pipeline says, number by number.
class Image {
 public:
  explicit Image(const Streets& town) {
    for (const Node& node : town.network.nodes) {
      put(node.point);
      for (const NodeAnchor& anchor : node.anchors) put(anchor.axis_id), put(anchor.abscissa);
    }
    for (const Edge& edge : town.network.edges) {
      put(edge.axis_id), put(edge.from_node), put(edge.to_node), put(edge.level);
      put(edge.start_abscissa), put(edge.end_abscissa), put(edge.line);
    }
    for (const NetworkReport& report : town.network.reports)
      put(report.issue), put(report.axis_a), put(report.axis_b), put(report.point);
    for (const Corner& corner : town.corners) {
      put(corner.node), put(corner.edge_a), put(corner.edge_b), put(corner.radius);
      put(corner.method), put(corner.centre.value_or(Point{}));
    }
    for (const SectionLimit& limit : town.limits)
      put(limit.abscissa), put(limit.border_line), put(limit.method);
    for (const Section& section : town.sections) put(section.surface), put(section.method);
    for (const Intersection& one : town.intersections) put(one.surface), put(one.method);
  }
  bool operator==(const Image& other) const { return bytes_ == other.bytes_; }

 private:
  template <class T>
  void put(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(values.size());
    for (const T& value : values) put(value);
  }
  std::string bytes_;
};

// Of streets made from the town, with its axes in another order too.
Faults faults_of(const Streets& made, Town town, const StreetOverrides& overrides,
                 std::uint64_t seed) {
  Faults faults;
  for (const Surface& surface : surfaces_of(made))
    if (!sound(*surface.ground)) faults.push_back(surface.name + " is not valid and finite");
  find_unfinished(made, faults);
  std::mt19937_64 shuffled(seed);
  std::shuffle(town.axes.begin(), town.axes.end(), shuffled);
  if (!(Image(streets(town.axes, town.settings, overrides)) == Image(made)))
    faults.push_back("not the same with the axes in another order");
  return faults;
}

}  // namespace

Faults town_faults(const Made& made) { return faults_of(made.streets, made.town, {}, made.seed); }

Faults override_faults(const Made& made) {
  Random random(made.seed);
  const StreetOverrides overrides = random_overrides(random, made.streets);
  const Streets decided = streets(made.town.axes, made.town.settings, overrides);
  Faults faults = faults_of(decided, made.town, overrides, made.seed);
  for (std::size_t e = 0; e < decided.network.edges.size(); ++e) {
    const double start = decided.limits[2 * e].abscissa, end = decided.limits[2 * e + 1].abscissa;
    if (start < -1e-9 || start > end + 1e-6 || end > length(decided.network.edges[e].line) + 1e-6)
      faults.push_back("limits of edge " + std::to_string(e) + " out of order");
  }
  return faults;
}

Faults tiling_faults(const Made& made) {
  const std::vector<Surface> surfaces = surfaces_of(made.streets);
  Faults faults;
  find_overlap(surfaces, faults);
  find_uncovered(made.streets, surfaces, faults);
  return faults;
}

}  // namespace streetgen::fuzz
