// Outwards from a piece of an axis: what comes as near as the piece itself.
#pragma once

#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include "straight.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

// a + b t + c t^2
struct Quadratic {
  double a = 0, b = 0, c = 0;
  double operator()(double t) const { return a + t * (b + t * c); }
};

// The places nearest to one side of a straight piece, or to an end of pieces. On the way outwards
// something else comes as near at last: an end of another piece, or its inside. How far out, is a
// quadratic of the metres along a side; about an end minus one over that distance is one, times
// 1 + t^2, of the tangent t of half the angle.
class Front {
 public:
  // As far as `reach`, metres.
  static Front beside(const Straight& piece, bool left, double reach);
  // None where the pieces that go away from the end in these directions leave nothing to it.
  static std::optional<Front> beyond(const Point& end, const std::vector<Point>& directions,
                                     double reach);

  // Another piece of the same owner, or one of the other.
  void meet(const Straight& piece, bool of_other);
  // How far out something of the other is met, at most; 0: nowhere.
  double farthest() const;
  // Where something of the other is met, as far as it comes near the box, in straight segments that
  // leave it by `off` at most.
  void append_met(double off, const Box& box, std::vector<std::pair<Point, Point>>& segments) const;

 private:
  enum class Part { start, inside, end };
  // What is met first.
  struct Met {
    double from, to;
    Quadratic value;
    const Straight* piece = nullptr;  // of the other; else nothing of it is
    Part part = Part::inside;
  };

  Front(const Point& origin, const Point& along, const Point& out, bool turns)
      : origin_(origin), along_(along), out_(out), turns_(turns) {}

  // About an end: the share of a vector in the direction outwards, times 1 + t^2.
  Quadratic share(const Point& vector) const;
  double distance_at(const Met& met, double at) const;
  Point place(const Met& met, double at) const;
  bool may_meet(const Straight& piece) const;
  void meet_end(const Point& end, const Straight* piece, Part part);
  void meet_inside(const Straight& piece, const Straight* named);
  void meet_inside_about_end(const Straight& piece, const Straight* named);
  // Within the range, where all of `holds` are positive, if it is less than what was met there.
  void meet(const Quadratic& value, const Range& range, std::initializer_list<Quadratic> holds,
            const Straight* piece, Part part);

  Point origin_, along_, out_;
  bool turns_;         // about an end
  Point start_, end_;  // its own
  double widest_;      // how far out anything is met, at most
  std::vector<Met> met_, next_;
};

}  // namespace streetgen
