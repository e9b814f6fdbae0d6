// A road between two places on terrain: its straight alignments, curves, heights and structures.
//
// Costs are those of a road as wide as the formation, per metre of its length; the greatest grade,
// the least radii and the prices stand in DesignRules. Source: Campos, Leitao and Coelho,
// "Integrated Modeling of Road Environments for Driving Simulation" (2015), section 3.2; what the
// paper leaves open is said where it is decided.
#pragma once

#include <string>
#include <vector>

#include "streetgen/alignment.hpp"
#include "streetgen/terrain.hpp"
#include "streetgen/vertical_alignment.hpp"

namespace streetgen {

struct DesignRules {
  double width = 12;                              // of the formation, metres
  double radius = 130;                            // least radius of a curve, metres
  double clothoid = 70;                           // parameter A, metres
  double grade = 0.07;                            // greatest, rise over run
  double crest = 2000, sag = 1600;                // least radii of parabolas, metres
  double fill_cost = 5, cut_cost = 6;             // per cubic metre
  double land_cost = 2, pavement_cost = 60;       // per square metre
  double bridge_cost = 1000, tunnel_cost = 2000;  // per square metre of formation
  double use_cost = 100;                          // per metre of length
  double climb_cost = 300;                        // per metre of climb or descent
  double side_slope = 1.5;                        // run of a cut or fill slope for a rise of 1
  double fill_greatest = 20, cut_greatest = 25;   // metres; beyond: bridge, tunnel
  double curve_radius = 0;                        // wanted radius of curves, metres; 0: the least
};

// The names of the rules as options, their ranges, and how one is set. Refused (invalid_input): an
// unknown name, a value out of range.
struct DesignRule {
  const char* name;
  double DesignRules::*value;
  double low, high;
};
const std::vector<DesignRule>& design_rules();
void set_design_rule(DesignRules& rules, const std::string& name, double value);

struct DesignSite {
  const Terrain& terrain;
  const ZoneGrid& zones;
  const DesignRules& rules;
};

// A vertex of the straight alignments.
struct PathVertex {
  Point point;  // z: height of the road as the search has it
  bool by_hand = false;
};

// The reason why no way is found: no heights, a zone that forbids, the greatest grade, or turns too
// sharp.
enum class Barrier { none, terrain, zone, grade, turn };

struct RoadPath {
  std::vector<PathVertex> vertices;
  Barrier barrier = Barrier::none;
};

// The path of least cost from the first to the last of the places, through those between. The
// search runs in layers of finer cells over (cell, heading, height over ground): a turn is taken
// only where the least curve fits in half of both sides, a side only within the greatest grade.
// Then the vertices move off the grid. Where no turn fits beside a place, or a way would tie a loop,
// the turns there are free, and their curves shrink; the last resort is the straight side. Equal
// places are refused (degenerate). Without a way the vertices are empty and the barrier is named.
// `straight` says of each place but the first whether the side that ends there is straight: it is
// taken as it is.
RoadPath road_path(const DesignSite& site, const Line& places, const std::vector<bool>& straight);

// The curve at each vertex: radius as wanted, less where the sides are short, never less than the
// least radius unless even that does not fit. `given` curves with a radius above 0 stay.
std::vector<VertexCurve> road_curves(const DesignRules& rules, const Line& line,
                                     const std::vector<VertexCurve>& given);

// The heights that a road may have at one abscissa: between low and high.
struct HeightLimit {
  double abscissa = 0, low = 0, high = 0;
};

struct ProfileWish {
  std::vector<GradePoint> fixed;    // grade points that stay
  std::vector<double> rejected;     // abscissas that no grade point comes near to
  std::vector<HeightLimit> limits;  // at crossings
  double start_height = 0, end_height = 0;
};

// Grade points of least cost along an alignment within greatest grade and least parabolas, by
// dynamic programming over (station, height, grade) in bands that narrow. Where the rules cannot be
// kept they are broken as little as possible.
std::vector<GradePoint> road_profile(const DesignSite& site,
                                     const std::vector<AlignmentElement>& elements,
                                     const ProfileWish& wish);

enum class StructureKind { bridge, tunnel };
struct RoadStructure {
  StructureKind kind = StructureKind::bridge;
  double start_abscissa = 0, end_abscissa = 0;
};

struct RoadCostTerms {
  double pavement = 0, land = 0, fill = 0, cut = 0, bridge = 0, tunnel = 0, zones = 0, use = 0;
};

struct RoadEstimate {
  std::vector<RoadStructure> structures;
  RoadCostTerms cost;
  double length = 0;
};

// Bridges and tunnels by cost, zones, and greatest fill and cut, and what the road costs.
RoadEstimate road_estimate(const DesignSite& site, const std::vector<AlignmentElement>& elements,
                           const std::vector<GradePiece>& grades);

}  // namespace streetgen
