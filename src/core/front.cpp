#include "front.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "polyline.hpp"

namespace streetgen {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr Range all{-infinite, infinite};
constexpr double noise = 1e-6;   // metres
constexpr double sliver = 1e-9;  // of an angle, as its tangent: no front

Quadratic operator+(const Quadratic& p, const Quadratic& q) {
  return {p.a + q.a, p.b + q.b, p.c + q.c};
}
Quadratic operator-(const Quadratic& p, const Quadratic& q) {
  return {p.a - q.a, p.b - q.b, p.c - q.c};
}
Quadratic operator*(const Quadratic& p, double k) { return {p.a * k, p.b * k, p.c * k}; }

// Places where quadratics change their sign within a range, ascending, with its ends.
class Cuts {
 public:
  explicit Cuts(const Range& range) : range_(range) { at_[count_++] = range.from; }

  void add_roots(const Quadratic& q) {
    const double square = q.b * q.b - 4 * q.a * q.c;
    if (!(square >= 0)) return;
    const double sum = -(q.b + std::copysign(std::sqrt(square), q.b)) / 2;
    for (const double root : {sum / q.c, q.a / sum})
      if (root > range_.from && root < range_.to) at_[count_++] = root;
  }
  void add_ends(const Range& range) {
    for (const double end : {range.from, range.to})
      if (end > range_.from && end < range_.to) at_[count_++] = end;
  }
  void close() {
    std::sort(at_.begin() + 1, at_.begin() + count_);
    at_[count_++] = range_.to;
  }
  std::size_t count() const { return count_; }
  double operator[](std::size_t i) const { return at_[i]; }

 private:
  Range range_;
  std::array<double, 10> at_;  // its own ends, those of another, and two of each of three
  std::size_t count_ = 0;
};

// The places as near to a point as to a line, by chords.
class Parabola {
 public:
  Parabola(const Point& focus, const Point& on_line, const Point& along, double off, const Box& box)
      : along_(along), foot_(on_line + along * dot(focus - on_line, along)), off_(off), box_(box) {
    const Point up = focus - foot_;
    height_ = norm(up);
    up_ = up * (1 / height_);
  }
  void append(const Point& from, const Point& to,
              std::vector<std::pair<Point, Point>>& chords) const {
    append(from, dot(from - foot_, along_), to, dot(to - foot_, along_), chords);
  }

 private:
  void append(const Point& from, double x, const Point& to, double y,
              std::vector<std::pair<Point, Point>>& chords) const {
    // How high the chord lies above it, and the slope of the chord.
    const double high = (y - x) * (y - x) / (8 * height_), slope = (x + y) / (2 * height_);
    const bool near = box_of(from, to).meets(box_, high);
    if (!near || !(high * high > off_ * off_ * (1 + slope * slope))) {
      if (near) chords.emplace_back(from, to);
      return;
    }
    const double z = (x + y) / 2;
    const Point middle = foot_ + along_ * z + up_ * ((z * z / height_ + height_) / 2);
    append(from, x, middle, z, chords);
    append(middle, z, to, y, chords);
  }

  Point along_, foot_, up_;
  double height_, off_;
  Box box_;
};

}  // namespace

Front Front::beside(const Straight& piece, bool left, double reach) {
  Front front(piece.origin, piece.along, left_normal(piece.along) * (left ? 1 : -1), false);
  front.start_ = piece.start;
  front.end_ = piece.end;
  front.widest_ = reach;
  front.met_.push_back({piece.from, piece.to, {reach, 0, 0}});
  return front;
}

std::optional<Front> Front::beyond(const Point& end, const std::vector<Point>& directions,
                                   double reach) {
  const Point out = directions.front() * -1;
  Front front(end, left_normal(out), out, true);
  front.start_ = front.end_ = end;
  Range range{-1, 1};
  for (const Point& direction : directions) {
    const double x = -dot(direction, out), y = -dot(direction, front.along_);
    if (y >= 0)
      range.from = std::max(range.from, -x / (1 + y));
    else
      range.to = std::min(range.to, x / (1 - y));
  }
  if (range.to - range.from < sliver) return std::nullopt;
  front.widest_ = reach;
  front.met_.push_back({range.from, range.to, {-1 / reach, 0, -1 / reach}});
  return front;
}

// Whether a circle that touches the front from outside, as wide as any that is left, may touch it.
bool Front::may_meet(const Straight& piece) const {
  const Point start = piece.start - origin_, end = piece.end - origin_;
  const double ahead = dot(start, along_), ahead_end = dot(end, along_);
  const double away = dot(start, out_), away_end = dot(end, out_);
  const double beside = turns_ ? 2 * widest_ : widest_, behind = turns_ ? -2 * widest_ : 0;
  const double from = turns_ ? 0 : met_.front().from, to = turns_ ? 0 : met_.back().to;
  return std::max(away, away_end) > behind && std::min(away, away_end) < 2 * widest_ &&
         std::max(ahead, ahead_end) > from - beside && std::min(ahead, ahead_end) < to + beside;
}

void Front::meet(const Straight& piece, bool of_other) {
  if (!may_meet(piece)) return;
  const auto own = [&](const Point& p) { return same(p, start_) || same(p, end_); };
  const bool at_start = own(piece.start), at_end = own(piece.end);
  const Straight* named = of_other ? &piece : nullptr;
  if (!at_start) meet_end(piece.start, named, Part::start);
  if (!at_end) meet_end(piece.end, named, Part::end);
  if (!turns_)
    meet_inside(piece, named);
  else if (!at_start && !at_end)
    meet_inside_about_end(piece, named);
}

