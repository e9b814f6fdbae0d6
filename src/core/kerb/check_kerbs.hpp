#pragma once

#include "streetgen/streets.hpp"

namespace streetgen {

// Invariant: kerbs have a line, and the parts of each side are numbered from 1 without a gap.
void check_kerbs(const Streets& streets);

}  // namespace streetgen
