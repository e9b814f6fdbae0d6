#include "streetgen/overpass.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double override_reach = 20;  // metres from the place of an override to its crossing

// One place where two edges cross; edge a is not after edge b.
struct Meeting {
  int a, b;
  double at_a, at_b;  // metres along the edges
  Point point;
};

struct EdgeSegment {
  int edge;
  int index;  // from point index to index + 1
  double abscissa;
};

class Crossings {
 public:
  Crossings(const Network& network, double tolerance) : network_(network), tolerance_(tolerance) {
    std::vector<Box> boxes;
    for (int e = 0; e < static_cast<int>(network.edges.size()); ++e) {
      const Line& line = network.edges[e].line;
      double abscissa = 0;
      for (int i = 0; i + 1 < static_cast<int>(line.size()); ++i) {
        segments_.push_back({e, i, abscissa});
        boxes.push_back(box_of(line[i], line[i + 1]));
        abscissa += distance(line[i], line[i + 1]);
      }
    }
    const BoxIndex index(boxes);
    for (int s = 0; s < static_cast<int>(segments_.size()); ++s) {
      poll_cancel();
      index.each_near(boxes[s], 0, [&](int t) {
        if (t > s) meet(segments_[s], segments_[t]);
      });
    }
  }

  // Each crossing once: one at a vertex is met by two segments.
  std::vector<Meeting> distinct() {
    std::sort(found_.begin(), found_.end(), [](const Meeting& p, const Meeting& q) {
      return std::tie(p.a, p.b, p.at_a, p.at_b) < std::tie(q.a, q.b, q.at_a, q.at_b);
    });
    std::vector<Meeting> kept;
    for (const Meeting& next : found_)
      if (!holds(kept, next)) kept.push_back(next);
    return kept;
  }

 private:
  static bool holds(const std::vector<Meeting>& kept, const Meeting& next) {
    for (auto last = kept.rbegin(); last != kept.rend(); ++last) {
      if (last->a != next.a || last->b != next.b || next.at_a - last->at_a > same_place)
        return false;
      if (std::abs(last->at_b - next.at_b) <= same_place) return true;
    }
    return false;
  }

  void meet(const EdgeSegment& one, const EdgeSegment& other) {
    if (one.edge == other.edge && std::abs(one.index - other.index) <= 1) return;
    const Line& line = network_.edges[one.edge].line;
    const Line& beside = network_.edges[other.edge].line;
    const std::optional<Point> point = crossing(line[one.index], line[one.index + 1],
                                                beside[other.index], beside[other.index + 1]);
    if (!point || near_shared_node(network_.edges[one.edge], network_.edges[other.edge], *point))
      return;
    found_.push_back({one.edge, other.edge, one.abscissa + distance(line[one.index], *point),
                      other.abscissa + distance(beside[other.index], *point), *point});
  }

  bool near_shared_node(const Edge& a, const Edge& b, const Point& point) const {
    for (const int node : {a.from_node, a.to_node})
      if ((node == b.from_node || node == b.to_node) &&
          distance(network_.nodes[node].point, point) <= tolerance_)
        return true;
    return false;
  }

  const Network& network_;
  double tolerance_;
  std::vector<EdgeSegment> segments_;
  std::vector<Meeting> found_;
};

Overpass ordered(const Meeting& meeting, bool a_above, OverpassMethod method, double clearance) {
  if (a_above)
    return {meeting.a, meeting.b, meeting.at_a, meeting.at_b, meeting.point, clearance, method};
  return {meeting.b, meeting.a, meeting.at_b, meeting.at_a, meeting.point, clearance, method};
}

std::int64_t whole_millimetres(double metres) { return std::llround(metres * 1000); }

