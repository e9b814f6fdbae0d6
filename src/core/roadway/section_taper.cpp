#include "roadway/section_taper.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "layout/node_corner.hpp"
#include "layout/width_transition.hpp"
#include "roadway/near_limits.hpp"

namespace streetgen {

namespace {

// The kerb on one side of an edge between a limit and the end of its taper.
struct KerbTaper {
  int side = 1;                 // +1: left of the edge, -1: right
  double limit = 0, until = 0;  // metres along the edge
  double half = 0;              // metres at the limit
  double own = 0;               // at the end of the change
  EdgeEnd beyond;               // as which the street goes on; no edge where it does elsewhere

  bool covers(double abscissa) const {
    return std::min(limit, until) <= abscissa && abscissa <= std::max(limit, until);
  }
  double half_at(double abscissa) const {
    return own + (half - own) * (abscissa - until) / (limit - until);
  }
};

// The side of an edge between a limit and the arc of a corner beyond it: up to the crossing of
// its kerb with that of a neighbour its section ends on what parts it from the neighbour's.
struct SharedSide {
  int side = 1;
  std::vector<std::pair<double, double>> places;  // ascending: metres along the edge, and aside

  bool covers(double abscissa) const {
    return places.front().first <= abscissa && abscissa <= places.back().first;
  }
  double half_at(double abscissa) const {
    const auto next = std::find_if(places.begin() + 1, places.end() - 1,
                                   [&](const auto& place) { return place.first >= abscissa; });
    const auto& [from, half] = *(next - 1);
    return half + (next->second - half) * (abscissa - from) / (next->first - from);
  }
};

// Where the own kerb of a narrower street that bends towards it comes out of the line in which the
// kerb of a wider one goes on; the kerb is on that side of the wider one, seen from the node.
struct WayOut {
  double before = 0;  // metres from the node along the wider one, which the bend needs
  double after = 0;   // along the narrower one
};
std::optional<WayOut> way_out(const Arm& wide, const Arm& narrow, int side) {
  const Point node = planar(wide.line.front());
  const Point along = position_at(wide.line, 0).direction,
              aside = left_normal(along) * static_cast<double>(side);
  const double half = half_at(wide, 0, side);
  double abscissa = 0;
  for (std::size_t i = 1; i < narrow.line.size(); ++i) {
    const Point from = planar(narrow.line[i - 1]), to = planar(narrow.line[i]);
    const Point own = left_normal(unit(to - from)) * static_cast<double>(-side);
    const double size = distance(from, to);
    const auto off = [&](const Point& p, double at) {
      return dot(p - node + own * half_at(narrow, at, -side), aside);
    };
    const double start = off(from, abscissa), end = off(to, abscissa + size);
    if (end >= half) {
      if (start >= half) return std::nullopt;
      const double sine = std::abs(cross(along, position_at(narrow.line, 0).direction));
      return WayOut{half * sine + coordinate_margin,
                    abscissa + size * (half - start) / (end - start)};
    }
    abscissa += size;
  }
  return std::nullopt;
}

class SectionTapers {
 public:
  explicit SectionTapers(Layout& layout)
      : layout_(layout), by_edge_(layout.axes.size()), shared_(layout.axes.size()) {}

  void find() {
    for (Junction& junction : layout_.junctions)
      for (std::size_t i = 0; i < junction.gaps.size(); ++i) {
        Gap& gap = junction.gaps[i];
        if (gap.tapers && !gap.direct) taper(junction, i, gap);
        if (gap.parting.empty()) continue;
        share(junction.ends[i], +1, gap);
        share(junction.next(i), -1, gap);
      }
  }

  void give() {
    for (std::size_t e = 0; e < by_edge_.size(); ++e)
      if (!by_edge_[e].empty() || !shared_[e].empty() || !layout_.arms[2 * e].merging.empty())
        layout_.streets.roadways[e].profile = profile_of(static_cast<int>(e));
  }

 private:
  double bend(const EdgeEnd& a, const EdgeEnd& b) const {
    return std::abs(angle_between(layout_.arm(a), layout_.arm(b)) - M_PI);
  }

  // Whether neither street goes on much straighter elsewhere, as past a ramp; both branches of a
  // fork bend alike but for rounding.
  bool goes_on(const Junction& junction, const EdgeEnd& a, const EdgeEnd& b) const {
    const double own = bend(a, b);
    return std::none_of(junction.ends.begin(), junction.ends.end(), [&](const EdgeEnd& other) {
      const bool third = slot(other) != slot(a) && slot(other) != slot(b);
      return third && std::min(bend(a, other), bend(other, b)) < own / 2 - same_angle;
    });
  }

  // Metres from the node to the kerb of a third street that goes on beside a or b as the other one,
  // but no farther out than both.
  double held_out(const Junction& junction, const EdgeEnd& a, const EdgeEnd& b) const {
    const Arm &arm_a = layout_.arm(a), &arm_b = layout_.arm(b);
    double half = 0;
    for (const EdgeEnd& end : junction.ends) {
      if (slot(end) == slot(a) || slot(end) == slot(b)) continue;
      const Arm& third = layout_.arm(end);
      if (nearly_in_line(angle_between(arm_a, third))) half = std::max(half, third.start_to(-1));
      if (nearly_in_line(angle_between(third, arm_b))) half = std::max(half, third.start_to(+1));
    }
    return std::min(half, std::max(arm_a.start_to(+1), arm_b.start_to(-1)));
  }

