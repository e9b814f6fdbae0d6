#include "geometry/polyline.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {

double length(const Line& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
  return sum;
}

Line reversed(Line line) {
  std::reverse(line.begin(), line.end());
  return line;
}

Line planar(Line line) {
  for (Point& p : line) p.z = 0;
  return line;
}

Line distinct(Line line) {
  const auto repeats = [](const Point& p, const Point& q) { return distance(p, q) == 0; };
  line.erase(std::unique(line.begin(), line.end(), repeats), line.end());
  return line;
}

Line without_noise(const Line& line) {
  Line out{line.front()};
  for (const Point& place : line)
    if (distance(place, out.back()) > least_piece) out.push_back(place);
  if (out.size() > 1 && distance(out.back(), line.back()) <= least_piece) out.pop_back();
  out.push_back(line.back());
  return out.size() > 2 || distance(line.front(), line.back()) > least_piece ? out : line;
}

LinePosition position_at(const Line& line, double abscissa) {
  double before = 0;
  const std::size_t last = line.size() - 2;
  for (std::size_t i = 0;; ++i) {
    const double d = distance(line[i], line[i + 1]);
    if (i == last || (abscissa < before + d)) {
      const double t = d > 0 ? std::clamp((abscissa - before) / d, 0.0, 1.0) : 0.0;
      const Point p = t == 1 ? line[i + 1] : line[i] + (line[i + 1] - line[i]) * t;
      return {i, p, unit(line[i + 1] - line[i])};
    }
    before += d;
  }
}

Point local_direction(const Line& line, double abscissa) {
  constexpr double reach = 0.1;
  const Point before = position_at(line, abscissa - reach).point;
  const Point after = position_at(line, abscissa + reach).point;
  const Point direction = unit(after - before);
  return norm(direction) > 0 ? direction : position_at(line, abscissa).direction;
}

Line substring(const Line& line, double u, double v) {
  if (u > v) return reversed(substring(line, v, u));
  Line out;
  out.reserve(line.size() + 1);
  out.push_back(position_at(line, u).point);
  double before = 0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    before += distance(line[i - 1], line[i]);
    if (before >= v) break;
    if (before > u) out.push_back(line[i]);
  }
  out.push_back(position_at(line, v).point);
  return out;
}

Point nearest_on_segment(const Point& p, const Point& a, const Point& b) {
  const Point ab = b - a;
  const double square = dot(ab, ab);
  return a + ab * (square > 0 ? std::clamp(dot(p - a, ab) / square, 0.0, 1.0) : 0.0);
}

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  return distance(p, nearest_on_segment(p, a, b));
}

std::optional<Point> crossing(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point ab = b - a, cd = d - c;
  const double sine = cross(ab, cd);
  if (sine == 0) return std::nullopt;
  const double t = cross(c - a, cd) / sine, u = cross(c - a, ab) / sine;
  if (t < 0 || t > 1 || u < 0 || u > 1) return std::nullopt;
  return a + ab * t;
}

double distance_to_line(const Point& p, const Line& line) {
  poll_cancel();
  double best = distance(p, line.front());
  for (std::size_t i = 1; i < line.size(); ++i)
    best = std::min(best, distance_to_segment(p, line[i - 1], line[i]));
  return best;
}

double nearest_abscissa(const Point& p, const Line& line) {
  double before = 0, best = 0, least = infinite;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double apart = distance_to_segment(p, line[i - 1], line[i]);
    const double size = distance(line[i - 1], line[i]);
    if (apart < least) {
      least = apart;
      best = before + std::clamp(dot(p - line[i - 1], unit(line[i] - line[i - 1])), 0.0, size);
    }
    before += size;
  }
  return best;
}

bool comes_within(const Point& p, const Line& line, double reach) {
  poll_cancel();
  if (distance(p, line.front()) < reach) return true;
  for (std::size_t i = 1; i < line.size(); ++i)
    if (distance_to_segment(p, line[i - 1], line[i]) < reach) return true;
  return false;
}

void append_arc(Ring& ring, const Point& centre, const Point& from, const Point& to,
                bool counter_clockwise, int quarter) {
  const double start = std::atan2(from.y - centre.y, from.x - centre.x);
  double sweep = std::atan2(to.y - centre.y, to.x - centre.x) - start;
  if (counter_clockwise && sweep < 0) sweep += 2 * M_PI;
  if (!counter_clockwise && sweep > 0) sweep -= 2 * M_PI;
  const double radius_from = distance(centre, from), radius_to = distance(centre, to);
  const int chords =
      std::max(1, static_cast<int>(std::ceil((std::abs(sweep) - same_angle) / M_PI_2 * quarter)));
  for (int i = 1; i < chords; ++i) {
    const double t = static_cast<double>(i) / chords;
    const double radius = radius_from + (radius_to - radius_from) * t;
    ring.push_back({centre.x + radius * std::cos(start + sweep * t),
                    centre.y + radius * std::sin(start + sweep * t), 0});
  }
}

double signed_area(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 1; i < ring.size(); ++i)
    sum += cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
  return sum / 2;
}

double area(const MultiPolygon& surface) {
  double sum = 0;
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon) sum += signed_area(ring);
  return sum;
}

}  // namespace streetgen
