#include <cmath>

#include "geometry/polyline.hpp"
#include "streetgen/clean.hpp"
#include "streetgen/corner.hpp"
#include "streetgen/surface.hpp"
#include "surfaces.hpp"
#include "truths.hpp"

namespace streetgen::fuzz {

namespace {

bool same_place(const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; }

void clean_keeps_its_promise(Random& random, const Line& line, Faults& faults) {
  const Line cleaned = clean(line, {}, random.scaled(0.01, 5), random.scaled(0.1, 10));
  if (cleaned.size() < 2 || !same_place(cleaned.front(), line.front()) ||
      !same_place(cleaned.back(), line.back()))
    faults.push_back("clean moved an end");
}

void corners_keep_their_distance(Random& random, const Line& a, const Line& b, Faults& faults) {
  const double wa = random.scaled(0.1, 60), wb = random.scaled(0.1, 60);
  const double radius = random.one_in(5) ? 0 : random.scaled(0.1, 60);
  const auto corner = corner_arc(a, b, wa, wb, radius);
  max_corner_radius(a, b, wa, wb);
  if (!corner) return;
  // The coordinates' own resolution, or a micrometre.
  const double slack = 1e-6 + 1e-15 * (std::abs(a[0].x) + std::abs(a[0].y)) * 10;
  if (distance_to_line(corner->centre, a) < wa / 2 + radius - slack ||
      distance_to_line(corner->centre, b) < wb / 2 + radius - slack)
    faults.push_back("an arc's circle overlaps a roadway");
}

void surfaces_are_sound(Random& random, const std::vector<Line>& star, Faults& faults) {
  const Line& line = star.front();
  std::vector<double> widths, radii, along;
  for (std::size_t i = 0; i < star.size(); ++i) {
    widths.push_back(random.scaled(0.1, 60));
    radii.push_back(random.one_in(4) ? 0 : random.scaled(0.1, 20));
  }
  for (std::size_t i = 0; i < line.size(); ++i)
    along.push_back(random.one_in(6) ? 0 : random.scaled(0.1, 30));
  const double total = length(line);
  const auto expect = [&](const char* what, const MultiPolygon& surface) {
    if (!sound(surface)) faults.push_back(std::string(what) + " is not valid and finite");
  };
  expect("section_surface",
         section_surface(line, widths[0], random.between(-1, total), random.between(0, total + 1)));
  expect("intersection_surface", intersection_surface(star, widths, radii));
  intersection_ring(star, widths, radii);
  for (const Side side : {Side::both, Side::left, Side::right})
    expect("variable_buffer",
           variable_buffer(line, along, side, random.one_in(2) ? Ends::flat : Ends::round));
  for (const Point& p : border_line(line, random.between(-1, total + 1), widths[0]))
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) faults.push_back("border_line is not finite");
}

}  // namespace

Faults primitive_faults(std::uint64_t seed) {
  Random random(seed);
  const Point node = random.of(std::vector<Point>{{0, 0, 0}, {650000, 6860000, 0}, {1e9, -1e9, 0}});
  std::vector<Line> star;
  for (int rays = 2 + random.below(5); rays > 0; --rays) star.push_back(random_line(random, node));
  Faults faults;
  clean_keeps_its_promise(random, star[0], faults);
  corners_keep_their_distance(random, star[0], star[1], faults);
  surfaces_are_sound(random, star, faults);
  return faults;
}

}  // namespace streetgen::fuzz
