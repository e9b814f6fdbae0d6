#include "streetgen/plan_view.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "road/chain_element.hpp"
#include "road/heading.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

namespace {

// Radians.  A sharper turn has no arc worth the name.
constexpr double sharpest = 0.9 * M_PI;
// A share of the tolerance is for the points left out, the other for the arcs at those that stay.
constexpr double half = 0.5;
// Metres from a kink that an arc of the least radius may leave it.
constexpr double most_aside = 1;
// Radians.  A turn that is smaller moves the end of a kilometre by ten micrometres.
constexpr double straight_turn = 1e-8;

// The points without which the line leaves what is kept by more than the tolerance.
Line simplified(const Line& line, double tolerance) {
  std::vector<bool> kept(line.size());
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> stretches{{0, line.size() - 1}};
  while (!stretches.empty()) {
    poll_cancel();
    const auto [first, last] = stretches.back();
    stretches.pop_back();
    std::size_t farthest = first;
    double most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = distance_to_segment(line[i], line[first], line[last]);
      if (off > most) most = off, farthest = i;
    }
    if (farthest == first) continue;
    kept[farthest] = true;
    stretches.push_back({first, farthest});
    stretches.push_back({farthest, last});
  }
  Line out;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (kept[i]) out.push_back(line[i]);
  return out;
}

// A point behind the first one, so that the line sets out as the heading says; also where it does
// by itself, since the point behind may yet be moved.
void set_out(Line& line, double heading, double tolerance) {
  const Point side = line[1] - line[0], way = along(heading);
  const double turn = std::abs(turn_from(way, side));
  const double aside = std::max(std::sin(std::min(turn, M_PI / 2)), straight_turn);
  line.insert(line.begin() + 1, line[0] + way * std::min(norm(side) / 3, tolerance / aside));
}

// A step aside where the line turns back: at the end of the longer side, which it turns least.
Line without_reversals(const Line& line, double tolerance) {
  Line out{line.front()};
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const Point before = line[i] - line[i - 1], behind = line[i + 1] - line[i];
    const bool turns_back = std::abs(turn_from(before, behind)) > sharpest;
    const double step = std::min(tolerance, std::max(norm(before), norm(behind)) / 2);
    const Point aside = line[i] + left_normal(unit(before)) * step;
    const bool step_first = norm(before) > norm(behind);
    if (turns_back && step_first) out.push_back(aside);
    out.push_back(line[i]);
    if (turns_back && !step_first) out.push_back(aside);
  }
  out.push_back(line.back());
  return out;
}

class Chain {
 public:
  Chain(const Line& line, double tolerance, double least_radius)
      : line_(line), tolerance_(tolerance), least_radius_(least_radius) {}

  std::vector<PlanPiece> pieces() {
    Point from = line_.front();
    for (std::size_t i = 0; i + 1 < line_.size(); ++i) {
      const Point side = line_[i + 1] - line_[i], way = unit(side);
      const double back = i + 2 < line_.size() ? tangent_at(i + 1) : 0;
      const Point to = line_[i + 1] - way * back;
      const double straight = dot(to - from, way);
      // A shorter piece would be written as nothing.
      if (straight > sides_touch) add(from, heading_of(side), straight, 0);
      from = to;
      if (back > 0) {
        const Point on = unit(line_[i + 2] - line_[i + 1]);
        const double turn = turn_from(way, on), radius = back / std::tan(std::abs(turn) / 2);
        add(from, heading_of(side), radius * std::abs(turn), (turn < 0 ? -1 : 1) / radius);
        from = line_[i + 1] + on * back;
      }
    }
    return std::move(pieces_);
  }

 private:
  // From the point to where the arc in its corner begins and ends, metres; 0 where it is straight.
  double tangent_at(std::size_t i) const {
    const Point before = line_[i] - line_[i - 1], behind = line_[i + 1] - line_[i];
    const double turn = std::abs(turn_from(before, behind));
    if (turn < straight_turn) return 0;
    const double quarter = std::tan(turn / 4);
    const double wide = std::min(least_radius_ * std::tan(turn / 2), most_aside / quarter);
    return std::min({norm(before) / 2, norm(behind) / 2, std::max(tolerance_ / quarter, wide)});
  }

  void add(const Point& from, double heading, double length, double curvature) {
    pieces_.push_back({s_, {from, heading}, length, curvature, curvature});
    s_ += length;
  }

  const Line& line_;
  double tolerance_, least_radius_;
  double s_ = 0;
  std::vector<PlanPiece> pieces_;
};

}  // namespace

std::vector<PlanPiece> plan_view(const Line& line, double tolerance, const ChainEnds& ends,
                                 double least_radius) {
  Line points = distinct(planar(line));
  if (points.size() < 2) return {};
  points = simplified(points, tolerance * half);
  if (ends.heading_from) set_out(points, *ends.heading_from, tolerance * half);
  if (ends.heading_to) {
    points = reversed(std::move(points));
    set_out(points, *ends.heading_to + M_PI, tolerance * half);
    points = reversed(std::move(points));
  }
  points = without_reversals(points, tolerance * half);
  return Chain(points, tolerance * half, least_radius).pieces();
}

double length(const std::vector<PlanPiece>& chain) {
  return chain.empty() ? 0 : chain.back().s + chain.back().length;
}

ChainPlace place_at(const std::vector<PlanPiece>& chain, double s) {
  if (chain.empty()) throw Error(ErrorKind::degenerate, "a chain without a piece has no place");
  const auto after =
      std::upper_bound(chain.begin() + 1, chain.end(), s,
                       [](double at, const PlanPiece& piece) { return at < piece.s; });
  const PlanPiece& piece = *(after - 1);
  const AlignmentPlace place =
      element_place(element_of(piece), std::clamp(s - piece.s, 0.0, piece.length));
  return {place.point, place.heading};
}

}  // namespace streetgen
