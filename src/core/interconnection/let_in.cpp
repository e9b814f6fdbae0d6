#include "interconnection/let_in.hpp"

#include <algorithm>

#include "interconnection/join_lanes.hpp"
#include "interconnection/way.hpp"

namespace streetgen {

namespace {

// No car drives on its street, whichever way.
bool closed_to_cars(const Leg& leg) {
  const auto open = [](const LaneEnd& lane) { return leads_as(lane.kind) == LaneKind::general; };
  return std::none_of(leg.in.begin(), leg.in.end(), open) &&
         std::none_of(leg.out.begin(), leg.out.end(), open);
}

// Whether traffic of a kind goes there from a general lane where others may not.
bool lets_in(const std::vector<Leg>& legs, const Movement& movement, LaneKind kind) {
  const Leg& to = legs[movement.to];
  if (movement.forbidden(kind)) return false;
  return movement.forbidden(LaneKind::general) ||
         (closed_to_cars(to) && !group_of(to.out, kind).empty());
}

// As traffic of a kind sees them: its own lanes and those for all are alike, unless it has both.
std::vector<Leg> seen_by(std::vector<Leg> legs, LaneKind kind) {
  for (Leg& leg : legs) {
    const bool own = closed_to_cars(leg);
    for (std::vector<LaneEnd>* lanes : {&leg.in, &leg.out})
      for (LaneEnd& lane : *lanes)
        if (own && lane.kind == kind) lane.kind = LaneKind::general;
  }
  return legs;
}

}  // namespace

void let_in(const std::vector<Leg>& legs, std::vector<Movement>& movements, LaneKind kind) {
  const auto wanted = [&](const Movement& m) { return lets_in(legs, m, kind); };
  if (std::none_of(movements.begin(), movements.end(), wanted)) return;
  std::vector<Movement> tried = movements;
  for (Movement& movement : tried) {
    const bool forbidden = movement.forbidden(kind);
    movement.restricted.reset();
    if (forbidden) movement.restricted.set();
    movement.verdicts.clear();
  }
  const std::vector<Leg> seen = seen_by(legs, kind);
  join_lanes(seen, tried);
  for (std::size_t m = 0; m < movements.size(); ++m) {
    if (!wanted(movements[m])) continue;
    const std::vector<LaneEnd>&in = legs[movements[m].from].in, &out = legs[movements[m].to].out;
    for (std::size_t p = 0; p < movements[m].verdicts.size(); ++p) {
      Verdict& verdict = movements[m].verdicts[p];
      const LaneKind to = out[p % out.size()].kind;
      const bool for_all = leads_as(to) == LaneKind::general;
      const bool open = verdict.plausible && verdict.traffic.none() && for_all;
      if (leads_as(in[p / out.size()].kind) != LaneKind::general || open ||
          !tried[m].verdicts[p].plausible || !(for_all || to == kind))
        continue;
      verdict.plausible = true;
      verdict.reason = Reason::traffic;
      verdict.traffic.set(index_of(kind));
    }
  }
}

}  // namespace streetgen
