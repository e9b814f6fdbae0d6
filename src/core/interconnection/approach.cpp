#include "interconnection/approach.hpp"

#include <algorithm>

#include "interconnection/connect_lanes.hpp"
#include "interconnection/served_lanes.hpp"

namespace streetgen {

namespace {

class Approach {
 public:
  Approach(const Ways& of_node, const Leg& leg) : of_node_(of_node), leg_(leg) {}

  void join() const {
    unsigned marked = 0;
    for (const LaneEnd& lane : leg_.in) marked |= lane.turns;
    const Group middle = middle_of(leg_.in);
    const std::vector<const Movement*> turns =
        middle.empty() ? std::vector<const Movement*>{} : turn_off(middle);
    for (const LaneKind kind : {LaneKind::general, LaneKind::bus, LaneKind::cycle}) {
      const Group lanes = group_of(leg_.in, kind);
      if (lanes.empty()) continue;
      Ways open = open_ways(lanes, kind, marked & turn::reverse);
      if (kind == LaneKind::general) leave_to_middle(lanes, turns, open);
      assign(lanes, kind, open);
    }
  }

 private:
  // From lanes in the middle traffic turns off to the left, or goes on to the middle of a street
  // that alone goes on.  Gives the movements that it takes.
  std::vector<const Movement*> turn_off(const Group& lanes) const {
    Ways open = open_ways(lanes, LaneKind::general, false);
    for (const Way& way : open) judge_all(way, lanes, Reason::lane_kind);
    open.erase(
        std::remove_if(open.begin(), open.end(), [&](const Way& w) { return w.turns_back(); }),
        open.end());
    const bool goes_on = open.size() == 1 && goes_on_alone(of_node_, open.front());
    const int through = way_through(open);
    std::vector<const Movement*> taken;
    for (int j = 0; j < static_cast<int>(open.size()); ++j) {
      Way& way = open[j];
      const bool left = through < 0 ? way.angle > 0 : j < through;
      if (!goes_on && !left) continue;
      way.goals = goes_on ? middle_of(way.to->out) : targets(*way.to, LaneKind::general);
      if (way.goals.empty()) continue;
      connect_lanes(of_node_, way, lanes, Reason::lane_order);
      if (!goes_on) taken.push_back(way.movement);
    }
    return taken;
  }

  // Who turns off from the middle does so from no lane beside it, unless it is marked or has no
  // other way.
  void leave_to_middle(const Group& lanes, const std::vector<const Movement*>& turns,
                       Ways& open) const {
    const auto left_to_middle = [&](const Way& way) {
      return std::find(turns.begin(), turns.end(), way.movement) != turns.end();
    };
    if (marks_on(leg_.in, lanes) & turn::leftwards) return;
    if (std::all_of(open.begin(), open.end(), left_to_middle)) return;
    open.erase(std::remove_if(open.begin(), open.end(), left_to_middle), open.end());
  }

  // The ways that lanes of a kind may take, from left to right; of the others it says why not.
  Ways open_ways(const Group& lanes, LaneKind kind, bool may_turn_back) const {
    Ways open;
    bool onwards = false;
    for (const Way& way : of_node_)
      if (way.from == &leg_ && !way.movement->forbidden(kind))
        onwards = onwards || !way.turns_back();
    for (const Way& way : of_node_) {
      if (way.from != &leg_) continue;
      const bool back = onwards && way.turns_back() && !may_turn_back;
      if (way.movement->forbidden(kind) || back)
        judge_all(way, lanes, back ? Reason::u_turn : Reason::lane_kind);
      else
        open.push_back(way);
    }
    std::stable_sort(open.begin(), open.end(),
                     [](const Way& a, const Way& b) { return a.order > b.order; });
    return open;
  }

  // A restriction that holds is the reason.
  static void judge_all(const Way& way, const Group& lanes, Reason reason) {
    for (const int in : lanes)
      for (int out = 0; out < static_cast<int>(way.to->out.size()); ++out)
        way.at(in, out) = {false, way.forbidden(in, out) ? Reason::restriction : reason};
  }

  void assign(const Group& lanes, LaneKind kind, const Ways& open) const {
    Ways ways;
    const Reason reason = marks_on(leg_.in, lanes) ? Reason::turn_lanes : Reason::lane_order;
    for (const Way& way : open) {
      Group goals = targets(*way.to, kind);
      for (const int i : lanes)
        for (int o = 0; o < static_cast<int>(way.to->out.size()); ++o)
          way.at(i, o).reason =
              std::find(goals.begin(), goals.end(), o) == goals.end() ? Reason::lane_kind : reason;
      if (goals.empty()) continue;
      ways.push_back(way);
      ways.back().goals = std::move(goals);
    }
    if (ways.empty()) return;
    const std::vector<Group> served = served_lanes(leg_.in, lanes, ways);
    for (std::size_t j = 0; j < ways.size(); ++j)
      if (!served[j].empty()) connect_lanes(of_node_, ways[j], served[j], reason);
  }

  const Ways& of_node_;
  const Leg& leg_;
};

}  // namespace

void join_approach(const Ways& of_node, const Leg& leg) { Approach(of_node, leg).join(); }

}  // namespace streetgen
