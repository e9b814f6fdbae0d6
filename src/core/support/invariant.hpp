// What must hold after a step of the pipeline.  The Debug and the sanitized build check it; in
// others each check returns at once.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace streetgen {

#ifdef STREETGEN_INVARIANTS
constexpr bool invariants_are_checked = true;
#else
constexpr bool invariants_are_checked = false;
#endif

// Throws std::logic_error with a sentence that names the broken rule and its row.
inline void must_hold(bool holds, const char* rule, std::size_t row) {
  if (!holds) throw std::logic_error(std::string(rule) + ", row " + std::to_string(row));
}

}  // namespace streetgen
