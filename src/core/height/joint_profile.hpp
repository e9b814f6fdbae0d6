// Heights of roads that are solved together: each of them can move each other one.
#pragma once

#include <vector>

#include "streetgen/profile.hpp"

namespace streetgen {

enum class Rounds {
  rough,  // without arcs and plateaus
  all,
};

Profiles joint_profiles(const std::vector<ProfileEdge>& edges,
                        const std::vector<ProfileLift>& lifts,
                        const std::vector<ProfileHeight>& by_hand, const ProfileRules& rules,
                        Rounds rounds);

}  // namespace streetgen
