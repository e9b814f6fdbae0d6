#include "streetgen/corner.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "layout/course.hpp"
#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

// Where `p`, known to lie on the piece's carrier, lies within the piece.
bool within(const OffsetPiece& piece, const Point& p, double* abscissa) {
  if (piece.arc) {
    const Point from = piece.start - piece.centre, to = piece.end - piece.centre;
    const Point at = p - piece.centre;
    const double turn = cross(from, to), scale = dot(from, from);
    const double sign = turn >= 0 ? 1 : -1;
    if (cross(from, at) * sign < -1e-9 * scale || cross(at, to) * sign < -1e-9 * scale)
      return false;
    if (dot(at, from + to) < 0 && scale > 0) return false;
    *abscissa = piece.start_abscissa;
    return true;
  }
  const Point along = piece.end - piece.start;
  const double size = norm(along);
  const double t = dot(p - piece.start, along) / size;
  if (t < -border_slack || t > size + border_slack) return false;
  *abscissa = std::clamp(piece.start_abscissa + t, piece.start_abscissa, piece.end_abscissa);
  return true;
}

int meet_line_line(const OffsetPiece& a, const OffsetPiece& b, const Point& node, Point out[2]) {
  const Point u = a.end - a.start, v = b.end - b.start, w = b.start - a.start;
  const double d = cross(u, v), nu = norm(u), nv = norm(v);
  if (std::abs(d) > 1e-12 * nu * nv) {
    out[0] = a.start + u * (cross(w, v) / d);
    return 1;
  }
  if (std::abs(cross(u, w)) > border_slack * nu) return 0;
  const Point e = u * (1 / nu);
  const double b0 = dot(b.start - a.start, e), b1 = dot(b.end - a.start, e);
  const double low = std::max(0.0, std::min(b0, b1)), high = std::min(nu, std::max(b0, b1));
  if (low > high + border_slack) return 0;
  out[0] = a.start + e * std::clamp(dot(node - a.start, e), low, std::max(low, high));
  return 1;
}

int meet_line_arc(const OffsetPiece& line, const OffsetPiece& arc, Point out[2]) {
  const Point e = unit(line.end - line.start);
  const double radius = distance(arc.start, arc.centre);
  const double along = dot(arc.centre - line.start, e);
  const Point foot = line.start + e * along;
  const double off = distance(foot, arc.centre);
  if (off > radius + border_slack) return 0;
  const double half = std::sqrt(std::max(0.0, radius * radius - off * off));
  out[0] = foot - e * half;
  out[1] = foot + e * half;
  return 2;
}

int meet_arc_arc(const OffsetPiece& a, const OffsetPiece& b, Point out[2]) {
  const double ra = distance(a.start, a.centre), rb = distance(b.start, b.centre);
  const Point between = b.centre - a.centre;
  const double d = norm(between);
  if (d == 0 || d > ra + rb + border_slack || d < std::abs(ra - rb) - border_slack) return 0;
  const double along = (d * d + ra * ra - rb * rb) / (2 * d);
  const double half = std::sqrt(std::max(0.0, ra * ra - along * along));
  const Point e = between * (1 / d), foot = a.centre + e * along;
  out[0] = foot + left_normal(e) * half;
  out[1] = foot - left_normal(e) * half;
  return 2;
}

Box box_of(const OffsetPiece& piece) {
  const Box box = box_of(piece.start, piece.end);
  if (!piece.arc) return box;
  const double radius = distance(piece.start, piece.centre);
  const double half_chord = distance(piece.start, piece.end) / 2;
  const double rise = radius - std::sqrt(std::max(0.0, radius * radius - half_chord * half_chord));
  return box.grown(rise);
}

constexpr std::size_t worth_an_index = 64;
constexpr std::size_t worth_thinning = 16;

