#include "interconnection/point_arrows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "interconnection/movement_angle.hpp"
#include "interconnection/next_junction.hpp"
#include "interconnection/node_restrictions.hpp"
#include "interconnection/plausibility.hpp"
#include "interconnection/turn.hpp"
#include "lane/arrow_paint.hpp"
#include "lane/turn_mark.hpp"
#include "roundabout/circulation.hpp"

namespace streetgen {

namespace {

// The mark that means a way best.
unsigned mark_of(double angle) {
  if (turn_of(angle) == Turn::through) return turn::through;
  const MarkedTurn* best = nullptr;
  for (const MarkedTurn& mark : marked_turns)
    if (mark.angle != 0 &&
        (best == nullptr || std::abs(mark.angle - angle) < std::abs(best->angle - angle)))
      best = &mark;
  return best->bit;
}

// A node, as traffic finds it that comes by one end of an edge.
struct Outlook {
  bool goes_on = true;       // a way answers to a mark straight on
  bool leads_apart = false;  // two general lanes have no way in common
  std::vector<const Lane*> lanes;
  std::vector<unsigned> ways;  // by lane: what it takes, as marks
};

class ArrowPointer {
 public:
  ArrowPointer(const Streets& streets, const std::vector<TurnRestriction>& restrictions,
               const std::vector<Circulation>& circulations, const WishedLanes& wished,
               DrivingSide driving_side, double node_tolerance, Lanes& lanes)
      : streets_(streets),
        circulations_(circulations),
        wished_(wished),
        driving_side_(driving_side),
        restrictions_(streets.network, restrictions, node_tolerance),
        lanes_(lanes),
        ends_(streets.network.nodes.size()),
        first_(streets.network.edges.size() + 1) {
    const auto& edges = streets.network.edges;
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
      ends_[edges[e].from_node].push_back({e, true});
      ends_[edges[e].to_node].push_back({e, false});
    }
    for (const Lane& lane : lanes.lanes) ++first_[lane.edge + 1];
    for (std::size_t e = 1; e < first_.size(); ++e) first_[e] += first_[e - 1];
  }

  void run() {
    auto& markings = lanes_.markings;
    markings.erase(std::remove_if(markings.begin(), markings.end(),
                                  [this](Marking& marking) {
                                    return marking.kind == MarkingKind::arrow &&
                                           ends_[marking.node].size() > 2 && !stands(marking);
                                  }),
                   markings.end());
  }

 private:
  // Whether an arrow has something to show, which it does then.
  bool stands(Marking& marking) {
    const EdgeEnd end{marking.edge, !marking.along_axis};
    if (!seen_ || slot(seen_from_) != slot(end)) {
      seen_ = outlook(end, marking.node);
      seen_from_ = end;
    }
    const Lane& lane = lanes_.lanes[first_[marking.edge] + marking.position - 1];
    unsigned turns = lane.turns;
    if (turns == 0)
      turns = seen_->leads_apart && drives(lane.kind) ? ways_of(lane, *seen_) : 0;
    else if (!seen_->goes_on && turns != turn::through)
      turns &= ~turn::through;
    if (turns != lane.turns) marking.surface = paint_.on(lane, turns, marking.line);
    return turns != 0;
  }

  // The lanes that come by an end, as the edge wants them: merging lanes apart, from left to right
  // as one drives.
  std::vector<const Lane*> lanes_by(const EdgeEnd& end) const {
    std::vector<const Lane*> found;
    for (int i = first_[end.edge]; i < first_[end.edge + 1]; ++i) {
      const Lane& lane = lanes_.lanes[i];
      if (lane.kind != LaneKind::merging && carries_traffic(lane.kind) &&
          (lane.both_ways || lane.along_axis != end.at_start))
        found.push_back(&lane);
    }
    if (end.at_start) std::reverse(found.begin(), found.end());
    return found;
  }

  static bool lead_apart(const Outlook& outlook) {
    const auto leads = [&](std::size_t i) {
      return outlook.ways[i] != 0 && outlook.lanes[i]->kind == LaneKind::general;
    };
    for (std::size_t i = 0; i < outlook.ways.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (leads(i) && leads(j) && (outlook.ways[i] & outlook.ways[j]) == 0) return true;
    return false;
  }

  static unsigned ways_of(const Lane& lane, const Outlook& outlook) {
    for (std::size_t i = 0; i < outlook.ways.size(); ++i)
      if (outlook.lanes[i] == &lane) return outlook.ways[i];
    return 0;
  }

  Outlook outlook(const EdgeEnd& end, int node) const {
    std::vector<Leg> legs;
    std::vector<std::int64_t> axes;
    int from = 0;
    for (const EdgeEnd& other : ends_[node]) {
      const Edge& edge = streets_.network.edges[other.edge];
      if (slot(other) == slot(end)) from = static_cast<int>(legs.size());
      legs.push_back(foreseen_leg(edge, other.at_start, wished_(edge)));
      legs.back().importance = streets_.roadways[other.edge].importance;
      legs.back().on_ring = circulations_.of(edge) != nullptr;
      axes.push_back(edge.axis_id);
    }
    Outlook found;
    found.lanes = lanes_by(end);
    std::vector<LaneEnd>& in = legs[from].in;
    if (in.empty() || in.size() != found.lanes.size()) return found;
    // Marks come to the lanes of the edge from elsewhere too.
    for (std::size_t i = 0; i < in.size(); ++i) in[i].turns = found.lanes[i]->turns;
    std::vector<Movement> movements = foreseen_movements(legs, from);
    restrictions_.mark(node, axes, legs, movements);
    found.goes_on = false;
    for (const Movement& movement : movements) {
      const double angle = movement_angle(legs[from], legs[movement.to]);
      if (movement.turns_back || movement.forbidden(LaneKind::general)) continue;
      found.goes_on = found.goes_on || answers(angle, 0);
    }
    found.ways.assign(in.size(), 0);
    if (in.size() == 1) return found;
    choose_lanes(legs, movements, driving_side_);
    for (const Movement& movement : movements) {
      if (movement.turns_back) continue;
      const unsigned mark = mark_of(movement_angle(legs[from], legs[movement.to]));
      const std::size_t goals = legs[movement.to].out.size();
      for (std::size_t p = 0; p < movement.verdicts.size(); ++p)
        if (movement.verdicts[p].plausible) found.ways[p / goals] |= mark;
    }
    found.leads_apart = lead_apart(found);
    return found;
  }

  const Streets& streets_;
  const Circulations circulations_;
  const WishedLanes& wished_;
  const DrivingSide driving_side_;
  const NodeRestrictions restrictions_;
  Lanes& lanes_;
  std::vector<std::vector<EdgeEnd>> ends_;  // by node
  std::vector<int> first_;                  // by edge: the index of its first lane
  ArrowPaint paint_;
  EdgeEnd seen_from_{};
  std::optional<Outlook> seen_;
};

}  // namespace

void point_arrows(const Streets& streets, const std::vector<TurnRestriction>& restrictions,
                  const std::vector<Circulation>& circulations, const WishedLanes& wished,
                  DrivingSide driving_side, double node_tolerance, Lanes& lanes) {
  ArrowPointer(streets, restrictions, circulations, wished, driving_side, node_tolerance, lanes)
      .run();
}

}  // namespace streetgen
