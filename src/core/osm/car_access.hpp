// Whom words about access let drive.
#pragma once

#include <string>

namespace streetgen {

// Does a value of an access tag shut out the cars of others than its owners?
bool shuts_cars_out(const std::string& said);

// Does it let in cars that end there, or have an errand, and no others?
bool lets_cars_end(const std::string& said);

}  // namespace streetgen
