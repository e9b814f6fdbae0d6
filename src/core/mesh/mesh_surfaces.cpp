#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/box_index.hpp"
#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/space.hpp"
#include "mesh/axis_height.hpp"
#include "mesh/border_net.hpp"
#include "mesh/breakline.hpp"
#include "mesh/kerb_face.hpp"
#include "mesh/texture_place.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/surface_mesh.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

// Metres between places of a border where the height is looked at, and of its shortest piece.
constexpr double height_step = 0.5, shortest_piece = 1;
constexpr int most_steps = 400;

class LevelMesh {
 public:
  LevelMesh(const std::vector<const MeshedSurface*>& surfaces, int level,
            const std::vector<HeightAxis>& axes, const AxisHeight& height, double tolerance)
      : surfaces_(surfaces),
        level_(level),
        height_(height),
        tolerance_(tolerance),
        net_(grounds(surfaces)),
        kerbs_(net_, surfaces),
        breaklines_(surfaces.size()) {
    // Half of the tolerance is for the axis that is broken less often, half for what lies flat.
    for (const HeightAxis& axis : axes)
      if (axis.level == level) axes_.push_back(without_slight_bends(axis.line, tolerance / 2));
    if (axes_.empty()) return;
    break_surfaces();
    for (int side = 0; side < static_cast<int>(net_.side_count()); ++side) {
      poll_cancel();
      follow_height(side);
    }
  }

  GroundMesh mesh(std::size_t surface, Geos& geos) {
    poll_cancel();
    GroundMesh made;
    made.ground.triangles = triangles(surface, geos);
    made.kerb.triangles = kerbs_.faces(surface, made.ground.triangles);
    finish_ground(*surfaces_[surface], made.ground);
    finish_kerb(*surfaces_[surface], made.kerb);
    return made;
  }

 private:
  static std::vector<const MultiPolygon*> grounds(
      const std::vector<const MeshedSurface*>& surfaces) {
    std::vector<const MultiPolygon*> all;
    for (const MeshedSurface* surface : surfaces) all.push_back(&surface->surface);
    return all;
  }
  const MultiPolygon& ground(std::size_t surface) const { return surfaces_[surface]->surface; }

  // In the plane.
  std::vector<Triangle> triangles(std::size_t surface, Geos& geos) {
    std::vector<BorderNet::Segment> segments = net_.border(surface);
    const auto kept = apart(net_, segments, breaklines_[surface]);
    segments.insert(segments.end(), kept.begin(), kept.end());
    std::vector<std::pair<Point, Point>> lines;
    for (const auto& [from, to] : segments) lines.emplace_back(net_.point(from), net_.point(to));
    std::vector<Triangle> all;
    for (const Polygon& face : geos.faces(lines)) {
      const std::vector<Triangle> part = geos.triangles(face);
      if (!part.empty() && inside(middle(part), ground(surface)))
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }

  // Heights, normals and texture coordinates, once for each place.
  void finish_ground(const MeshedSurface& surface, SurfaceMesh& mesh) {
    struct Corner {
      double height;
      Point normal;
      std::array<double, 2> texture;
    };
    std::map<std::pair<double, double>, Corner> known;
    for (Triangle& triangle : mesh.triangles)
      for (Point& corner : triangle) {
        const auto [found, added] = known.try_emplace({corner.x, corner.y});
        if (added)
          found->second = {height(corner) + surface.raised, height_.normal(corner, level_),
                           texture_place(surface.line, corner)};
        corner.z = found->second.height;
        mesh.normals.push_back(found->second.normal);
        mesh.texture.push_back(found->second.texture);
      }
  }

  // Corners of a kerb come with what they lie above the height of their place.
  void finish_kerb(const MeshedSurface& surface, SurfaceMesh& mesh) {
    for (Triangle& triangle : mesh.triangles) {
      const auto& [a, b, c] = triangle;
      const Point normal = space::unit(space::cross(b - a, c - a));
      const double foot = std::min({a.z, b.z, c.z});
      for (Point& corner : triangle) {
        mesh.normals.push_back(normal);
        mesh.texture.push_back({texture_place(surface.line, corner)[0], corner.z - foot});
        corner.z += height(corner);
      }
    }
  }

  double height(const Point& place) { return height_.at(place, level_); }

  // A place deep in a face: the middle of its greatest triangle.
  static Point middle(const std::vector<Triangle>& part) {
    const auto area = [](const Triangle& t) { return cross(t[1] - t[0], t[2] - t[0]); };
    const Triangle& most =
        *std::max_element(part.begin(), part.end(),
                          [&](const Triangle& a, const Triangle& b) { return area(a) < area(b); });
    return (most[0] + most[1] + most[2]) * (1.0 / 3);
  }

  void break_surfaces() {
    std::vector<Box> boxes;
    for (const Line& axis : axes_) boxes.push_back(box_of(MultiPolygon{{axis}}));
    const BoxIndex index(boxes);
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      poll_cancel();
      const std::vector<int> near = index.near(box_of(ground(i)), 0);
      if (lies_level(i, near)) continue;
      for (const int axis : near) add_breaklines(net_, i, ground(i), axes_[axis], breaklines_[i]);
      end_at_border(net_, i, ground(i), breaklines_[i]);
    }
  }

