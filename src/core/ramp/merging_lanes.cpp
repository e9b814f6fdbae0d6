#include "ramp/merging_lanes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "ramp/highway.hpp"

namespace streetgen {

namespace {

constexpr double shortest = 20;                // metres, of a run with a merging lane
constexpr double shortest_piece = 1;           // metres of a lane on a further edge
constexpr double least_taper_share = 1.0 / 3;  // of the room of a merging lane

EdgeEnd far_end(const EdgeEnd& end) { return {end.edge, !end.at_start}; }

// The edges that the lanes of each ramp may reach, by where the highway goes on as it is.
class Courses {
 public:
  Courses(const Layout& layout, const RampRules& rules) : layout_(layout), rules_(rules) {
    for (const RampAxis& axis : rules.axes) parts_.emplace(axis.axis_id, axis.part);
  }

  // From the ramp on.  The room for its limit is no more than the reach of a corner.
  std::vector<EdgeEnd> of(const Ramp& ramp) const {
    const double wanted = ramp.length + ramp.taper + layout_.settings.reach;
    std::vector<EdgeEnd> course;
    std::optional<EdgeEnd> end = EdgeEnd{ramp.merging_edge(), ramp.merging_at_start()};
    for (double covered = 0; end; end = onward(far_end(*end))) {
      if (!course.empty() && end->edge == course.front().edge) break;
      course.push_back(*end);
      covered += length(layout_.arm(*end).line);
      if (covered >= wanted) break;
    }
    return course;
  }

 private:
  // Where the highway goes on behind an end of an edge.
  std::optional<EdgeEnd> onward(const EdgeEnd& end) const {
    const Edge& edge = layout_.streets.network.edges[end.edge];
    const auto& ends = layout_.junctions[end.at_start ? edge.from_node : edge.to_node].ends;
    if (ends.size() != 2 || ends[0].edge == ends[1].edge) return std::nullopt;
    const EdgeEnd& next = ends[slot(ends[0]) == slot(end) ? 1 : 0];
    return goes_on(end, next) ? std::optional(next) : std::nullopt;
  }

  bool goes_on(const EdgeEnd& a, const EdgeEnd& b) const {
    const auto part = [&](const EdgeEnd& end) {
      const auto found = parts_.find(layout_.axis_of(end.edge).axis_id);
      return found == parts_.end() ? RampPart::none : found->second;
    };
    const bool highway = part(a) == RampPart::highway || part(a) == RampPart::unclassed;
    const Arm &arm_a = layout_.arm(a), &arm_b = layout_.arm(b);
    return highway && part(a) == part(b) && as_wide(arm_a, arm_b) &&
           dot(direction(arm_a), direction(arm_b)) <= -highway_straightest && same_lanes(a, b);
  }

  static Point direction(const Arm& arm) {
    return unit(position_at(arm.line, std::min(highway_look, length(arm.line))).point -
                arm.line.front());
  }

  bool same_lanes(const EdgeEnd& a, const EdgeEnd& b) const {
    const auto counts = [&](const EdgeEnd& end, bool towards) {
      const RampEdgeLanes lanes = rules_.lanes_of(layout_.streets.network.edges[end.edge]);
      return lanes.both_ways ? -1 : (towards != end.at_start ? lanes.along : lanes.against).count;
    };
    return counts(a, true) >= 0 && counts(a, true) == counts(b, false) &&
           counts(a, false) == counts(b, true);
  }

  const Layout& layout_;
  const RampRules& rules_;
  std::unordered_map<std::int64_t, RampPart> parts_;
};

// Two ramps whose lanes may reach one edge, from its two ends, are those of one run.
class Runs {
 public:
  Runs(const Layout& layout, const RampRules& rules) {
    const Courses courses(layout, rules);
    const std::vector<Ramp>& ramps = layout.streets.ramps;
    courses_.resize(ramps.size());
    for (std::size_t r = 0; r < ramps.size(); ++r) {
      if (ramps[r].missing == 0) continue;
      courses_[r] = courses.of(ramps[r]);
      for (const EdgeEnd& end : courses_[r]) by_edge_[end.edge].push_back(static_cast<int>(r));
    }
    for (int r = 0; r < static_cast<int>(ramps.size()); ++r)
      if (!courses_[r].empty()) add(layout, r);
  }