// An axis, or a piece of a course, and, where it is long, its segments by place.
class Axis {
 public:
  Axis(const Line& line, double half) : line_(line), half_(half) {
    if (distance(line.front(), line.back()) == 0) until_ = length(line) / 2 - coordinate_margin;
    if (line.size() <= worth_an_index) return;
    std::vector<Box> boxes(line.size() - 1);
    for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i] = box_of(line[i], line[i + 1]);
    segments_.emplace(boxes);
  }
  Axis(const CoursePiece& piece, bool last) : Axis(piece.line, piece.half) {
    start_ = piece.start;
    if (start_ > 0) until_ = infinite;
    if (half_ == 0) share_ = (piece.end - piece.start) / length(piece.line);
    last_ = last;
  }

  const Line& line() const { return line_; }
  double half() const { return half_; }
  bool first() const { return start_ == 0; }
  // On the course, of a place `at` metres along the line.
  double abscissa(double at) const { return start_ + at * share_; }
  // Of an axis that comes back to its node: its second half leads there from the other side.
  bool leads_back(double at) const { return at > until_; }

  // Whether the place on it that is nearest to p is an end where the width changes.
  bool ends_before(const Point& p) const {
    if (half_ == 0 || (first() && last_)) return false;
    const double at = nearest_abscissa(p, line_);
    return (!first() && at <= 0) || (!last_ && at >= length(line_) - border_slack);
  }

  // Whether it is anywhere nearer to p than `reach`.
  bool comes_within(const Point& p, double reach) const {
    if (!segments_) return streetgen::comes_within(p, line_, reach);
    poll_cancel();
    Box box;
    box.add(p);
    return segments_->any_near(
        box, reach, [&](int i) { return distance_to_segment(p, line_[i], line_[i + 1]) < reach; });
  }

  // Whether one of the segments about the piece's own is nearer than `reach` to all of it.
  bool hides(const OffsetPiece& piece, double reach) const {
    Point tip = piece.start;  // where the tangents at an arc's ends meet
    if (piece.arc) {
      const Point from = piece.start - piece.centre, to = piece.end - piece.centre;
      tip = piece.centre + (from + to) * (1 / (1 + dot(from, to) / dot(from, from)));
    }
    const int own = static_cast<int>(piece.segment), count = static_cast<int>(line_.size()) - 1;
    const auto holds = [&](int i) {
      return i >= 0 && i < count &&
             distance_to_segment(piece.start, line_[i], line_[i + 1]) < reach &&
             distance_to_segment(piece.end, line_[i], line_[i + 1]) < reach &&
             distance_to_segment(tip, line_[i], line_[i + 1]) < reach;
    };
    for (int away = 1; away <= static_cast<int>(worth_an_index); ++away)
      if (holds(own - away) || holds(own + away)) return true;
    return false;
  }

 private:
  const Line& line_;
  double half_;
  double start_ = 0, share_ = 1;  // metres of the course, and of it a metre of the line
  double until_ = infinite;       // metres of the line
  bool last_ = true;
  std::optional<BoxIndex> segments_;
};

using Street = std::vector<Axis>;

struct Foot {
  const Axis* axis;
  double at;  // metres along its line

  double abscissa() const { return axis->abscissa(at); }
  bool leads_back() const { return axis->leads_back(at); }
};

struct Meeting {
  Point centre;
  Foot a, b;
};

// Out from the node along both streets, whichever of them is a.
class WayOut {
 public:
  WayOut(const Point& node, const Street& a, const Street& b)
      : node_(node), from_a_(place_on(a)), from_b_(place_on(b)) {}

  const Point& node() const { return node_; }
  double to(const Meeting& meeting) const {
    return std::abs(meeting.a.abscissa() - from_a_) + std::abs(meeting.b.abscissa() - from_b_);
  }
  // As far as to a piece of a alone.
  double to_piece(const Axis& axis, const OffsetPiece& piece) const {
    const double start = axis.abscissa(piece.start_abscissa) - from_a_,
                 end = axis.abscissa(piece.end_abscissa) - from_a_;
    return std::max({start, -end, 0.0});
  }

 private:
  double place_on(const Street& street) const {
    return nearest_abscissa(node_, street.front().line());
  }

  Point node_;
  double from_a_, from_b_;  // 0 where the axes start at the node
};

