// What the core computes streets from, proven.
#pragma once

#include <vector>

#include "streetgen/interconnection.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/streets.hpp"
#include "streets_call.hpp"

namespace streetgen::pg {

struct StreetsInput {
  int srid = 0;
  bool has_z = false;
  std::vector<StreetAxis> axes;
  StreetSettings settings;
  Former former;
  std::vector<LanesOfAxis> lanes;
  std::vector<LaneOverride> overrides;
  LaneSettings lane_settings;
  std::vector<TurnRestriction> restrictions;
  InterconnectionSettings interconnection_settings;
};

// Each refusal is an Error{invalid_input} that names the axis or setting and its value.
StreetsInput read_input(const StreetsCall& call);

}  // namespace streetgen::pg