  // Whether the heights of a surface differ so little that no breakline is worth it.
  bool lies_level(std::size_t surface, const std::vector<int>& near) {
    double least = infinite, most = -least;
    const auto see = [&](double z) {
      least = std::min(least, z);
      most = std::max(most, z);
    };
    for (const int side : net_.sides(surface)) {
      see(height(net_.from(side)));
      see(height(net_.to(side)));
    }
    for (const int axis : near)
      for (const Point& p : axes_[axis])
        if (inside(p, ground(surface))) see(p.z);
    return most - least <= tolerance_ / 2;
  }

  // Divides the pieces of a side where the height leaves their chord most, until it hardly does.
  void follow_height(int side) {
    const Point start = net_.from(side);
    const double size = distance(start, net_.to(side));
    std::vector<std::pair<Point, Point>> open;
    const std::vector<int> vertices = net_.along(side);
    for (std::size_t i = 1; i < vertices.size(); ++i)
      open.emplace_back(net_.point(vertices[i - 1]), net_.point(vertices[i]));
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      if (distance(a, b) < shortest_piece) continue;
      const Point place = farthest_off(a, b);
      if (same(place, a)) continue;
      const Point middle = net_.point(net_.divide(side, distance(start, place) / size));
      if (same(middle, a) || same(middle, b)) continue;
      open.insert(open.end(), {{a, middle}, {middle, b}});
    }
  }

  // The place between two others where the height leaves their chord by the most; the first where
  // that is within the tolerance.
  Point farthest_off(const Point& a, const Point& b) {
    const double start = height(a), rise = height(b) - start;
    const int steps =
        std::clamp(static_cast<int>(std::ceil(distance(a, b) / height_step)), 2, most_steps);
    double most = tolerance_;
    Point farthest = a;
    for (int i = 1; i < steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      const Point place = a + (b - a) * share;
      const double off = std::abs(height(place) - start - rise * share);
      if (off <= most) continue;
      most = off;
      farthest = place;
    }
    return farthest;
  }

  const std::vector<const MeshedSurface*>& surfaces_;
  int level_;
  const AxisHeight& height_;
  double tolerance_;
  BorderNet net_;
  KerbFaces kerbs_;
  std::vector<Line> axes_;
  std::vector<Breaklines> breaklines_;
};

}  // namespace

std::vector<GroundMesh> mesh_surfaces(const std::vector<MeshedSurface>& surfaces,
                                      const std::vector<HeightAxis>& axes, double tolerance) {
  std::map<int, std::vector<std::size_t>> levels;
  for (std::size_t i = 0; i < surfaces.size(); ++i) levels[surfaces[i].level].push_back(i);
  const AxisHeight height(axes);
  Geos geos;
  std::vector<GroundMesh> meshes(surfaces.size());
  for (const auto& [level, members] : levels) {
    std::vector<const MeshedSurface*> of_level;
    for (const std::size_t i : members) of_level.push_back(&surfaces[i]);
    LevelMesh level_mesh(of_level, level, axes, height, tolerance);
    for (std::size_t k = 0; k < members.size(); ++k)
      if (surfaces[members[k]].wanted) meshes[members[k]] = level_mesh.mesh(k, geos);
  }
  return meshes;
}

}  // namespace streetgen
