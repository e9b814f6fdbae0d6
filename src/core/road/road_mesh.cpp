// The surface between two offsets: ArcRoad::mesh.
#include <algorithm>
#include <cmath>

#include "geometry/space.hpp"
#include "geometry/tolerance.hpp"
#include "road/bend_loop.hpp"
#include "road/road_body.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

// A place of the road and the direction across it. A sharp bend has several.
struct CrossLine {
  Point place;
  Point left;
};

constexpr int most_halvings = 10;  // of a step in space, where the road comes near the vertical

class Stations {
 public:
  Stations(const RoadBody& road, double reach, double tolerance)
      : reach_(reach), tolerance_(tolerance) {
    for (std::size_t i = 0; i < road.pieces.size(); ++i) {
      poll_cancel();
      const RoadPiece& piece = road.pieces[i];
      if (i > 0) turn_to(piece.forward);
      add(piece.origin, piece.forward);
      const double reached = piece.radius + reach_;
      const std::size_t count =
          piece.curved() ? chord_count(piece.angle(), reached, tolerance_) : 1;
      for (std::size_t k = 1; k <= count; ++k)
        add_step(piece, piece.length * (k - 1) / count, piece.length * k / count,
                 road.flat ? 0 : most_halvings);
    }
  }
  const std::vector<CrossLine>& all() const { return stations_; }

 private:
  void add(const Point& place, const Point& direction) {
    const CrossLine next{place, leftwards(direction)};
    if (!stations_.empty() && space::distance(stations_.back().place, place) <= rounding &&
        norm(stations_.back().left - next.left) * reach_ <= same_place)
      return;
    stations_.push_back(next);
  }

  // The stations of a sharp bend, about its point.
  void turn_to(const Point& direction) {
    const CrossLine from = stations_.back();
    const Point to = leftwards(direction);
    const double angle = std::atan2(cross(from.left, to), dot(from.left, to));
    if (std::abs(angle) * reach_ <= same_place) return;
    const std::size_t count = chord_count(std::abs(angle), reach_, tolerance_);
    for (std::size_t k = 1; k < count; ++k) {
      const double at = angle * k / count;
      stations_.push_back(
          {from.place, from.left * std::cos(at) + left_normal(from.left) * std::sin(at)});
    }
  }

  // In space a border may leave its chord by more than the arc does: then the step is halved.
  void add_step(const RoadPiece& piece, double from, double to, int halvings) {
    const double middle = (from + to) / 2;
    if (halvings > 0 && piece.curved() && leaves(piece, from, middle, to)) {
      add_step(piece, from, middle, halvings - 1);
      add_step(piece, middle, to, halvings - 1);
    } else {
      add(piece.point(to), piece.direction(to));
    }
  }

  bool leaves(const RoadPiece& piece, double from, double middle, double to) const {
    for (const double offset : {-reach_, reach_}) {
      const auto border = [&](double at) {
        return piece.point(at) + leftwards(piece.direction(at)) * offset;
      };
      const Point chord = (border(from) + border(to)) * 0.5;
      if (space::distance(border(middle), chord) > tolerance_) return true;
    }
    return false;
  }

  double reach_, tolerance_;
  std::vector<CrossLine> stations_;
};

// A step that still runs back is a loop that the chords leave open: it becomes its middle.
void shut_steps_back(const std::vector<RawBorderPiece>& border, Line& points) {
  for (std::size_t first = 0; first < border.size(); ++first) {
    std::size_t last = first;
    while (last < border.size() && border[last].turned_over) ++last;
    if (last == first) continue;
    const Point middle = (points[first] + points[last]) * 0.5;
    for (std::size_t i = first; i <= last; ++i) points[i] = middle;
    first = last;
  }
}

// A point for each station: beside it, or where the border meets itself.
Line border_of(const std::vector<CrossLine>& stations, double offset, double tolerance) {
  Line points;
  points.reserve(stations.size());
  for (const CrossLine& station : stations) points.push_back(station.place + station.left * offset);
  std::vector<RoadPiece> road;
  std::vector<RawBorderPiece> border;
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    road.push_back(straight_piece(planar(stations[i].place), planar(stations[i + 1].place)));
    const Point along = left_normal(stations[i].left + stations[i + 1].left) * -1;
    const Point step = points[i + 1] - points[i];
    border.push_back({straight_piece(planar(points[i]), planar(points[i + 1])), i,
                      dot(step, along) < -rounding * norm(along)});
  }
  const std::vector<BorderPart> parts = without_bend_loops(border, road, offset, 2 * tolerance);
  if (parts.empty()) return points;
  const auto place = [&](const BorderPart& part, double at) {
    const RoadPiece& piece = border[part.index].piece;
    const Point &a = points[part.index], &b = points[part.index + 1];
    return piece.length > 0 ? a + (b - a) * (at / piece.length) : a;
  };
  std::size_t next = 0;  // the first point that no part has settled
  for (const BorderPart& part : parts) {
    const Point start = place(part, part.from);
    const std::size_t first = part.from > 0 ? part.index + 1 : part.index;
    for (; next < first; ++next) points[next] = start;
    if (part.to < border[part.index].piece.length) continue;
    next = std::max(next, part.index + 1);
  }
  const Point end = place(parts.back(), parts.back().to);
  if (parts.back().to < border[parts.back().index].piece.length ||
      parts.back().index + 1 < border.size())
    for (std::size_t i = std::max(next, parts.back().index + 1); i < points.size(); ++i)
      points[i] = end;
  shut_steps_back(border, points);
  for (std::size_t i = 1; i < points.size(); ++i)
    if (space::distance(points[i - 1], points[i]) <= same_place) points[i] = points[i - 1];
  return points;
}

}  // namespace

std::vector<Triangle> road_mesh(const RoadBody& road, double offset_left, double offset_right,
                                double tolerance) {
  const double reach = std::max(std::abs(offset_left), std::abs(offset_right));
  const Stations stations(road, reach, tolerance);
  const Line left = border_of(stations.all(), offset_left, tolerance);
  const Line right = border_of(stations.all(), offset_right, tolerance);
  std::vector<Triangle> triangles;
  triangles.reserve(2 * left.size());
  const auto differ = [](const Point& a, const Point& b) { return !same(a, b) || a.z != b.z; };
  for (std::size_t i = 0; i + 1 < left.size(); ++i) {
    if (differ(right[i], right[i + 1])) triangles.push_back({left[i], right[i], right[i + 1]});
    if (differ(left[i], left[i + 1])) triangles.push_back({left[i], right[i + 1], left[i + 1]});
  }
  return triangles;
}

}  // namespace streetgen
