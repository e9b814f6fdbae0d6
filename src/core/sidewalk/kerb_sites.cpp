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

// That come so near to the other kerb; the same whichever way a kerb is walked along, and however
// the paper lies.
std::vector<Place> places_on(const Line& line, const Line& other, double reach) {
  std::vector<Place> places;
  Box near;
  for (const Point& at : other) near.add(at);
  const auto add = [&](const Point& at, const Point& along) {
    if (near.holds(at, reach) && comes_within(at, other, reach))
      places.push_back({planar(at), along});
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

// A circle that touches one kerb in the place may also touch the other kerb: there it is. Where the
// other kerb goes straight on, it is as far beyond the place where they meet. Otherwise the nearest
// place of the other kerb comes out. Of two segments as near, at a vertex between them, either may
// hold it.
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
    const double size = distance(from, to);
    const Point along = unit(to - from);
    // The chord between the two places that a circle touches has one angle with both kerbs.
    const Point chord = left_normal(place.along) - left_normal(along);
    const double sine = cross(chord, along);
    double share;
    if (std::abs(sine) > straight_sine)
      share = cross(place.at - from, chord) / (-sine * size);
    else if (std::abs(cross(place.at - from, along)) <= same_site)
      share = dot(nearest * 2 - place.at - from, along) / size;
    else
      continue;
    const Point touched = from + (to - from) * share;
    if (share <= 0 || share >= 1 || distance(touched, nearest) >= farthest) continue;
    found = touched;
    farthest = distance(touched, nearest);
  }
  return planar(found);
}

}  // namespace

std::vector<Site> kerb_sites(const Line& first, const Line& second, double reach) {
  std::vector<Site> sites;
  // A row of sites along one kerb, and one along the other. A place of both kerbs is none of
  // either.
  const auto add = [&](const Line& line, const Line& other, bool is_first) {
    std::vector<Site> row;
    for (const Place& place : places_on(line, other, reach)) {
      poll_cancel();
      if (!comes_within(place.at, other, same_site)) sites.push_back({place.at, is_first});
      const Point beside = across(place, other);
      if (!comes_within(beside, line, same_site)) row.push_back({beside, !is_first});
    }
    sites.insert(sites.end(), row.begin(), row.end());
  };
  add(first, second, true);
  add(second, first, false);
  return sites;
}

}  // namespace streetgen
