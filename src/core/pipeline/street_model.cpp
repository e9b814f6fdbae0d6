#include "streetgen/street_model.hpp"

#include "pipeline/invariants.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {

StreetModel street_model(const StreetModelInput& input) {
  StreetModel model;
  model.streets =
      streets(input.axes, input.settings, input.overrides, input.former, input.subjects.kerb);
  if (input.subjects.lane) {
    model.lanes = lanes(model.streets, input.lanes, input.lane_overrides, input.lane_settings);
    check_lanes(model.streets, model.lanes);
  }
  if (input.subjects.interconnection) {
    model.interconnections = interconnections(model.streets, input.axes, model.lanes.lanes,
                                              input.restrictions, input.interconnection_settings);
    check_interconnections(model);
  }
  return model;
}

}  // namespace streetgen
