#include "network/missed_end.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "geometry/box.hpp"
#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

class MissedEnds {
 public:
  MissedEnds(const Network& network, const std::vector<const StreetAxis*>& axes, double tolerance)
      : network_(network),
        axes_(axes),
        tolerance_(tolerance + same_place),
        degree_(network.nodes.size(), 0) {
    std::vector<Box> boxes;
    for (std::size_t e = 0; e < axes.size(); ++e) {
      const Edge& edge = network.edges[e];
      ++degree_[edge.from_node];
      ++degree_[edge.to_node];
      Box box;
      for (const Point& p : edge.line) box.add(p);
      // A box as wide as the roadway finds the ends that lie in it.
      boxes.push_back(box.grown(std::max(axes[e]->width, axes[e]->width_end) / 2 +
                                std::abs(axes[e]->roadway_offset)));
    }
    index_ = BoxIndex(boxes);
    for (const NetworkReport& report : network.reports)
      if (report.issue == NetworkIssue::lies_on_another)
        upon_.insert(std::minmax({report.axis_a, report.axis_b}));
  }

  std::vector<NetworkReport> find() {
    for (int e = 0; e < static_cast<int>(axes_.size()); ++e)
      for (const bool at_start : {true, false})
        if (degree_[node({e, at_start})] == 1)
          if (const auto missed = missed_by({e, at_start})) missed_[slot({e, at_start})] = *missed;
    std::vector<NetworkReport> reports;
    for (const auto& [end, missed] : missed_) {
      if (told_by_the_other(end, missed)) continue;
      reports.push_back({NetworkIssue::misses, axes_[end / 2]->axis_id, axes_[missed.edge]->axis_id,
                         planar(place({end / 2, end % 2 == 0})), missed.apart});
    }
    return reports;
  }

 private:
  struct Missed {
    int edge;
    double apart;  // metres from its axis
    int end;       // slot of its dead end, where that is nearest; else -1
  };

  const Edge& edge(int e) const { return network_.edges[e]; }
  int node(const EdgeEnd& end) const {
    return end.at_start ? edge(end.edge).from_node : edge(end.edge).to_node;
  }
  const Point& place(const EdgeEnd& end) const { return network_.nodes[node(end)].point; }

  std::optional<Missed> missed_by(const EdgeEnd& end) const {
    poll_cancel();
    const Point& p = place(end);
    std::optional<Missed> best;
    for (const int f : index_.near(box_of(p, p), 0)) {
      const std::int64_t own = edge(end.edge).axis_id, other = edge(f).axis_id;
      if (other == own || edge(f).level != edge(end.edge).level ||
          upon_.count(std::minmax({own, other})) > 0)
        continue;
      // An edge bends to its nodes: what joins an end is how far the axis is, as it is drawn.
      const double apart = distance_to_line(p, axes_[f]->line);
      if (apart <= tolerance_) return std::nullopt;  // a cluster too wide to be joined
      if (best && best->apart <= apart) continue;
      const double at = nearest_abscissa(p, edge(f).line);
      if (!holds(f, at, p) || is_stub(end, f)) continue;
      best = Missed{f, apart, dead_end_at(f, at)};
    }
    return best;
  }

  // Whether the roadway of an edge holds p, beside this place of the edge or before its end.
  bool holds(int e, double at, const Point& p) const {
    const StreetAxis& axis = *axes_[e];
    const double total = length(axis.line);
    const double share =
        total > 0 ? std::clamp((edge(e).start_abscissa + at) / total, 0.0, 1.0) : 0;
    const double half = (axis.width + (axis.width_end - axis.width) * share) / 2;
    const LinePosition foot = position_at(edge(e).line, at);
    return distance(p, foot.point + left_normal(foot.direction) * axis.roadway_offset) <= half;
  }

  // Whether the edge lies in the roadway that holds its end, from another street on: it joins that
  // there.
  bool is_stub(const EdgeEnd& end, int f) const {
    if (degree_[node({end.edge, !end.at_start})] == 1) return false;
    const Line& line = edge(end.edge).line;
    return std::all_of(line.begin(), line.end(), [&](const Point& p) {
      return holds(f, nearest_abscissa(p, edge(f).line), p);
    });
  }

  int dead_end_at(int f, double at) const {
    if (at <= 0 && degree_[edge(f).from_node] == 1) return slot({f, true});
    if (at >= length(edge(f).line) && degree_[edge(f).to_node] == 1) return slot({f, false});
    return -1;
  }

  bool told_by_the_other(int end, const Missed& missed) const {
    const auto other = missed_.find(missed.end);
    return other != missed_.end() && other->second.end == end &&
           axes_[end / 2]->axis_id < axes_[missed.edge]->axis_id;
  }

  const Network& network_;
  const std::vector<const StreetAxis*>& axes_;
  double tolerance_;
  std::vector<int> degree_;  // by node
  BoxIndex index_;
  std::set<std::pair<std::int64_t, std::int64_t>> upon_;  // axes that lie on one another
  std::map<int, Missed> missed_;                          // by slot of the end
};

}  // namespace

void report_missed_ends(Network& network, const std::vector<const StreetAxis*>& axes,
                        double tolerance) {
  const std::vector<NetworkReport> reports = MissedEnds(network, axes, tolerance).find();
  network.reports.insert(network.reports.end(), reports.begin(), reports.end());
}

}  // namespace streetgen
