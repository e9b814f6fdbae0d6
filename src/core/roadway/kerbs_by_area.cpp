#include "streetgen/kerbs_by_area.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

constexpr double step = 1;           // metres along the axis from one look to the next
constexpr double least_share = 0.3;  // of an axis, within areas
constexpr double least_width = 1;    // metres
constexpr double usual_side = 10;    // metres from an axis to a kerb of its street

using Stretch = std::pair<double, double>;

// The stretches of the line across a place that lie within an area, metres from the place.
void append_within(const MultiPolygon& area, const Point& place, const Point& across,
                   std::vector<Stretch>& within) {
  std::vector<double> borders;
  const Point along = left_normal(across);
  for (const Polygon& polygon : area)
    for (const Ring& ring : polygon)
      for (std::size_t i = 1; i < ring.size(); ++i) {
        const Point from = ring[i - 1] - place, to = ring[i] - place;
        const double before = dot(from, along), after = dot(to, along);
        if ((before > 0) == (after > 0)) continue;
        borders.push_back(dot(from, across) + dot(to - from, across) * before / (before - after));
      }
  std::sort(borders.begin(), borders.end());
  for (std::size_t i = 1; i < borders.size(); i += 2)
    within.emplace_back(borders[i - 1], borders[i]);
}

// The stretch that holds the place, once those that touch are one.
std::optional<Stretch> about_place(std::vector<Stretch> within) {
  std::sort(within.begin(), within.end());
  for (auto next = within.begin(); next != within.end();) {
    Stretch one = *next;
    while (++next != within.end() && next->first <= one.second + area_touching)
      one.second = std::max(one.second, next->second);
    if (one.first < 0 && one.second > 0) return one;
  }
  return std::nullopt;
}

double middle_of(std::vector<double>& values) {
  const auto middle = values.begin() + (values.size() - 1) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle <= area_reach ? *middle : infinite;
}

}  // namespace

std::optional<KerbsByArea> kerbs_by_area(const Line& axis, const std::vector<MultiPolygon>& areas) {
  const Line line = distinct(planar(axis));
  const double total = length(line);
  const int looks = static_cast<int>(std::clamp(std::ceil(total / step), 1.0, 1000.0));
  std::vector<double> left, right;
  for (int i = 0; i < looks; ++i) {
    poll_cancel();
    const LinePosition at = position_at(line, total * (i + 0.5) / looks);
    std::vector<Stretch> within;
    for (const MultiPolygon& area : areas)
      append_within(area, planar(at.point), left_normal(at.direction), within);
    const auto about = about_place(std::move(within));
    if (!about) continue;
    left.push_back(about->second);
    right.push_back(-about->first);
  }
  if (left.empty() || left.size() < least_share * looks) return std::nullopt;
  double to_left = middle_of(left), to_right = middle_of(right);
  const double near = std::min(to_left, to_right), far = std::max(2 * near + 2, usual_side);
  if (near == infinite || 2 * near < least_width) return std::nullopt;
  if (to_left > far) to_left = near;
  if (to_right > far) to_right = near;
  return KerbsByArea{to_left + to_right, (to_left - to_right) / 2};
}

}  // namespace streetgen
