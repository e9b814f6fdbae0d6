// What the core computes streets from, proven.
#pragma once

#include "model/streets_call.hpp"
#include "streetgen/street_model.hpp"

namespace streetgen::pg {

struct StreetsInput {
  int srid = 0;
  bool has_z = false;
  StreetModelInput model;
};

// Each refusal is an Error{invalid_input} that names the axis or setting and its value.
StreetsInput read_input(const StreetsCall& call);

}  // namespace streetgen::pg