  std::vector<MergingRun> runs() { return std::move(runs_); }

 private:
  void add(const Layout& layout, int ramp) {
    const std::vector<EdgeEnd>& own = courses_[ramp];
    for (std::size_t i = 0; i < own.size(); ++i)
      for (const int other : by_edge_.at(own[i].edge)) {
        if (other == ramp) continue;
        if (begins_run(layout, ramp, other)) runs_.push_back(joined(ramp, other, i));
        return;
      }
    runs_.push_back({own, ramp, -1});
  }

  // Of both that which does not depend on the numbers of nodes.
  static bool begins_run(const Layout& layout, int ramp, int other) {
    const auto place = [&](int r) {
      const Point& p = layout.streets.network.nodes[layout.streets.ramps[r].node].point;
      return std::pair(p.x, p.y);
    };
    return place(ramp) < place(other);
  }

  // By the edge that both reach, at index i of the first one.
  MergingRun joined(int ramp, int other, std::size_t i) const {
    const std::vector<EdgeEnd>&own = courses_[ramp], &theirs = courses_[other];
    MergingRun run{{own.begin(), own.begin() + i + 1}, ramp, other};
    auto end = std::find_if(theirs.begin(), theirs.end(),
                            [&](const EdgeEnd& e) { return e.edge == own[i].edge; });
    while (end != theirs.begin()) run.edges.push_back(far_end(*--end));
    return run;
  }

  std::vector<std::vector<EdgeEnd>> courses_;  // by ramp
  std::map<int, std::vector<int>> by_edge_;    // ramps
  std::vector<MergingRun> runs_;
};

// The lanes of one ramp: metres from its limit to where their width is full, and to where they end.
struct Lanes {
  double full = 0, all = 0;
};

// Distributes lanes over the edges of a run, in metres along its sections: tapers pause within the
// intersection at a bend.  Two lanes that meet are one; of others on one side each gets its share.
class Room {
 public:
  Room(Layout& layout, const MergingRun& run) : layout_(layout), run_(run) {
    for (const EdgeEnd& end : run.edges) ends_.push_back(ends_.back() + length_of(end));
    starts_ = ends_;
    near_.resize(run.edges.size());
  }

  // Limits are not known: each lane has its full width at all nodes that it may reach.
  void give_widest() {
    if (meet()) give(whole());
    for (const bool first : {true, false}) {
      if (meet() || ramp_at(first) == nullptr) continue;
      const Ramp& ramp = *ramp_at(first);
      Lanes lanes = fitted(ramp, room());
      for (std::size_t k = 1; k < run_.edges.size(); ++k)
        if (from_ramp(first, k) < wanted(ramp) + layout_.settings.reach)
          lanes.full = std::max(lanes.full, from_ramp(first, k));
      lanes.all = std::max(lanes.all, std::min(room(), lanes.full + least_taper));
      give(stretch_of(first, lanes));
    }
    widen();
  }

  // Between the limits.
  void settle() {
    measure_sections();
    for (const EdgeEnd& end : run_.edges) layout_.streets.roadways[end.edge].merging.clear();
    if (meet() && open(true) == run_.edges.size()) {
      for (Ramp* ramp : {ramp_at(true), ramp_at(false)}) ramp->full_length = room();
      give(whole());
    } else {
      for (const bool first : {true, false})
        if (Ramp* ramp = ramp_at(first)) settle(*ramp, first);
    }
    widen();
    for (const EdgeEnd& end : run_.edges)
      if (limits_crossed(layout_.streets, end.edge))
        layout_.streets.roadways[end.edge].merging.clear();
  }

 private:
  double length_of(const EdgeEnd& end) const { return length(layout_.arm(end).line); }
  double room() const { return starts_.back(); }
  // To the start of the section at index k.
  double from_ramp(bool first, std::size_t k) const {
    return first ? starts_[k] : room() - starts_[k];
  }

