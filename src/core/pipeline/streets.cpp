#include "streetgen/streets.hpp"

#include <map>
#include <utility>

#include "kerb/check_kerbs.hpp"
#include "kerb/find_kerbs.hpp"
#include "layout/layout.hpp"
#include "network/check_network.hpp"
#include "ownership/check_surfaces.hpp"
#include "ownership/covered_arc.hpp"
#include "ownership/settle_owners.hpp"
#include "ramp/find_ramps.hpp"
#include "ramp/merging_lanes.hpp"
#include "roadway/check_roadway.hpp"
#include "roadway/find_affected.hpp"
#include "roadway/ground_beside.hpp"
#include "roadway/settle_limits.hpp"
#include "roadway/solve_corners.hpp"
#include "roadway/street_override.hpp"

namespace streetgen {

namespace {

// An edit that has to be given up is so as soon as that is known.
void stay_within(const Streets& streets, const Former& former) {
  if (former.may_spread) return;
  std::vector<std::int64_t> axes;
  for (std::size_t e = 0; e < streets.spreads_to.size(); ++e) {
    const std::int64_t axis = streets.network.edges[e].axis_id;
    if (streets.spreads_to[e] && (axes.empty() || axes.back() != axis)) axes.push_back(axis);
  }
  if (!axes.empty()) throw ChangeSpreads(std::move(axes));
}

}  // namespace

Streets streets(const std::vector<StreetAxis>& axes, const StreetSettings& settings,
                const StreetOverrides& overrides, const Former& former, bool with_kerbs,
                const RampRules& ramps, const LeadsOn& leads_on) {
  Layout layout(axes, settings, overrides.bends);
  check_network(layout.streets.network);
  find_ramps(layout, ramps);
  give_merging_lanes(layout, ramps);
  const RadiiByHand radii = radii_by_hand(layout, overrides.corners);
  solve_corners(layout, radii);
  check_corners(layout.streets);
  settle_limits(layout, limits_by_hand(layout, overrides.limits));
  solve_joints(layout, radii);
  check_limits(layout.streets);
  layout.streets.beside = ground_beside(layout);
  const Affected moved = find_affected(layout, former, leads_on);
  stay_within(layout.streets, former);
  const std::map<int, MultiPolygon> beyond_reach =
      settle_owners(layout, moved, with_kerbs && !former.neighbours);
  check_surfaces(layout.streets);
  stay_within(layout.streets, former);
  if (with_kerbs) find_kerbs(layout, moved, beyond_reach, former.neighbours);
  check_kerbs(layout.streets);
  leave_covered_arcs(layout.streets.corners);
  return std::move(layout.streets);
}

const char* method_name(Method method) noexcept {
  switch (method) {
    case Method::hypothesis:
      return "hypothesis";
    case Method::radius_reduced:
      return "radius_reduced";
    case Method::radius_minimal:
      return "radius_minimal";
    case Method::followed:
      return "followed";
    case Method::nose:
      return "nose";
    case Method::no_arc:
      return "no_arc";
    case Method::crossed_limits:
      return "crossed_limits";
    case Method::transition:
      return "transition";
    case Method::contested:
      return "contested";
    case Method::crowded:
      return "crowded";
    case Method::robust_fallback:
      return "robust_fallback";
    case Method::by_hand:
      return "by_hand";
    case Method::level_change:
      return "level_change";
    case Method::covered:
      return "covered";
    case Method::axis_bound:
      return "axis_bound";
  }
  return "";
}

bool limits_crossed(const Streets& streets, int edge) {
  return streets.limits[2 * edge].method == Method::crossed_limits ||
         streets.limits[2 * edge + 1].method == Method::crossed_limits;
}

}  // namespace streetgen