// The longer axis is above where level and importance are equal; of one axis it is the edge nearer
// to its middle, and of one edge the place nearer to its own. All edges are in one order, which
// goes by no direction: no circle of overpasses comes of it.
bool above_by_order(const Meeting& meeting, const Network& network,
                    const std::vector<double>& axis_lengths) {
  const Edge &a = network.edges[meeting.a], &b = network.edges[meeting.b];
  const std::int64_t of_a = whole_millimetres(axis_lengths[meeting.a]);
  const std::int64_t of_b = whole_millimetres(axis_lengths[meeting.b]);
  if (of_a != of_b) return of_a > of_b;
  if (a.axis_id != b.axis_id) return a.axis_id > b.axis_id;
  double off_a = std::abs(a.start_abscissa + a.end_abscissa - axis_lengths[meeting.a]);
  double off_b = std::abs(b.start_abscissa + b.end_abscissa - axis_lengths[meeting.b]);
  if (meeting.a == meeting.b) {
    off_a = std::abs(2 * meeting.at_a - length(a.line));
    off_b = std::abs(2 * meeting.at_b - length(a.line));
  }
  if (whole_millimetres(off_a) != whole_millimetres(off_b)) return off_a < off_b;
  return meeting.a == meeting.b && meeting.at_a > meeting.at_b;
}

Overpass by_rule(const Meeting& meeting, const Network& network,
                 const std::vector<int>& importances, const std::vector<double>& axis_lengths,
                 double clearance) {
  const Edge &a = network.edges[meeting.a], &b = network.edges[meeting.b];
  if (a.level != b.level)
    return ordered(meeting, a.level > b.level, OverpassMethod::level, clearance);
  if (importances[meeting.a] != importances[meeting.b])
    return ordered(meeting, importances[meeting.a] < importances[meeting.b],
                   OverpassMethod::importance, clearance);
  return ordered(meeting, above_by_order(meeting, network, axis_lengths), OverpassMethod::order,
                 clearance);
}

// Of the crossings of the two axes the one nearest to the place, or -1.
int crossing_of(const OverpassOverride& wish, const std::vector<Overpass>& overpasses,
                const std::vector<int>& candidates) {
  int best = -1;
  double least = override_reach;
  for (const int i : candidates) {
    const double apart = distance(overpasses[i].point, wish.place);
    if (apart > least || (apart == least && best >= 0)) continue;
    least = apart;
    best = i;
  }
  return best;
}

void apply(const std::vector<OverpassOverride>& by_hand, const Network& network,
           std::vector<Overpass>& overpasses) {
  if (by_hand.empty()) return;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<int>> of_axes;
  for (int i = 0; i < static_cast<int>(overpasses.size()); ++i) {
    const std::int64_t above = network.edges[overpasses[i].edge_above].axis_id;
    const std::int64_t below = network.edges[overpasses[i].edge_below].axis_id;
    of_axes[std::minmax(above, below)].push_back(i);
  }
  for (const OverpassOverride& wish : by_hand) {
    const auto found = of_axes.find(std::minmax(wish.axis_above, wish.axis_below));
    if (found == of_axes.end()) continue;
    const int i = crossing_of(wish, overpasses, found->second);
    if (i < 0) continue;
    Overpass& overpass = overpasses[i];
    if (network.edges[overpass.edge_above].axis_id != wish.axis_above) {
      std::swap(overpass.edge_above, overpass.edge_below);
      std::swap(overpass.abscissa_above, overpass.abscissa_below);
    }
    if (wish.clearance) overpass.clearance = *wish.clearance;
    overpass.method = OverpassMethod::by_hand;
  }
}

}  // namespace

std::vector<Overpass> overpasses(const Network& network, const std::vector<int>& importances,
                                 const std::vector<double>& axis_lengths,
                                 const std::vector<OverpassOverride>& by_hand, double tolerance,
                                 double clearance) {
  std::vector<Overpass> found;
  for (const Meeting& meeting : Crossings(network, tolerance).distinct())
    found.push_back(by_rule(meeting, network, importances, axis_lengths, clearance));
  apply(by_hand, network, found);
  std::sort(found.begin(), found.end(), [](const Overpass& p, const Overpass& q) {
    return std::tie(p.edge_above, p.abscissa_above, p.edge_below, p.abscissa_below) <
           std::tie(q.edge_above, q.abscissa_above, q.edge_below, q.abscissa_below);
  });
  return found;
}

}  // namespace streetgen
