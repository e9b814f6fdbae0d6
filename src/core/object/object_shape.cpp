#include "streetgen/object_shape.hpp"

#include <array>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/space.hpp"

namespace streetgen {

namespace {

constexpr int sides = 8, rings = 6;

void add(SurfaceMesh& mesh, const Point& a, const Point& b, const Point& c) {
  const Point normal = space::unit(space::cross(b - a, c - a));
  mesh.triangles.push_back({{a, b, c}});
  mesh.normals.insert(mesh.normals.end(), 3, normal);
  mesh.texture.insert(mesh.texture.end(), 3, {0, 0});
}

void add(SurfaceMesh& mesh, const Point& a, const Point& b, const Point& c, const Point& d) {
  add(mesh, a, b, c);
  add(mesh, a, c, d);
}

Point on_circle(double radius, double height, int side) {
  const double angle = 2 * M_PI * side / sides;
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

// An upright column with a top.
void add_column(SurfaceMesh& mesh, double radius, double top) {
  for (int i = 0; i < sides; ++i) {
    add(mesh, on_circle(radius, 0, i), on_circle(radius, 0, i + 1), on_circle(radius, top, i + 1),
        on_circle(radius, top, i));
    add(mesh, on_circle(radius, top, i), on_circle(radius, top, i + 1), {0, 0, top});
  }
}

void add_ball(SurfaceMesh& mesh, double radius, double middle) {
  const auto place = [&](int ring, int side) {
    const double angle = M_PI * ring / rings - M_PI / 2;
    return on_circle(radius * std::cos(angle), middle + radius * std::sin(angle), side);
  };
  for (int ring = 0; ring < rings; ++ring)
    for (int i = 0; i < sides; ++i) {
      if (ring > 0) add(mesh, place(ring, i), place(ring, i + 1), place(ring + 1, i + 1));
      if (ring + 1 < rings) add(mesh, place(ring, i), place(ring + 1, i + 1), place(ring + 1, i));
    }
}

// Its middle lies aside of the foot by `north`.
void add_box(SurfaceMesh& mesh, double wide, double deep, double from, double to,
             double north = 0) {
  const double x = wide / 2, y = deep / 2;
  const std::array<Point, 4> foot{
      {{-x, north - y, from}, {x, north - y, from}, {x, north + y, from}, {-x, north + y, from}}};
  const auto top = [&](int i) { return Point{foot[i].x, foot[i].y, to}; };
  for (int i = 0; i < 4; ++i) add(mesh, foot[i], foot[(i + 1) % 4], top((i + 1) % 4), top(i));
  add(mesh, top(0), top(1), top(2), top(3));
  add(mesh, foot[3], foot[2], foot[1], foot[0]);
}

}  // namespace

ObjectShape object_shape(const std::string& kind) {
  ObjectShape shape;
  if (kind == "arrow" || kind == "calming" || kind == "manhole") return shape;
  if (kind == "tree") {
    add_column(shape.post, 0.15, 3);
    add_ball(shape.head, 2, 4.5);
  } else if (kind == "lamp") {
    add_column(shape.post, 0.08, 6);
    add_box(shape.head, 0.3, 0.7, 5.9, 6.05, 0.25);
  } else if (kind == "traffic_light") {
    add_column(shape.post, 0.08, 2.5);
    add_box(shape.head, 0.3, 0.3, 2.5, 3.4);
  } else if (kind == "signal") {
    add_box(shape.head, 0.3, 0.3, 5, 5.9);
  } else if (kind == "sign" || kind == "bus_stop" || kind == "tram_stop") {
    add_column(shape.post, 0.04, 2.8);
    add_box(shape.head, 0.6, 0.04, 2.1, 2.7, 0.05);
  } else if (kind == "protection") {
    add_column(shape.head, 0.1, 0.9);
  } else if (kind == "furniture") {
    add_box(shape.head, 1.5, 0.5, 0, 0.5);
  } else {
    add_column(shape.head, 0.1, 3);
  }
  return shape;
}

}  // namespace streetgen
