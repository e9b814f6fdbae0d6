#include "roadway/section_taper.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "layout/node_corner.hpp"
#include "layout/width_transition.hpp"

namespace streetgen {

namespace {

// The kerb on one side of an edge between a limit and the end of the change.
struct KerbTaper {
  int side = 1;                 // +1: left of the edge, -1: right
  double limit = 0, until = 0;  // metres along the edge
  double half = 0;              // metres at the limit
  double own = 0;               // at the end of the change
  EdgeEnd beyond;               // as which the street goes on

  bool covers(double abscissa) const {
    return std::min(limit, until) <= abscissa && abscissa <= std::max(limit, until);
  }
  double half_at(double abscissa) const {
    return own + (half - own) * (abscissa - until) / (limit - until);
  }
};

class SectionTapers {
 public:
  explicit SectionTapers(Layout& layout) : layout_(layout), by_edge_(layout.axes.size()) {}

  void find() {
    for (const Junction& junction : layout_.junctions)
      for (std::size_t i = 0; i < junction.gaps.size(); ++i)
        if (junction.gaps[i].tapers && goes_on(junction, junction.ends[i], junction.next(i)))
          taper(junction.ends[i], junction.next(i));
  }

  void give() {
    for (std::size_t e = 0; e < by_edge_.size(); ++e)
      if (!by_edge_[e].empty() || !layout_.arms[2 * e].merging.empty())
        layout_.streets.roadways[e].profile = profile_of(static_cast<int>(e));
  }

 private:
  double bend(const EdgeEnd& a, const EdgeEnd& b) const {
    return std::abs(angle_between(layout_.arm(a), layout_.arm(b)) - M_PI);
  }

  // Whether neither street goes on straighter elsewhere, as past a ramp.
  bool goes_on(const Junction& junction, const EdgeEnd& a, const EdgeEnd& b) const {
    const double own = bend(a, b);
    return std::none_of(junction.ends.begin(), junction.ends.end(), [&](const EdgeEnd& other) {
      const bool third = slot(other) != slot(a) && slot(other) != slot(b);
      return third && std::min(bend(a, other), bend(other, b)) < own - same_angle;
    });
  }

  // The left kerb of a goes on as the right one of b.
  void taper(const EdgeEnd& a, const EdgeEnd& b) {
    const Arm &arm_a = layout_.arm(a), &arm_b = layout_.arm(b);
    const double speed = std::max(layout_.axis_of(a.edge).speed, layout_.axis_of(b.edge).speed);
    const double wanted = taper_length(sideways(arm_a, arm_b), speed, layout_.settings.taper_ratio);
    if (arm_a.limit + arm_b.limit >= wanted) return;
    const double reach_a = reach(a, wanted), reach_b = reach(b, wanted);
    const double half_a = half_at(arm_a, reach_a, +1), half_b = half_at(arm_b, reach_b, -1);
    const double slope = (half_b - half_a) / (reach_a + reach_b);
    add(a, +1, reach_a, half_a + slope * (reach_a - arm_a.limit), b);
    add(b, -1, reach_b, half_b - slope * (reach_b - arm_b.limit), a);
  }

  // Metres from the node; the limit where the section has no room for more.
  double reach(const EdgeEnd& end, double wanted) const {
    const Arm& arm = layout_.arm(end);
    if (limits_crossed(layout_.streets, end.edge)) return arm.limit;
    const double room = length(arm.line) - layout_.arm({end.edge, !end.at_start}).limit;
    return std::max(arm.limit, std::min(transition_limit(arm, wanted), room));
  }

  void add(const EdgeEnd& end, int side, double reach, double half, const EdgeEnd& beyond) {
    Arm& arm = layout_.arm(end);
    if (reach - arm.limit < coordinate_margin) return;
    const double total = length(arm.line), own = half_at(arm, reach, side);
    const auto along_edge = [&](double from_node) {
      return end.at_start ? from_node : total - from_node;
    };
    by_edge_[end.edge].push_back(
        {end.at_start ? side : -side, along_edge(arm.limit), along_edge(reach), half, own, beyond});
    const Point foot = planar(position_at(arm.line, arm.limit).point);
    Point& kerb = arm.border[side > 0 ? 0 : 1];
    kerb = foot + unit(kerb - arm.border[side > 0 ? 1 : 0]) * half;
    const double widest = half - side * arm.roadway_offset;
    arm.widest = std::max(arm.widest, widest);
    Arm& back = layout_.arm({end.edge, !end.at_start});
    back.widest = std::max(back.widest, widest);
  }

  double half_on(int e, int side, double abscissa) const {
    for (const KerbTaper& taper : by_edge_[e])
      if (taper.side == side && taper.covers(abscissa)) return taper.half_at(abscissa);
    return half_at(layout_.arms[2 * e], abscissa, side);
  }

  WidthProfile profile_of(int e) const {
    const double total = length(layout_.arms[2 * e].line);
    std::set<double> abscissas{0, total};
    WidthProfile profile;
    for (const KerbTaper& taper : by_edge_[e]) {
      abscissas.insert({taper.limit, taper.until});
      (taper.limit < taper.until ? profile.beyond_start : profile.beyond_end) = {
          taper.beyond.edge, taper.beyond.at_start};
    }
    for (const MergingStretch& stretch : layout_.arms[2 * e].merging)
      for (const double abscissa : stretch.places())
        abscissas.insert(std::clamp(abscissa, 0.0, total));
    for (const double abscissa : abscissas)
      profile.places.push_back({abscissa, half_on(e, +1, abscissa), half_on(e, -1, abscissa)});
    return profile;
  }

  Layout& layout_;
  std::vector<std::vector<KerbTaper>> by_edge_;
};

}  // namespace

void taper_sections(Layout& layout) {
  SectionTapers tapers(layout);
  tapers.find();
  tapers.give();
}

}  // namespace streetgen
