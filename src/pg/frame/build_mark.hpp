// Module and SQL of one build, or nothing: a function of the module reads the arguments, and gives
// the rows, that the SQL of its own build declares.
#pragma once

namespace streetgen::pg {

// Whether they were found to be so, and the catalogue did not change since.
extern bool is_one_build;

// Looks; raises 55000 with the way out where they are not.
void look_for_build_mark();

inline void require_one_build() {
  if (!is_one_build) look_for_build_mark();
}

}  // namespace streetgen::pg
