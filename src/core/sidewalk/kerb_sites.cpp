#include "sidewalk/kerb_sites.hpp"

#include <cmath>
#include <limits>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double spacing = 1;  // metres along kerbs

struct Place {
  Point at;
  Point along;  // unit vector
};

std::vector<Place> places_on(const Line& line, const Box& within, double margin) {
  std::vector<Place> places;
  const auto add = [&](const Point& at, const Point& along) {
    if (within.holds(at, margin)) places.push_back({planar(at), along});
  };
  double at = 0, walked = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double size = distance(line[i - 1], line[i]);
    if (size == 0) continue;
    const Point along = unit(line[i] - line[i - 1]);
    add(line[i - 1], along);
    for (; at < walked + size; at += spacing) add(line[i - 1] + along * (at - walked), along);
    walked += size;
    if (i + 1 == line.size()) add(line[i], along);
  }
  return places;
}

// A circle that touches one kerb in the place may also touch the other kerb: there it is. Without
// such a circle the nearest place of the other kerb comes out.
Point across(const Place& place, const Line& other) {
  Point nearest;
  double least = std::numeric_limits<double>::infinity();
  std::size_t segment = 1;
  for (std::size_t i = 1; i < other.size(); ++i) {
    const Point p = nearest_on_segment(place.at, other[i - 1], other[i]);
    const double away = distance(place.at, p);
    if (away >= least || distance(other[i - 1], other[i]) == 0) continue;
    least = away;
    nearest = p;
    segment = i;
  }
  const Point &from = other[segment - 1], &to = other[segment];
  // The chord between the two places that a circle touches has one angle with both kerbs.
  const Point chord = left_normal(place.along) - left_normal(unit(to - from));
  const double sine = cross(chord, to - from);
  if (std::abs(sine) <= straight_sine * distance(from, to)) return planar(nearest);
  const double share = cross(place.at - from, chord) / -sine;
  return planar(share > 0 && share < 1 ? from + (to - from) * share : nearest);
}

}  // namespace

std::vector<Site> kerb_sites(const Line& first, const Line& second, const Box& within,
                             double margin) {
  std::vector<Site> sites;
  // A row of sites along one kerb, and one along the other.
  const auto add = [&](const Line& line, const Line& other, bool is_first) {
    const std::vector<Place> places = places_on(line, within, margin);
    for (const Place& place : places) sites.push_back({place.at, is_first});
    for (const Place& place : places) {
      poll_cancel();
      sites.push_back({across(place, other), !is_first});
    }
  };
  add(first, second, true);
  add(second, first, false);
  return sites;
}

}  // namespace streetgen
