#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/closed_ring.hpp"
#include "geometry/polyline.hpp"
#include "geometry/ring_simplicity.hpp"
#include "road/curve_chords.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/surface.hpp"

namespace streetgen {

namespace {

constexpr double search_widths = 10;

// Where a border of the crossing meets a kerb.
struct Landing {
  Point point;
  double abscissa;  // along the kerb
};

std::optional<Landing> landing(const Point& from, const Point& to, const Line& kerb) {
  poll_cancel();
  std::optional<Landing> nearest;
  double before = 0;
  for (std::size_t i = 1; i < kerb.size(); ++i) {
    const auto place = crossing(from, to, kerb[i - 1], kerb[i]);
    if (place && (!nearest || distance(from, *place) < distance(from, nearest->point)))
      nearest = Landing{*place, before + distance(kerb[i - 1], *place)};
    before += distance(kerb[i - 1], kerb[i]);
  }
  return nearest;
}

// Of a closed kerb the shorter way.
Line followed(const Line& kerb, const Landing& from, const Landing& to) {
  const double total = length(kerb), apart = to.abscissa - from.abscissa;
  Line way;
  if (distance(kerb.front(), kerb.back()) > 0 || std::abs(apart) <= total / 2) {
    way = substring(kerb, from.abscissa, to.abscissa);
  } else {
    const double end = apart > 0 ? 0 : total;
    way = substring(kerb, from.abscissa, end);
    const Line rest = substring(kerb, total - end, to.abscissa);
    way.insert(way.end(), rest.begin() + 1, rest.end());
  }
  way.front() = from.point;
  way.back() = to.point;
  return way;
}

struct PedestrianCrossing {
  Point centre;
  Point across;  // unit, to the left
  double width;

  // Whether the kerb keeps to the crossing, so that it bounds it.
  bool bounded_by(const Line& kerb) const {
    return std::all_of(kerb.begin(), kerb.end(), [&](const Point& p) {
      return std::abs(cross(across, p - centre)) <= 1.5 * width;
    });
  }
};

}  // namespace

std::optional<Polygon> crossing_surface(const Line& axis, const CurvedLine& kerb_left,
                                        const CurvedLine& kerb_right, double abscissa, double width,
                                        double angle) {
  return crossing_surface(axis, curve_chords(kerb_left), curve_chords(kerb_right), abscissa, width,
                          angle);
}

std::optional<Polygon> crossing_surface(const Line& axis, const Line& left, const Line& right,
                                        double abscissa, double width, double angle) {
  const Line line = distinct(planar(axis));
  const double at = std::clamp(abscissa, 0.0, length(line));
  const Point along = local_direction(line, at);
  const Point across = along * std::cos(angle) + left_normal(along) * std::sin(angle);
  const PedestrianCrossing crossing{position_at(line, at).point, across, width};
  const Point step = along * (width / 2 / std::sin(angle));
  const Point before = crossing.centre - step, after = crossing.centre + step;
  const Point reach = across * (search_widths * width);
  const auto right_before = landing(before, before - reach, right);
  const auto right_after = landing(after, after - reach, right);
  const auto left_after = landing(after, after + reach, left);
  const auto left_before = landing(before, before + reach, left);
  if (!right_before || !right_after || !left_after || !left_before) return std::nullopt;
  Ring ring = followed(right, *right_before, *right_after);
  const Line back = followed(left, *left_after, *left_before);
  const bool bounded = crossing.bounded_by(ring) && crossing.bounded_by(back);
  ring.insert(ring.end(), back.begin(), back.end());
  ring.push_back(ring.front());
  ring = closed(std::move(ring));
  if (!bounded || ring.empty() || !simple({{ring}}).value_or(false))
    ring = closed({right_before->point, right_after->point, left_after->point, left_before->point,
                   right_before->point});
  if (ring.empty() || signed_area(ring) <= 0) return std::nullopt;
  return Polygon{ring};
}

}  // namespace streetgen
