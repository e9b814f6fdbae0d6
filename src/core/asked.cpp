#include "asked.hpp"

#include <algorithm>
#include <unordered_map>

#include "polyline.hpp"

namespace streetgen {

namespace {

bool same(const Line& a, const Line& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; });
}

class Change {
 public:
  Change(const Layout& layout, const Former& former)
      : layout_(layout),
        edges_(layout.streets.network.edges),
        former_(former),
        met_(layout.junctions.size()),
        places_(layout.junctions.size()),
        moved_{std::vector<bool>(edges_.size()), std::vector<bool>(layout.junctions.size())} {}

  Moved moved() {
    compare_edges();
    for (const FormerPlace& place : former_.places)
      mark_near(place.point, place.met ? met_ : places_);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (layout_.axis_of(e).outer) continue;
      for (const int node : {edges_[e].from_node, edges_[e].to_node})
        if (met_[node] || follows_met(node)) moved_.edges[e] = moved_.nodes[node] = true;
    }
    return moved_;
  }

  // Nodes near which ground was given up.
  const std::vector<bool>& places() const { return places_; }

 private:
  void mark_near(const Point& place, std::vector<bool>& nodes) const {
    for (std::size_t n = 0; n < nodes.size(); ++n)
      if (distance(layout_.streets.network.nodes[n].point, place) <= 3 * layout_.settings.tolerance)
        nodes[n] = true;
  }

  // Met are the nodes at which an edge came, went or got another line; elsewhere limits moved.
  void compare_edges() {
    std::unordered_map<std::int64_t, std::vector<const FormerEdge*>> former;
    for (const FormerEdge& edge : former_.edges) former[edge.axis_id].push_back(&edge);
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
      const Edge& edge = edges_[e];
      if (layout_.axis_of(e).outer) continue;
      auto& lines = former[edge.axis_id];
      const auto kept = std::find_if(lines.begin(), lines.end(), [&](const FormerEdge* old) {
        return same(old->line, edge.line);
      });
      if (kept == lines.end() || layout_.axis_of(e).changed) {
        met_[edge.from_node] = met_[edge.to_node] = true;
        continue;
      }
      compare_limits(e, (*kept)->limits);
      lines.erase(kept);
    }
    for (const auto& [axis_id, gone] : former)
      for (const FormerEdge* edge : gone)
        for (const Point& end : {edge->line.front(), edge->line.back()}) mark_near(end, met_);
  }

  void compare_limits(int e, const std::array<double, 4>& before) {
    const SectionLimit &start = layout_.streets.limits[2 * e],
                       &end = layout_.streets.limits[2 * e + 1];
    const std::array<double, 4> now{start.wanted_abscissa, start.abscissa, end.wanted_abscissa,
                                    end.abscissa};
    if (before == now) return;
    // Lanes of crossed limits end at the other one's.
    const bool crossed = before[1] >= before[3] || limits_crossed(layout_.streets, e);
    if (crossed || before[0] != now[0] || before[1] != now[1])
      moved_.nodes[edges_[e].from_node] = true;
    if (crossed || before[2] != now[2] || before[3] != now[3])
      moved_.nodes[edges_[e].to_node] = true;
    moved_.edges[e] = true;
  }

  // A corner there looked at a node that is met.
  bool follows_met(int node) const {
    const auto& followed = layout_.junctions[node].followed;
    return std::any_of(followed.begin(), followed.end(), [&](int other) { return met_[other]; });
  }

  const Layout& layout_;
  const std::vector<Edge>& edges_;
  const Former& former_;
  std::vector<bool> met_, places_;
  Moved moved_;
};

}  // namespace

Moved ask_around_changes(Layout& layout, const Former& former) {
  Change change(layout, former);
  Moved moved = change.moved();
  auto &edges = layout.streets.asked_edges, &nodes = layout.streets.asked_nodes;
  edges = moved.edges;
  nodes = moved.nodes;
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (layout.axis_of(e).beside && !layout.axis_of(e).outer) edges[e] = true;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (change.places()[n]) nodes[n] = true;
  return moved;
}

}  // namespace streetgen
