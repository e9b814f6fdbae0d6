// Heights at stations, found by dynamic programming within a band of steps about a former profile.
#pragma once

#include <vector>

#include "design/section_cost.hpp"
#include "streetgen/road_design.hpp"

namespace streetgen {

// Ground under the axis at places between two stations.
struct GroundSample {
  double share = 0;  // of the way from one station to the next
  double ground = 0, cross_slope = 0;
  const ZoneClass* zone = nullptr;
};

struct ProfileStation {
  double abscissa = 0;
  double height = 0;
  bool fixed = false;
};

struct ProfileSide {
  std::vector<GroundSample> samples;
  std::vector<HeightLimit> limits;  // with abscissas as shares of the side
};

// Moves the heights of stations by up to seven steps to the cheapest profile. Sides steeper than
// the greatest grade, parabolas that do not fit and heights beyond limits cost so much that they
// are taken only where nothing else is left.
void improve_profile(const DesignSite& site, const SectionCost& section,
                     const std::vector<ProfileSide>& sides, double step,
                     std::vector<ProfileStation>& stations);

}  // namespace streetgen
