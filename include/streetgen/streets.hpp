// From the network to surfaces: one call for a set of axes.
#pragma once

#include "streetgen/street.hpp"

namespace streetgen {

// Deterministic and independent of the order of `axes`.  Throws Error and ChangeSpreads.
Streets streets(const std::vector<StreetAxis>& axes, const StreetSettings& settings,
                const StreetOverrides& overrides = {}, const Former& former = {},
                bool with_kerbs = false, const RampRules& ramps = {}, const LeadsOn& leads_on = {});

}  // namespace streetgen
