#include "road/road_vertex.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "geometry/space.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

namespace {

void refuse_infinite(const Line& line) {
  for (std::size_t i = 0; i < line.size(); ++i)
    for (const auto& [name, value] :
         {std::pair{"x", line[i].x}, std::pair{"y", line[i].y}, std::pair{"z", line[i].z}})
      if (!std::isfinite(value))
        throw Error(ErrorKind::invalid_input, "vertex " + std::to_string(i + 1) + " has " + name +
                                                  " " + text_of(value) +
                                                  ", expected a finite number");
}

RoadVertices without_repeats(const Line& line, double near) {
  RoadVertices kept;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0 && space::distance(kept.points.back(), line[i]) <= near) continue;
    kept.points.push_back(line[i]);
    kept.numbers.push_back(i);
  }
  if (kept.points.size() > 1) {
    kept.points.back() = line.back();
    kept.numbers.back() = line.size() - 1;
  }
  return kept;
}

double square_from_segment(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double square = space::dot(along, along);
  const double at = square > 0 ? std::clamp(space::dot(p - a, along) / square, 0.0, 1.0) : 0;
  const Point away = p - (a + along * at);
  return space::dot(away, away);
}

bool straight_at(const Line& points, std::size_t i, double near) {
  return space::dot(points[i] - points[i - 1], points[i + 1] - points[i]) > 0 &&
         square_from_segment(points[i], points[i - 1], points[i + 1]) <= near * near;
}

// Points that leave the chord of a run are bends, though each is straight beside the next.
void keep_farthest(const Line& points, std::size_t first, std::size_t last, double near,
                   std::vector<bool>& bends) {
  std::vector<std::pair<std::size_t, std::size_t>> chords{{first, last}};
  while (!chords.empty()) {
    poll_cancel();
    const auto [from, to] = chords.back();
    chords.pop_back();
    double farthest = near * near;
    std::size_t bend = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double square = square_from_segment(points[i], points[from], points[to]);
      if (square > farthest) farthest = square, bend = i;
    }
    if (bend == from) continue;
    bends[bend] = true;
    chords.push_back({from, bend});
    chords.push_back({bend, to});
  }
}

RoadVertices without_straight(RoadVertices all, double near) {
  const Line& points = all.points;
  std::vector<bool> bends(points.size(), true);
  for (std::size_t i = 1; i + 1 < points.size(); ++i) bends[i] = !straight_at(points, i, near);
  for (std::size_t first = 0; first + 1 < points.size();) {
    std::size_t last = first + 1;
    while (!bends[last]) ++last;
    if (last > first + 1) keep_farthest(points, first, last, near, bends);
    first = last;
  }
  RoadVertices kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!bends[i]) continue;
    kept.points.push_back(points[i]);
    kept.numbers.push_back(all.numbers[i]);
  }
  return kept;
}

}  // namespace

double resolution(const Line& points) {
  double greatest = 0;
  for (const Point& p : points)
    greatest = std::max({greatest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return std::max(rounding, 4 * std::numeric_limits<double>::epsilon() * greatest);
}

void refuse_vertical(const Point& from, const Point& to, const char* what, std::size_t number) {
  if (distance(from, to) <= 1e-9 * space::distance(from, to))
    throw Error(ErrorKind::invalid_input, std::string("the piece after ") + what + " " +
                                              std::to_string(number) + " is vertical: it rises " +
                                              text_of(to.z - from.z) + " m over " +
                                              text_of(distance(from, to)) + " m");
}

RoadVertices road_vertices(const Line& line) {
  refuse_infinite(line);
  const double near = resolution(line);
  RoadVertices all;
  if (!line.empty()) all = without_repeats(line, near);
  if (all.points.size() < 2)
    throw Error(
        ErrorKind::invalid_input,
        "the line has no length: its " + std::to_string(line.size()) + " points are one place");
  for (std::size_t i = 0; i + 1 < all.points.size(); ++i) {
    poll_cancel();
    refuse_vertical(all.points[i], all.points[i + 1], "vertex", all.numbers[i] + 1);
  }
  return without_straight(std::move(all), near);
}

}  // namespace streetgen
