// The one door to GEOS: owned geometries, conversions, the few operations we use.
// Every result is checked.  While one lives, GEOS' process-wide interrupt callback asks cancel.hpp;
// the one before comes back after.
#pragma once

#include <geos_c.h>

#include <memory>
#include <utility>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

class Geos {
 public:
  struct Free {
    GEOSContextHandle_t handle;
    void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(handle, g); }
  };
  using Geometry = std::unique_ptr<GEOSGeometry, Free>;

  Geos();
  ~Geos();
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  Geometry polygon(const Polygon& polygon);
  Geometry surface(const MultiPolygon& surface);
  // The polygons of any geometry, exterior counter-clockwise, holes clockwise; the rest is dropped.
  MultiPolygon polygons(const GEOSGeometry* geometry);

  bool valid(const GEOSGeometry* geometry);
  // Of holes within their polygons and polygons beside each other; GEOS decides where rings touch.
  bool valid(const MultiPolygon& surface);
  // The faces that segments enclose; they meet in common ends only. What dangles is left out.
  MultiPolygon faces(const std::vector<std::pair<Point, Point>>& segments);
  // The constrained Delaunay triangulation of a valid polygon, which adds no vertex.
  std::vector<Triangle> triangles(const Polygon& polygon);
  Geometry unite(const std::vector<MultiPolygon>& parts);  // of any rings

 private:
  Geometry collection(int type, std::vector<Geometry> parts);
  Geometry own(GEOSGeometry* geometry);
  Geometry ring(const Ring& ring);
  GEOSCoordSequence* sequence(const Line& points);
  void append(const GEOSGeometry* geometry, MultiPolygon& out);
  GEOSContextHandle_t handle_;
  GEOSInterruptCallback* callback_before_ = nullptr;
};

}  // namespace streetgen
