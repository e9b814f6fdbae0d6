// Where the overrides of streets find their place in the network.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "layout/layout.hpp"

namespace streetgen {

// The least limit of an arm where three edges and more meet, and of one by hand.
double least_limit(const Arm& arm);

// By slot, metres from the node.
using LimitsByHand = std::vector<std::optional<double>>;
LimitsByHand limits_by_hand(const Layout& layout, const std::vector<SectionLimitOverride>& puts);

// By node and index of the corner's first end there.
using RadiiByHand = std::map<std::pair<int, std::size_t>, double>;
RadiiByHand radii_by_hand(const Layout& layout, const std::vector<CornerOverride>& wanted);

}  // namespace streetgen