  void measure_sections() {
    for (std::size_t k = 0; k < run_.edges.size(); ++k) {
      const EdgeEnd& end = run_.edges[k];
      near_[k] = layout_.arm(end).limit;
      const double section = length_of(end) - near_[k] - layout_.arm(far_end(end)).limit;
      starts_[k + 1] = starts_[k] + std::max(section, 0.0);
    }
  }

  Ramp* ramp_at(bool first) const {
    const int ramp = first ? run_.first_ramp : run_.last_ramp;
    return ramp < 0 ? nullptr : &layout_.streets.ramps[ramp];
  }

  // Of the run: +1 left, -1 right.
  int side_at(bool first) const {
    // With the traffic of the highway, which leaves the node behind an on-ramp.
    const Ramp& ramp = *ramp_at(first);
    return ramp.on == first ? ramp.side : -ramp.side;
  }

  bool one_side() const {
    return ramp_at(true) && ramp_at(false) && side_at(true) == side_at(false);
  }

  static double wanted(const Ramp& ramp) { return ramp.length + ramp.taper; }

  // By lengths alone, so that it does not depend on limits.
  bool meet() const {
    return one_side() && ramp_at(true)->on != ramp_at(false)->on &&
           wanted(*ramp_at(true)) + wanted(*ramp_at(false)) >= ends_.back();
  }

  // How many edges lie before limits that crossed, from an end of the run on.
  std::size_t open(bool first) const {
    const std::size_t count = run_.edges.size();
    std::size_t many = 0;
    while (many < count &&
           !limits_crossed(layout_.streets, run_.edges[first ? many : count - 1 - many].edge))
      ++many;
    return many;
  }

  // The length of full width, and with the taper.  Of less room the taper gives way first, down to
  // a third of the room.
  static Lanes fitted(const Ramp& ramp, double room) {
    const double taper =
        std::min(ramp.taper, std::max(room - ramp.length, room * least_taper_share));
    const double full = std::min(ramp.length, room - taper);
    return {full, full + taper};
  }

  void settle(Ramp& ramp, bool first) {
    const std::size_t many = open(first);
    ramp.auxiliary = false;
    if (many == 0) {
      ramp.merging = 0, ramp.full_length = 0, ramp.cut = true;
      keep_width_at(first);
      return;
    }
    const double whole_room = from_ramp(first, first ? many : run_.edges.size() - many);
    const double both =
        one_side() ? wanted(*ramp_at(true)) + wanted(*ramp_at(false)) : wanted(ramp);
    const double share = both > whole_room ? whole_room * wanted(ramp) / both : whole_room;
    ramp.cut = share < wanted(ramp);
    Lanes lanes = fitted(ramp, share);
    ramp.full_length = lanes.full;
    lanes.all = ends_at(lanes.all, whole_room, first);
    lanes.full = std::min(lanes.full, lanes.all - std::min(least_taper, share * least_taper_share));
    give(stretch_of(first, lanes));
  }

  // A lane that fills its room ends at the limit itself, and one that hardly reaches a further edge
  // before it.
  double ends_at(double abscissa, double last, bool first) const {
    if (std::abs(abscissa - last) < coordinate_margin) return last;
    for (std::size_t k = 1; k < run_.edges.size(); ++k) {
      const double beyond = abscissa - from_ramp(first, k);
      if (beyond > -coordinate_margin && beyond < shortest_piece) return from_ramp(first, k);
    }
    return abscissa;
  }

  // Where the limits of the ramp's edge crossed it has no lane, but its corners have that width.
  void keep_width_at(bool first) {
    const EdgeEnd end = first ? run_.edges.front() : far_end(run_.edges.back());
    MergingStretch stretch;
    stretch.side = first ? side_at(first) : -side_at(first);
    stretch.width = ramp_at(first)->merging_width;
    stretch.full_to = length_of(end) / 2;
    stretch.to = length_of(end);
    layout_.streets.roadways[end.edge].merging.push_back(
        end.at_start ? stretch : stretch.turned(length_of(end)));
  }

