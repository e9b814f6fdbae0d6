#include <string>

#include "streetgen/error.hpp"
#include "streetgen/road_design.hpp"

namespace streetgen {

const std::vector<DesignRule>& design_rules() {
  static const std::vector<DesignRule> rules{
      {"width", &DesignRules::width, 1, 200},
      {"radius", &DesignRules::radius, 5, 10000},
      {"clothoid", &DesignRules::clothoid, 0, 10000},
      {"grade", &DesignRules::grade, 0.001, 0.5},
      {"crest", &DesignRules::crest, 10, 1e6},
      {"sag", &DesignRules::sag, 10, 1e6},
      {"fill_cost", &DesignRules::fill_cost, 0, 1e6},
      {"cut_cost", &DesignRules::cut_cost, 0, 1e6},
      {"land_cost", &DesignRules::land_cost, 0, 1e6},
      {"pavement_cost", &DesignRules::pavement_cost, 0, 1e6},
      {"bridge_cost", &DesignRules::bridge_cost, 0, 1e6},
      {"tunnel_cost", &DesignRules::tunnel_cost, 0, 1e6},
      {"use_cost", &DesignRules::use_cost, 0.01, 1e9},
      {"climb_cost", &DesignRules::climb_cost, 0, 1e9},
      {"side_slope", &DesignRules::side_slope, 0.1, 20},
      {"fill_greatest", &DesignRules::fill_greatest, 0, 1000},
      {"cut_greatest", &DesignRules::cut_greatest, 0, 1000},
      {"curve_radius", &DesignRules::curve_radius, 0, 1e5}};
  return rules;
}

void set_design_rule(DesignRules& rules, const std::string& name, double value) {
  for (const DesignRule& rule : design_rules()) {
    if (name != rule.name) continue;
    if (!(value >= rule.low && value <= rule.high))
      throw Error(ErrorKind::invalid_input, name + " of the road is " + text_of(value),
                  "Expected " + text_of(rule.low) + " to " + text_of(rule.high) + ".");
    rules.*rule.value = value;
    return;
  }
  throw Error(ErrorKind::invalid_input, "there is no rule \"" + name + "\" of roads");
}

}  // namespace streetgen
