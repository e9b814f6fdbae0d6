#include "geometry/geos.hpp"

#include <algorithm>
#include <stdexcept>

#include "geometry/polyline.hpp"
#include "geometry/ring_simplicity.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {
// GEOS takes what it makes a whole of, even where it fails: from here on nothing may throw.
std::vector<GEOSGeometry*> released(std::vector<Geos::Geometry>& parts) {
  std::vector<GEOSGeometry*> raw(parts.size());
  std::transform(parts.begin(), parts.end(), raw.begin(),
                 [](Geos::Geometry& part) { return part.release(); });
  return raw;
}

// Metres, where an overlay of doubles fails: a micrometre, but no finer than doubles can take so
// far from the origin.
double coarse_grid(GEOSContextHandle_t handle, const GEOSGeometry* geometry) {
  double min_x = 0, min_y = 0, max_x = 0, max_y = 0;
  GEOSGeom_getExtent_r(handle, geometry, &min_x, &min_y, &max_x, &max_y);
  return std::max({1e-6, -1e-13 * min_x, -1e-13 * min_y, 1e-13 * max_x, 1e-13 * max_y});
}

// An overlay that is interrupted once tries again by other means: it is interrupted each time.
void interrupt_if_wanted() {
  if (cancel_wanted()) GEOS_interruptRequest();
}
}  // namespace

Geos::Geos() : handle_(GEOS_init_r()) {
  if (handle_ == nullptr) throw std::bad_alloc();
  callback_before_ = GEOS_interruptRegisterCallback(interrupt_if_wanted);
}
Geos::~Geos() {
  GEOS_interruptRegisterCallback(callback_before_);
  GEOS_finish_r(handle_);
}

Geos::Geometry Geos::own(GEOSGeometry* geometry) {
  if (geometry == nullptr) {
    poll_cancel();
    throw std::runtime_error("a GEOS operation failed");
  }
  return Geometry(geometry, Free{handle_});
}

GEOSCoordSequence* Geos::sequence(const Line& points) {
  GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(handle_, points.size(), 2);
  if (sequence == nullptr) throw std::bad_alloc();
  for (std::size_t i = 0; i < points.size(); ++i)
    GEOSCoordSeq_setXY_r(handle_, sequence, i, points[i].x, points[i].y);
  return sequence;
}

Geos::Geometry Geos::ring(const Ring& ring) {
  return own(GEOSGeom_createLinearRing_r(handle_, sequence(ring)));
}

Geos::Geometry Geos::polygon(const Polygon& polygon) {
  Geometry shell = ring(polygon.front());
  std::vector<Geometry> holes;
  for (std::size_t i = 1; i < polygon.size(); ++i) holes.push_back(ring(polygon[i]));
  std::vector<GEOSGeometry*> raw = released(holes);
  return own(GEOSGeom_createPolygon_r(handle_, shell.release(), raw.data(), raw.size()));
}

Geos::Geometry Geos::surface(const MultiPolygon& surface) {
  if (surface.size() == 1) return polygon(surface.front());
  std::vector<Geometry> parts;
  for (const Polygon& part : surface) parts.push_back(polygon(part));
  return collection(GEOS_MULTIPOLYGON, std::move(parts));
}

Geos::Geometry Geos::collection(int type, std::vector<Geometry> parts) {
  std::vector<GEOSGeometry*> raw = released(parts);
  return own(GEOSGeom_createCollection_r(handle_, type, raw.data(), raw.size()));
}

void Geos::append(const GEOSGeometry* geometry, MultiPolygon& out) {
  const int type = GEOSGeomTypeId_r(handle_, geometry);
  if (type == GEOS_POLYGON) {
    if (GEOSisEmpty_r(handle_, geometry) == 1) return;
    const auto read = [&](const GEOSGeometry* from, bool counter_clockwise) {
      const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(handle_, from);
      unsigned size = 0;
      GEOSCoordSeq_getSize_r(handle_, sequence, &size);
      Ring ring(size);
      for (unsigned i = 0; i < size; ++i)
        GEOSCoordSeq_getXY_r(handle_, sequence, i, &ring[i].x, &ring[i].y);
      return (signed_area(ring) > 0) == counter_clockwise ? ring : reversed(ring);
    };
    Polygon polygon{read(GEOSGetExteriorRing_r(handle_, geometry), true)};
    const int holes = GEOSGetNumInteriorRings_r(handle_, geometry);
    for (int i = 0; i < holes; ++i)
      polygon.push_back(read(GEOSGetInteriorRingN_r(handle_, geometry, i), false));
    out.push_back(std::move(polygon));
  } else if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
    const int parts = GEOSGetNumGeometries_r(handle_, geometry);
    for (int i = 0; i < parts; ++i) append(GEOSGetGeometryN_r(handle_, geometry, i), out);
  }
}

MultiPolygon Geos::polygons(const GEOSGeometry* geometry) {
  MultiPolygon out;
  append(geometry, out);
  return out;
}

bool Geos::valid(const GEOSGeometry* geometry) {
  poll_cancel();
  const bool valid = GEOSisValid_r(handle_, geometry) == 1;
  poll_cancel();
  return valid;
}

bool Geos::valid(const MultiPolygon& surface) {
  if (const std::optional<bool> known = simple(surface)) return *known;
  return valid(this->surface(surface).get());
}

MultiPolygon Geos::faces(const std::vector<std::pair<Point, Point>>& segments) {
  std::vector<Geometry> lines;
  lines.reserve(segments.size());
  for (const auto& [from, to] : segments)
    lines.push_back(own(GEOSGeom_createLineString_r(handle_, sequence({from, to}))));
  std::vector<const GEOSGeometry*> raw;
  for (const Geometry& line : lines) raw.push_back(line.get());
  return polygons(own(GEOSPolygonize_r(handle_, raw.data(), raw.size())).get());
}

std::vector<Triangle> Geos::triangles(const Polygon& polygon) {
  std::vector<Triangle> triangles;
  const Geometry whole = this->polygon(polygon);
  for (const Polygon& part :
       polygons(own(GEOSConstrainedDelaunayTriangulation_r(handle_, whole.get())).get()))
    triangles.push_back({part[0][0], part[0][1], part[0][2]});
  return triangles;
}

Geos::Geometry Geos::unite(const std::vector<MultiPolygon>& parts) {
  std::vector<Geometry> all;
  for (const MultiPolygon& part : parts)
    for (const Polygon& one : part) {
      Geometry geometry = polygon(one);
      if (!valid(MultiPolygon{one})) geometry = own(GEOSMakeValid_r(handle_, geometry.get()));
      all.push_back(std::move(geometry));
    }
  const Geometry together = collection(GEOS_GEOMETRYCOLLECTION, std::move(all));
  if (GEOSGeometry* result = GEOSUnaryUnion_r(handle_, together.get())) return own(result);
  poll_cancel();
  return own(GEOSUnaryUnionPrec_r(handle_, together.get(), coarse_grid(handle_, together.get())));
}

}  // namespace streetgen
