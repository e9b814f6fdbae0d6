// What a driver does at a signal.
#pragma once

#include "streetgen/traffic.hpp"

namespace streetgen {

// Whether a car stops `metres` ahead for what it is shown: at red, and at amber where it can by
// `deceleration`, metres a second squared.
bool stops_for(Aspect aspect, double speed, double metres, double deceleration);

}  // namespace streetgen
