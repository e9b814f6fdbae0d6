#include "roundabout/roundness.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/fit_circle.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

constexpr double beside_circle = 0.1;  // of the radius: what is nearer lies on the circle
constexpr double step = 1;             // metres between the places that are compared with it
constexpr std::size_t most_places = 2000;
constexpr std::size_t waist_places = 72;
constexpr std::size_t beside_waist = waist_places / 12;  // places on either side tell a bend
constexpr double least_bend = 0.17;                      // sine of ten degrees
constexpr double half_of_double = 0.9;                   // compactness
constexpr double widest_of_halves = 2;                   // times the radius of the other one

// The vertices that are the farthest from the middle of a ring, so that places are counted from the
// same ones wherever it is given from, and whichever way round. Several where it is symmetrical.
std::vector<std::size_t> farthest_vertices(const Ring& ring) {
  Point middle;
  for (std::size_t i = 1; i < ring.size(); ++i)
    middle = middle + (ring[i - 1] + ring[i] - ring[0] * 2) * distance(ring[i - 1], ring[i]);
  middle = ring[0] + middle * (0.5 / length(ring));
  double most = 0;
  for (const Point& p : ring) most = std::max(most, distance(p, middle));
  std::vector<std::size_t> farthest;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    if (distance(ring[i], middle) >= most - same_place) farthest.push_back(i);
  return farthest;
}

// Places on a closed line, equally far apart from a vertex on.
Line places_from(std::size_t vertex, const Ring& given, std::size_t count) {
  Ring ring(given.begin(), given.end() - 1);
  std::rotate(ring.begin(), ring.begin() + vertex, ring.end());
  ring.push_back(ring.front());
  const double size = length(ring);
  Line places;
  double done = 0;
  std::size_t segment = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = size * i / count;
    while (segment + 2 < ring.size() && done + distance(ring[segment], ring[segment + 1]) < at)
      done += distance(ring[segment], ring[segment + 1]), ++segment;
    places.push_back(ring[segment] + unit(ring[segment + 1] - ring[segment]) * (at - done));
  }
  return places;
}

std::size_t count_by_step(const Ring& ring) {
  return static_cast<std::size_t>(
      std::clamp(length(ring) / step, 32.0, static_cast<double>(most_places)));
}

// About a step apart, from each farthest vertex on: those of a regular ring coincide where they are
// fewer.
Line places_on(const Ring& ring) {
  Line places;
  for (const std::size_t vertex : farthest_vertices(ring))
    for (const Point& place : places_from(vertex, ring, count_by_step(ring)))
      places.push_back(place);
  return places;
}

// Of a counter-clockwise ring: to the right.
bool bends_inwards(const Line& places, std::size_t i) {
  const std::size_t count = places.size();
  const Point comes = unit(places[i] - places[(i + count - beside_waist) % count]);
  const Point goes = unit(places[(i + beside_waist) % count] - places[i]);
  return cross(comes, goes) < -least_bend;
}

}  // namespace

double compactness_of(const Ring& line) {
  const double size = length(line);
  return std::min(1.0, 4 * M_PI * signed_area(line) / (size * size));
}

std::optional<Roundness> roundness_of(const Ring& line) {
  const Line places = places_on(line);
  const auto circle = fit_circle(places.data(), places.size());
  if (!circle) return std::nullopt;
  const auto near = std::count_if(places.begin(), places.end(), [&](const Point& p) {
    return std::abs(distance(p, circle->centre) - circle->radius) <= beside_circle * circle->radius;
  });
  return Roundness{*circle, compactness_of(line), static_cast<double>(near) / places.size()};
}

bool are_halves(const Roundness& a, const Roundness& b) {
  return std::min(a.compactness, b.compactness) >= half_of_double &&
         std::max(a.circle.radius, b.circle.radius) <=
             widest_of_halves * std::min(a.circle.radius, b.circle.radius);
}

std::optional<Roundness> less_round_half(const Ring& line) {
  const Line places = places_from(farthest_vertices(line).front(), line, waist_places);
  const std::size_t third = waist_places / 3;
  std::size_t from = 0, to = 0;
  double least = infinite;
  for (std::size_t i = 0; i < waist_places; ++i)
    for (std::size_t j = i + third; j <= i + 2 * third && j < waist_places; ++j) {
      // Of places nearly alike the one that parts equal halves.
      const double unequal = std::abs(2.0 * (j - i) / waist_places - 1);
      const double across = distance(places[i], places[j]) * (1 + beside_circle * unequal);
      if (across < least) least = across, from = i, to = j;
    }
  Ring inner(places.begin() + from, places.begin() + to + 1);
  Ring outer(places.begin() + to, places.end());
  outer.insert(outer.end(), places.begin(), places.begin() + from + 1);
  inner.push_back(inner.front());
  outer.push_back(outer.front());
  const auto a = roundness_of(inner), b = roundness_of(outer);
  if (!a || !b || !bends_inwards(places, from) || !bends_inwards(places, to)) return std::nullopt;
  return a->compactness < b->compactness ? a : b;
}

}  // namespace streetgen
