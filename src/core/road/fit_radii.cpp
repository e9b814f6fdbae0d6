#include "road/fit_radii.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>

#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

constexpr double unsettled = -1;

// A stop of the growth at a radius: a segment that is full (even place) or a bend at its bound.
struct Stop {
  double radius;
  std::size_t place;
  bool operator<(const Stop& other) const {  // the queue gives the greatest first
    return radius != other.radius ? radius > other.radius : place > other.place;
  }
};

class Growth {
 public:
  Growth(const std::vector<double>& lengths, const std::vector<Bend>& bends)
      : lengths_(lengths), bends_(bends), radii_(bends.size(), unsettled) {}

  std::vector<double> grown() {
    for (std::size_t i = 0; i < bends_.size(); ++i)
      if (bends_[i].fixed) radii_[i] = *bends_[i].fixed;
    std::vector<Stop> stops;
    stops.reserve(2 * bends_.size() + 1);
    // A bound beyond what its shorter segment holds stops nothing.
    for (std::size_t i = 0; i < bends_.size(); ++i)
      if (radii_[i] == unsettled &&
          bends_[i].bound * bends_[i].tangent <= std::min(lengths_[i], lengths_[i + 1]))
        stops.push_back({bends_[i].bound, 2 * i + 1});
    for (std::size_t i = 0; i < lengths_.size(); ++i)
      if (wants_more(i)) stops.push_back({full_at(i), 2 * i});
    std::priority_queue<Stop> next({}, std::move(stops));
    for (std::size_t step = 0; !next.empty(); ++step) {
      poll_cancel();
      const Stop stop = next.top();
      next.pop();
      if (stop.place % 2 == 1) {
        if (radii_[stop.place / 2] == unsettled) settle(stop.place / 2, stop.radius, next);
      } else if (wants_more(stop.place / 2) && full_at(stop.place / 2) <= stop.radius) {
        const std::size_t segment = stop.place / 2;
        if (segment > 0 && radii_[segment - 1] == unsettled) settle(segment - 1, stop.radius, next);
        if (segment < bends_.size() && radii_[segment] == unsettled)
          settle(segment, stop.radius, next);
      }
    }
    return std::move(radii_);
  }

 private:
  // The bends of segment i are i - 1 and i.
  bool wants_more(std::size_t i) const {
    return (i > 0 && radii_[i - 1] == unsettled) || (i < bends_.size() && radii_[i] == unsettled);
  }
  double full_at(std::size_t i) const {
    double room = lengths_[i], tangents = 0;
    const auto take = [&](std::size_t bend) {
      if (radii_[bend] == unsettled)
        tangents += bends_[bend].tangent;
      else
        room -= radii_[bend] * bends_[bend].tangent;
    };
    if (i > 0) take(i - 1);
    if (i < bends_.size()) take(i);
    return tangents > 0 ? std::max(room, 0.0) / tangents : infinite;
  }
  void settle(std::size_t bend, double radius, std::priority_queue<Stop>& next) {
    radii_[bend] = radius;
    for (const std::size_t segment : {bend, bend + 1})
      if (wants_more(segment)) next.push({std::max(full_at(segment), radius), 2 * segment});
  }

  const std::vector<double>& lengths_;
  const std::vector<Bend>& bends_;
  std::vector<double> radii_;
};

}  // namespace

double half_turn_tangent(double sine, double cosine) {
  return cosine > 0 ? sine / (1 + cosine) : (1 - cosine) / sine;  // without loss of digits
}

double radius_of_shift(double tangent, double shift) {
  const double square = tangent * tangent;
  return shift * (std::sqrt(1 + square) + 1) / square;
}

std::vector<double> fit_radii(const std::vector<double>& lengths, const std::vector<Bend>& bends) {
  return Growth(lengths, bends).grown();
}

}  // namespace streetgen
