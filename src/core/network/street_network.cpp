#include "streetgen/street_network.hpp"

#include <unordered_map>

#include "network/missed_end.hpp"
#include "network/twin.hpp"

namespace streetgen {

Network street_network(const std::vector<StreetAxis>& axes, double tolerance, Crossing crossing) {
  std::vector<NetworkAxis> lines;
  std::unordered_map<std::int64_t, const StreetAxis*> by_id;
  for (const StreetAxis& axis : axes) {
    lines.push_back({axis.axis_id, axis.line, axis.level});
    by_id.emplace(axis.axis_id, &axis);
  }
  Network out = network(lines, tolerance, crossing);
  const auto by_edge = [&] {
    std::vector<const StreetAxis*> found;
    for (const Edge& edge : out.edges) found.push_back(by_id.at(edge.axis_id));
    return found;
  };
  drop_twins(out, by_edge(), tolerance);
  report_missed_ends(out, by_edge(), tolerance);
  return out;
}

}  // namespace streetgen
