#pragma once

#include "frame/border.hpp"

namespace streetgen::pg {

/// The owner of the schema of a model; the current role for a model that is still to be made.
Oid owner_of(const char* model);

}  // namespace streetgen::pg