Quadratic Front::share(const Point& vector) const {
  const double out = dot(vector, out_);
  return {out, 2 * dot(vector, along_), -out};
}

void Front::meet_end(const Point& end, const Straight* piece, Part part) {
  const Point away = end - origin_;
  if (turns_) {
    meet(share(away) * (-2 / dot(away, away)), all, {}, piece, part);
    return;
  }
  const double x = dot(away, along_), y = dot(away, out_);
  if (y <= 0) return;
  meet({(x * x + y * y) / (2 * y), -x / y, 1 / (2 * y)}, all, {}, piece, part);
}

void Front::meet_inside_about_end(const Straight& piece, const Straight* named) {
  const Point from = origin_ - piece.origin, normal = left_normal(piece.along);
  const double off = dot(from, normal), ahead = dot(from, piece.along), away = std::abs(off);
  if (off == 0) return;
  const Quadratic closing = Quadratic{1, 0, 1} - share(normal) * (off > 0 ? 1 : -1);
  const Quadratic moved = share(piece.along) * away;
  meet(closing * (-1 / away), all,
       {moved + closing * (ahead - piece.from), closing * (piece.to - ahead) - moved}, named,
       Part::inside);
}

void Front::meet_inside(const Straight& piece, const Straight* named) {
  const Point from = origin_ - piece.origin, normal = left_normal(piece.along);
  const double off = dot(from, normal), slope = dot(normal, along_), turn = dot(normal, out_);
  const double ahead = dot(from, piece.along), goes = dot(piece.along, along_),
               rises = dot(piece.along, out_);
  for (const double side : {1.0, -1.0}) {
    Range range{met_.front().from, met_.back().to};
    range.hold(side * off, side * slope, 0, infinite);
    if (range.empty()) continue;
    // 1 - side * turn, also where that is next to nothing.
    const double closing = side * turn > 0 ? slope * slope / (1 + side * turn) : 1 - side * turn;
    if (closing == 0) continue;
    const Quadratic value{side * off / closing, side * slope / closing, 0};
    range.hold(ahead + rises * value.a, goes + rises * value.b, piece.from, piece.to);
    if (range.empty()) continue;
    // Where one lies on the other neither is in the way of the other.
    const auto gap = [&](double at) { return std::abs(off + slope * at); };
    if (std::max(gap(range.from), gap(range.to)) <= noise) continue;
    meet(value, range, {}, named, Part::inside);
  }
}

void Front::meet(const Quadratic& value, const Range& range, std::initializer_list<Quadratic> holds,
                 const Straight* piece, Part part) {
  next_.clear();
  bool first = false, any = false;  // whether it is, in the last of the next, and in any
  for (const Met& now : met_) {
    Cuts cuts({now.from, now.to});
    const Range within{std::max(now.from, range.from), std::min(now.to, range.to)};
    if (!within.empty()) {
      cuts.add_ends(within);
      cuts.add_roots(value - now.value);
      for (const Quadratic& hold : holds) cuts.add_roots(hold);
    }
    cuts.close();
    for (std::size_t i = 1; i < cuts.count(); ++i) {
      const double middle = (cuts[i - 1] + cuts[i]) / 2;
      const bool was_first = first;
      first = middle > range.from && middle < range.to && value(middle) < now.value(middle) &&
              std::all_of(holds.begin(), holds.end(),
                          [&](const Quadratic& hold) { return hold(middle) > 0; });
      any = any || first;
      if (!next_.empty() && first == was_first && (first || i > 1))
        next_.back().to = cuts[i];
      else if (first)
        next_.push_back({cuts[i - 1], cuts[i], value, piece, part});
      else
        next_.push_back({cuts[i - 1], cuts[i], now.value, now.piece, now.part});
    }
  }
  if (!any) return;
  std::swap(met_, next_);
  widest_ = 0;
  for (const Met& met : met_)
    widest_ = std::max({widest_, distance_at(met, met.from), distance_at(met, met.to)});
}

double Front::distance_at(const Met& met, double at) const {
  const double value = met.value(at);
  return turns_ ? -(1 + at * at) / value : value;
}

double Front::farthest() const {
  double most = 0;
  for (const Met& met : met_)
    if (met.piece != nullptr)
      most = std::max({most, distance_at(met, met.from), distance_at(met, met.to)});
  return most;
}

Point Front::place(const Met& met, double at) const {
  const double value = met.value(at);
  if (!turns_) return origin_ + along_ * at + out_ * value;
  return origin_ + (out_ * (1 - at * at) + along_ * (2 * at)) * (-1 / value);
}

void Front::append_met(double off, const Box& box,
                       std::vector<std::pair<Point, Point>>& segments) const {
  for (const Met& met : met_) {
    if (met.piece == nullptr) continue;
    const Point from = place(met, met.from), to = place(met, met.to);
    if ((met.part == Part::inside) != turns_) {
      if (box_of(from, to).meets(box, 0)) segments.emplace_back(from, to);
      continue;
    }
    const Point focus = turns_                    ? origin_
                        : met.part == Part::start ? met.piece->start
                                                  : met.piece->end;
    const Parabola parabola(focus, turns_ ? met.piece->origin : origin_,
                            turns_ ? met.piece->along : along_, off, box);
    parabola.append(from, to, segments);
  }
}

}  // namespace streetgen
