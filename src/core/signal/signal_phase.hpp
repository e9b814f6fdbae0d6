// Phases of a signal program: who has green together.
#pragma once

#include <vector>

#include "streetgen/signal.hpp"

namespace streetgen {

// The numbers of the movements that have green together.
using Phase = std::vector<int>;

// Approaches that do not meet share phases, the most important ones choosing first. With turn
// phases, turns that need one go before the others of their phase.
std::vector<Phase> phases_of(const std::vector<SignalRequest>& movements, const SignalRules& rules,
                             bool turn_phases);

// Makes one of the two phases of the least important traffic.
void merge_least(const std::vector<SignalRequest>& movements, std::vector<Phase>& phases);

// What phases count for beside each other: their lanes and importance.
double weight_of(const std::vector<SignalRequest>& movements, const Phase& phase);

// Who goes first is protected; what meets one before it gives way.
std::vector<SignalState::Green> greens_of(const std::vector<SignalRequest>& movements,
                                          const Phase& phase);

}  // namespace streetgen
