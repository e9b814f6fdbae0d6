#include "streetgen/street_network.hpp"

#include <unordered_map>

#include "network/cut_at_signals.hpp"
#include "network/missed_end.hpp"
#include "network/twin.hpp"

namespace streetgen {

namespace {

std::vector<const StreetAxis*> by_edge(const Network& network,
                                       const std::vector<StreetAxis>& axes) {
  std::unordered_map<std::int64_t, const StreetAxis*> by_id;
  for (const StreetAxis& axis : axes) by_id.emplace(axis.axis_id, &axis);
  std::vector<const StreetAxis*> found;
  for (const Edge& edge : network.edges) found.push_back(by_id.at(edge.axis_id));
  return found;
}

Network network_without_twins(const std::vector<StreetAxis>& axes, double tolerance,
                              Crossing crossing) {
  std::vector<NetworkAxis> lines;
  for (const StreetAxis& axis : axes) lines.push_back({axis.axis_id, axis.line, axis.level});
  Network out = network(lines, tolerance, crossing);
  drop_twins(out, by_edge(out, axes), tolerance);
  return out;
}

}  // namespace

Network street_network(const std::vector<StreetAxis>& axes, double tolerance, Crossing crossing,
                       const ControlRules& controls) {
  Network out = network_without_twins(axes, tolerance, crossing);
  std::vector<const StreetAxis*> of_edges = by_edge(out, axes);
  report_missed_ends(out, of_edges, tolerance);
  cut_at_signals(out, of_edges, controls);
  return out;
}

Network network_without_end_reports(const std::vector<StreetAxis>& axes, double tolerance,
                                    Crossing crossing, const ControlRules& controls) {
  Network out = network_without_twins(axes, tolerance, crossing);
  std::vector<const StreetAxis*> of_edges = by_edge(out, axes);
  cut_at_signals(out, of_edges, controls);
  return out;
}

}  // namespace streetgen
