#include "junction/slip_lane.hpp"

#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

// The flattest angle between a street and the slip lane that leaves it, as a cosine.
const double flattest = std::cos(M_PI / 3 + same_angle);
const double least_turn = std::cos(M_PI / 6 + same_angle);  // of a slip lane between its ends
constexpr std::size_t most_pieces = 8;                      // edges of a slip lane

class Finder {
 public:
  Finder(const std::vector<RuleEdge>& edges, const JunctionRules& rules,
         const std::vector<std::vector<int>>& ends, Groups& groups)
      : edges_(edges), rules_(rules), ends_(ends), groups_(groups) {}

  std::vector<SlipLane> run() {
    std::vector<SlipLane> found;
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
      if (!may_be_piece(e) || ends_[first_node(e)].size() < 3) continue;
      SlipLane lane = chain_from(e);
      if (lane.length > rules_.extent || ends_[lane.to_node].size() < 3 ||
          lane.from_node == lane.to_node || !turns(lane) || !cuts_corner(lane))
        continue;
      found.push_back(std::move(lane));
    }
    return found;
  }

 private:
  bool may_be_piece(int e) const {
    const RuleEdge& edge = edges_[e];
    return edge.one_way() && !edge.on_ring && !edge.by_hand && edge.from_node != edge.to_node;
  }

  int first_node(int e) const { return edges_[e].along ? edges_[e].from_node : edges_[e].to_node; }
  int last_node(int e) const { return edges_[e].along ? edges_[e].to_node : edges_[e].from_node; }
  // With the traffic.
  Point start_direction(int e) const {
    return edges_[e].along ? edges_[e].leaves_from : edges_[e].leaves_to;
  }
  Point end_direction(int e) const {
    return (edges_[e].along ? edges_[e].leaves_to : edges_[e].leaves_from) * -1;
  }

  // Goes on beyond nodes of two edges.
  SlipLane chain_from(int e) const {
    SlipLane lane;
    lane.from_node = first_node(e);
    while (true) {
      lane.edges.push_back(e);
      lane.length += edges_[e].length;
      lane.to_node = last_node(e);
      const std::vector<int>& there = ends_[lane.to_node];
      if (there.size() != 2 || lane.edges.size() == most_pieces) return lane;
      const int next = there[0] == e ? there[1] : there[0];
      if (!may_be_piece(next) || first_node(next) != lane.to_node) return lane;
      e = next;
    }
  }

  bool turns(const SlipLane& lane) const {
    return dot(start_direction(lane.edges.front()), end_direction(lane.edges.back())) < least_turn;
  }

  // Whether streets lead from the start of the lane to a corner, and from the corner to its end.
  bool cuts_corner(SlipLane& lane) {
    double least = 2 * rules_.extent;
    for (const int before : ends_[lane.from_node]) {
      const int corner = far_node(before, lane.from_node);
      if (before == lane.edges.front() || !leads(before, lane.from_node, true) ||
          dot(leaving(before, lane.from_node), start_direction(lane.edges.front())) < flattest)
        continue;
      for (const int behind : ends_[lane.to_node]) {
        const double size = edges_[before].length + edges_[behind].length;
        if (behind == lane.edges.back() || behind == before || size >= least ||
            !leads(behind, lane.to_node, false) ||
            groups_.of(far_node(behind, lane.to_node)) != groups_.of(corner) ||
            dot(leaving(behind, lane.to_node) * -1, end_direction(lane.edges.back())) < flattest)
          continue;
        least = size;
        lane.before = before;
        lane.behind = behind;
        lane.corner = corner;
      }
    }
    return least < 2 * rules_.extent;
  }

  int far_node(int e, int node) const {
    return edges_[e].from_node == node ? edges_[e].to_node : edges_[e].from_node;
  }
  Point leaving(int e, int node) const {
    return edges_[e].from_node == node ? edges_[e].leaves_from : edges_[e].leaves_to;
  }
  // Whether traffic runs from the node, or to the node, by a street short enough for a junction.
  bool leads(int e, int node, bool away) const {
    const RuleEdge& edge = edges_[e];
    const bool from_here = (edge.from_node == node) == away;
    return edge.length <= rules_.extent && edge.from_node != edge.to_node &&
           edge.by_hand.value_or(true) && (from_here ? edge.along : edge.against);
  }

  const std::vector<RuleEdge>& edges_;
  const JunctionRules& rules_;
  const std::vector<std::vector<int>>& ends_;
  Groups& groups_;
};

}  // namespace

std::vector<SlipLane> find_slip_lanes(const std::vector<RuleEdge>& edges,
                                      const JunctionRules& rules,
                                      const std::vector<std::vector<int>>& ends, Groups& groups) {
  return Finder(edges, rules, ends, groups).run();
}

}  // namespace streetgen
