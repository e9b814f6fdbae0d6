// Bridges and tunnels of a road, and what it costs.
#include <algorithm>
#include <cmath>

#include "design/section_cost.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/road_design.hpp"

namespace streetgen {
namespace {

constexpr double sample_distance = 5;
// Structures nearer to each other are one, shorter ones are earth.
constexpr double joined = 30, shortest = 15;

void add_terms(RoadCostTerms& sum, const RoadCostTerms& terms, double metres) {
  sum.pavement += terms.pavement * metres;
  sum.land += terms.land * metres;
  sum.fill += terms.fill * metres;
  sum.cut += terms.cut * metres;
  sum.bridge += terms.bridge * metres;
  sum.tunnel += terms.tunnel * metres;
  sum.zones += terms.zones * metres;
  sum.use += terms.use * metres;
}

struct Section {
  SectionKind kind;
  double from, to;
};

std::vector<RoadStructure> structures_of(const std::vector<Section>& sections) {
  std::vector<RoadStructure> found;
  for (const Section& s : sections) {
    if (s.kind == SectionKind::earth) continue;
    const StructureKind kind =
        s.kind == SectionKind::tunnel ? StructureKind::tunnel : StructureKind::bridge;
    if (!found.empty() && found.back().kind == kind && s.from - found.back().end_abscissa < joined)
      found.back().end_abscissa = s.to;
    else
      found.push_back({kind, s.from, s.to});
  }
  found.erase(std::remove_if(found.begin(), found.end(),
                             [](const RoadStructure& s) {
                               return s.end_abscissa - s.start_abscissa < shortest;
                             }),
              found.end());
  return found;
}

}  // namespace

RoadEstimate road_estimate(const DesignSite& site, const std::vector<AlignmentElement>& elements,
                           const std::vector<GradePiece>& grades) {
  const SectionCost section(site.rules);
  RoadEstimate estimate;
  estimate.length = alignment_length(elements);
  const int parts = std::max(1, static_cast<int>(std::ceil(estimate.length / sample_distance)));
  const double metres = estimate.length / parts;
  std::vector<Section> sections;
  for (int i = 0; i < parts; ++i) {
    poll_cancel();
    const double at = (i + 0.5) * metres;
    const AlignmentPlace place = alignment_place(elements, at);
    const GradePlace road = grade_place(grades, at);
    const Terrain::Ground g = site.terrain.ground(place.point.x, place.point.y);
    const double over = std::isnan(g.height) ? 0 : road.height - g.height;
    const double across = std::isnan(g.height) ? 0
                                               : -g.slope_x * std::sin(place.heading) +
                                                     g.slope_y * std::cos(place.heading);
    const ZoneClass* zone = site.zones.at(place.point.x, place.point.y);
    add_terms(estimate.cost, section.terms(over, across, zone), metres);
    estimate.cost.use += site.rules.climb_cost * std::abs(road.grade) * metres;
    const SectionKind kind = section.kind(over, across, zone);
    if (!sections.empty() && sections.back().kind == kind)
      sections.back().to = (i + 1) * metres;
    else
      sections.push_back({kind, i * metres, (i + 1) * metres});
  }
  estimate.structures = structures_of(sections);
  return estimate;
}

}  // namespace streetgen
