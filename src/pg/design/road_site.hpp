// The composite streetgen.road_site: terrain, zones and rules of a road.
#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "frame/border.hpp"
#include "streetgen/road_design.hpp"

namespace streetgen::pg {

// As PostgreSQL holds it: plain arrays of Datum.
struct SiteArgument {
  struct Column {
    int count = 0;
    Datum* values = nullptr;
  };
  Column tiles, zone_surfaces, zone_classes, class_costs, class_passages, rule_names, rule_values;
};

// For the take step; raises 22004 where an element is NULL.
SiteArgument take_site(FunctionCallInfo fcinfo, int argument);
SiteArgument::Column take_column(Datum array, unsigned element);

// For the compute step.
struct ReadSite {
  Terrain terrain;
  ZoneGrid zones;
  DesignRules rules;
  DesignSite site() const { return {terrain, zones, rules}; }
};
Terrain read_terrain(const SiteArgument::Column& tiles);
DesignRules read_rules(const SiteArgument& argument);
std::unique_ptr<ReadSite> read_site(const SiteArgument& argument);

}  // namespace streetgen::pg
