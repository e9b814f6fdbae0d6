#include "road/arc_chain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/polyline.hpp"
#include "road/heading.hpp"

namespace streetgen {

namespace {

// Radians.  Series of two terms are exact below it.
constexpr double small_turn = 1e-4;

// An arc of one metre that turns by so much ends ahead of its start and to the left of it.
struct Reach {
  double ahead = 1, left = 0;
};
Reach reach(double turn, double sine, double cosine) {
  if (std::abs(turn) < small_turn) return {1 - turn * turn / 6, turn / 2};
  return {sine / turn, (1 - cosine) / turn};
}
// The same by the turn.
Reach reach_slope(double turn) {
  if (std::abs(turn) < small_turn) return {-turn / 3, 0.5 - turn * turn / 8};
  const double sine = std::sin(turn), cosine = std::cos(turn);
  const Reach to = reach(turn, sine, cosine);
  return {(cosine - to.ahead) / turn, (sine - to.left) / turn};
}

Point turned(const Point& way, const Reach& by) {
  return way * by.ahead + left_normal(way) * by.left;
}

}  // namespace

ArcChain::ArcChain(const ChainPlace& start, std::vector<ChainArc> arcs) : arcs_(std::move(arcs)) {
  starts_.push_back({0, start.heading, planar(start.point), along(start.heading)});
  for (const ChainArc& arc : arcs_) {
    const Start& from = starts_.back();
    const double turn = arc.curvature * arc.length, heading = from.heading + turn;
    const Reach to = reach(turn, std::sin(turn), std::cos(turn));
    starts_.push_back({from.s + arc.length, heading, from.point + turned(from.way, to) * arc.length,
                       along(heading)});
  }
}

ArcChain::Place ArcChain::at(double s) const {
  std::size_t i = 0;
  while (i + 1 < arcs_.size() && starts_[i + 1].s <= s) ++i;
  const double on = s - starts_[i].s, turn = arcs_[i].curvature * on;
  const Point way = starts_[i].way;
  const double sine = std::sin(turn), cosine = std::cos(turn);
  const Reach to = reach(turn, sine, cosine);
  return {s, i, starts_[i].point + turned(way, to) * on, way * cosine + left_normal(way) * sine};
}

ArcChain::Place ArcChain::end() const {
  const Start& end = starts_.back();
  return {end.s, arcs_.size(), end.point, end.way};
}

void ArcChain::slopes(const Place& place, std::vector<Point>& out) const {
  out.assign(2 * arcs_.size(), Point{});
  const auto bent = [&](std::size_t i, double length) {
    return turned(starts_[i].way, reach_slope(arcs_[i].curvature * length)) * (length * length);
  };
  for (std::size_t i = 0; i < place.arc; ++i) {
    const Point arm = left_normal(place.point - starts_[i + 1].point);
    out[2 * i] = starts_[i + 1].way + arm * arcs_[i].curvature;
    out[2 * i + 1] = bent(i, arcs_[i].length) + arm * arcs_[i].length;
  }
  if (place.arc < arcs_.size())
    out[2 * place.arc + 1] = bent(place.arc, place.s - starts_[place.arc].s);
}

std::vector<PlanPiece> ArcChain::pieces() const {
  constexpr double straight = 1e-9;  // radians
  std::vector<PlanPiece> out;
  for (std::size_t i = 0; i < arcs_.size(); ++i) {
    const bool bends = std::abs(arcs_[i].curvature * arcs_[i].length) > straight;
    const double curvature = bends ? arcs_[i].curvature : 0;
    out.push_back({starts_[i].s,
                   {starts_[i].point, starts_[i].heading},
                   arcs_[i].length,
                   curvature,
                   curvature});
  }
  return out;
}

}  // namespace streetgen
