#include "block/block_ground.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/arrangement.hpp"
#include "geometry/box.hpp"
#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/ring_simplicity.hpp"
#include "geometry/surface_union.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

// Whether a place on no ring lies on ground: left of the first side of a ring to the east of it, or
// beyond all roadway.
bool on_ground(const Point& place, const std::vector<KerbLoop>& loops) {
  double nearest = infinite;
  bool ground = true;
  for (const KerbLoop& loop : loops) {
    const Box& box = loop.box;
    if (box.min_y > place.y || box.max_y < place.y || box.max_x < place.x || box.min_x > nearest)
      continue;
    for (std::size_t i = 1; i < loop.ring.size(); ++i) {
      const Point &a = loop.ring[i - 1], &b = loop.ring[i];
      if ((a.y > place.y) == (b.y > place.y)) continue;
      const double x = a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y);
      if (x <= place.x || x >= nearest) continue;
      nearest = x;
      ground = b.y > a.y;
    }
  }
  return ground;
}

bool face_holds(const Face& face, const Point& place) {
  Polygon rings;
  for (const FaceRing& ring : face.rings) rings.push_back(ring.line);
  return inside(place, rings);
}

// By the least vertex of the first ring.
void sort(MultiPolygon& surface) {
  std::sort(surface.begin(), surface.end(), [](const Polygon& a, const Polygon& b) {
    const Point &p = a[0][0], &q = b[0][0];
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  });
}

}  // namespace

FaceGround ground_of(const std::vector<const KerbLoop*>& loops) {
  FaceGround ground;
  std::vector<Box> boxes;
  std::vector<double> areas;
  std::vector<const KerbLoop*> holes;
  for (const KerbLoop* loop : loops) {
    const double area = signed_area(loop->ring);
    if (area < -least_part) holes.push_back(loop);
    if (area <= least_part) continue;
    ground.surface.push_back({loop->ring});
    boxes.push_back(loop->box);
    areas.push_back(area);
  }
  for (const KerbLoop* hole : holes) {
    poll_cancel();
    const Point& place = hole->ring.front();
    int around = -1;
    for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
      if ((boxes.size() == 1 ||
           (boxes[i].holds(place, 0) && inside(place, {ground.surface[i][0]}))) &&
          (around < 0 || areas[i] < areas[around]))
        around = i;
    if (around >= 0) ground.surface[around].push_back(hole->ring);
  }
  if (simple(ground.surface).value_or(false)) {
    sort(ground.surface);
    return ground;
  }
  Geos geos;
  if (!geos.valid(ground.surface)) {
    ground.surface = united(geos, {ground.surface});
    ground.by_faces = true;
  }
  sort(ground.surface);
  return ground;
}

std::vector<MultiPolygon> ground_of(const std::vector<const Face*>& faces,
                                    const std::vector<KerbLoop>& loops) {
  std::vector<LineView> lines;
  Box box;
  for (const Face* face : faces)
    for (const FaceRing& ring : face->rings) {
      lines.push_back(ring.line);
      for (const Point& p : ring.line) box.add(p);
    }
  for (const KerbLoop& loop : loops)
    if (loop.box.meets(box)) lines.push_back(loop.ring);
  const Arrangement parts(lines);
  std::vector<std::vector<bool>> kept(faces.size(), std::vector<bool>(parts.places().size()));
  for (std::size_t i = 0; i < parts.places().size(); ++i) {
    poll_cancel();
    const Point& place = parts.places()[i];
    if (!on_ground(place, loops)) continue;
    for (std::size_t f = 0; f < faces.size(); ++f) kept[f][i] = face_holds(*faces[f], place);
  }
  Geos geos;
  std::vector<MultiPolygon> grounds;
  for (const std::vector<bool>& own : kept) {
    grounds.push_back(parts.joined(own));
    if (!geos.valid(grounds.back()))
      grounds.back() = parts.joined(own, Arrangement::Vertices::on_grid);
    sort(grounds.back());
  }
  return grounds;
}

}  // namespace streetgen
