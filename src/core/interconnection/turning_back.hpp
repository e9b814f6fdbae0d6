// Which movements turn back: by where the streets lie, not by how sharp the turn is.
#pragma once

#include <vector>

#include "interconnection/movement.hpp"

namespace streetgen {

// Whether all lanes that cars may use lead to the node, or all of them away from it.  Of a street
// without such lanes those of buses count.
bool comes_alone(const Leg& leg);
bool goes_alone(const Leg& leg);

// Whether a movement turns back: into its own leg, into one drawn upon it where others leave the
// node too, or from one carriageway of a street into the other.  Two legs are carriageways of one
// street where one comes alone, the other goes alone, and both leave the node within 30 degrees;
// within 75 degrees where a street of both directions parts into them, and into nothing else.  Onto
// a roundabout, round and off it nobody turns back.
bool turns_back(const std::vector<Leg>& legs, int from, int to);

}  // namespace streetgen
