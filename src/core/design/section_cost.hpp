// The cost of a metre of road by its height over ground, the cross slope and the zone.
#pragma once

#include "streetgen/road_design.hpp"

namespace streetgen {

// Areas of fill and cut of a cross-section, square metres.
struct Earthwork {
  double fill = 0, cut = 0;
};

// Formation of a width at a height over ground of a cross slope, side slopes 1 : m. Exact for a
// ground that is straight across. Slopes never meet ground that is steeper than they: infinite.
Earthwork earthwork(double width, double side_slope, double height, double cross_slope);

enum class SectionKind { earth, bridge, tunnel, barred };

class SectionCost {
 public:
  explicit SectionCost(const DesignRules& rules);
  // The least cost a metre among earthworks, bridge and tunnel; infinite in a forbidden zone.
  double cost(double height, double cross_slope, const ZoneClass* zone) const;
  // The way in which the section is built for that, and its terms.
  SectionKind kind(double height, double cross_slope, const ZoneClass* zone) const;
  RoadCostTerms terms(double height, double cross_slope, const ZoneClass* zone) const;
  // No metre is cheaper.
  double least() const { return always_ + land_; }

 private:
  double earth(double height, double cross_slope) const;
  const DesignRules& rules_;
  double always_, land_, bridge_, tunnel_;
};

}  // namespace streetgen
