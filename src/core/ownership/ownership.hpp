// Every point of a level's roadway has one owner.
#pragma once

#include <utility>
#include <vector>

#include "geometry/geos.hpp"
#include "ownership/claim.hpp"

namespace streetgen {

// The pairs of claims that overlap and should tile.
std::vector<std::pair<int, int>> disputes(const std::vector<Claim>& claims);

// Of each claim, those that decide about its ground, ascending: those that it has a dispute with,
// and of other levels those that dispute with these.
std::vector<std::vector<int>> opponents(const std::vector<Claim>& claims,
                                        const std::vector<std::pair<int, int>>& disputes);

// Of the ground of a disputing pair each point goes to the one whose axis is nearer; where their
// axes cross, to the one that comes before the other, if that does not take an intersection its
// node. Pairs are judged on the surfaces as they come in, so that the
// order does not matter. Claims that are not wanted may
// come out unsettled.
void settle_ownership(Geos& geos, std::vector<Claim>& claims,
                      const std::vector<std::pair<int, int>>& disputes);

}  // namespace streetgen
