#include "streetgen/border_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "geometry/polyline.hpp"
#include "lane/bound_side.hpp"
#include "road/heading.hpp"
#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

// Metres. Stations that are nearer to each other become one.
constexpr double same_station = 1e-3;
// Metres. Two points of a border are no nearer to each other, but for its ends.
constexpr double shortest_side = 0.1;
// Of the loop of a border that a bend turned over, such a share leads back at least; a road that
// passes over itself has none.
constexpr double turned_over = 0.2;
// One by metres. What bends more confuses readers.
constexpr double sharpest_bend = 0.5;
// Metres. A lane across a junction may get so much wider where that spares a sharp bend.
constexpr double widening = 0.4;
// Metres. How far the border inside a turn without room goes round it, and how wide.
constexpr double nose_length = 0.5, nose_width = 0.2;
// The tip is at most so far of the way from the middle of the border outside to the nearer end.
constexpr double nearest_tip = 0.8;
// Each side of a border that needs points all along is at most such a part of it.
constexpr int sides_all_along = 8;

struct BorderPoint {
  Point point;
  double s = 0;  // metres along the chain
};

using Border = std::vector<BorderPoint>;

// The value is straight between stations, and as at the first and the last one beyond them.
double value_at(const std::vector<double>& stations, const std::vector<double>& values, double s) {
  const auto next = std::upper_bound(stations.begin(), stations.end(), s);
  if (next == stations.begin()) return values.front();
  if (next == stations.end()) return values.back();
  const std::size_t i = next - stations.begin();
  const double share = (s - stations[i - 1]) / (stations[i] - stations[i - 1]);
  return values[i - 1] + (values[i] - values[i - 1]) * share;
}

// The border that lies farthest beside an arc needs the most chords.
int chords_of(const PlanPiece& piece, double farthest, double tolerance) {
  const double bend = std::max(std::abs(piece.curvature), std::abs(piece.curvature_end));
  const double chords = piece.length * std::sqrt(bend * (1 + bend * farthest) / (8 * tolerance));
  return std::max(1, static_cast<int>(std::ceil(chords)));
}

std::vector<double> looks_along(const BorderCourse& course, double tolerance) {
  double farthest = 0;
  for (const auto& border : course.borders)
    for (const double aside : border) farthest = std::max(farthest, std::abs(aside));
  const double end = course.stations.back();
  std::vector<double> all = course.stations;
  for (const double s : course.height_stations)
    if (s > 0 && s < end) all.push_back(s);
  for (const PlanPiece& piece : course.chain) {
    const int chords = chords_of(piece, farthest, tolerance);
    for (int i = 0; i < chords; ++i) all.push_back(piece.s + piece.length * i / chords);
  }
  std::sort(all.begin(), all.end());
  std::vector<double> at{all.front()};
  for (const double s : all)
    if (s - at.back() >= same_station && end - s >= same_station) at.push_back(s);
  at.push_back(end);
  return at;
}

// Radians that a chain turns between two stations.
double turn_between(const std::vector<PlanPiece>& chain, double from, double to) {
  double sum = 0;
  for (const PlanPiece& piece : chain) {
    const double a = std::clamp(from - piece.s, 0.0, piece.length);
    const double b = std::clamp(to - piece.s, 0.0, piece.length);
    if (b <= a) continue;
    const double grows = (piece.curvature_end - piece.curvature) / piece.length;
    sum += (b - a) * (piece.curvature + grows * (a + b) / 2);
  }
  return sum;
}

// The border inside a turn that has no room for it: from one end to the other round a nose, whose
// tip is nearer to the middle of the border outside than the ends are, at most so wide.
Line round_a_nose(const Line& ends, const Point& outside, double width, bool leftwards) {
  const Point &a = ends.front(), &b = ends.back();
  const Point base = (a + b) * 0.5, to = planar(outside - base);
  const double apart = std::min(distance(a, outside), distance(b, outside));
  const double room = std::min(width, nearest_tip * apart);
  const Point ahead = unit(to);
  const Point tip = base + ahead * std::max(nose_length * std::min(1.0, norm(to)), norm(to) - room);
  const Point aside = left_normal(ahead) * (nose_width / 2 * (leftwards ? 1 : -1));
  return {a, base - aside, tip - aside, tip + aside, base + aside, b};
}

std::vector<Border> raw_borders(const BorderCourse& course, double tolerance) {
  std::vector<Border> borders(course.borders.size());
  for (const double s : looks_along(course, tolerance)) {
    const ChainPlace place = place_at(course.chain, s);
    const Point left = left_normal(along(place.heading));
    const double height =
        course.heights.empty() ? 0 : value_at(course.height_stations, course.heights, s);
    for (std::size_t b = 0; b < borders.size(); ++b) {
      Point p = place.point + left * value_at(course.stations, course.borders[b], s);
      p.z = height;
      borders[b].push_back({p, s});
    }
  }
  return borders;
}

