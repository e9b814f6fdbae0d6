#include "sidewalk/kerb_sites.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

constexpr double spacing = 1;  // metres along kerbs, at most

struct Place {
  Point at;
  Point along;  // unit vector
};

// The same whichever way the kerb is walked along.
std::vector<Place> places_on(const Line& line, const Box& within, double margin) {
  std::vector<Place> places;
  const auto add = [&](const Point& at, const Point& along) {
    if (within.holds(at, margin)) places.push_back({planar(at), along});
  };
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point& from = line[i - 1];
    const Point size = line[i] - from;
    if (norm(size) == 0) continue;
    const int count = static_cast<int>(std::ceil(norm(size) / spacing - same_place));
    const int parts = std::max(count, 1);
    for (int k = 0; k <= parts; ++k)
      add(from + size * (static_cast<double>(k) / parts), unit(size));
  }
  return places;
}

// A circle that touches one kerb in the place may also touch the other kerb: there it is. Without
// such a circle the nearest place of the other kerb comes out. Of two segments as near, at a vertex
// between them, either may hold it.
Point across(const Place& place, const Line& other) {
  Point nearest;
  double least = infinite;
  std::size_t segments[2]{};  // that are the nearest; 0: none
  for (std::size_t i = 1; i < other.size(); ++i) {
    const Point p = nearest_on_segment(place.at, other[i - 1], other[i]);
    const double away = distance(place.at, p);
    if (away > least + same_place || distance(other[i - 1], other[i]) == 0) continue;
    if (away < least - same_place)
      least = away, nearest = p, segments[0] = i, segments[1] = 0;
    else
      segments[1] = i;
  }
  Point found = nearest;
  double farthest = infinite;
  for (const std::size_t i : segments) {
    if (i == 0) continue;
    const Point &from = other[i - 1], &to = other[i];
    // The chord between the two places that a circle touches has one angle with both kerbs.
    const Point chord = left_normal(place.along) - left_normal(unit(to - from));
    const double sine = cross(chord, to - from);
    if (std::abs(sine) <= straight_sine * distance(from, to)) continue;
    const double share = cross(place.at - from, chord) / -sine;
    const Point touched = from + (to - from) * share;
    if (share <= 0 || share >= 1 || distance(touched, nearest) >= farthest) continue;
    found = touched;
    farthest = distance(touched, nearest);
  }
  return planar(found);
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
