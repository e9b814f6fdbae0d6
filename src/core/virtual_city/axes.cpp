#include "virtual_city/axes.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "support/random.hpp"

namespace streetgen {

namespace {

// The line of a street between two of its nodes, with a vertex at each node.
Line noded_line(const CityStreet& street, std::size_t first, std::size_t last) {
  Line line;
  std::size_t bend = 0;
  for (std::size_t node = first; node <= last; ++node) {
    const double abscissa = street.nodes[node].abscissa;
    for (; bend < street.line.size() && street.abscissas[bend] <= abscissa; ++bend)
      if (!line.empty() && street.abscissas[bend] < abscissa) line.push_back(street.line[bend]);
    line.push_back(street.nodes[node].point);
  }
  return line;
}

// Nodes at which a street is divided into stretches, its ends among them.
std::vector<std::size_t> stretch_ends(const CityStreet& street, double stretch) {
  std::vector<std::size_t> ends{0};
  const double parts = stretch > 0 ? std::floor(street.length() / stretch + 0.5) : 1;
  for (double part = 1; part < parts; ++part) {
    std::size_t node = ends.back();
    const double wanted = street.length() * part / parts;
    while (node + 1 < street.nodes.size() && street.nodes[node].abscissa < wanted) ++node;
    if (node > ends.back() && node + 1 < street.nodes.size()) ends.push_back(node);
  }
  ends.push_back(street.nodes.size() - 1);
  return ends;
}

const char* kind_of(int level) {
  static const char* const kinds[] = {"Main Road", "Avenue", "Street", "Lane"};
  return kinds[std::min(level, 3)];
}

// Neighbours on one side of a main road that reach the same road: one leads away from the main
// road, the other back to it.
std::vector<CityDirection> directions(const std::vector<CityStreet>& streets, double share) {
  std::vector<CityDirection> directions(streets.size(), CityDirection::both);
  if (share == 0) return directions;
  std::map<std::pair<int, bool>, std::size_t> previous;  // by main road and side
  for (std::size_t i = 1; i < streets.size(); ++i) {
    const CityStreet& street = streets[i];
    const auto [before, first] = previous.try_emplace({street.main, street.to_left}, i);
    if (first) continue;
    const std::size_t other = before->second;
    before->second = i;
    if (street.ends_on < 0 || streets[other].ends_on != street.ends_on ||
        directions[other] != CityDirection::both || street.width != streets[other].width ||
        !Random::part(street.key, UINT64_MAX).chance(share))
      continue;
    directions[other] = CityDirection::direct;
    directions[i] = CityDirection::reverse;
  }
  return directions;
}

}  // namespace

std::vector<CityAxis> street_axes(const std::vector<CityStreet>& streets,
                                  const CityOptions& options) {
  const std::vector<CityDirection> direction = directions(streets, options.one_way_pairs);
  std::vector<CityAxis> axes;
  axes.reserve(streets.size());
  for (std::size_t i = 0; i < streets.size(); ++i) {
    const CityStreet& street = streets[i];
    const std::vector<std::size_t> ends = stretch_ends(street, options.stretch);
    for (std::size_t part = 1; part < ends.size(); ++part) {
      CityAxis axis;
      axis.line = noded_line(street, ends[part - 1], ends[part]);
      axis.level = street.level;
      axis.width = street.width;
      axis.lane_count = static_cast<int>(at_level(options.lanes, street.level));
      axis.importance = std::min(street.level + 1, 5);
      axis.speed = at_level(options.speed, street.level);
      axis.direction = direction[i];
      axis.name = std::string(kind_of(street.level)) + " " + std::to_string(axes.size() + 1);
      axes.push_back(std::move(axis));
    }
  }
  return axes;
}

}  // namespace streetgen
