#include "sidewalk/straight_end.hpp"

#include <algorithm>

#include "geometry/closed_ring.hpp"
#include "geometry/polyline.hpp"
#include "geometry/ring_simplicity.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

// Of a place from the end of the sidewalk's own kerb: along it, and away from the roadway.
struct Offset {
  double ahead, behind;  // metres
};

class StraightEnd {
 public:
  StraightEnd(const std::vector<SidewalkKerb>& kerbs, const SidewalkEnd& end)
      : line_(kerbs[end.on.front()].line), ahead_(end.ahead), width_(end.width) {
    const Line& own = kerbs[end.beside].line;
    along_ = ahead_ ? unit(own.back() - own[own.size() - 2]) : unit(own[0] - own[1]);
    away_ = ahead_ ? left_normal(along_) : left_normal(along_) * -1;
    for (const int kerb : end.on) append(kerbs[kerb].line);
    corner_ = way_.size();
    append(kerbs[end.none].line);
  }

  Ring ring(double reach) const {
    Ring meeting = up_to_meeting();
    if (lies_within(meeting, reach)) return meeting;
    Ring square = up_to_corner();
    return lies_within(square, reach) ? square : Ring{};
  }

 private:
  void append(const Line& line) {
    Line part = line;
    if (!ahead_) std::reverse(part.begin(), part.end());
    for (const Point& place : part)
      if (way_.empty() || distance(way_.back(), place) > same_place) way_.push_back(planar(place));
  }

  Offset offset(const Point& place) const {
    return {dot(place - way_[0], along_), dot(place - way_[0], away_)};
  }
  Point back_at(double ahead) const { return way_[0] + along_ * ahead + away_ * width_; }

  // The kerb may also come back to the end of the sidewalk, about a sharp corner.
  Ring up_to_meeting() const {
    Ring ring{way_[0]};
    for (std::size_t i = 1; i < way_.size(); ++i) {
      const Offset from = offset(way_[i - 1]), to = offset(way_[i]);
      double share = 2;
      if (to.behind >= width_) share = (width_ - from.behind) / (to.behind - from.behind);
      const bool returns = to.ahead < 0 && from.ahead / (from.ahead - to.ahead) < share;
      if (returns) share = from.ahead / (from.ahead - to.ahead);
      if (share > 1) {
        ring.push_back(way_[i]);
        continue;
      }
      ring.push_back(way_[i - 1] + (way_[i] - way_[i - 1]) * share);
      if (!returns) ring.push_back(back_at(0));
      return closed_about(std::move(ring));
    }
    return {};
  }

  Ring up_to_corner() const {
    const Offset end = offset(way_[corner_ - 1]);
    if (end.ahead <= same_place || end.behind < -same_place || end.behind >= width_) return {};
    Ring ring(way_.begin(), way_.begin() + static_cast<std::ptrdiff_t>(corner_));
    ring.push_back(back_at(end.ahead));
    ring.push_back(back_at(0));
    return closed_about(std::move(ring));
  }

  Ring closed_about(Ring ring) const {
    ring.push_back(ring.front());
    if (!ahead_) std::reverse(ring.begin(), ring.end());
    return closed(std::move(ring));
  }

  bool lies_within(const Ring& ring, double reach) const {
    return !ring.empty() && signed_area(ring) > 0 &&
           std::all_of(
               ring.begin(), ring.end(),
               [&](const Point& place) { return distance_to_line(place, line_) <= reach; }) &&
           simple({{ring}}).value_or(false);
  }

  const Line& line_;  // the first kerb of the way
  bool ahead_;
  double width_;
  Point along_, away_;  // unit vectors
  Line way_;            // from the sidewalk's own kerb on
  std::size_t corner_;  // vertices of it before the kerb without a sidewalk
};

}  // namespace

Ring straight_end(const std::vector<SidewalkKerb>& kerbs, const SidewalkEnd& end, double reach) {
  return StraightEnd(kerbs, end).ring(reach);
}

}  // namespace streetgen
