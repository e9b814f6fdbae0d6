#include "network/twin.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include "geometry/box.hpp"
#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double least_along = 0.8;  // of its length an edge goes on along what it lies on
constexpr double step = 1;           // metres between the places that are looked at

// What an edge lies on.
struct Bed {
  std::int64_t axis_id = 0;
  bool leads_as_well = false;  // in the directions of the edge
};

class TwinFinder {
 public:
  TwinFinder(const Network& network, const std::vector<const StreetAxis*>& axes, double tolerance)
      : network_(network), axes_(axes), tolerance_(tolerance), is_twin_(axes.size(), false) {
    for (const Edge& edge : network_.edges) {
      Box box;
      for (const Point& p : edge.line) box.add(p);
      boxes_.push_back(box);
      lengths_.push_back(length(edge.line));
    }
    index_ = BoxIndex(boxes_);
  }

  // By edge, from the most important axis on: what lies on a twin lies on what that lies on.
  void find() {
    std::vector<int> order(axes_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int e, int f) { return rank(e) < rank(f); });
    for (const int e : order) {
      poll_cancel();
      const auto bed = bed_of(e);
      if (!bed) continue;
      beds_[e] = *bed;
      is_twin_[e] = bed->leads_as_well;
    }
    keep_what_leads_elsewhere();
  }

  bool is_twin(int e) const { return is_twin_[e]; }
  const std::map<int, Bed>& beds() const { return beds_; }
  double length_of(int e) const { return lengths_[e]; }

 private:
  const Edge& edge(int e) const { return network_.edges[e]; }

  static double width(const StreetAxis& axis) { return std::max(axis.width, axis.width_end); }

  std::tuple<int, double, std::int64_t> rank(int e) const {
    return {axes_[e]->importance, -width(*axes_[e]), axes_[e]->axis_id};
  }

  double near(int e, int f) const {
    return std::max(tolerance_, std::min(width(*axes_[e]), width(*axes_[f])) / 4);
  }

  std::optional<Bed> bed_of(int e) const {
    const Point middle = position_at(edge(e).line, lengths_[e] / 2).point;
    const double farthest = std::max(tolerance_, width(*axes_[e]) / 4);
    std::map<std::int64_t, int> others;  // axis -> its edge beside the middle
    for (const int f : index_.near(box_of(middle, middle), farthest))
      if (may_bear(f, e) && distance_to_line(middle, edge(f).line) <= near(e, f))
        others.emplace(edge(f).axis_id, f);
    std::optional<Bed> best;
    int best_edge = -1;
    for (const auto& [axis_id, f] : others) {
      if (best && (best->leads_as_well || rank(best_edge) < rank(f))) continue;
      if (const auto bed = bears(e, f)) {
        best = bed;
        best_edge = f;
      }
    }
    return best;
  }

  bool may_bear(int f, int e) const {
    return !is_twin_[f] && edge(f).axis_id != edge(e).axis_id && edge(f).level == edge(e).level &&
           rank(f) < rank(e);
  }

  struct Place {
    double apart, abscissa;  // along the axis
  };

  Place nearest(const Point& p, const std::vector<int>& edges) const {
    Place best{1e300, 0};
    for (const int f : edges) {
      const double at = nearest_abscissa(p, edge(f).line);
      const double apart = distance(p, position_at(edge(f).line, at).point);
      if (apart < best.apart) best = {apart, edge(f).start_abscissa + at};
    }
    return best;
  }

  // Whether the axis of f does so all along e.
  std::optional<Bed> bears(int e, int f) const {
    const double within = near(e, f);
    std::vector<int> edges;
    for (const int g : index_.near(boxes_[e], within))
      if (edge(g).axis_id == edge(f).axis_id && may_bear(g, e)) edges.push_back(g);
    const Line& line = edge(e).line;
    for (const Point& p : line)
      if (nearest(p, edges).apart > within) return std::nullopt;
    for (double at = step; at < lengths_[e]; at += step)
      if (nearest(position_at(line, at).point, edges).apart > within) return std::nullopt;
    // Halves, so that a loop has a course too.
    const double start = nearest(line.front(), edges).abscissa,
                 middle = nearest(position_at(line, lengths_[e] / 2).point, edges).abscissa,
                 end = nearest(line.back(), edges).abscissa;
    const double ring = ring_length(edges);
    const double course = short_way(start, middle, ring) + short_way(middle, end, ring);
    if (std::abs(course) < least_along * lengths_[e]) return std::nullopt;
    const StreetAxis &own = *axes_[e], &other = *axes_[f];
    const bool along = course > 0;
    if (std::abs(own.roadway_offset - (along ? 1 : -1) * other.roadway_offset) > within)
      return std::nullopt;
    const bool forward = along ? other.leads_forward : other.leads_backward,
               backward = along ? other.leads_backward : other.leads_forward;
    return Bed{other.axis_id, (forward || !own.leads_forward) && (backward || !own.leads_backward)};
  }

  // Of the axis, where it is closed; else 0.
  double ring_length(const std::vector<int>& edges) const {
    const Line& line = axes_[edges.front()]->line;
    return distance(line.front(), line.back()) <= tolerance_ ? length(line) : 0;
  }

  static double short_way(double from, double to, double ring) {
    const double way = to - from;
    return ring > 0 ? way - ring * std::round(way / ring) : way;
  }

  // A twin that alone leads from its bed to another street stays, and with it what leads there.
  void keep_what_leads_elsewhere() {
    std::map<int, std::vector<int>> about;  // node of a twin -> edges there
    for (const auto& [e, bed] : beds_)
      if (is_twin_[e]) about[edge(e).from_node], about[edge(e).to_node];
    if (about.empty()) return;
    for (int e = 0; e < static_cast<int>(axes_.size()); ++e)
      for (const int n : {edge(e).from_node, edge(e).to_node})
        if (const auto found = about.find(n); found != about.end()) found->second.push_back(e);
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto& [e, bed] : beds_) {
        if (!is_twin_[e]) continue;
        for (const int n : {edge(e).from_node, edge(e).to_node}) {
          const std::vector<int>& edges = about[n];
          const std::int64_t axis_id = bed.axis_id;
          const bool meets_bed = std::any_of(edges.begin(), edges.end(), [&](int f) {
            return !is_twin_[f] && edge(f).axis_id == axis_id;
          });
          const bool ends =
              std::all_of(edges.begin(), edges.end(), [&](int f) { return bool(is_twin_[f]); });
          if (meets_bed || ends) continue;
          is_twin_[e] = false;
          changed = true;
          break;
        }
      }
    }
  }

  const Network& network_;
  const std::vector<const StreetAxis*>& axes_;
  double tolerance_;
  std::vector<bool> is_twin_;
  std::vector<Box> boxes_;
  std::vector<double> lengths_;
  BoxIndex index_;
  std::map<int, Bed> beds_;  // by edge
};