class Unfolding {
 public:
  Unfolding(const std::vector<PlanPiece>& chain, Border border)
      : chain_(chain), border_(std::move(border)) {}

  Border unfolded() {
    cut_loops();
    drop_what_leads_back();
    return std::move(border_);
  }

 private:
  // A side leads on as the chain does at both its ends.
  bool leads_on(const BorderPoint& a, const BorderPoint& b) const {
    const Point side = b.point - a.point;
    return dot(side, along(place_at(chain_, a.s).heading)) > 0 &&
           dot(side, along(place_at(chain_, b.s).heading)) > 0;
  }

  // Metres of sides up to each point, and of those among them that lead back.
  struct Led {
    std::vector<double> all{0}, back{0};
  };

  Led led() const {
    Led led;
    for (std::size_t i = 0; i + 1 < border_.size(); ++i) {
      const double side = distance(border_[i].point, border_[i + 1].point);
      led.all.push_back(led.all.back() + side);
      led.back.push_back(led.back.back() + (leads_on(border_[i], border_[i + 1]) ? 0 : side));
    }
    return led;
  }

  std::optional<BorderPoint> crossing_of(std::size_t i, std::size_t j) const {
    const BorderPoint &a = border_[i], &b = border_[i + 1], &c = border_[j], &d = border_[j + 1];
    const auto place = crossing(a.point, b.point, c.point, d.point);
    if (!place) return std::nullopt;
    return BorderPoint{{place->x, place->y, (b.point.z + c.point.z) / 2}, (b.s + c.s) / 2};
  }

  // The longest loop from each side goes out, where a bend turned it over.
  void cut_loops() {
    const Led led = this->led();
    if (led.back.back() == 0) return;
    Border out{border_.front()};
    for (std::size_t i = 0; i + 1 < border_.size();) {
      poll_cancel();
      std::size_t next = i + 1;
      for (std::size_t j = border_.size() - 2; j > i + 1 && led.back[j] > led.back[i + 1]; --j) {
        const double back = led.back[j] - led.back[i + 1];
        if (back < turned_over * (led.all[j] - led.all[i + 1])) continue;
        const auto place = crossing_of(i, j);
        if (!place) continue;
        out.push_back(*place);
        next = j + 1;
        break;
      }
      out.push_back(border_[next]);
      i = next;
    }
    border_ = std::move(out);
  }

  // A loop that an end leaves open is left at once.
  void drop_what_leads_back() {
    Border out{border_.front()};
    for (std::size_t i = 1; i + 1 < border_.size(); ++i)
      if (leads_on(out.back(), border_[i])) out.push_back(border_[i]);
    while (out.size() > 1 && !leads_on(out.back(), border_.back())) out.pop_back();
    out.push_back(border_.back());
    border_ = std::move(out);
  }

  const std::vector<PlanPiece>& chain_;
  Border border_;
};

// The distance of a point from where the side from a to b passes it, aside or in height.
double off(const BorderPoint& p, const BorderPoint& a, const BorderPoint& b) {
  const double share = b.s > a.s ? (p.s - a.s) / (b.s - a.s) : 0;
  const double height = a.point.z + (b.point.z - a.point.z) * share;
  return std::max(distance_to_segment(p.point, a.point, b.point), std::abs(p.point.z - height));
}

// The points that a line within the tolerance needs.
Border needed_points(const Border& border, double tolerance) {
  Border out{border.front()};
  std::vector<std::size_t> ends{border.size() - 1};
  for (std::size_t first = 0; !ends.empty();) {
    const std::size_t last = ends.back();
    std::size_t farthest = first;
    double most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double here = off(border[i], border[first], border[last]);
      if (here > most) most = here, farthest = i;
    }
    if (farthest != first) {
      ends.push_back(farthest);
      continue;
    }
    out.push_back(border[last]);
    ends.pop_back();
    first = last;
  }
  return out;
}

// One by metres, of the circle through three points.
double bend(const Point& a, const Point& b, const Point& c) {
  const double sides = distance(a, b) * distance(b, c) * distance(c, a);
  return sides > 0 ? 2 * std::abs(cross(b - a, c - b)) / sides : infinite;
}

// The side of a border on which the lane lies that is not to get narrower.
enum class InnerSide { none, left, right };

// Points that make a sharp bend are left out, where the border lies within the tolerance of what is
// left, or the lane gets wider by a little.
class Blunting {
 public:
  Blunting(const Border& border, double tolerance, InnerSide lane)
      : border_(border), tolerance_(tolerance), lane_(lane) {
    for (std::size_t i = 0; i < border.size(); ++i) kept_.push_back(i);
  }

