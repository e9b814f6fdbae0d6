#include "network/face.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

bool before(const EdgeSide& a, const EdgeSide& b) {
  return std::tuple(a.edge, a.part, !a.left) < std::tuple(b.edge, b.part, !b.left);
}

bool ring_before(const FaceRing& a, const FaceRing& b) {
  return before(a.sides.front(), b.sides.front());
}

// The same whatever else crosses the edge.
double millimetres(double metres) { return std::round(metres * 1000) / 1000; }

class FaceFinder {
 public:
  explicit FaceFinder(const std::vector<LineView>& edges)
      : segments_(edges, Arrangement::Asked::ways),
        next_(segments_.side_count()),
        place_(segments_.side_count()),
        starts_(segments_.walk_count()) {
    read_walks();
    for (int edge = 0; edge < static_cast<int>(edges.size()); ++edge) add_sides(edge);
  }

  NetworkFaces find() const {
    const std::vector<double> areas = segments_.areas();
    const std::vector<int> face_of_walk = segments_.faces_of_walks();
    NetworkFaces found;
    std::vector<Face> faces(areas.size());  // by the walk about each
    for (int w = 0; w < segments_.walk_count(); ++w) {
      poll_cancel();
      if (face_of_walk[w] < 0) {
        found.outside.push_back(ring(w));
        continue;
      }
      Face& face = faces[face_of_walk[w]];
      face.area += areas[w];
      face.rings.push_back(ring(w));
      if (face_of_walk[w] == w) std::swap(face.rings.front(), face.rings.back());
    }
    for (Face& face : faces) {
      if (face.rings.empty()) continue;
      std::sort(face.rings.begin() + 1, face.rings.end(), ring_before);
      found.faces.push_back(std::move(face));
    }
    std::sort(found.faces.begin(), found.faces.end(), [](const Face& a, const Face& b) {
      return ring_before(a.rings.front(), b.rings.front());
    });
    std::sort(found.outside.begin(), found.outside.end(), ring_before);
    return found;
  }

 private:
  // A part of an edge's side, and where the walk beside it comes to that.
  struct Start {
    int place;
    EdgeSide side;
  };

  void read_walks() {
    for (int w = 0; w < segments_.walk_count(); ++w) {
      const std::vector<int> sides = segments_.sides_of(w);
      for (std::size_t i = 0; i < sides.size(); ++i) {
        next_[sides[i]] = sides[(i + 1) % sides.size()];
        place_[sides[i]] = static_cast<int>(i);
      }
    }
  }

  // A part ends where the walk leaves the edge. On the right the walk comes the other way.
  void add_sides(int edge) {
    const std::vector<int> way = segments_.way(edge);
    EdgeSide left{edge}, right{edge, false};
    double abscissa = 0;
    for (std::size_t i = 0, first = 0; i < way.size(); ++i) {
      abscissa += distance(segments_.start_of(way[i]), segments_.start_of(way[i] ^ 1));
      const bool last = i + 1 == way.size();
      if (last || next_[way[i]] != way[i + 1]) {
        left.end = millimetres(abscissa);
        add(left, way[first]);
        left = {edge, true, left.part + 1, left.end};
        first = i + 1;
      }
      if (last || next_[way[i + 1] ^ 1] != (way[i] ^ 1)) {
        right.end = millimetres(abscissa);
        add(right, way[i] ^ 1);
        right = {edge, false, right.part + 1, right.end};
      }
    }
  }

  void add(const EdgeSide& part, int first) {
    starts_[segments_.walk_of(first)].push_back({place_[first], part});
  }

  // From the smallest place on.
  FaceRing ring(int walk) const {
    std::vector<Start> starts = starts_[walk];
    const auto smallest =
        std::min_element(starts.begin(), starts.end(),
                         [](const Start& a, const Start& b) { return before(a.side, b.side); });
    std::vector<int> sides = segments_.sides_of(walk);
    const int begin = smallest->place, size = static_cast<int>(sides.size());
    for (Start& start : starts) start.place = (start.place - begin + size) % size;
    std::sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) {
      return a.place != b.place ? a.place < b.place : before(a.side, b.side);
    });
    std::rotate(sides.begin(), sides.begin() + begin, sides.end());
    FaceRing ring;
    for (const Start& start : starts) ring.sides.push_back(start.side);
    for (const int side : sides) ring.line.push_back(segments_.start_of(side));
    ring.line.push_back(ring.line.front());
    return ring;
  }

  const Arrangement segments_;
  std::vector<int> next_, place_;  // of each side: the next one of its walk, and its place there
  std::vector<std::vector<Start>> starts_;  // by walk
};

}  // namespace

NetworkFaces find_faces(const std::vector<LineView>& edges) { return FaceFinder(edges).find(); }

NetworkFaces find_faces(const Network& network, int level) {
  std::vector<LineView> edges;
  for (const Edge& edge : network.edges)
    edges.push_back(edge.level == level ? LineView(edge.line) : LineView(nullptr, 0));
  return find_faces(edges);
}

}  // namespace streetgen
