#include "streetgen/crossing_line.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/lane.hpp"

namespace streetgen {

namespace {

// Metres.
constexpr double half_line = stop_line_width / 2;
constexpr double room_of_car = 6;  // between two crossings, or a crossing and the line behind it
constexpr double arrow_before_line = 2;
constexpr double equally_near = 0.01;
constexpr double beyond_ends = 30;  // paint lies nowhere farther from a lane

// The way of a lane, which goes straight on at both ends; metres count from where the lane begins.
class Way {
 public:
  explicit Way(const Line& line) : line_(distinct(planar(line))), size_(length(line_)) {
    const std::size_t last = line_.size() - 1;
    const Point before = unit(line_[0] - line_[1]) * beyond_ends;
    const Point behind = unit(line_[last] - line_[last - 1]) * beyond_ends;
    line_.front() = line_.front() + before;
    line_.back() = line_.back() + behind;
  }

  double size() const { return size_; }
  const Line& line() const { return line_; }
  double metres_to(const Point& place) const { return nearest_abscissa(place, line_) - beyond_ends; }
  Point at(double metres) const { return position_at(line_, metres + beyond_ends).point; }

 private:
  Line line_;
  double size_;
};

// A stretch of the way, metres along it.
struct Stretch {
  double from = 0, to = 0;
  double size() const { return to - from; }
};

// Where the driver comes upon a crossing, and has it behind: from where its borders meet the lane
// and its middle.  None beside the lane.
std::optional<Stretch> on_way(const MultiPolygon& ground, const Way& way, double width) {
  std::optional<Stretch> found;
  const auto take = [&](const Point& place) {
    const double metres = way.metres_to(place);
    if (!found) found = {metres, metres};
    *found = {std::min(found->from, metres), std::max(found->to, metres)};
  };
  const Line& middle = way.line();
  const Line lanes[] = {middle, offset_line(middle, width / 2, width / 2),
                        offset_line(middle, -width / 2, -width / 2)};
  for (const Polygon& polygon : ground) {
    const Ring& ring = polygon.front();
    for (std::size_t i = 1; i < ring.size(); ++i) {
      for (const Line& line : lanes)
        for (std::size_t k = 1; k < line.size(); ++k)
          if (const auto met = crossing(ring[i - 1], ring[i], line[k - 1], line[k])) take(*met);
      // A corner at the kerb lies on the border of the lane.
      if (comes_within(ring[i], middle, width / 2 + same_place)) take(ring[i]);
    }
  }
  return found;
}

// Where the driver meets the first crossing of the arm.
std::optional<double> first_of_arm(std::vector<Stretch> crossings, const DrivenLane& lane,
                                   double size, const CrossingRules& rules) {
  std::sort(crossings.begin(), crossings.end(), [](const Stretch& a, const Stretch& b) {
    return std::pair(-a.to, a.from) < std::pair(-b.to, b.from);
  });
  std::optional<double> first;
  for (const Stretch& crossing : crossings) {
    const double before_end = size - crossing.to;
    const bool nearer_behind = lane.between_junctions && before_end > crossing.from + equally_near;
    const double gap = first.value_or(size) - crossing.to;
    if (nearer_behind && gap > (first ? rules.ahead + 2 * half_line : room_of_car)) break;
    if (before_end > rules.of_arm && (!first || gap > room_of_car)) break;
    first = std::min(first.value_or(crossing.from), crossing.from);
  }
  return first;
}

// From a place with one direction to a place with another.
Slide slide_to(const Point& was, const Point& before, const Point& now, const Point& direction) {
  const double cosine = dot(before, direction), sine = cross(before, direction);
  return {cosine, sine, now - Point{cosine * was.x - sine * was.y, sine * was.x + cosine * was.y}};
}

// From a stretch of the way to one that begins elsewhere.
Slide slide_along(const Way& way, const Stretch& old, double from) {
  const Point was = way.at(old.from), now = way.at(from);
  return slide_to(was, unit(way.at(old.to) - was), now, unit(way.at(from + old.size()) - now));
}

// A line that lies beyond the end of its lane may follow a bend there.  It comes to lie square to
// the way, on the half of the lane where it lay if it takes no more: that ends in the middle of the
// lane, to which the way leads on in an even bend.
Slide slide_square(const Way& way, double width, const Line& line, double place) {
  const auto direction_at = [&](double metres) {
    return unit(way.at(metres + half_line) - way.at(metres - half_line));
  };
  const Point middle = (line.front() + line.back()) * 0.5;
  const double left_at = std::min(way.metres_to(middle), way.size());
  const Point across = unit(line.back() - line.front()), leaves = direction_at(left_at);
  const Point along = left_normal(across) * std::copysign(1.0, cross(across, leaves));
  const auto beside = [&](const Point& end) {
    return std::abs(cross(unit(leaves + along), end - way.at(left_at)));
  };
  const Point aside = across * (std::max(0.0, width - distance(line.front(), line.back())) / 2 *
                                (beside(line.front()) < beside(line.back()) ? 1 : -1));
  const Point direction = direction_at(place);
  return slide_to(middle, along,
                  way.at(place) + left_normal(direction) * dot(aside, left_normal(along)),
                  direction);
}

}  // namespace

std::vector<LaidPaint> lay_before_crossings(const DrivenLane& lane,
                                            const std::vector<MultiPolygon>& crossings,
                                            const std::vector<PaintOnLane>& paint,
                                            const CrossingRules& rules) {
  const Way way(lane.way);
  std::vector<Stretch> met;
  for (const MultiPolygon& ground : crossings)
    if (const auto stretch = on_way(ground, way, lane.width)) met.push_back(*stretch);
  const std::optional<double> first = first_of_arm(met, lane, way.size(), rules);
  std::vector<LaidPaint> laid(paint.size());
  double last_tip = first ? *first - rules.ahead : INFINITY;
  for (std::size_t i = 0; i < paint.size(); ++i) {
    if (paint[i].arrow || paint[i].stays || !first) continue;
    const Line& line = paint[i].line;
    const double middle = way.metres_to((line.front() + line.back()) * 0.5);
    const double wanted = *first - rules.ahead - half_line;
    if (middle <= wanted) continue;
    const double place = std::max(wanted, half_line);
    laid[i].slide = slide_square(way, lane.width, line, place);
    laid[i].has_room = place + half_line <= *first;
    last_tip = std::min(last_tip, place - half_line - arrow_before_line);
  }
  for (std::size_t i = 0; i < paint.size(); ++i) {
    if (!paint[i].arrow) continue;
    const Stretch old{way.metres_to(paint[i].line.front()), way.metres_to(paint[i].line.back())};
    std::vector<double> tips{old.to, last_tip};
    for (const Stretch& crossing : met) tips.push_back(crossing.from - rules.ahead);
    std::sort(tips.rbegin(), tips.rend());
    const auto found = std::find_if(tips.begin(), tips.end(), [&](double tip) {
      return tip <= std::min(old.to, last_tip) && tip >= old.size() &&
             std::none_of(met.begin(), met.end(), [&](const Stretch& crossing) {
               return crossing.from < tip && crossing.to > tip - old.size();
             });
    });
    laid[i].has_room = found != tips.end();
    if (laid[i].has_room && *found == old.to) continue;
    laid[i].slide = slide_along(way, old, laid[i].has_room ? *found - old.size() : 0);
  }
  return laid;
}

}  // namespace streetgen