// The offset border. That of the first piece has the quarter of its round end behind the node:
// where a wide axis meets a narrow one nearly straight on, the circle touches the wide one's end.
class Border {
 public:
  Border(const Axis& axis, double radius, int side)
      : axis_(axis),
        offset_(axis.half() + radius),
        pieces_(offset_pieces(axis.line(), offset_, side)) {
    const Point node = planar(axis.line().front());
    const Point behind = node - position_at(axis.line(), 0).direction * offset_;
    if (axis.first())
      pieces_.insert(pieces_.begin(), {behind, pieces_.front().start, node, true, 0, 0, 0});
    // Most pieces of a jagged axis hold no place for a centre.
    if (pieces_.size() > worth_thinning)
      pieces_.erase(std::remove_if(pieces_.begin(), pieces_.end(),
                                   [&](const OffsetPiece& piece) {
                                     return axis_.hides(piece, offset_ - 2 * border_slack);
                                   }),
                    pieces_.end());
    boxes_.reserve(pieces_.size());
    for (const OffsetPiece& piece : pieces_) boxes_.push_back(box_of(piece));
    if (pieces_.size() > worth_an_index) index_.emplace(boxes_);
  }

  const Axis& axis() const { return axis_; }
  const std::vector<OffsetPiece>& pieces() const { return pieces_; }

  // The pieces that may meet one of another border, in order.
  template <class Use>
  void each_near(const OffsetPiece& other, Use use) const {
    const Box box = box_of(other);
    if (index_)
      for (const int i : index_->near(box, touch)) use(pieces_[i]);
    else
      for (std::size_t i = 0; i < pieces_.size(); ++i)
        if (boxes_[i].meets(box, touch)) use(pieces_[i]);
  }

  // Nearer to the axis than the border is: no place for a centre. Beyond an end where the width
  // changes the kerb counts.
  bool too_near(const Point& p) const {
    return axis_.comes_within(p, offset_ - border_slack) && !axis_.ends_before(p);
  }

 private:
  static constexpr double touch = 1e-5;  // metres, more than the slack of a meeting

  const Axis& axis_;
  double offset_;
  std::vector<OffsetPiece> pieces_;
  std::vector<Box> boxes_;
  std::optional<BoxIndex> index_;
};

Street street_of(const Line& axis, double width) {
  Street street;
  street.emplace_back(axis, width / 2);
  return street;
}

Street street_of(const Course& course) {
  Street street;
  street.reserve(course.size());
  for (const CoursePiece& piece : course) street.emplace_back(piece, &piece == &course.back());
  return street;
}

std::vector<Border> borders_of(const Street& street, double radius, int side) {
  std::vector<Border> borders;
  borders.reserve(street.size());
  for (const Axis& axis : street) borders.emplace_back(axis, radius, side);
  return borders;
}

Point start_of(const Street& street) { return planar(street.front().line().front()); }

// The first meeting on the way out along both borders; of two as far the one nearer to the node.
std::optional<Meeting> first_meeting(const Street& street_a, const Street& street_b, double radius,
                                     const WayOut& out) {
  const auto borders_a = borders_of(street_a, radius, +1),
             borders_b = borders_of(street_b, radius, -1);
  std::optional<Meeting> first;
  double shortest = infinite;
  const auto too_near = [](const std::vector<Border>& borders, const Point& p) {
    return std::any_of(borders.begin(), borders.end(),
                       [&](const Border& border) { return border.too_near(p); });
  };
  const auto nearer = [&](const Meeting& found) {
    return !first || distance(out.node(), found.centre) < distance(out.node(), first->centre);
  };
  const auto meet = [&](const Border& border_a, const OffsetPiece& a, const Border& border_b,
                        const OffsetPiece& b) {
    Point places[2];
    const int count =
        a.arc ? (b.arc ? meet_arc_arc(a, b, places) : meet_line_arc(b, a, places))
              : (b.arc ? meet_line_arc(a, b, places) : meet_line_line(a, b, out.node(), places));
    for (int i = 0; i < count; ++i) {
      Meeting found{places[i], {&border_a.axis(), 0}, {&border_b.axis(), 0}};
      if (!within(a, found.centre, &found.a.at)) continue;
      if (!within(b, found.centre, &found.b.at)) continue;
      const double way = out.to(found);
      if (way > shortest + border_slack) continue;
      if (way > shortest - border_slack && !nearer(found)) continue;
      if (found.a.leads_back() || found.b.leads_back()) continue;
      if (too_near(borders_a, found.centre) || too_near(borders_b, found.centre)) continue;
      first = found;
      shortest = std::min(way, shortest);
    }
  };
  for (const Border& border_a : borders_a)
    for (const OffsetPiece& a : border_a.pieces()) {
      if (out.to_piece(border_a.axis(), a) > shortest + border_slack) continue;
      poll_cancel();
      for (const Border& border_b : borders_b)
        border_b.each_near(a, [&](const OffsetPiece& b) { meet(border_a, a, border_b, b); });
    }
  return first;
}

