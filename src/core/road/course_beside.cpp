// The part of an alignment that a road follows.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/polyline.hpp"
#include "road/chain_element.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/plan_view.hpp"

namespace streetgen {

namespace {

constexpr double same = 1e-3;       // metres, and radians: a wider gap is a gap
constexpr double shortest = 1e-4;   // metres: what is shorter would be written as nothing
constexpr double backwards = 1e-6;  // metres that rounding may go back

PlanPiece part_of(const PlanPiece& piece, double from, double to) {
  const double rate = (piece.curvature_end - piece.curvature) / piece.length;
  const AlignmentPlace place = element_place(element_of(piece), from);
  return {0,
          {planar(place.point), place.heading},
          to - from,
          piece.curvature + rate * from,
          piece.curvature + rate * to};
}

PlanPiece turned_round(const PlanPiece& piece) {
  const AlignmentPlace end = element_place(element_of(piece), piece.length);
  return {0,
          {planar(end.point), end.heading + M_PI},
          piece.length,
          -piece.curvature_end,
          -piece.curvature};
}

// From one place along the chain to another one behind it.
std::vector<PlanPiece> between(const std::vector<PlanPiece>& chain, double from, double to) {
  std::vector<PlanPiece> parts;
  for (const PlanPiece& piece : chain) {
    const double a = std::max(from - piece.s, 0.0), b = std::min(to - piece.s, piece.length);
    if (b - a > shortest) parts.push_back(part_of(piece, a, b));
  }
  return parts;
}

bool goes_on(const PlanPiece& before, const PlanPiece& behind) {
  const AlignmentPlace end = element_place(element_of(before), before.length);
  const double turn = std::remainder(end.heading - behind.start.heading, 2 * M_PI);
  return distance(planar(end.point), behind.start.point) <= same && std::abs(turn) <= same;
}

}  // namespace

std::vector<PlanPiece> course_beside(const std::vector<AlignmentElement>& alignment,
                                     const Line& line, double reach) {
  std::vector<PlanPiece> chain;
  double s = 0;
  for (const AlignmentElement& element : alignment) {
    if (element.length <= 0) continue;
    chain.push_back(piece_of(element));
    chain.back().s = s;
    s += element.length;
  }
  if (chain.empty() || line.size() < 2) return {};
  std::vector<double> stations;
  for (const Point& point : line) {
    poll_cancel();
    const ChainStation station = station_of(chain, point);
    if (std::abs(station.aside) > reach || std::abs(station.beyond) > reach) return {};
    stations.push_back(station.s);
  }
  const bool against = stations.back() < stations.front();
  if (against) std::reverse(stations.begin(), stations.end());
  for (std::size_t i = 1; i < stations.size(); ++i)
    if (stations[i] < stations[i - 1] - backwards) return {};
  std::vector<PlanPiece> course = between(chain, stations.front(), stations.back());
  if (against) {
    std::reverse(course.begin(), course.end());
    for (PlanPiece& piece : course) piece = turned_round(piece);
  }
  s = 0;
  for (std::size_t i = 0; i < course.size(); ++i) {
    if (i > 0 && !goes_on(course[i - 1], course[i])) return {};
    course[i].s = s;
    s += course[i].length;
  }
  return course;
}

}  // namespace streetgen
