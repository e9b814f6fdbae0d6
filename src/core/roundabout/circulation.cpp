#include "roundabout/circulation.hpp"

#include <map>

#include "streetgen/interconnection.hpp"

namespace streetgen {

Circulations::Circulations(const std::vector<Circulation>& all) {
  for (const Circulation& circulation : all) by_axis_.emplace(circulation.axis_id, circulation);
}

const Circulation* Circulations::of(const Edge& edge) const {
  const auto [first, last] = by_axis_.equal_range(edge.axis_id);
  for (auto at = first; at != last; ++at)
    if (at->second.abscissa > edge.start_abscissa && at->second.abscissa < edge.end_abscissa)
      return &at->second;
  return nullptr;
}

void turn_round(const Circulation& circulation, std::vector<LaneWish>& wishes) {
  if (!circulation.turned) return;
  for (LaneWish& wish : wishes) {
    if (wish.along_axis != circulation.along_axis || wish.both_ways) wish.turns = 0;
    wish.along_axis = circulation.along_axis;
    wish.both_ways = false;
  }
}

void forbid_against_rings(const Streets& streets, const std::vector<Lane>& lanes,
                          const std::vector<Circulation>& circulations,
                          std::vector<Interconnection>& interconnections) {
  if (circulations.empty()) return;
  const Circulations rings(circulations);
  std::map<int, bool> along;  // by edge
  for (const Lane& lane : lanes)
    if (along.count(lane.edge) == 0)
      if (const Circulation* c = rings.of(streets.network.edges[lane.edge]))
        along[lane.edge] = c->along_axis;
  const auto against = [&](int lane, bool along_axis) {
    const auto found = along.find(lanes[lane].edge);
    return found != along.end() && found->second != along_axis &&
           leads_as(lanes[lane].kind) == LaneKind::general;
  };
  for (Interconnection& path : interconnections) {
    if (!against(path.lane_in, path.along_in) && !against(path.lane_out, path.along_out)) continue;
    path.plausible = false;
    path.reason = Reason::ring;
  }
}

}  // namespace streetgen
