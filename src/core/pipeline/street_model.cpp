#include "streetgen/street_model.hpp"

#include <unordered_map>

#include "geometry/polyline.hpp"
#include "interconnection/check_interconnections.hpp"
#include "interconnection/point_arrows.hpp"
#include "lane/carried_marks.hpp"
#include "lane/check_lanes.hpp"
#include "lane/lane_wishes.hpp"
#include "lane/ramp_lanes.hpp"
#include "network/control_reach.hpp"
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

// By node, whether a control point may speak there, whatever meets the streets between.
std::vector<bool> near_controls(const StreetModelInput& input, const Network& network) {
  std::vector<bool> near(network.nodes.size());
  if (input.controls.empty()) return near;
  const ControlReach reach(network, std::vector<EdgeWays>(network.edges.size()), input.controls,
                           input.settings.controls);
  for (const ControlPoint& point : input.controls)
    for (const int node : reach.nodes_near(point)) near[node] = true;
  return near;
}

// A control point speaks at the next junction: along short edges from nodes of two edges, and from
// a node before which one stands.
void controls_lead_on(const StreetModelInput& input, const Network& network,
                      std::vector<bool>& leads) {
  leads.resize(2 * network.edges.size());
  std::vector<int> degree(network.nodes.size());
  for (const Edge& edge : network.edges) ++degree[edge.from_node], ++degree[edge.to_node];
  const std::vector<bool> near = near_controls(input, network);
  for (std::size_t e = 0; e < network.edges.size(); ++e) {
    const Edge& edge = network.edges[e];
    if (edge.end_abscissa - edge.start_abscissa > input.settings.controls.farthest) continue;
    const auto leads_from = [&](int node) { return degree[node] == 2 || near[node]; };
    leads[2 * e] = leads[2 * e] || leads_from(edge.from_node);
    leads[2 * e + 1] = leads[2 * e + 1] || leads_from(edge.to_node);
  }
}

LeadsOn changes_lead_on(const StreetModelInput& input, const LaneWishes& wishes,
                        bool interconnected) {
  if (input.former.edges.empty()) return {};
  return [&input, &wishes, interconnected](const Network& network,
                                           const std::vector<Roadway>& roadways) {
    Leads leads{marks_lead_on(input, wishes, network, roadways), {}};
    controls_lead_on(input, network, leads.on);
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
