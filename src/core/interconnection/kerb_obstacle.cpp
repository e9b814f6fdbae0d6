#include "interconnection/kerb_obstacle.hpp"

#include <algorithm>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

int border_along(const Point& a, const Point& b, const std::vector<Line>& border_lines) {
  for (std::size_t i = 0; i < border_lines.size(); ++i) {
    const Point &left = border_lines[i][0], &right = border_lines[i][1];
    const Box box = box_of(left, right);
    if (box.holds(a, same_place) && box.holds(b, same_place) &&
        distance_to_segment(a, left, right) < same_place &&
        distance_to_segment(b, left, right) < same_place)
      return static_cast<int>(i);
  }
  return -1;
}

// Whether one goes through the other; a touch does not count.
bool cross_each_other(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point ab = b - a, cd = d - c;
  return cross(ab, c - a) * cross(ab, d - a) < 0 && cross(cd, a - c) * cross(cd, b - c) < 0;
}

// Are segments that do not cross so near? An end of one is nearest to the other.
bool nearer_than(double reach, const Point& a, const Point& b, const Point& c, const Point& d) {
  return reach > 0 &&
         (distance_to_segment(a, c, d) < reach || distance_to_segment(b, c, d) < reach ||
          distance_to_segment(c, a, b) < reach || distance_to_segment(d, a, b) < reach);
}

}  // namespace

Kerbs::Kerbs(const MultiPolygon& intersection, const std::vector<Line>& border_lines) {
  std::size_t count = 0;
  for (const Polygon& polygon : intersection)
    for (const Ring& ring : polygon) count += ring.size();
  pieces_.reserve(count);
  for (const Polygon& polygon : intersection)
    for (std::size_t r = 0; r < polygon.size(); ++r) {
      const bool left = (signed_area(polygon[r]) > 0) == (r == 0);
      const Ring ring = left ? polygon[r] : reversed(polygon[r]);
      const std::size_t first = pieces_.size();
      for (std::size_t i = 1; i < ring.size(); ++i)
        pieces_.push_back({ring[i - 1], ring[i], box_of(ring[i - 1], ring[i]),
                           border_along(ring[i - 1], ring[i], border_lines), pieces_.size() + 1});
      if (pieces_.size() > first) pieces_.back().next = first;
    }
}

// Wherever a ring begins: of offers that are nearer to each other than the clearance, the one that
// is nearer to the middle of the kerbs.
std::vector<Point> Kerbs::bulges(double clearance) const {
  std::vector<std::pair<double, Point>> offers;
  const Point middle = middle_of_pieces();
  const auto offer = [&](const Point& place) {
    offers.emplace_back(distance(place, middle), place);
  };
  for (const Piece& piece : pieces_) {
    const Piece& next = pieces_[piece.next];
    const Point along = unit(piece.end - piece.start), beyond = unit(next.end - next.start);
    if ((piece.border >= 0 && next.border >= 0) || cross(along, beyond) > -same_place) continue;
    const Point left = left_normal(along) * clearance,
                left_beyond = left_normal(beyond) * clearance;
    offer(piece.end + left);
    // A sharp bulge is gone round at its tip.
    if (dot(along, beyond) < 0)
      offer(piece.end + (along - beyond) * (clearance / norm(along - beyond)));
    offer(piece.end + left_beyond);
  }
  std::sort(offers.begin(), offers.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Point> places;
  for (const auto& [away, place] : offers)
    if (std::none_of(places.begin(), places.end(), [&, place = place](const Point& other) {
          return distance(place, other) < clearance;
        }))
      places.push_back(place);
  return places;
}

Point Kerbs::middle_of_pieces() const {
  if (pieces_.empty()) return {};
  const Point& origin = pieces_[0].start;
  Point sum;
  double size = 0;
  for (const Piece& piece : pieces_) {
    const double metres = distance(piece.start, piece.end);
    sum = sum + ((piece.start + piece.end) * 0.5 - origin) * metres;
    size += metres;
  }
  return size > 0 ? origin + sum * (1 / size) : origin;
}

bool Kerbs::stop(const Line& path, int border_in, int border_out, double clearance) const {
  Box around;
  std::vector<Box> boxes;  // of the path's segments
  boxes.reserve(path.size());
  for (std::size_t i = 1; i < path.size(); ++i) {
    boxes.push_back(box_of(path[i - 1], path[i]));
    around = around.joined_with(boxes.back());
  }
  for (const Piece& piece : pieces_) {
    if (piece.border >= 0 && (piece.border == border_in || piece.border == border_out)) continue;
    const double apart = piece.border < 0 ? clearance : 0;
    if (!piece.box.meets(around, apart)) continue;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (boxes[i].meets(piece.box, apart) &&
          (cross_each_other(path[i], path[i + 1], piece.start, piece.end) ||
           nearer_than(apart, path[i], path[i + 1], piece.start, piece.end)))
        return true;
  }
  return false;
}

}  // namespace streetgen
