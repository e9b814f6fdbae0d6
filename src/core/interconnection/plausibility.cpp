#include "interconnection/plausibility.hpp"

#include "interconnection/join_lanes.hpp"
#include "interconnection/let_in.hpp"
#include "interconnection/mirrored_legs.hpp"

namespace streetgen {

namespace {

void choose(const std::vector<Leg>& legs, std::vector<Movement>& movements) {
  join_lanes(legs, movements);
  for (const LaneKind kind : {LaneKind::bus, LaneKind::carpool, LaneKind::cycle})
    let_in(legs, movements, kind);
}

}  // namespace

LaneKinds traffic_of(const Verdict& verdict, LaneKind in, LaneKind out) {
  if (verdict.traffic.any()) return verdict.traffic;
  const auto general = [](LaneKind kind) {
    return kind == LaneKind::general || kind == LaneKind::merging;
  };
  const LaneKind kind = !general(in) ? in : general(out) ? LaneKind::general : out;
  return LaneKinds().set(index_of(kind));
}

void choose_lanes(const std::vector<Leg>& legs, std::vector<Movement>& movements,
                  DrivingSide driving_side) {
  if (driving_side == DrivingSide::right) {
    choose(legs, movements);
    return;
  }
  std::vector<Leg> seen = legs;
  mirror(seen, movements);
  choose(seen, movements);
  mirror(seen, movements);
}

}  // namespace streetgen
