#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "junction/slip_lane.hpp"
#include "lane/end_control.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/junction.hpp"

namespace streetgen {

namespace {

const double opposite = std::cos(M_PI / 6 + same_angle);  // of the directions of two carriageways
constexpr double longer_than_wide = 2;  // a median without a name; else it may be a block
constexpr double least_across = 0.5;    // sine of the angle of a link and a carriageway

RuleEdge rule_edge(const JunctionEdge& edge, const ControlEdge& control) {
  return {edge.from_node,   edge.to_node, length(edge.line), control.from_start,
          control.from_end, edge.along,   edge.against,      edge.name,
          edge.crossed,     edge.on_ring, edge.by_hand};
}

// Nodes that a rule would join, by some edges.
struct Link {
  std::vector<int> nodes, edges;
  double length = 0;  // metres
  Point middle;       // of its nodes: tells links of one length apart
};

class Grouping {
 public:
  Grouping(const JunctionNetwork& network, const JunctionRules& rules)
      : network_(network),
        rules_(rules),
        ends_(network.nodes.size()),
        chains_(static_cast<int>(network.nodes.size())),
        groups_(static_cast<int>(network.nodes.size())) {
    for (const JunctionEdge& edge : network.edges) {
      control_edges_.push_back(control_edge({edge.along, edge.against, edge.on_ring},
                                            edge.importance, edge.width, edge.width_end,
                                            edge.line));
      edges_.push_back(rule_edge(edge, control_edges_.back()));
    }
    for (int e = 0; e < size(); ++e) {
      ends_[edge(e).from_node].push_back(e);
      ends_[edge(e).to_node].push_back(e);
    }
    out_.parted.resize(size());
    out_.roles.resize(size(), EdgeRole::outside);
  }

  JunctionGroups run() {
    tell_controls();
    join_certain();
    const std::vector<Link> gaps = gap_links();
    for (const Link& link : gaps)
      for (const int node : link.nodes) chains_.join(link.nodes.front(), node);
    const std::vector<SlipLane> slips = find_slip_lanes(edges_, rules_, ends_, chains_);
    join_in_turn(signal_links());
    join_in_turn(with_slip_lanes(gaps, slips));
    join_signals();
    join_by_hand();
    tell_roles(slips);
    return std::move(out_);
  }

 private:
  int size() const { return static_cast<int>(edges_.size()); }
  const RuleEdge& edge(int e) const { return edges_[e]; }

  // Edges whose limits crossed; those inside by hand join chains here, and groups at the end.
  void join_certain() {
    for (int e = 0; e < size(); ++e) {
      if (!edge(e).by_hand.value_or(edge(e).crossed)) continue;
      chains_.join(edge(e).from_node, edge(e).to_node);
      if (edge(e).crossed) groups_.join(edge(e).from_node, edge(e).to_node);
    }
  }

  // After all rules, so that the extent of what they join does not count what is joined by hand.
  void join_by_hand() {
    for (int e = 0; e < size(); ++e)
      if (edge(e).by_hand.value_or(false)) groups_.join(edge(e).from_node, edge(e).to_node);
  }

  // Edges that go on from each other at nodes of two, from a node of more.
  struct Chain {
    std::vector<int> nodes, edges;
    double length = 0;
  };

  std::vector<Link> gap_links() {
    std::vector<Link> links;
    for (int e = 0; e < size(); ++e) {
      poll_cancel();
      for (const int node : {edge(e).from_node, edge(e).to_node}) {
        const Chain chain = chain_from(e, node);
        // A chain is found from both its ends.
        if (chain.edges.empty()) continue;
        const bool first = chain.edges.size() == 1 ? node == edge(e).from_node
                                                   : chain.edges.front() < chain.edges.back();
        if (first && joins_carriageways(chain))
          links.push_back(link_of(chain.nodes, chain.edges, chain.length));
      }
    }
    return links;
  }

  Chain chain_from(int e, int node) const {
    Chain chain{{node}, {}, 0};
    if (ends_[node].size() < 3) return chain;
    while (true) {
      node = other_end(e, node);
      chain.edges.push_back(e);
      chain.nodes.push_back(node);
      chain.length += edge(e).length;
      if (ends_[node].size() != 2 || chain.length > rules_.gap) return chain;
      const int next = ends_[node][0] == e ? ends_[node][1] : ends_[node][0];
      if (next == e) return chain;
      e = next;
    }
  }

