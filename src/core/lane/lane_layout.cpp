#include "lane/lane_layout.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/offset.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

// What lanes without a stated width keep of their least where stated widths leave less.
constexpr double least_kept = 0.5;

}  // namespace

double LaneStrip::half_at(double abscissa) const {
  if (half_start == half_end) return half_start;
  return half_start + (half_end - half_start) * std::clamp(abscissa / length(axis), 0.0, 1.0);
}

double LaneStrip::share_at(double abscissa, const LaneShares& shares) const {
  if (shares.size() == 1) return shares.front();
  const auto& places = profile.places;
  const auto next =
      std::find_if(places.begin(), places.end(),
                   [&](const WidthProfile::Place& place) { return place.abscissa >= abscissa; });
  if (next == places.begin()) return shares.front();
  if (next == places.end()) return shares.back();
  const std::size_t i = next - places.begin();
  const double from_place = places[i - 1].abscissa;
  return shares[i - 1] +
         (shares[i] - shares[i - 1]) * (abscissa - from_place) / (next->abscissa - from_place);
}

double LaneStrip::offset_at(double abscissa, const LaneShares& shares) const {
  const double share = share_at(abscissa, shares);
  if (profile.empty()) return half_at(abscissa) * (1 - 2 * share) + roadway_offset;
  const WidthProfile::Place wide = profile.at(abscissa);
  return wide.left - share * (wide.left + wide.right);
}

std::vector<LaneWish> across(const AxisLanes& lanes, DrivingSide side) {
  std::vector<LaneWish> forward = lanes.forward, backward = lanes.backward;
  for (LaneWish& lane : forward) lane.along_axis = true;
  for (LaneWish& lane : backward) lane.along_axis = false;
  std::vector<LaneWish> middle = lanes.both_ways;
  for (LaneWish& lane : middle) lane.along_axis = lane.both_ways = true;
  std::reverse(backward.begin(), backward.end());
  auto &first = side == DrivingSide::right ? backward : forward,
       &second = side == DrivingSide::right ? forward : backward;
  first.insert(first.end(), middle.begin(), middle.end());
  first.insert(first.end(), second.begin(), second.end());
  if (first.empty()) first.emplace_back();
  return std::move(first);
}

int ordinality_of(int position, int count, LaneOrder order) {
  // Twice the distance from the middle, in lanes: 1, 3, 5 where the count is even, else 0, 2, 4.
  const int apart = std::abs(2 * position - count - 1);
  if (apart == 0) return 1;
  const bool left = 2 * position < count + 1;
  return apart + (left == (order == LaneOrder::left_first) ? 0 : 1);
}

LaneSide side_of(int position, int count) {
  const int twice = 2 * position - count - 1;
  return twice < 0 ? LaneSide::left : twice > 0 ? LaneSide::right : LaneSide::centre;
}

std::vector<double> lane_shares(const std::vector<LaneWish>& wishes, double width,
                                double narrowest) {
  double stated = 0, usual = 0;
  int open = 0;
  for (const LaneWish& wish : wishes) {
    (wish.yields ? usual : stated) += wish.width;
    if (wish.width <= 0) ++open;
  }
  const double rest = open > 0 ? std::max((width - stated - usual) / open, narrowest) : 0,
               yielding = usual + open * rest;
  const double kept = stated + yielding > width + same_place
                          ? std::clamp((width - stated) / yielding, least_kept, 1.0)
                          : 1;
  std::vector<double> widths;
  for (const LaneWish& wish : wishes)
    widths.push_back(wish.width > 0    ? wish.width * (wish.yields ? kept : 1)
                     : wish.widest > 0 ? std::min(rest * kept, wish.widest)
                                       : rest * kept);
  const double filled = std::accumulate(widths.begin(), widths.end(), 0.0);
  const bool driven = std::any_of(wishes.begin(), wishes.end(),
                                  [](const LaneWish& wish) { return drives(wish.kind); });
  const double surplus = driven && width > filled + same_place ? width - filled : 0;
  const double total = filled + surplus;
  std::vector<double> shares{surplus / 2 / total};
  double sum = surplus / 2;
  for (const double lane : widths) {
    sum += lane;
    shares.push_back(sum / total);
  }
  shares.back() = 1 - shares.front();
  return shares;
}

namespace {

// A bend beside the limit may lie behind the border line, which is normal to the axis about it.
void drop_behind(Line& line, const Line& border, double reach) {
  const Point onwards = left_normal(border[1] - border[0]);
  auto first = line.begin() + 1;
  while (first + 1 != line.end() && distance(*first, line.front()) < reach &&
         dot(*first - line.front(), onwards) <= 0)
    ++first;
  line.erase(line.begin() + 1, first);
}

// Not yet ended on the borders.
Line along(const LaneStrip& strip, const LaneShares& shares) {
  const double of_half = 1 - 2 * shares.front();
  if (strip.profile.empty())
    return offset_line(strip.axis, strip.from, strip.to,
                       of_half * strip.half_start + strip.roadway_offset,
                       of_half * strip.half_end + strip.roadway_offset);
  Line line;
  const double total = length(strip.axis);
  WidthProfile offsets;
  for (const WidthProfile::Place& place : strip.profile.places)
    offsets.places.push_back({place.abscissa, strip.offset_at(place.abscissa, shares)});
  offsets.of_side(+1).each_stretch(strip.from, strip.to, [&](const auto& from, const auto& to) {
    const auto [start, end] =
        WidthProfile::extended(from.abscissa, from.left, to.abscissa, to.left, total);
    const Line part = offset_line(strip.axis, from.abscissa, to.abscissa, start, end);
    const bool goes_on = !line.empty() && distance(line.back(), part.front()) <= same_place;
    line.insert(line.end(), part.begin() + (goes_on ? 1 : 0), part.end());
  });
  return distinct(std::move(line));
}

}  // namespace

bool is_kerb(const LaneShares& shares) {
  const auto [least, most] = std::minmax_element(shares.begin(), shares.end());
  return *most <= 0 || *least >= 1;
}

Line line_at_shares(const LaneStrip& strip, const LaneShares& shares) {
  Line line = along(strip, shares);
  if (line.size() < 2) line.push_back(line.front());
  const auto on = [&](const Line& border, double abscissa) {
    return border[0] + (border[1] - border[0]) * strip.share_at(abscissa, shares);
  };
  line.front() = on(strip.from_border, strip.from);
  line.back() = on(strip.to_border, strip.to);
  if (is_kerb(shares)) return line;  // that of the section
  const double reach = strip.half_at(strip.from) + std::abs(strip.roadway_offset);
  drop_behind(line, strip.from_border, reach);
  line = reversed(std::move(line));
  drop_behind(line, reversed(strip.to_border), reach);
  return reversed(std::move(line));
}

}  // namespace streetgen
