#include "road/path_guide.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/polyline.hpp"
#include "road/heading.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

// Metres between two points of a guide, at most; a longer path has `most_points`.
constexpr double spacing = 1;
constexpr int least_points = 8, most_points = 60;
// Metres.  Two parts of a path meet across a lane that is shorter.
constexpr double joint = 0.1;
// Metres over which a path that bends turns; a shorter bend is a kink.
constexpr double bend_length = 2;
// Metres, and a share.  A curve that sets out and arrives as its path does may be tighter than the
// path by so much, but a gentle one by more.
constexpr double gentle_radius = 30, hardly = 1.03;
// Radians.  An end that turns less leads where its lane does.
constexpr double no_kink = 0.02;

Line without_joints(const Line& path) {
  Line out{path.front()};
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
    if (distance(path[i], out.back()) > joint && distance(path[i], path.back()) > joint)
      out.push_back(path[i]);
  out.push_back(path.back());
  return out;
}

// The line moved so that its ends lie at two points: each place as far as it is near to the end.
Line led(const Line& path, const Point& from, const Point& to) {
  const Point at_start = from - path.front(), at_end = to - path.back();
  const double total = length(path);
  double s = 0;
  Line out;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0) s += distance(path[i - 1], path[i]);
    out.push_back(path[i] + at_start * (1 - s / total) + at_end * (s / total));
  }
  return out;
}

Line with_points(const Line& path, double apart) {
  Line out{path.front()};
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point side = path[i] - path[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(norm(side) / apart - 1e-9)));
    for (int k = 1; k < parts; ++k)
      out.push_back(path[i - 1] + side * (static_cast<double>(k) / parts));
    out.push_back(path[i]);
  }
  return out;
}

// Stations and headings, and the length and the last heading that follow from them.
void read_headings(PathGuide& guide) {
  double s = 0, heading = guide.from.heading;
  const auto note = [&](double at, double next) {
    heading += std::remainder(next - heading, 2 * M_PI);
    guide.stations.push_back(at);
    guide.headings.push_back(heading);
  };
  note(0, heading);
  for (std::size_t i = 1; i < guide.points.size(); ++i) {
    const Point side = guide.points[i] - guide.points[i - 1];
    note(s + norm(side) / 2, heading_of(side));
    s += norm(side);
  }
  note(s, guide.to.heading);
  guide.length = s;
  guide.to.heading = heading;
}

// The ends of the path do not count: it may turn into lanes there.
double sharpest_bend(const PathGuide& guide, double over) {
  const std::vector<double>&s = guide.stations, &h = guide.headings;
  double most = 0;
  for (std::size_t i = 1; i + 1 < h.size(); ++i)
    for (std::size_t k = i + 1; k + 1 < h.size(); ++k) {
      const double length = s[k] - s[i];
      if (length < over && length < guide.length / 2) continue;
      most = std::max(most, std::abs(h[k] - h[i]) / length);
      if (length > 2 * over) break;
    }
  return most;
}

// The direction in which a parabola or an arc through the first points sets out.  Its chords
// change evenly.
Point way_out(const Line& path) {
  const Point first = path[1] - path[0];
  if (path.size() < 3) return first;
  const Point second = path[2] - path[1];
  const double ratio = norm(second) / norm(first);
  return ratio < 0.4 || ratio > 2.5 ? first : first + (first - second) * 0.5;
}

// Radians between a heading and the direction in which the path sets out.
double kink(const Line& path, double heading) {
  const Point way = along(heading);
  return std::min(std::abs(turn_from(way, way_out(path))),
                  std::abs(turn_from(way, path[1] - path[0])));
}

// Metres that a curve needs beside a kink, for its sharpest arc at the kink and for its way back.
struct Room {
  double aside = 0, over = 1;
};
Room room_at(double kink, double most_curvature) {
  constexpr double reserve = 1.3, way_back = 4;
  if (kink < no_kink) return {};
  const double radius = 1 / most_curvature;
  return {reserve * radius * (1 - std::cos(kink)), way_back + 2 * radius * kink};
}

double aside_at(const Room& room, double away) { return room.aside * (1 - away / room.over); }

}  // namespace

PathGuide path_guide(const Line& path, const ChainPlace& from, const ChainPlace& to,
                     double tolerance, double lane_width) {
  PathGuide guide;
  guide.from = {planar(from.point), from.heading};
  guide.to = {planar(to.point), to.heading};
  const Line line = led(without_joints(path), guide.from.point, guide.to.point);
  const double total = length(line);
  guide.points =
      with_points(line, std::max(total / most_points, std::min(spacing, total / least_points)));
  read_headings(guide);
  const double kink_from = kink(line, from.heading);
  const double kink_to = kink(reversed(line), to.heading + M_PI);
  // Where its ends lead as the lanes do, a curve is hardly tighter than its path.
  const bool as_lanes = std::max(kink_from, kink_to) < no_kink;
  const double widest = std::max(least_curve_radius, lane_width / 2);
  const double tight =
      as_lanes ? std::max(hardly * sharpest_bend(guide, spacing), 1 / gentle_radius) : infinite;
  guide.most_curvature = std::max(std::min(tight, 1 / widest), sharpest_bend(guide, bend_length));
  const Room first = room_at(kink_from, guide.most_curvature);
  const Room last = room_at(kink_to, guide.most_curvature);
  double s = 0;
  for (std::size_t i = 0; i < guide.points.size(); ++i) {
    if (i > 0) s += distance(guide.points[i - 1], guide.points[i]);
    guide.reach.push_back(tolerance +
                          std::max({0.0, aside_at(first, s), aside_at(last, guide.length - s)}));
  }
  return guide;
}

std::vector<ChainArc> first_arcs(const PathGuide& guide, int count) {
  const std::vector<double>&s = guide.stations, &h = guide.headings;
  double turns = 0;
  for (std::size_t i = 1; i < h.size(); ++i) turns += std::abs(h[i] - h[i - 1]);
  const auto share = [&](std::size_t i) {
    return (s[i] - s[i - 1]) / guide.length + (turns > 0 ? std::abs(h[i] - h[i - 1]) / turns : 0);
  };
  const double all = turns > 0 ? 2 : 1;
  std::vector<ChainArc> arcs;
  double passed = 0, at = 0, heading = h.front();
  std::size_t i = 1;
  for (int k = 1; k <= count; ++k) {
    const double wanted = all * k / count;
    while (i + 1 < h.size() && passed + share(i) < wanted) passed += share(i++);
    const double part = std::clamp((wanted - passed) / share(i), 0.0, 1.0);
    const double next = s[i - 1] + (s[i] - s[i - 1]) * part;
    const double turned = h[i - 1] + (h[i] - h[i - 1]) * part;
    const double length = std::max(next - at, guide.length * 1e-3);
    arcs.push_back({length, (turned - heading) / length});
    at = next;
    heading = turned;
  }
  return arcs;
}

}  // namespace streetgen
