#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/ring_simplicity.hpp"
#include "geometry/surface_union.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/object.hpp"
#include "streetgen/surface.hpp"

namespace streetgen {

namespace {

// Metres.
constexpr double stripe = 0.5, gap = 0.5, free_at_border = 0.25;
constexpr double line_across = 0.2, dot = 0.3;

// Points that nearly repeat another one have no direction.
Line spaced(const Line& line) {
  Line out{line.front()};
  for (const Point& point : line)
    if (distance(out.back(), point) > same_place) out.push_back(point);
  return out;
}

// The line goes straight on for so many metres at both ends.
Line drawn_on(const Line& line, double run) {
  Line out = spaced(line);
  if (out.size() < 2) return {};
  const Point start = unit(out[0] - out[1]) * run;
  const Point end = unit(out.back() - out[out.size() - 2]) * run;
  out.insert(out.begin(), out.front() + start);
  out.push_back(out.back() + end);
  return out;
}

// The part of the axis about a crossing: a long axis has many bends elsewhere.
struct Surroundings {
  double low, high;  // metres along the whole axis
  double reach = 0;  // metres along the axis that the crossing takes on either side, at most
  Line axis;         // from low to high, and so far on at both ends
  double abscissa;   // of the crossing, along this part

  Surroundings(const Line& whole, const WidthProfile& borders, const StreetCrossing& crossing) {
    double widest = 0;
    for (const WidthProfile::Place& place : borders.places)
      widest = std::max({widest, 2 * std::abs(place.left), 2 * std::abs(place.right)});
    const double about = widest * 3 + crossing.width * 2;
    const double along = widest * std::abs(std::cos(crossing.angle)) + crossing.width;
    reach = along / std::sin(crossing.angle) / 2 + 0.5;
    low = std::max(0.0, crossing.abscissa - about);
    high = std::min(length(whole), crossing.abscissa + about);
    abscissa = crossing.abscissa - low + reach;
    if (high > low) axis = drawn_on(substring(whole, low, high), reach);
  }
};

// Of what is painted, metres along the axis from the crossing's way across, and to its left.
struct PaintedPiece {
  double low, high, right, left;
};

// About the middle of the roadway, of a crossing so deep along the axis, with so much room from
// there to either border.
std::vector<PaintedPiece> painted_pieces(CrossingPaint paint, double depth, double room) {
  const double low = -depth / 2, high = depth / 2;
  std::vector<PaintedPiece> pieces;
  if (paint == CrossingPaint::ladder || paint == CrossingPaint::lines)
    for (const double from : {low, high - line_across})
      if (room > 0) pieces.push_back({from, from + line_across, -room, room});
  if (paint == CrossingPaint::lines) return pieces;
  const bool round = paint == CrossingPaint::dots;
  const double half = (round ? dot : stripe) / 2, deep = round ? dot : line_across;
  const int last = static_cast<int>(std::floor((room - stripe / 2) / (stripe + gap)));
  for (int i = -last; i <= last; ++i) {
    const double middle = i * (stripe + gap);
    if (paint == CrossingPaint::dashes || round)
      for (const double from : {low, high - deep})
        pieces.push_back({from, from + deep, middle - half, middle + half});
    else
      pieces.push_back({low, high, middle - half, middle + half});
  }
  return pieces;
}

}  // namespace

std::optional<Polygon> crossing_ground(const Line& axis, const WidthProfile& borders,
                                       const StreetCrossing& crossing) {
  const Line line = distinct(planar(axis));
  const Surroundings near(line, borders, crossing);
  if (near.axis.empty()) return std::nullopt;
  const auto border = [&](int side) {
    return drawn_on(roadway_border(line, borders, {near.low, near.high, side}), near.reach);
  };
  const Line left = border(+1), right = border(-1);
  if (left.empty() || right.empty()) return std::nullopt;
  return crossing_surface(near.axis, left, right, near.abscissa, crossing.width, crossing.angle);
}

MultiPolygon crossing_stripes(const Line& axis, const WidthProfile& borders,
                              const StreetCrossing& crossing, CrossingPaint paint) {
  const Surroundings near(distinct(planar(axis)), borders, crossing);
  if (near.axis.empty()) return {};
  const WidthProfile::Place sides = borders.at(crossing.abscissa);
  const double middle = (sides.left - sides.right) / 2;
  const double room = (sides.left + sides.right) / 2 - free_at_border;
  const double slope = 1 / std::tan(crossing.angle);
  MultiPolygon stripes;
  for (const PaintedPiece& piece : painted_pieces(paint, crossing.width, room)) {
    poll_cancel();
    const auto place = [&](double along, double aside) {
      const double offset = middle + aside;
      return place_beside(near.axis, {near.abscissa + along + offset * slope, offset}).point;
    };
    const Ring ring{place(piece.low, piece.right), place(piece.high, piece.right),
                    place(piece.high, piece.left), place(piece.low, piece.left),
                    place(piece.low, piece.right)};
    if (signed_area(ring) > 0 && simple({{ring}}).value_or(false)) stripes.push_back({ring});
  }
  Geos geos;
  if (geos.valid(stripes)) return stripes;
  std::vector<MultiPolygon> parts;
  for (const Polygon& one : stripes) parts.push_back({one});
  return united(geos, parts);
}

}  // namespace streetgen