// Edges that follow each other on one bed are one stretch.
void report_stretches(Network& network, const std::vector<const StreetAxis*>& axes,
                      const TwinFinder& twins) {
  const auto& beds = twins.beds();
  for (auto first = beds.begin(); first != beds.end();) {
    double sum = twins.length_of(first->first);
    auto last = first;
    for (auto next = std::next(last);
         next != beds.end() && next->first == last->first + 1 &&
         axes[next->first] == axes[first->first] && next->second.axis_id == first->second.axis_id &&
         twins.is_twin(next->first) == twins.is_twin(first->first);
         last = next++)
      sum += twins.length_of(next->first);
    double to_middle = sum / 2;
    int e = first->first;
    for (; e < last->first && twins.length_of(e) < to_middle; ++e) to_middle -= twins.length_of(e);
    network.reports.push_back({NetworkIssue::lies_on_another, axes[e]->axis_id,
                               first->second.axis_id,
                               planar(position_at(network.edges[e].line, to_middle).point), sum});
    first = std::next(last);
  }
}

void drop(Network& network, const TwinFinder& twins) {
  std::vector<Edge> edges;
  for (std::size_t e = 0; e < network.edges.size(); ++e)
    if (!twins.is_twin(static_cast<int>(e))) edges.push_back(std::move(network.edges[e]));
  network.edges = std::move(edges);
  std::vector<bool> used(network.nodes.size(), false);
  for (const Edge& edge : network.edges) used[edge.from_node] = used[edge.to_node] = true;
  std::vector<int> number(network.nodes.size(), -1);
  std::vector<Node> nodes;
  for (std::size_t n = 0; n < network.nodes.size(); ++n) {
    if (!used[n]) continue;
    number[n] = static_cast<int>(nodes.size());
    nodes.push_back(std::move(network.nodes[n]));
  }
  for (Edge& edge : network.edges) {
    edge.from_node = number[edge.from_node];
    edge.to_node = number[edge.to_node];
  }
  network.nodes = std::move(nodes);
}

}  // namespace

void drop_twins(Network& network, const std::vector<const StreetAxis*>& axes, double tolerance) {
  TwinFinder twins(network, axes, tolerance);
  twins.find();
  if (twins.beds().empty()) return;
  report_stretches(network, axes, twins);
  drop(network, twins);
}

}  // namespace streetgen
