#include "sidewalk/strip.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/ring_simplicity.hpp"
#include "geometry/surface_union.hpp"
#include "geometry/tolerance.hpp"
#include "roadway/surface_ring.hpp"

namespace streetgen {

namespace {

constexpr int join_quarter = 8;
constexpr double mitred_cosine = 0.5;  // sharper inner bends between two kerbs end square

// The vertices of a kerb, and its places where the change of width begins or ends.
struct Course {
  Line line;
  std::vector<double> widths;

  void add(const Point& point, double width) {
    if (!line.empty() && distance(line.back(), point) == 0 && widths.back() == width) return;
    line.push_back(planar(point));
    widths.push_back(width);
  }
};

// A change of width that begins or ends beside a bend does so at the bend, where the sides of the
// strip are shorter than the kerb.
std::vector<WidthKnot> at_bends(const Line& line, std::vector<WidthKnot> knots) {
  constexpr double beside = 0.25;  // widths
  for (std::size_t k = 1; k + 1 < knots.size(); ++k) {
    double at = 0, moved = knots[k].abscissa, least = beside * knots[k].width;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      at += distance(line[i - 1], line[i]);
      if (std::abs(knots[k].abscissa - at) >= least) continue;
      least = std::abs(knots[k].abscissa - at);
      moved = at;
    }
    knots[k].abscissa = moved;
  }
  return knots;
}

double width_of(const std::vector<WidthKnot>& knots, double at) {
  std::size_t k = 0;
  while (k + 1 < knots.size() && knots[k + 1].abscissa < at) ++k;
  if (k + 1 == knots.size()) return knots[k].width;
  const double size = knots[k + 1].abscissa - knots[k].abscissa;
  const double share = size > 0 ? std::clamp((at - knots[k].abscissa) / size, 0.0, 1.0) : 1;
  return knots[k].width + (knots[k + 1].width - knots[k].width) * share;
}

Course course_of(const Line& line, const std::vector<WidthKnot>& widths) {
  const std::vector<WidthKnot> knots = at_bends(line, widths);
  Course course;
  course.add(line[0], knots.front().width);
  double before = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double at = before + distance(line[i - 1], line[i]);
    for (const WidthKnot& knot : knots)
      if (knot.abscissa > before + same_place && knot.abscissa < at - same_place)
        course.add(
            line[i - 1] + (line[i] - line[i - 1]) * ((knot.abscissa - before) / (at - before)),
            knot.width);
    course.add(line[i], i + 1 == line.size() ? knots.back().width : width_of(knots, at));
    before = at;
  }
  return course;
}

// Builds the far side of the strip, and says whether it may be trusted.
class FarSide {
 public:
  void bend(const Point& at, const Point& before, const Point& after, double width, double size) {
    const double cosine = dot(before, after);
    if (cross(before, after) < -straight_sine) {
      side_.push_back(at + left_normal(before) * width);
      go_round(at, before, after, width);
      trim_ = 0;
      return;
    }
    mitre(at, before, after, width, std::max(cosine, -0.999), size);
  }
  void mitre(const Point& at, const Point& before, const Point& after, double width, double cosine,
             double size) {
    const double trim = width * std::sqrt((1 - cosine) / (1 + cosine));
    if (trim_ + trim > size) whole_ = false;
    trim_ = trim;
    side_.push_back(at + (left_normal(before) + left_normal(after)) * (width / (1 + cosine)));
  }
  void go_round(const Point& at, const Point& before, const Point& after, double width) {
    append_arc(side_, at, at + left_normal(before) * width, at + left_normal(after) * width, false,
               join_quarter);
    side_.push_back(at + left_normal(after) * width);
  }
  void put(const Point& point, double size) {
    if (trim_ > size) whole_ = false;
    side_.push_back(point);
  }
  const Line& side() const { return side_; }
  bool whole() const { return whole_; }

 private:
  Line side_;
  double trim_ = 0;  // of the segment before, by the bend before it
  bool whole_ = true;
};

