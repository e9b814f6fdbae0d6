// The links between towns: networks of highways, secondary and rural roads, each on top of the one
// before. Campos, Leitao and Coelho, "Integrated Modeling of Road Environments for Driving
// Simulation" (2015), section 3.1; equation 2 with the sign that makes a short cut worth building.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "streetgen/geometry.hpp"
#include "streetgen/terrain.hpp"

namespace streetgen {

enum class TownKind { city, town, village, interchange };
enum class RoadNetwork { highway, secondary, rural };

struct Town {
  TownKind kind = TownKind::city;
  double importance = 0;  // people, as a rule
  Point point;
};

// A link between two towns by their indices. Utilisation is equation 1 in thousands of people and
// kilometres, length, benefit and cost are kilometres of road.
struct TownLink {
  std::size_t a = 0, b = 0;
  RoadNetwork network = RoadNetwork::highway;
  double length = 0, utilisation = 0;
  double benefit = 0;  // factor x utilisation x (shortest other way - length); infinite: no other
  double cost = 0;     // length
  bool by_hand = false;
};

enum class LinkBenefit {
  of_ends,     // trips between both ends of a link, as the paper has it
  of_network,  // trips of all towns whose shortest way uses the link
};

struct NetworkWish {
  double factor =
      27.5;  // kilometres of road that a unit of utilisation and kilometre saved is worth
  LinkBenefit benefit = LinkBenefit::of_ends;
  std::vector<TownLink> by_hand;                              // stay
  std::vector<std::pair<std::size_t, std::size_t>> rejected;  // never come
};

// Begins with all pairs of a network (highways: cities; secondary roads: cities and towns; rural
// roads: all) and removes the link whose cost exceeds its benefit the most, until none does. All
// benefits are known anew after each removal. A network stays as connected as its pairs are.
// Refused (invalid_input): two towns at one place, more than 1,000 towns.
std::vector<TownLink> link_towns(const std::vector<Town>& towns, const NetworkWish& wish);

// Links of one network that cross away from their ends: the place, and both links.
struct TownLinkCrossing {
  Point point;
  std::size_t first = 0, second = 0;
};
std::vector<TownLinkCrossing> link_crossings(const std::vector<Town>& towns,
                                         const std::vector<TownLink>& links);

// Towns whose importance falls with their rank (importance = largest / rank^exponent) at random
// places of an area: off zones and steep ground, and no nearer to a town of at least their kind
// than `spacing` times what an even spread would leave. Fewer towns than asked for are a result.
struct TownWish {
  int count = 0, cities = 0, towns = 0;
  double largest = 500000, exponent = 1;
  double spacing = 0.6;
  double steepest = 0.15;  // slope of the ground, rise over run
  std::uint64_t seed = 0;
};
std::vector<Town> rank_size_towns(const MultiPolygon& area, const Terrain& terrain,
                                  const ZoneGrid& zones, const TownWish& wish,
                                  const std::vector<Town>& there);

}  // namespace streetgen