  // Ways between signals that are too short for a queue, also over nodes without any.  Signals of a
  // node are those of all that it is joined to.
  std::vector<Link> signal_links() {
    lit_.assign(ends_.size(), false);
    for (int slot = 0; slot < 2 * size(); ++slot)
      if (at_signals_[slot])
        lit_[groups_.of(slot % 2 == 0 ? edge(slot / 2).from_node : edge(slot / 2).to_node)] = true;
    std::vector<Link> links;
    for (int n = 0; n < static_cast<int>(ends_.size()); ++n)
      if (lit_[groups_.of(n)]) {
        Chain way{{n}, {}, 0};
        append_signal_links(way, links);
      }
    return links;
  }

  void append_signal_links(Chain& way, std::vector<Link>& links) {
    poll_cancel();
    const int from = way.nodes.back();
    for (const int e : ends_[from]) {
      const int to = other_end(e, from);
      const bool here = groups_.of(to) == groups_.of(way.nodes.front());
      if (way.length + edge(e).length > rules_.controls.queue || edge(e).by_hand == false || here ||
          std::find(way.nodes.begin(), way.nodes.end(), to) != way.nodes.end())
        continue;
      way.nodes.push_back(to);
      way.edges.push_back(e);
      way.length += edge(e).length;
      if (!lit_[groups_.of(to)])
        append_signal_links(way, links);
      else if (way.nodes.front() < to)  // each way is found from both its ends
        links.push_back(link_of(way.nodes, way.edges, way.length));
      way.nodes.pop_back();
      way.edges.pop_back();
      way.length -= edge(e).length;
    }
  }

  Link link_of(std::vector<int> nodes, std::vector<int> edges, double length) const {
    Point sum;
    for (const int node : nodes) sum = sum + planar(network_.nodes[node]);
    return {nodes, std::move(edges), length, sum * (1.0 / static_cast<double>(nodes.size()))};
  }

  bool joins_carriageways(const Chain& chain) const {
    const int from = chain.nodes.front(), to = chain.nodes.back();
    if (chain.length > rules_.gap || from == to || ends_[to].size() < 3) return false;
    bool joined = true;  // by what is certain
    for (const int e : chain.edges) {
      if (edge(e).on_ring || edge(e).by_hand == false) return false;
      joined = joined && (edge(e).crossed || edge(e).by_hand);
    }
    if (joined) return false;
    for (const int a : ends_[from])
      for (const int b : ends_[to])
        if (a != chain.edges.front() && b != chain.edges.back() && a != b &&
            are_carriageways(a, b, chain))
          return true;
    return false;
  }

  // Are these both carriageways of the street that the link crosses?
  bool are_carriageways(int a, int b, const Chain& link) const {
    if (!edge(a).one_way() || !edge(b).one_way() || edge(a).on_ring || edge(b).on_ring)
      return false;
    const int from = link.nodes.front(), to = link.nodes.back();
    const Point first = heading(a, from), second = heading(b, to);
    if (std::abs(cross(first, course_from(link.edges.front(), from))) < least_across ||
        std::abs(cross(second, course_from(link.edges.back(), to))) < least_across)
      return false;
    const double cosine = -dot(first, second);
    if (edge(a).name != 0 && edge(b).name != 0) return cosine > 0 && edge(a).name == edge(b).name;
    return cosine >= opposite && goes_through(a, from) && goes_through(b, to) &&
           side_of(a, link.edges.front(), from) != side_of(b, link.edges.back(), to) &&
           std::min(edge(a).length, edge(b).length) >= longer_than_wide * link.length;
  }

  // Whether an edge leaves a node to the left of a link that leaves it too.
  bool side_of(int e, int link, int node) const {
    return cross(course_from(link, node), course_from(e, node)) > 0;
  }

  // In which an edge leaves a node.
  Point course_from(int e, int node) const {
    return edge(e).from_node == node ? edge(e).leaves_from : edge(e).leaves_to;
  }

  // Whether the traffic of a one-way edge has another such edge ahead of it, or behind it, there.
  bool goes_through(int e, int node) const {
    const Point course = heading(e, node);
    return std::any_of(ends_[node].begin(), ends_[node].end(), [&](int other) {
      return other != e && edge(other).one_way() && leaves(other, node) != leaves(e, node) &&
             dot(heading(other, node), course) >= opposite;
    });
  }

  // Whether the traffic of a one-way edge leaves the node.
  bool leaves(int e, int node) const { return (edge(e).from_node == node) == edge(e).along; }

  // The direction of the traffic of a one-way edge at a node.
  Point heading(int e, int node) const { return course_from(e, node) * (leaves(e, node) ? 1 : -1); }

  std::vector<Link> with_slip_lanes(std::vector<Link> links,
                                    const std::vector<SlipLane>& slips) const {
    for (const SlipLane& slip : slips) {
      std::vector<int> edges = slip.edges, nodes{slip.from_node, slip.to_node, slip.corner,
                                                 other_end(slip.behind, slip.to_node)};
      edges.insert(edges.end(), {slip.before, slip.behind});
      for (const int e : slip.edges)
        nodes.insert(nodes.end(), {edge(e).from_node, edge(e).to_node});
      links.push_back(link_of(std::move(nodes), std::move(edges), slip.length));
    }
    return links;
  }

