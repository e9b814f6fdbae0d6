// The whole model of a set of axes: every step from the network to lane-to-lane paths, in order.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "streetgen/interconnection.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/overpass.hpp"
#include "streetgen/ramp.hpp"
#include "streetgen/street.hpp"

namespace streetgen {

struct StreetModelInput {
  // Subjects that are computed on the roadway, by their words.  One that needs another comes out
  // empty without it, and words that no step knows are passed over.
  std::set<std::string> subjects{"lane", "interconnection"};
  std::vector<StreetAxis> axes;
  StreetSettings settings;
  StreetOverrides overrides;
  Former former;
  std::vector<LanesOfAxis> lanes;
  std::set<std::int64_t> marked_before{};  // axes whose lanes had marks before the change
  RampRules ramps{};  // their lanes and the outer side follow from `lanes`
  std::vector<LaneOverride> lane_overrides;
  LaneSettings lane_settings;
  std::vector<ControlPoint> controls;
  std::vector<Circulation> circulations{};
  PaintRules paint{};
  std::vector<TurnRestriction> restrictions;
  InterconnectionSettings interconnection_settings;
  std::vector<OverpassOverride> overpass_overrides;
  double clearance = 6;  // metres from a roadway to the one above, where no override says otherwise
};

struct StreetModel {
  Streets streets;
  Lanes lanes;
  std::vector<Interconnection> interconnections;
  std::vector<Overpass> overpasses;
};

// Deterministic and independent of the order of `input.axes`.  Throws Error and ChangeSpreads.
StreetModel street_model(const StreetModelInput& input);

}  // namespace streetgen
