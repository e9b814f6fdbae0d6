// The likeliest pair of lanes, for a lane that no way joins.
#pragma once

#include "interconnection/way.hpp"

namespace streetgen {

struct LikelyPair {
  Verdict* verdict = nullptr;  // none: nothing leads on
  bool easy = false;           // neither tight nor back
};

// Of a lane that comes by a leg, and of one that leaves by it: for cars, where they are asked for.
LikelyPair likeliest_on(const Ways& of_node, const Leg& leg, int lane, bool cars = false);
LikelyPair likeliest_to(const Ways& of_node, const Leg& leg, int lane, bool cars = false);

// Whether a lane that comes by a leg leads on, and whether one that leaves by it is reached, by a
// path besides one; so too.
bool leads_on(const Ways& of_node, const Leg& leg, int in, bool cars = false,
              const Verdict* besides = nullptr);
bool reached(const Ways& of_node, const Leg& leg, int out, bool cars = false,
             const Verdict* besides = nullptr);

// Whether cars may take the path of a pair.
bool for_cars(const Way& way, int in, int out);

// Lets each lane lead on and be reached.
void reach_every_lane(const Ways& of_node, const std::vector<Leg>& legs);

}  // namespace streetgen
