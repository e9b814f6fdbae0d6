#include "streetgen/clean.hpp"

#include <cmath>
#include <string>

#include "polyline.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

namespace {

constexpr double collinear_within = 1e-3;

struct Kept {
  Point point;
  bool fixed;
};

template <class Drop>
void filter(std::vector<Kept>& points, Drop drop) {
  std::vector<Kept> out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    poll_cancel();
    const bool inner = i > 0 && i + 1 < points.size();
    if (!inner || points[i].fixed || !drop(out.back().point, points[i].point, points[i + 1].point))
      out.push_back(points[i]);
  }
  points = std::move(out);
}

}  // namespace

Line clean(const Line& line, const std::vector<bool>& keep, double epsilon, double r_min) {
  if (!keep.empty() && keep.size() != line.size())
    throw Error(ErrorKind::invalid_input, "the line has " + std::to_string(line.size()) +
                                              " points but keep has " +
                                              std::to_string(keep.size()) + " elements");
  std::vector<Kept> points;
  for (std::size_t i = 0; i < line.size(); ++i)
    points.push_back({line[i], !keep.empty() && keep[i]});
  filter(points, [&](const Point& before, const Point& at, const Point&) {
    return distance(before, at) < epsilon;
  });
  filter(points, [&](const Point& before, const Point& at, const Point& after) {
    return distance_to_segment(at, before, after) < collinear_within;
  });
  filter(points, [&](const Point& before, const Point& at, const Point& after) {
    const Point in = unit(at - before), out = unit(after - at);
    const double half_turn = std::atan2(std::abs(cross(in, out)), dot(in, out)) / 2;
    const double offset = r_min * std::tan(half_turn);
    return offset > distance(before, at) / 2 || offset > distance(at, after) / 2;
  });
  Line out;
  for (const Kept& kept : points) out.push_back(kept.point);
  return out;
}

}  // namespace streetgen