void append_piece(Ring ring, std::vector<MultiPolygon>& pieces) {
  ring.push_back(ring.front());
  ring = closed(std::move(ring));
  if (!ring.empty() && signed_area(ring) > 0) pieces.push_back({{std::move(ring)}});
}

// For any line: a piece behind each segment, and one about each outer bend.
MultiPolygon united_pieces(const Line& line, const std::vector<double>& widths, const Point& came) {
  std::vector<MultiPolygon> pieces;
  Point before = came;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (distance(line[i - 1], line[i]) == 0) continue;
    const Point& at = line[i - 1];
    const Point along = unit(line[i] - at), normal = left_normal(along);
    const double width = widths[i - 1];
    if (cross(before, along) < -straight_sine) {
      Ring fan{at, at + normal * width};
      append_arc(fan, at, at + normal * width, at + left_normal(before) * width, true,
                 join_quarter);
      fan.push_back(at + left_normal(before) * width);
      append_piece(std::move(fan), pieces);
    }
    append_piece({at, line[i], line[i] + normal * widths[i], at + normal * width}, pieces);
    before = along;
  }
  Geos geos;
  return united(geos, pieces);
}

Point direction_at(const Line& line, bool at_start) {
  return at_start ? unit(line[1] - line[0]) : unit(line.back() - line[line.size() - 2]);
}

bool bisected(const Point& before, const Point& after) {
  return cross(before, after) >= -straight_sine && dot(before, after) > mitred_cosine;
}

}  // namespace

Strip strip_behind(const std::vector<SidewalkKerb>& kerbs, const KerbChains& chains, int kerb) {
  const std::vector<WidthKnot>& knots = chains.widths(kerb);
  Strip strip;
  if (knots.empty()) return strip;
  const auto [line, widths] = course_of(kerbs[kerb].line, knots);
  const std::size_t last = line.size() - 1;
  strip.widest = *std::max_element(widths.begin(), widths.end());
  FarSide far;
  const Point first = direction_at(line, true), end = direction_at(line, false);
  const int previous = chains.previous(kerb), next = chains.next(kerb);
  const double start_width = widths.front(), end_width = widths.back();
  const Point came = previous >= 0 ? direction_at(kerbs[previous].line, false) : first;
  if (previous >= 0 && bisected(came, first)) {
    far.mitre(line[0], came, first, start_width, dot(came, first), start_width + 1);
  } else {
    if (previous >= 0 && cross(came, first) < -straight_sine) {
      far.put(line[0] + left_normal(came) * start_width, start_width);
      far.go_round(line[0], came, first, start_width);
    } else {
      far.put(line[0] + left_normal(first) * start_width, start_width);
    }
  }
  Point before = first;
  for (std::size_t i = 1; i < last; ++i) {
    if (distance(line[i], line[i + 1]) == 0) {
      far.put(line[i] + left_normal(before) * widths[i], distance(line[i - 1], line[i]));
      continue;
    }
    const Point after = unit(line[i + 1] - line[i]);
    far.bend(line[i], before, after, widths[i], distance(line[i - 1], line[i]));
    before = after;
  }
  const Point goes = next >= 0 ? direction_at(kerbs[next].line, true) : end;
  const double size = distance(line[last - 1], line[last]);
  if (next >= 0 && bisected(end, goes))
    far.mitre(line[last], end, goes, end_width, dot(end, goes), size);
  else
    far.put(line[last] + left_normal(end) * end_width, size);
  const Line side = reversed(far.side());
  Ring ring = line;
  ring.insert(ring.end(), side.begin(), side.end());
  ring.push_back(ring.front());
  ring = closed(std::move(ring));
  if (far.whole() && !ring.empty() && signed_area(ring) > 0 && simple({{ring}}).value_or(false)) {
    strip.surface = {{std::move(ring)}};
    return strip;
  }
  strip.plain = false;
  strip.surface = united_pieces(line, widths, came);
  return strip;
}

}  // namespace streetgen
