#include "sidewalk/strip.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/closed_ring.hpp"
#include "geometry/polyline.hpp"
#include "geometry/ring_simplicity.hpp"
#include "geometry/surface_union.hpp"
#include "geometry/tolerance.hpp"
#include "sidewalk/straight_end.hpp"
#include "streetgen/cancel.hpp"
#include "strip/back_line.hpp"
#include "strip/bend.hpp"
#include "strip/kerb_front.hpp"

namespace streetgen {

namespace {

// A strip may lie so far from its kerb, in widths: its own, or that of a strip beside it. A back
// line that turns where the width changes is farther off than the strip is wide.
constexpr double spread = 1.25;

// The vertices of a kerb, and its places where the change of width begins or ends.
struct WidthCourse {
  Line line;
  std::vector<double> widths;
  std::vector<Point> alongs;  // that the kerb comes from, towards each

  void add(const Point& point, double width, const Point& along) {
    if (!line.empty() && distance(line.back(), point) == 0 && widths.back() == width) return;
    line.push_back(planar(point));
    widths.push_back(width);
    alongs.push_back(along);
  }
};

double width_of(const std::vector<WidthKnot>& knots, double at) {
  std::size_t k = 0;
  while (k + 1 < knots.size() && knots[k + 1].abscissa < at) ++k;
  if (k + 1 == knots.size()) return knots[k].width;
  const double size = knots[k + 1].abscissa - knots[k].abscissa;
  const double share = size > 0 ? std::clamp((at - knots[k].abscissa) / size, 0.0, 1.0) : 1;
  return knots[k].width + (knots[k + 1].width - knots[k].width) * share;
}

double mean_of(const std::vector<WidthKnot>& knots) {
  const double size = knots.back().abscissa - knots.front().abscissa;
  if (size <= 0) return (knots.front().width + knots.back().width) / 2;
  double sum = 0, least = knots.front().width, most = least;
  for (std::size_t k = 1; k < knots.size(); ++k) {
    sum += (knots[k].abscissa - knots[k - 1].abscissa) * (knots[k - 1].width + knots[k].width) / 2;
    least = std::min(least, knots[k].width);
    most = std::max(most, knots[k].width);
  }
  return std::clamp(sum / size, least, most);
}

WidthCourse course_of(const Line& line, const std::vector<WidthKnot>& knots) {
  WidthCourse course;
  course.add(line[0], knots.front().width, {});
  double before = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double at = before + distance(line[i - 1], line[i]);
    const Point along = at > before ? unit(line[i] - line[i - 1]) : Point{};
    for (const WidthKnot& knot : knots)
      if (knot.abscissa > before + same_place && knot.abscissa < at - same_place)
        course.add(
            line[i - 1] + (line[i] - line[i - 1]) * ((knot.abscissa - before) / (at - before)),
            knot.width, along);
    course.add(line[i], i + 1 == line.size() ? knots.back().width : width_of(knots, at), along);
    before = at;
  }
  return course;
}

// Whether no vertex of the ring is farther from the line than `reach`. Vertices that follow each
// other lie near segments that do, so the search goes out from the last one found.
bool stays_near(const Ring& ring, const Line& line, double reach) {
  const std::size_t many = line.size() - 1;
  std::size_t nearest = 0;
  return std::all_of(ring.begin(), ring.end(), [&](const Point& place) {
    poll_cancel();
    for (std::size_t away = 0; away <= many; ++away)
      for (const std::size_t i : {nearest + away, nearest - away})
        if (i < many && distance_to_segment(place, line[i], line[i + 1]) <= reach) {
          nearest = i;
          return true;
        }
    return false;
  });
}

void append_piece(Ring ring, std::vector<MultiPolygon>& pieces) {
  ring.push_back(ring.front());
  ring = closed(std::move(ring));
  if (!ring.empty() && signed_area(ring) > 0) pieces.push_back({{std::move(ring)}});
}

// About an outer bend, between two directions from there.
void append_fan(const Point& at, double width, const Point& later, const Point& earlier,
                std::vector<MultiPolygon>& pieces) {
  const Point first = at + earlier * width, last = at + later * width;
  Ring fan{at, last};
  append_arc(fan, at, last, first, true, bend_quarter);
  fan.push_back(first);
  append_piece(std::move(fan), pieces);
}

bool bends_outwards(const Point& before, const Point& after) {
  return cross(before, after) < -same_angle;
}

// For any line: a piece behind each segment, and one about each outer bend. Of the bends where a
// strip lies before it and after it the half; their directions there, or zero.
MultiPolygon united_pieces(const WidthCourse& course, const Point& came, const Point& goes) {
  const auto& [line, widths, alongs] = course;
  std::vector<MultiPolygon> pieces;
  Point before;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (distance(line[i - 1], line[i]) == 0) continue;
    const Point& at = line[i - 1];
    const Point& along = alongs[i];
    const Point normal = left_normal(along);
    const double width = widths[i - 1];
    const bool is_first = norm(before) == 0;
    if (is_first && bends_outwards(came, along))
      append_fan(at, width, normal, middle_of_bend(came, along), pieces);
    if (!is_first && bends_outwards(before, along))
      append_fan(at, width, normal, left_normal(before), pieces);
    append_piece({at, line[i], line[i] + normal * widths[i], at + normal * width}, pieces);
    before = along;
  }
  if (bends_outwards(before, goes))
    append_fan(line.back(), widths.back(), middle_of_bend(before, goes), left_normal(before),
               pieces);
  Geos geos;
  return united(geos, pieces);
}

