#include "streetgen/street_model.hpp"

#include <unordered_map>

#include "geometry/polyline.hpp"
#include "interconnection/check_interconnections.hpp"
#include "lane/check_lanes.hpp"
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

}  // namespace

StreetModel street_model(const StreetModelInput& input) {
  const auto wanted = [&](const char* subject) { return input.subjects.count(subject) > 0; };
  StreetModel model;
  RampRules ramps = input.ramps;
  if (!ramps.axes.empty())
    count_ramp_lanes(ramps, input.axes,
                     {input.lanes, input.lane_overrides, input.circulations, input.lane_settings},
                     input.lane_settings);
  model.streets =
      streets(input.axes, input.settings, input.overrides, input.former, wanted("kerb"), ramps);
  if (wanted("lane")) {
    model.lanes = lanes(model.streets, input.lanes, input.lane_overrides, input.lane_settings,
                        input.controls, input.circulations, input.paint);
    check_lanes(model.streets, model.lanes);
  }
  if (wanted("interconnection")) {
    model.interconnections =
        interconnections(model.streets, input.axes, model.lanes.lanes, input.restrictions,
                         input.interconnection_settings, input.circulations);
    forbid_against_rings(model.streets, model.lanes.lanes, input.circulations,
                         model.interconnections);
    check_interconnections(model.streets, model.lanes.lanes, model.interconnections);
  }
  if (wanted("overpass")) model.overpasses = overpasses_of(model.streets, input);
  return model;
}

}  // namespace streetgen