Point towards(const Foot& foot, const Point& centre) {
  const Point point = planar(position_at(foot.axis->line(), foot.at).point);
  return point + unit(planar(centre) - point) * foot.axis->half();
}

bool straight(const Street& street) {
  return street.size() == 1 && street.front().line().size() == 2;
}

// The largest radius that fits two straight axes, as long as the slack takes them.
double straight_radius(const Axis& a, const Axis& b) {
  const Point u = unit(a.line()[1] - a.line()[0]), v = unit(b.line()[1] - b.line()[0]);
  const double sine = cross(u, v), cosine = dot(u, v);
  const auto fitting = [&](const Axis& axis, double other) {
    const double size = distance(axis.line()[0], axis.line()[1]) + border_slack;
    return (size * sine - (other + axis.half() * cosine)) / (1 + cosine);
  };
  return std::min(fitting(a, b.half()), fitting(b, a.half()));
}

std::optional<CornerArc> arc_of(const Street& a, const Street& b, double radius,
                                const Point& node) {
  const auto meeting = first_meeting(a, b, radius, {node, a, b});
  if (!meeting) return std::nullopt;
  CornerArc corner;
  corner.centre = planar(meeting->centre);
  corner.radius = radius;
  corner.abscissa_a = meeting->a.abscissa();
  corner.abscissa_b = meeting->b.abscissa();
  corner.arc.start = towards(meeting->a, corner.centre);
  corner.arc.end = towards(meeting->b, corner.centre);
  const Point from = unit(corner.arc.start - corner.centre),
              to = unit(corner.arc.end - corner.centre);
  // From a to b the arc turns clockwise about its centre: it bulges towards the node.
  double sweep = std::atan2(cross(from, to), dot(from, to));
  if (sweep > M_PI_2) sweep -= 2 * M_PI;
  const double middle = std::atan2(from.y, from.x) + sweep / 2;
  corner.arc.middle = {corner.centre.x + radius * std::cos(middle),
                       corner.centre.y + radius * std::sin(middle), 0};
  return corner;
}

std::optional<double> largest_radius(const Street& a, const Street& b, double radius_limit) {
  constexpr double precision = 1e-7;
  const WayOut out(start_of(a), a, b);
  const auto fits = [&](double radius) { return first_meeting(a, b, radius, out).has_value(); };
  if (!fits(0)) return std::nullopt;
  if (fits(radius_limit)) return radius_limit;
  double low = 0, high = radius_limit;
  if (straight(a) && straight(b)) {
    const double expected = straight_radius(a.front(), b.front());
    const double below = expected - 0.4 * precision, above = expected + 0.4 * precision;
    if (below > low && above < high && fits(below) && !fits(above)) return below;
  }
  while (high - low > precision) {
    const double middle = (low + high) / 2;
    (fits(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

std::optional<CornerArc> corner_arc(const Course& a, const Course& b, double radius) {
  const Street street = street_of(a);
  return arc_of(street, street_of(b), radius, start_of(street));
}

std::optional<CornerArc> corner_arc(const Line& axis_a, const Line& axis_b, double width_a,
                                    double width_b, double radius) {
  return corner_arc(axis_a, axis_b, width_a, width_b, radius, planar(axis_a.front()));
}

std::optional<CornerArc> corner_arc(const Line& axis_a, const Line& axis_b, double width_a,
                                    double width_b, double radius, const Point& node) {
  return arc_of(street_of(axis_a, width_a), street_of(axis_b, width_b), radius, node);
}

std::optional<Point> arc_centre(const Line& axis_a, const Line& axis_b, double width_a,
                                double width_b, double radius) {
  const auto corner = corner_arc(axis_a, axis_b, width_a, width_b, radius);
  return corner ? std::optional<Point>(corner->centre) : std::nullopt;
}

std::optional<double> max_corner_radius(const Course& a, const Course& b, double radius_limit) {
  return largest_radius(street_of(a), street_of(b), radius_limit);
}

std::optional<double> max_corner_radius(const Line& axis_a, const Line& axis_b, double width_a,
                                        double width_b, double radius_limit) {
  return largest_radius(street_of(axis_a, width_a), street_of(axis_b, width_b), radius_limit);
}

}  // namespace streetgen