  // Along the run.
  MergingStretch stretch_of(bool first, const Lanes& lanes) const {
    Ramp& ramp = *ramp_at(first);
    MergingStretch stretch;
    stretch.side = side_at(first);
    stretch.lanes = ramp.merging = ramp.missing;
    stretch.width = ramp.merging_width;
    stretch.along_axis = ramp.on == first;
    (ramp.on ? stretch.enters : stretch.leaves) = true;
    stretch.full_to = stretch.to = room();
    if (first)
      stretch.full_to = lanes.full, stretch.to = lanes.all;
    else
      stretch.full_from = room() - lanes.full, stretch.from = room() - lanes.all;
    return stretch;
  }

  MergingStretch whole() const {
    Ramp &a = *ramp_at(true), &b = *ramp_at(false);
    MergingStretch stretch = stretch_of(true, {room(), room()});
    stretch.width = std::max(a.merging_width, b.merging_width);
    stretch.lanes = std::max(a.missing, b.missing);
    stretch.enters = stretch.leaves = true;
    for (Ramp* ramp : {&a, &b}) {
      ramp->auxiliary = true;
      ramp->cut = false;
      ramp->merging = stretch.lanes;
    }
    return stretch;
  }

  void give(const MergingStretch& along_run) {
    for (std::size_t k = 0; k < run_.edges.size(); ++k) {
      const double from = starts_[k], to = starts_[k + 1];
      if (along_run.to <= from || along_run.from >= to) continue;
      const EdgeEnd& end = run_.edges[k];
      MergingStretch piece = along_run;
      for (double* abscissa : {&piece.from, &piece.full_from, &piece.full_to, &piece.to})
        *abscissa += near_[k] - from;
      piece.section_from = near_[k];
      piece.section_to = near_[k] + (to - from);
      piece.comes_on = along_run.from < from;
      piece.goes_on = along_run.to > to;
      // No rounding keeps a lane from its limit.
      if (along_run.to == to) piece.to = piece.section_to;
      if (along_run.full_to == to) piece.full_to = piece.section_to;
      if (!end.at_start) piece = piece.turned(length_of(end));
      layout_.streets.roadways[end.edge].merging.push_back(piece);
    }
  }

  // The arms get what the roadways have.
  void widen() {
    for (const EdgeEnd& end : run_.edges) {
      const auto& merging = layout_.streets.roadways[end.edge].merging;
      Arm &start = layout_.arms[2 * end.edge], &back = layout_.arms[2 * end.edge + 1];
      start.merging = merging;
      back.merging.clear();
      for (const MergingStretch& stretch : merging)
        back.merging.push_back(stretch.turned(length_of(end)));
      for (Arm* arm : {&start, &back})
        for (const MergingStretch& stretch : merging)
          arm->widest =
              std::max(arm->widest, std::max(arm->half_start, arm->half_end) + stretch.width);
    }
  }

  Layout& layout_;
  const MergingRun& run_;
  std::vector<double> ends_{0};  // metres along the run, to each node
  std::vector<double> starts_;   // metres along its sections, to each of them and to the end
  std::vector<double> near_;     // metres along each edge to its section
};

double length_of(const Layout& layout, const MergingRun& run) {
  double total = 0;
  for (const EdgeEnd& end : run.edges) total += length(layout.arm(end).line);
  return total;
}

}  // namespace

MergingStretch MergingStretch::turned(double length) const {
  MergingStretch other = *this;
  other.side = -side;
  other.from = length - to;
  other.full_from = length - full_to;
  other.full_to = length - full_from;
  other.to = length - from;
  other.section_from = length - section_to;
  other.section_to = length - section_from;
  other.along_axis = !along_axis;
  std::swap(other.comes_on, other.goes_on);
  return other;
}

void give_merging_lanes(Layout& layout, const RampRules& rules) {
  for (MergingRun& run : Runs(layout, rules).runs()) {
    if (length_of(layout, run) >= shortest) {
      layout.merging_runs.push_back(std::move(run));
      continue;
    }
    for (const int ramp : {run.first_ramp, run.last_ramp})
      if (ramp >= 0) layout.streets.ramps[ramp].cut = true;
  }
  for (const MergingRun& run : layout.merging_runs) Room(layout, run).give_widest();
}

void settle_merging_lanes(Layout& layout) {
  for (const MergingRun& run : layout.merging_runs) Room(layout, run).settle();
}

}  // namespace streetgen
