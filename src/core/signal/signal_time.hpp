// The seconds of signal programs, and what may ask for one.
#pragma once

#include <vector>

#include "streetgen/signal.hpp"

namespace streetgen {

// Refuses numbers out of their range.
void check_requests(const std::vector<SignalRequest>& movements, const SignalRules& rules);

// The movements with edges and lanes numbered as they come, so that no program hangs on ids.
std::vector<SignalRequest> numbered(std::vector<SignalRequest> movements);

double steps_up(double seconds, const SignalRules& rules);

bool meets(const SignalRequest& movement, int other);

// Traffic that cannot stop before the line still drives in amber.
double amber_of(const SignalRequest& movement, const SignalRules& rules);

// From the end of green of `a` to the start of green of `b`, which it meets; 0: they do not meet.
double intergreen(const std::vector<SignalRequest>& movements, int a, int b,
                  const SignalRules& rules);

// From the end of green of a movement to the start of a walk that it drives over.
double intergreen_to_walk(const SignalRequest& movement, const SignalRequest::Walk& walk,
                          const SignalRules& rules);

// What ends one green state before another one.
struct SignalChange {
  double amber = 0, all_red = 0;
  double lacks = 0;  // seconds of all red that the rules do not leave
  double duration() const { return amber + all_red; }
};

// From movements that have green to those that have it next. All have red for a step at least, and
// no longer than the rules let them.
SignalChange change_between(const std::vector<SignalRequest>& movements,
                            const std::vector<int>& ends, const std::vector<int>& begins,
                            const SignalRules& rules);

void append_change(const SignalChange& change, std::vector<SignalState>& states);

}  // namespace streetgen
