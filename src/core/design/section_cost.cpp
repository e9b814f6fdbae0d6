#include "design/section_cost.hpp"

#include <algorithm>
#include <cmath>

#include "support/infinite.hpp"

namespace streetgen {
namespace {

// A tunnel needs so much ground over its roadway, metres.
constexpr double tunnel_cover = 8;

}  // namespace

Earthwork earthwork(double width, double side_slope, double height, double cross_slope) {
  const double b = width, m = side_slope, h = std::abs(height), k = std::abs(cross_slope);
  if (m * k >= 1) return {infinite, infinite};
  Earthwork work;
  if (h >= k * b / 2) {
    const double half = b / 2 + m * h;
    work.fill = half * half / (m * (1 - m * m * k * k)) - b * b / (4 * m);
  } else {
    const double filled = b / 2 + h / k, cut = b / 2 - h / k;
    work.fill = k * filled * filled / (2 * (1 - m * k));
    work.cut = k * cut * cut / (2 * (1 - m * k));
  }
  if (height < 0) std::swap(work.fill, work.cut);
  return work;
}

SectionCost::SectionCost(const DesignRules& rules)
    : rules_(rules),
      always_(rules.pavement_cost * rules.width + rules.use_cost),
      land_(rules.land_cost * rules.width),
      bridge_(rules.bridge_cost * rules.width),
      tunnel_(rules.tunnel_cost * rules.width) {}

double SectionCost::earth(double height, double cross_slope) const {
  if (height > rules_.fill_greatest || height < -rules_.cut_greatest) return infinite;
  const Earthwork work = earthwork(rules_.width, rules_.side_slope, height, cross_slope);
  return work.fill * rules_.fill_cost + work.cut * rules_.cut_cost + land_ +
         2 * rules_.side_slope * std::abs(height) * rules_.land_cost;
}

double SectionCost::cost(double height, double cross_slope, const ZoneClass* zone) const {
  if (zone != nullptr && zone->passage == Passage::forbidden) return infinite;
  const bool bridged = zone != nullptr && zone->passage == Passage::bridge;
  const double over = zone != nullptr ? zone->cost * rules_.width : 0;
  // A wall or deck stands where neither earth nor a whole structure has room.
  double best = height >= 0 ? bridge_ + over : tunnel_ + over;
  if (bridged && height < 0) best += 4 * tunnel_;
  if (height < -tunnel_cover) best = tunnel_;
  if (!bridged) best = std::min(best, earth(height, cross_slope) + over);
  return always_ + best;
}

SectionKind SectionCost::kind(double height, double cross_slope, const ZoneClass* zone) const {
  const double over = zone != nullptr ? zone->cost * rules_.width : 0;
  if (zone != nullptr && zone->passage == Passage::forbidden) return SectionKind::barred;
  const bool bridged = zone != nullptr && zone->passage == Passage::bridge;
  if (!bridged &&
      always_ + earth(height, cross_slope) + over <= cost(height, cross_slope, zone) * (1 + 1e-12))
    return SectionKind::earth;
  return height >= 0 || (bridged && height > -tunnel_cover) ? SectionKind::bridge
                                                            : SectionKind::tunnel;
}

RoadCostTerms SectionCost::terms(double height, double cross_slope, const ZoneClass* zone) const {
  RoadCostTerms terms;
  terms.pavement = rules_.pavement_cost * rules_.width;
  terms.use = rules_.use_cost;
  const SectionKind built = kind(height, cross_slope, zone);
  if (built != SectionKind::tunnel && zone != nullptr) terms.zones = zone->cost * rules_.width;
  if (built == SectionKind::bridge) terms.bridge = bridge_;
  if (built == SectionKind::tunnel) terms.tunnel = tunnel_;
  if (built == SectionKind::earth) {
    const Earthwork work = earthwork(rules_.width, rules_.side_slope, height, cross_slope);
    terms.fill = work.fill * rules_.fill_cost;
    terms.cut = work.cut * rules_.cut_cost;
    terms.land = land_ + 2 * rules_.side_slope * std::abs(height) * rules_.land_cost;
  }
  return terms;
}

}  // namespace streetgen
