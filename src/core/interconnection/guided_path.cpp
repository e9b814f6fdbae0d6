#include "interconnection/guided_path.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

constexpr double farthest_aside = 30;   // metres from a node at which two pieces may meet
constexpr double parallel_sine = 1e-6;  // sine of an angle that is none
constexpr double shortest = 1e-3;       // metres
constexpr double shift_ratio = 3;       // metres along for each metre that a path moves aside
constexpr double unfollowed = 0.3;      // metres aside that no driver follows
constexpr double lead = 0.5;            // metres that a path stays on the course of its lanes

// A straight piece of the guide, endless.
struct Guide {
  Point place, direction;
};

std::optional<Point> meeting(const Guide& a, const Guide& b) {
  const double sine = cross(a.direction, b.direction);
  if (std::abs(sine) < 0.1) return std::nullopt;
  return a.place + a.direction * (cross(b.place - a.place, b.direction) / sine);
}

// The corner where two pieces that follow each other at a node meet; if nearly parallel, a way
// from the one to the other about the node.
void append_corner(Line& guide, const Guide& a, const Guide& b, const Point& node) {
  const std::optional<Point> place = meeting(a, b);
  if (place && distance(*place, node) <= farthest_aside) {
    guide.push_back(*place);
    return;
  }
  const Point from = a.place + a.direction * dot(node - a.place, a.direction);
  const Point to = b.place + b.direction * dot(node - b.place, b.direction);
  const double half = shift_ratio * distance(from, to) / 2;
  guide.push_back(from - a.direction * half);
  guide.push_back(to + b.direction * half);
}

Line driven(const InnerEdge& edge, bool along) {
  const double aside = along ? edge.offset_along : edge.offset_against;
  Line line;
  for (std::size_t i = 1; i < edge.line.size(); ++i) {
    const Point direction = unit(planar(edge.line[i]) - planar(edge.line[i - 1]));
    if (norm(direction) == 0) continue;
    const Point shift = left_normal(direction) * aside;
    if (line.empty()) line.push_back(planar(edge.line[i - 1]) + shift);
    line.push_back(planar(edge.line[i]) + shift);
  }
  return along ? line : reversed(std::move(line));
}

// Without corners that turn back from the one before, or from which the last two points turn back.
Line forward_only(const Line& guide, const LaneEnd& out) {
  Line kept{guide[0], guide[1]};
  for (std::size_t i = 2; i + 2 < guide.size(); ++i) {
    const Point ahead = guide[i] - kept.back(), from = kept.back() - kept[kept.size() - 2];
    const bool last = i + 3 == guide.size();
    if (norm(ahead) < shortest || dot(unit(ahead), unit(from)) < -0.5 ||
        (last && dot(guide[i + 1] - guide[i], out.direction) < 0))
      continue;
    kept.push_back(guide[i]);
  }
  kept.insert(kept.end(), guide.end() - 2, guide.end());
  return kept;
}

// Without corners that lie beside the way from the one before to the next; the first two and the
// last two lead the path in and out.
Line without_slight_corners(const Line& guide) {
  Line kept{guide[0], guide[1]};
  for (std::size_t i = 2; i + 2 < guide.size(); ++i)
    if (distance_to_segment(guide[i], kept.back(), guide[i + 1]) > unfollowed)
      kept.push_back(guide[i]);
  kept.insert(kept.end(), guide.end() - 2, guide.end());
  return kept;
}

void append_rounded(Line& line, const Point& corner, const Point& from, const Point& to,
                    double tangent, double tolerance) {
  const Point start = corner - from * tangent, end = corner + to * tangent;
  const double turn = std::atan2(cross(from, to), dot(from, to));
  if (std::abs(turn) < parallel_sine || tangent < shortest) {
    line.push_back(corner);
    return;
  }
  const double radius = tangent / std::tan(std::abs(turn) / 2);
  const double step = 2 * std::acos(std::max(1 - tolerance / std::max(radius, tolerance), 0.5));
  const int chords = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / step)));
  const Point centre = start + left_normal(from) * (turn > 0 ? radius : -radius);
  const Point ray = start - centre;
  // Rounding would turn the line for nothing where the arc before ends in the same place.
  for (int i = distance(line.back(), start) < shortest ? 1 : 0; i <= chords; ++i) {
    const double angle = turn * i / chords;
    line.push_back(centre + ray * std::cos(angle) + left_normal(ray) * std::sin(angle));
  }
  line.back() = end;
}

}  // namespace

Line rounded(const Line& guide, double widest, double tolerance) {
  const std::size_t n = guide.size();
  std::vector<Point> along(n - 1);
  std::vector<double> size(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    size[i] = distance(guide[i], guide[i + 1]);
    along[i] = unit(guide[i + 1] - guide[i]);
  }
  std::vector<double> wish(n, 0);  // the tangent of an arc of radius 1 at each corner
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double turn = std::atan2(cross(along[i - 1], along[i]), dot(along[i - 1], along[i]));
    wish[i] = std::tan(std::min(std::abs(turn), 3.0) / 2);
  }
  // The corners at both ends of a piece share it, so that their arcs may have one radius; the first
  // and the last piece stay straight at their ends.
  const auto share = [&](std::size_t piece, std::size_t corner) {
    const std::size_t other = corner == piece ? piece + 1 : piece;
    if (other == 0 || other + 1 == n) return 0.8 * size[piece];
    const double both = wish[corner] + wish[other];
    return both > parallel_sine ? size[piece] * wish[corner] / both : 0;
  };
  Line line{guide.front()};
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double tangent = std::min({share(i - 1, i), share(i, i), widest * wish[i]});
    append_rounded(line, guide[i], along[i - 1], along[i], tangent, tolerance);
  }
  line.push_back(guide.back());
  // An arc may end where the next corner is, which is straight.
  return without_noise(line);
}

Line guided_path(const JunctionPlace& place, const JunctionRoute& route, const LaneEnd& in,
                 const LaneEnd& out, double widest, double tolerance) {
  Line guide{in.place, in.place + in.direction * lead};
  Guide last{in.place, in.direction};
  for (const RoutePiece& piece : route) {
    const InnerEdge& edge = place.inner[piece.inner];
    const Line line = driven(edge, piece.along);
    if (line.size() < 2) continue;
    const Guide first{line[0], unit(line[1] - line[0])};
    append_corner(guide, last, first,
                  planar(place.nodes[piece.along ? edge.from_node : edge.to_node]));
    guide.insert(guide.end(), line.begin() + 1, line.end() - 1);
    last = {line.back(), unit(line.back() - line[line.size() - 2])};
  }
  const Guide end{out.place, out.direction};
  if (!route.empty()) {
    const InnerEdge& edge = place.inner[route.back().inner];
    append_corner(guide, last, end,
                  planar(place.nodes[route.back().along ? edge.to_node : edge.from_node]));
  } else if (const auto corner = meeting(last, end)) {
    guide.push_back(*corner);
  }
  guide.push_back(out.place - out.direction * lead);
  guide.push_back(out.place);
  return rounded(without_slight_corners(forward_only(guide, out)), widest, tolerance);
}

}  // namespace streetgen
