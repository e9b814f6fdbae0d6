#include "streetgen/street_model.hpp"

#include <unordered_map>

#include "geometry/polyline.hpp"
#include "interconnection/check_interconnections.hpp"
#include "interconnection/point_arrows.hpp"
#include "lane/carried_marks.hpp"
#include "lane/check_lanes.hpp"
#include "lane/lane_wishes.hpp"
#include "lane/ramp_lanes.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {

namespace {

std::vector<Overpass> overpasses_of(const Streets& streets, const StreetModelInput& input) {
  std::vector<int> importances;
  for (const Roadway& roadway : streets.roadways) importances.push_back(roadway.importance);
  std::unordered_map<std::int64_t, double> lengths;
  for (const StreetAxis& axis : input.axes) lengths[axis.axis_id] = length(axis.line);
  std::vector<double> axis_lengths;
  for (const Edge& edge : streets.network.edges) axis_lengths.push_back(lengths.at(edge.axis_id));
  return overpasses(streets.network, importances, axis_lengths, input.overpass_overrides,
                    input.settings.tolerance, input.clearance);
}

// Along the edges whose lanes have marks that come from elsewhere, or had them before.
std::vector<bool> marks_lead_on(const StreetModelInput& input, const LaneWishes& wishes,
                                const Network& network, const std::vector<Roadway>& roadways) {
  if (!wishes.mark_any() && input.marked_before.empty()) return {};
  const CarriedMarks marks(network, roadways, wishes, input.lane_settings);
  std::vector<bool> leads;
  for (int e = 0; e < static_cast<int>(network.edges.size()); ++e)
    for (const bool along_axis : {true, false}) {
      const DrivenEdge driven{e, along_axis};
      leads.push_back(
          marks.carries(driven) ||
          (marks.may_carry(driven) && input.marked_before.count(network.edges[e].axis_id) > 0));
    }
  return leads;
}

// Along the edges on which traffic looks ahead where they are short.
std::vector<bool> choices_lead_back(const LaneWishes& wishes, const Network& network) {
  std::vector<bool> leads;
  for (const Edge& edge : network.edges) {
    const std::vector<LaneWish> lanes = wishes.of(edge).lanes;
    for (const bool along_axis : {true, false}) leads.push_back(leave_choice(lanes, along_axis));
  }
  return leads;
}

LeadsOn changes_lead_on(const StreetModelInput& input, const LaneWishes& wishes,
                        bool interconnected) {
  if (input.former.edges.empty()) return {};
  return [&input, &wishes, interconnected](const Network& network,
                                           const std::vector<Roadway>& roadways) {
    Leads leads{marks_lead_on(input, wishes, network, roadways), {}};
    if (interconnected) {
      leads.back = choices_lead_back(wishes, network);
      leads.back_within = input.interconnection_settings.look_ahead;
    }
    return leads;
  };
}

}  // namespace

StreetModel street_model(const StreetModelInput& input) {
  const auto wanted = [&](const char* subject) { return input.subjects.count(subject) > 0; };
  StreetModel model;
  RampRules ramps = input.ramps;
  if (!ramps.axes.empty())
    count_ramp_lanes(ramps, input.axes,
                     {input.lanes, input.lane_overrides, input.circulations, input.lane_settings},
                     input.lane_settings);
  const LaneWishes wishes(input.lanes, input.lane_overrides, input.circulations,
                          input.lane_settings);
  const WishedLanes wished = [&](const Edge& edge) { return wishes.of(edge).lanes; };
  model.streets = streets(
      input.axes, input.settings, input.overrides, input.former, wanted("kerb"), ramps,
      wanted("lane") ? changes_lead_on(input, wishes, wanted("interconnection")) : LeadsOn{});
  if (wanted("lane")) {
    model.lanes = lanes(model.streets, input.lanes, input.lane_overrides, input.lane_settings,
                        input.controls, input.circulations, input.paint);
    point_arrows(model.streets, input.restrictions, input.circulations, wished,
                 input.lane_settings.driving_side, input.settings.tolerance, model.lanes);
    check_lanes(model.streets, model.lanes);
  }
  if (wanted("interconnection")) {
    model.interconnections =
        interconnections(model.streets, input.axes, model.lanes.lanes, input.restrictions,
                         input.interconnection_settings, input.circulations, wished);
    forbid_against_rings(model.streets, model.lanes.lanes, input.circulations,
                         model.interconnections);
    check_interconnections(model.streets, model.lanes.lanes, model.interconnections);
  }
  if (wanted("overpass")) model.overpasses = overpasses_of(model.streets, input);
  return model;
}

}  // namespace streetgen