  Border blunted() {
    for (std::size_t k = 1; k + 1 < kept_.size();) {
      if (bend(at(k - 1), at(k), at(k + 1)) <= sharpest_bend || !leave_out_about(k))
        ++k;
      else
        k = k > 2 ? k - 2 : 1;
    }
    Border out;
    for (const std::size_t i : kept_) out.push_back(border_[i]);
    return out;
  }

 private:
  const Point& at(std::size_t k) const { return border_[kept_[k]].point; }

  bool in_lane(const Point& p, const Point& from, const Point& to) const {
    const double left = cross(to - from, p - from);
    return lane_ == InnerSide::left ? left > 0 : lane_ == InnerSide::right && left < 0;
  }

  // The share of what a border may be off by which it is, without the point.
  double off_without(std::size_t k) const {
    const BorderPoint &from = border_[kept_[k - 1]], &to = border_[kept_[k + 1]];
    double most = 0;
    for (std::size_t i = kept_[k - 1] + 1; i < kept_[k + 1]; ++i) {
      const bool wider = in_lane(border_[i].point, from.point, to.point);
      most = std::max(most, off(border_[i], from, to) / (wider ? widening : tolerance_));
    }
    return most;
  }

  // The point or one beside it, whichever matters least.
  bool leave_out_about(std::size_t k) {
    std::size_t best = k;
    double least = off_without(k);
    for (const std::size_t other : {k - 1, k + 1})
      if (other > 0 && other + 1 < kept_.size() && off_without(other) < least)
        least = off_without(best = other);
    if (least > 1) return false;
    kept_.erase(kept_.begin() + best);
    return true;
  }

  const Border& border_;
  double tolerance_;
  InnerSide lane_;
  std::vector<std::size_t> kept_;
};

Line without_short_sides(const Border& border) {
  const Point& end = border.back().point;
  Line line{border.front().point};
  for (std::size_t i = 1; i + 1 < border.size(); ++i) {
    const Point& p = border[i].point;
    if (distance(p, line.back()) >= shortest_side && distance(p, end) >= shortest_side)
      line.push_back(p);
  }
  line.push_back(end);
  return line;
}

// The line with a point wherever a side is too long a part of it.
Line with_points_all_along(const Line& line) {
  const double longest = length(line) / sides_all_along;
  Line out{line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point side = line[i] - line[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(norm(side) / longest)));
    for (int k = 1; k < parts; ++k) out.push_back(line[i - 1] + side * (double(k) / parts));
    out.push_back(line[i]);
  }
  return out;
}

}  // namespace

std::vector<Line> border_lines(const BorderCourse& course, const std::vector<BorderEnds>& ends,
                               double tolerance) {
  // Half of the tolerance goes to chords of arcs, half to points that are left out.
  std::vector<Border> borders = raw_borders(course, tolerance / 2);
  std::vector<Line> lines;
  for (std::size_t b = 0; b < borders.size(); ++b) {
    if (b < ends.size()) {
      borders[b].front().point = {ends[b].from.x, ends[b].from.y, borders[b].front().point.z};
      borders[b].back().point = {ends[b].to.x, ends[b].to.y, borders[b].back().point.z};
    }
    const Border unfolded = Unfolding(course.chain, std::move(borders[b])).unfolded();
    const Border needed = needed_points(unfolded, tolerance / 2);
    const InnerSide inside = ends.empty() ? InnerSide::none
                             : b == 0     ? InnerSide::right
                                          : InnerSide::left;
    lines.push_back(without_short_sides(Blunting(needed, 2 * tolerance, inside).blunted()));
  }
  const bool leftwards = turn_between(course.chain, 0, course.stations.back()) > 0;
  for (std::size_t b = 1; b < lines.size(); ++b) {
    Line &left = lines[b - 1], &right = lines[b];
    if (are_bounds(left, right)) continue;
    // A reader looks at the middle point, which is to lie about the middle.
    for (Line* line : {&left, &right}) *line = with_points_all_along(*line);
    if (are_bounds(left, right)) continue;
    // A border between two lanes goes round none: it is outside of the one inside.
    if (leftwards ? b > 1 : b + 1 < lines.size()) continue;
    Line& inner = leftwards ? left : right;
    const Point outside = middle_point(leftwards ? right : left);
    inner = round_a_nose(inner, outside, distance(left.front(), right.front()), leftwards);
    // A way that goes about in a ring narrower than its lane is straight.
    if (!ends.empty() && !are_bounds(left, right))
      for (Line* line : {&left, &right}) *line = {line->front(), line->back()};
  }
  return lines;
}

}  // namespace streetgen