  // The left kerb of a goes on as the right one of b.
  void taper(const Junction& junction, std::size_t i, Gap& gap) {
    const EdgeEnd &a = junction.ends[i], &b = junction.next(i);
    const Arm &arm_a = layout_.arm(a), &arm_b = layout_.arm(b);
    const double speed = std::max(layout_.axis_of(a.edge).speed, layout_.axis_of(b.edge).speed);
    const double wanted = taper_length(sideways(arm_a, arm_b), speed, layout_.settings.taper_ratio);
    const bool beyond = goes_on(junction, a, b);
    const auto straight = straight_on(a, b, wanted, beyond);
    const auto [reach_a, reach_b] =
        straight.value_or(std::pair(reach(a, +1, wanted, beyond), reach(b, -1, wanted, beyond)));
    gap.taper = {reach_a,
                 reach_b,
                 half_at(arm_a, reach_a, +1),
                 half_at(arm_b, reach_b, -1),
                 straight.has_value(),
                 held_out(junction, a, b)};
    gap.direct = gap.taper.length() < coordinate_margin;
    if (gap.direct) return;
    constexpr EdgeEnd none{-1, true};
    add(a, +1, reach_a, gap.taper.half_a, gap.taper.half_on_a(arm_a.limit), beyond ? b : none);
    add(b, -1, reach_b, gap.taper.half_b, gap.taper.half_on_b(arm_b.limit), beyond ? a : none);
  }

  // The outer kerb of a fork goes straight on from the wider street to where that of the branch
  // comes out, at most as far as two changes of width and with no more ground than a corner.
  std::optional<std::pair<double, double>> straight_on(const EdgeEnd& a, const EdgeEnd& b,
                                                       double wanted, bool beyond) const {
    const Arm &arm_a = layout_.arm(a), &arm_b = layout_.arm(b);
    const bool a_is_wide = arm_a.start_to(+1) > arm_b.start_to(-1);
    const auto way = a_is_wide ? way_out(arm_a, arm_b, +1) : way_out(arm_b, arm_a, -1);
    if (!way || way->after > 2 * wanted) return std::nullopt;
    const double ground = way->after * sideways(arm_a, arm_b) / 2;
    const EdgeEnd &wide = a_is_wide ? a : b, &narrow = a_is_wide ? b : a;
    if (ground > layout_.settings.corner_area ||
        way->after > room(narrow, a_is_wide ? -1 : +1, beyond))
      return std::nullopt;
    const double before = std::min(way->before, room(wide, a_is_wide ? +1 : -1, beyond));
    return a_is_wide ? std::pair(before, way->after) : std::pair(way->after, before);
  }

  // Metres from the node, as far as the kerb has room, or to where the section shares no ground any
  // more.
  double room(const EdgeEnd& end, int side, bool beyond) const {
    const double room = kerb_room(layout_, end, side);
    const double alone = layout_.arm(end).limit + layout_.streets.limits[slot(end)].shared;
    return beyond ? room : std::min(alone, room);
  }
  double reach(const EdgeEnd& end, int side, double wanted, bool beyond) const {
    return std::min(transition_limit(layout_.arm(end), wanted), room(end, side, beyond));
  }

  void add(const EdgeEnd& end, int side, double reach, double own, double half,
           const EdgeEnd& beyond) {
    Arm& arm = layout_.arm(end);
    if (reach - arm.limit < coordinate_margin) return;
    const double total = length(arm.line);
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

  void share(const EdgeEnd& end, int side, const Gap& gap) {
    const Arm& arm = layout_.arm(end);
    const double total = length(arm.line);
    const CornerArc& crossing = *gap.crossing;
    SharedSide shared{end.at_start ? side : -side, {}};
    const auto add = [&](double from_node, double half) {
      shared.places.emplace_back(end.at_start ? from_node : total - from_node, half);
    };
    const double last = side > 0 ? crossing.abscissa_a : crossing.abscissa_b;
    double before = arm.limit;
    add(before, distance(gap.parting.front(), planar(position_at(arm.line, before).point)));
    for (auto p = gap.parting.begin() + 1; p != gap.parting.end(); ++p) {
      const double abscissa = nearest_abscissa(*p, arm.line);
      if (abscissa < before + coordinate_margin || abscissa > last - coordinate_margin) continue;
      add(before = abscissa, distance_to_line(*p, arm.line));
    }
    add(last, arm.start_to(side));
    // The arc's end is a place too: by it an edit sees that the arc is another.
    const double arc = side > 0 ? gap.corner.abscissa_a : gap.corner.abscissa_b;
    if (arc > last + coordinate_margin) add(arc, arm.start_to(side));
    if (!end.at_start) std::reverse(shared.places.begin(), shared.places.end());
    shared_[end.edge].push_back(std::move(shared));
  }

  double half_on(int e, int side, double abscissa) const {
    for (const SharedSide& shared : shared_[e])
      if (shared.side == side && shared.covers(abscissa)) return shared.half_at(abscissa);
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
    for (const SharedSide& shared : shared_[e])
      for (const auto& place : shared.places) abscissas.insert(place.first);
    for (const MergingStretch& stretch : layout_.arms[2 * e].merging)
      for (const double abscissa : stretch.places())
        abscissas.insert(std::clamp(abscissa, 0.0, total));
    for (const double abscissa : abscissas)
      profile.places.push_back({abscissa, half_on(e, +1, abscissa), half_on(e, -1, abscissa)});
    return profile;
  }

  Layout& layout_;
  std::vector<std::vector<KerbTaper>> by_edge_;
  std::vector<std::vector<SharedSide>> shared_;  // by edge
};

}  // namespace

void taper_sections(Layout& layout) {
  SectionTapers tapers(layout);
  tapers.find();
  tapers.give();
}

}  // namespace streetgen