  // From the shortest on, as far as the extent allows.
  bool join_in_turn(std::vector<Link> links) {
    std::sort(links.begin(), links.end(), [](const Link& a, const Link& b) {
      return std::make_tuple(a.length, a.middle.x, a.middle.y) <
             std::make_tuple(b.length, b.middle.x, b.middle.y);
    });
    members_.assign(network_.nodes.size(), {});
    for (int n = 0; n < static_cast<int>(network_.nodes.size()); ++n)
      members_[groups_.of(n)].push_back(n);
    bool joined = false;
    for (const Link& link : links) joined = join_link(link) || joined;
    return joined;
  }

  // What other rules joined may have come near to other signals.
  void join_signals() {
    while (join_in_turn(signal_links())) {
    }
  }

  int other_end(int e, int node) const {
    return edge(e).from_node == node ? edge(e).to_node : edge(e).from_node;
  }

  bool join_link(const Link& link) {
    std::vector<int> groups, nodes;
    for (const int node : link.nodes) groups.push_back(groups_.of(node));
    std::sort(groups.begin(), groups.end());
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    for (const int group : groups)
      nodes.insert(nodes.end(), members_[group].begin(), members_[group].end());
    const bool fits = groups.size() == 1 || within_extent(nodes);
    for (const int node : link.nodes) chains_.join(link.nodes.front(), node);
    if (!fits)
      for (const int e : link.edges) out_.parted[e] = true;
    if (!fits || groups.size() == 1) return false;
    for (const int group : groups) {
      groups_.join(groups.front(), group);
      members_[group].clear();
    }
    members_[groups_.of(groups.front())] = std::move(nodes);
    return true;
  }

  bool within_extent(const std::vector<int>& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (std::size_t j = i + 1; j < nodes.size(); ++j)
        if (distance(network_.nodes[nodes[i]], network_.nodes[nodes[j]]) > rules_.extent)
          return false;
    return true;
  }

  void tell_roles(const std::vector<SlipLane>& slips) {
    for (int n = 0; n < static_cast<int>(network_.nodes.size()); ++n)
      out_.of_node.push_back(groups_.of(n));
    for (int n = 0; n < static_cast<int>(network_.nodes.size()); ++n)
      out_.chain_of_node.push_back(chains_.of(n));
    for (int e = 0; e < size(); ++e)
      if (edge(e).from_node != edge(e).to_node && edge(e).by_hand.value_or(true) &&
          out_.of_node[edge(e).from_node] == out_.of_node[edge(e).to_node] &&
          (edge(e).crossed || edge(e).by_hand || edge(e).length <= rules_.extent))
        out_.roles[e] = EdgeRole::inside;
    for (const SlipLane& slip : slips)
      for (const int e : slip.edges)
        if (out_.roles[e] == EdgeRole::inside) out_.roles[e] = EdgeRole::slip_lane;
  }

  void tell_controls() {
    Network network;
    network.nodes.resize(network_.nodes.size());
    for (const JunctionEdge& edge : network_.edges)
      network.edges.push_back({edge.axis_id,
                               edge.from_node,
                               edge.to_node,
                               0,
                               edge.start_abscissa,
                               edge.end_abscissa,
                               {}});
    EndControls found = end_controls(network, control_edges_, network_.controls, rules_.controls);
    for (const EndControl& end : found.ends) {
      out_.controls.push_back(end.own);
      at_signals_.push_back(end.at_signals());
    }
    out_.served = std::move(found.served);
  }

  const JunctionNetwork& network_;
  const JunctionRules& rules_;
  std::vector<RuleEdge> edges_;
  std::vector<ControlEdge> control_edges_;
  std::vector<bool> lit_;               // by group
  std::vector<bool> at_signals_;        // by slot
  std::vector<std::vector<int>> ends_;  // by node
  Groups chains_;  // whatever the extent; at first without slip lanes: their corners
  Groups groups_;
  std::vector<std::vector<int>> members_;  // by group
  JunctionGroups out_;
};

}  // namespace

const char* edge_role_name(EdgeRole role) noexcept {
  switch (role) {
    case EdgeRole::outside:
      return "outside";
    case EdgeRole::inside:
      return "inside";
    case EdgeRole::slip_lane:
      return "slip_lane";
  }
  return "";
}

JunctionGroups group_junctions(const JunctionNetwork& network, const JunctionRules& rules) {
  return Grouping(network, rules).run();
}

}  // namespace streetgen
