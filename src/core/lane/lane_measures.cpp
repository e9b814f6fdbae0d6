#include "streetgen/lane_measures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

// Metres: places nearer to a limit than this are the limit.
constexpr double at_limit = 1e-6;
// A sine: a vertex that turns less is on a straight line.
constexpr double straight = 1e-9;
// Metres of a lane that are none.
constexpr double no_length = 1e-9;

// Where the bends of an axis begin and end for the widest lane.
std::vector<double> bend_ends(const Line& axis, double widest) {
  std::vector<double> ends;
  double abscissa = 0;
  for (std::size_t i = 1; i + 1 < axis.size(); ++i) {
    const Point before = axis[i] - axis[i - 1], behind = axis[i + 1] - axis[i];
    abscissa += norm(before);
    if (norm(before) == 0 || norm(behind) == 0) continue;
    const double turn = std::atan2(cross(before, behind), dot(before, behind));
    if (std::abs(std::sin(turn)) <= straight) continue;
    const double half =
        std::min({widest * std::abs(std::tan(turn / 2)), norm(before) / 2, norm(behind) / 2});
    ends.push_back(abscissa - half);
    ends.push_back(abscissa + half);
  }
  return ends;
}

}  // namespace

LaneMeasures lane_measures(const Line& axis, const Line& lane, double widest, double first,
                           double last) {
  std::vector<std::pair<double, double>> places{
      {first, 0}, {last - first > at_limit ? last : first + 1, length(lane)}};
  for (const double at : bend_ends(axis, widest))
    if (at > first + at_limit && at < last - at_limit)
      places.push_back({at, nearest_abscissa(position_at(axis, at).point, lane)});
  std::sort(places.begin(), places.end());
  // A short lane beside a bend may lie off such a place, and is one stretch then.
  bool off_bend = false;
  for (std::size_t i = 1; i < places.size(); ++i) {
    places[i].second = std::max(places[i].second, places[i - 1].second);
    off_bend = off_bend || places[i].second - places[i - 1].second < no_length;
  }
  if (off_bend) places = {places.front(), places.back()};
  LaneMeasures measures;
  for (const auto& [on_axis, on_lane] : places) {
    measures.on_axis.push_back(on_axis);
    measures.on_lane.push_back(on_lane);
  }
  return measures;
}

double measure_at(const std::vector<double>& places, const std::vector<double>& measures,
                  double place) {
  if (place <= places.front()) return measures.front();
  const std::size_t i = std::lower_bound(places.begin(), places.end(), place) - places.begin();
  if (i == places.size()) return measures.back();
  return measures[i - 1] + (measures[i] - measures[i - 1]) * (place - places[i - 1]) /
                               (places[i] - places[i - 1]);
}

}  // namespace streetgen