class Strips {
 public:
  Strips(const std::vector<SidewalkKerb>& kerbs, const KerbChains& chains)
      : kerbs_(kerbs),
        chains_(chains),
        strips_(kerbs.size()),
        done_(kerbs.size()),
        ends_ahead_(kerbs.size()),
        ends_behind_(kerbs.size()) {
    for (const SidewalkEnd& end : chains.ends()) make_end(end);
  }

  std::vector<Strip> make() {
    for (int i = 0; i < count(); ++i)
      if (!follows(i)) make_chain(i);
    for (int i = 0; i < count(); ++i) make_chain(i);  // closed ones
    return std::move(strips_);
  }

 private:
  int count() const { return static_cast<int>(kerbs_.size()); }
  bool has_strip(int kerb) const { return kerb >= 0 && !chains_.widths(kerb).empty(); }
  bool follows(int kerb) const { return has_strip(chains_.previous(kerb)); }
  Point came(int kerb) const {
    const int previous = ends_behind_[kerb] ? -1 : chains_.previous(kerb);
    return previous < 0 ? Point{} : direction_at(kerbs_[previous].line, false);
  }
  Point goes(int kerb) const {
    const int next = ends_ahead_[kerb] ? -1 : chains_.next(kerb);
    return next < 0 ? Point{} : direction_at(kerbs_[next].line, true);
  }

  double widest(int kerb) const {
    double most = 0;
    if (kerb >= 0)
      for (const WidthKnot& knot : chains_.widths(kerb)) most = std::max(most, knot.width);
    return most;
  }
  double widest_beside(int kerb) const {
    return std::max({widest(chains_.previous(kerb)), widest(kerb), widest(chains_.next(kerb))});
  }

  // Beside it, the sidewalk ends square.
  void make_end(const SidewalkEnd& end) {
    const double reach = spread * end.width;
    Ring ring = straight_end(kerbs_, end, reach);
    if (ring.empty()) return;
    strips_[end.on.front()] = {{{std::move(ring)}}, end.width, end.width, reach, false};
    (end.ahead ? ends_ahead_ : ends_behind_)[end.beside] = true;
  }

  void make_chain(int first) {
    if (!has_strip(first) || done_[first]) return;
    poll_cancel();
    std::vector<int> chain;
    for (int kerb = first; has_strip(kerb) && !done_[kerb]; kerb = chains_.next(kerb)) {
      done_[kerb] = true;
      chain.push_back(kerb);
    }
    std::vector<WidthCourse> courses;
    std::vector<KerbSegment> segments;
    std::vector<int> begins;
    for (std::size_t k = 0; k < chain.size(); ++k) {
      begins.push_back(static_cast<int>(segments.size()));
      courses.push_back(course_of(kerbs_[chain[k]].line, chains_.widths(chain[k])));
      const auto& [line, widths, alongs] = courses.back();
      for (std::size_t i = 1; i < line.size(); ++i)
        if (distance(line[i - 1], line[i]) > 0)
          segments.push_back(
              {line[i - 1], line[i], widths[i - 1], widths[i], static_cast<int>(k), alongs[i]});
    }
    begins.push_back(static_cast<int>(segments.size()));
    const bool is_closed = chain.size() > 1 && chains_.next(chain.back()) == first;
    const FrontPassed passed = pass_front(segments, is_closed, came(first), goes(chain.back()));
    const BackLine back(segments, passed, is_closed);
    for (std::size_t k = 0; k < chain.size(); ++k)
      make_strip(chain[k], courses[k], passed.grounds[k], back, begins[k], begins[k + 1] - 1);
  }

  void make_strip(int kerb, const WidthCourse& course, const KerbGround& ground,
                  const BackLine& back, int first, int last) {
    Strip& strip = strips_[kerb];
    const std::vector<WidthKnot>& widths = chains_.widths(kerb);
    strip.width = mean_of(widths);
    strip.widest = widest(kerb);
    strip.reach = spread * widest_beside(kerb);
    strip.narrow = ground.narrow;
    if (ground.whole) {
      const Ring ring = ring_behind(course.line, ground, back, first, last);
      if (!ring.empty() && signed_area(ring) > 0 && stays_near(ring, course.line, strip.reach) &&
          simple({{ring}}).value_or(false)) {
        strip.surface = {{ring}};
        return;
      }
    }
    strip.plain = false;
    strip.surface = united_pieces(course, follows(kerb) ? came(kerb) : Point{},
                                  has_strip(chains_.next(kerb)) ? goes(kerb) : Point{});
  }

  const std::vector<SidewalkKerb>& kerbs_;
  const KerbChains& chains_;
  std::vector<Strip> strips_;
  std::vector<bool> done_;
  std::vector<bool> ends_ahead_,
      ends_behind_;  // its sidewalk goes on along a corner, and ends there
};

}  // namespace

std::vector<Strip> strips_behind(const std::vector<SidewalkKerb>& kerbs, const KerbChains& chains) {
  return Strips(kerbs, chains).make();
}

}  // namespace streetgen
