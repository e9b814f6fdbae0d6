#include "roadway/find_affected.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "geometry/surface_distance.hpp"
#include "geometry/tolerance.hpp"
#include "roadway/section_borders.hpp"

namespace streetgen {

namespace {

constexpr double before_limit = 0.01;  // metres
// Metres aside by metres along a kerb.  No taper is as long.
constexpr double least_slant = 1e-4;

// Metres between surfaces, no more than which may have been filled as a hole.
constexpr double near_enough = 1;

constexpr int none = -1;

bool stays(const FormerLimit& before, const SectionLimit& now) {
  return before.wanted_abscissa == now.wanted_abscissa && before.abscissa == now.abscissa &&
         same(before.border_line, now.border_line);
}

class Change {
 public:
  Change(const Layout& layout, const Former& former)
      : layout_(layout),
        edges_(layout.streets.network.edges),
        nodes_(layout.streets.network.nodes),
        former_(former),
        met_(nodes_.size()),
        turned_(nodes_.size(), none),
        spreads_to_(edges_.size()),
        room_before_(edges_.size(), std::numeric_limits<double>::infinity()),
        moved_{std::vector<bool>(edges_.size()), std::vector<bool>(nodes_.size()),
               std::vector<const FormerSurface*>(edges_.size()),
               std::vector<const FormerSurface*>(nodes_.size()), std::vector<bool>(edges_.size())} {
  }

  Affected moved(const LeadsOn& leads_on) {
    compare_edges();
    for (std::size_t n = 0; n < nodes_.size(); ++n)
      if (!layout_.outer(static_cast<int>(n)) && (met_[n] || follows_met(n)))
        moved_.nodes[n] = true;
    lead_followers_on();
    if (leads_on && !former_.edges.empty()) {
      const Leads leads = leads_on(layout_.streets.network, layout_.streets.roadways);
      if (!leads.on.empty()) lead_along(leads.on);
      if (!leads.back.empty()) lead_back(leads);
    }
    compare_nodes();
    return moved_;
  }

  const std::vector<GivenUp>& given_up() const { return given_up_; }
  const std::vector<bool>& spreads_to() const { return spreads_to_; }

 private:
  // Met are the nodes at which an edge came, went or got another line; elsewhere limits moved.
  void compare_edges() {
    std::unordered_map<std::int64_t, std::vector<const FormerEdge*>> former;
    for (const FormerEdge& edge : former_.edges) former[edge.axis_id].push_back(&edge);
    std::map<std::int64_t, std::vector<int>> unchanged;  // their edges that are new
    std::vector<const FormerEdge*> kept(edges_.size());
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
      const StreetAxis& axis = layout_.axis_of(e);
      if (axis.outer) continue;
      const auto before = former.find(axis.axis_id);
      if (!axis.changed) {
        unchanged[axis.axis_id];
        if (before != former.end()) kept[e] = take(before->second, edges_[e]);
      }
      if (kept[e] != nullptr) continue;
      moved_.edges[e] = met_[edges_[e].from_node] = met_[edges_[e].to_node] = true;
      if (axis.changed || before == former.end()) continue;
      turn(e);
      unchanged[axis.axis_id].push_back(e);
    }
    for (const auto& [axis_id, fresh] : unchanged)
      if (!fresh.empty()) compare_course(fresh, former[axis_id]);
    for (const auto& [axis_id, gone] : former)
      for (const FormerEdge* edge : gone) give_up(*edge, unchanged.count(axis_id) == 0);
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e)
      if (kept[e] != nullptr) compare(e, *kept[e]);
    compare_runs(kept);
    for (bool changed = true; changed;) {
      changed = false;
      for (int e = 0; e < static_cast<int>(edges_.size()); ++e)
        if (kept[e] != nullptr && compare_borders(e, *kept[e])) changed = true;
    }
  }

  // Limits do not tell how far merging lanes go beyond them.
  void compare_runs(const std::vector<const FormerEdge*>& kept) {
    for (const MergingRun& run : layout_.merging_runs) {
      const auto met = [&](int ramp) {
        return ramp >= 0 && met_[layout_.streets.ramps[ramp].node];
      };
      const bool moved = std::any_of(run.edges.begin(), run.edges.end(),
                                     [&](const EdgeEnd& end) { return moved_.edges[end.edge]; });
      if (!moved && !met(run.first_ramp) && !met(run.last_ramp)) continue;
      for (const EdgeEnd& end : run.edges)
        if (kept[end.edge] != nullptr) move_all(end.edge, *kept[end.edge]);
    }
  }

  void move_all(int e, const FormerEdge& before) {
    move_section(e, before);
    move_end(e, edges_[e].from_node);
    move_end(e, edges_[e].to_node);
  }

  // Beyond a limit that stays, borders change with the street that goes on there, or with a merging
  // lane that came or went. Where they change at an end the next edge may too.
  bool compare_borders(int e, const FormerEdge& before) {
    const std::array nodes{edges_[e].from_node, edges_[e].to_node};
    const auto changes = [&](int node) { return met_[node] || moved_.nodes[node]; };
    if (!std::any_of(nodes.begin(), nodes.end(), changes)) return false;
    const auto &then = before.borders.places, now = section_borders(layout_, e).places;
    if (then == now) return false;
    const bool fresh = !moved_.edges[e];
    move_section(e, before);
    bool led_on = false;
    for (const bool first : {true, false}) {
      const int node = nodes[first ? 0 : 1];
      if (changes(node) || as_wide_at(e, first, then, now)) continue;
      move_end(e, node);
      led_on = true;
    }
    return fresh || led_on;
  }

  // Whether two kinds of borders of an edge lie as far apart at one of its ends.
  bool as_wide_at(int e, bool first, const std::vector<WidthProfile::Place>& then,
                  const std::vector<WidthProfile::Place>& now) const {
    const Arm& arm = layout_.arms[2 * e];
    const double half = first ? arm.half_start : arm.half_end;
    const auto at_end = [&](const std::vector<WidthProfile::Place>& places) {
      if (places.empty())
        return WidthProfile::Place{0, half + arm.roadway_offset, half - arm.roadway_offset};
      return first ? places.front() : places.back();
    };
    const WidthProfile::Place a = at_end(then), b = at_end(now);
    return std::abs(a.left - b.left) < rounding && std::abs(a.right - b.right) < rounding;
  }

  void move_section(int e, const FormerEdge& before) {
    if (moved_.edges[e]) return;
    moved_.edges[e] = true;
    moved_.sections[e] = nullptr;
    given_up_.push_back({&before.section, false});
  }

  // The same stretch of an axis may get another line, and the same line may be another stretch.
  static const FormerEdge* take(std::vector<const FormerEdge*>& some, const Edge& edge) {
    const auto found = std::find_if(some.begin(), some.end(), [&](const FormerEdge* before) {
      return before->start_abscissa == edge.start_abscissa &&
             before->end_abscissa == edge.end_abscissa && same(before->line, edge.line);
    });
    if (found == some.end()) return nullptr;
    const FormerEdge* before = *found;
    some.erase(found);
    return before;
  }

  void compare_course(const std::vector<int>& fresh, const std::vector<const FormerEdge*>& gone) {
    std::vector<const Line*> now, before;
    Turned turned{fresh, {}};
    for (const int e : fresh) now.push_back(&edges_[e].line);
    for (const FormerEdge* edge : gone) {
      before.push_back(&edge->line);
      turned.surfaces.push_back(&edge->section);
      for (const FormerNode& node : former_.nodes)
        if (distance(node.point, edge->line.front()) == 0 ||
            distance(node.point, edge->line.back()) == 0)
          turned.surfaces.push_back(&node.intersection);
    }
    if (!lies_on(now, before) || !lies_on(before, now)) moved_.turned.push_back(turned);
  }

  static bool lies_on(const std::vector<const Line*>& some,
                      const std::vector<const Line*>& course) {
    const auto on_course = [&](const Point& p) {
      return std::any_of(course.begin(), course.end(), [&](const Line* line) {
        return distance_to_line(p, *line) <= same_place;
      });
    };
    return std::all_of(some.begin(), some.end(), [&](const Line* line) {
      return std::all_of(line->begin(), line->end(), on_course);
    });
  }

  // An edge of an axis that did not change becomes another.
  void turn(int e) {
    for (const int node : {edges_[e].from_node, edges_[e].to_node}) {
      turned_[node] = e;
      lead_on(e, node);
    }
  }

  void lead_on(int e, int node) {
    if (layout_.meets_outer(node)) spreads_to_[e] = true;
  }

  // Along each edge that leads on from a node that moved, to its other end.
  void lead_along(const std::vector<bool>& leads) {
    std::vector<int> led;
    for (int n = 0; n < static_cast<int>(nodes_.size()); ++n)
      if (moved_.nodes[n]) led.push_back(n);
    while (!led.empty()) {
      const int node = led.back();
      led.pop_back();
      for (const EdgeEnd& end : layout_.junctions[node].ends) {
        const Edge& edge = edges_[end.edge];
        const int next = end.at_start ? edge.to_node : edge.from_node;
        if (!leads[2 * end.edge + (end.at_start ? 0 : 1)] || moved_.nodes[next] ||
            layout_.axis_of(end.edge).outer)
          continue;
        move_end(end.edge, next);
        led.push_back(next);
      }
    }
  }

  // Against traffic on each short edge that leads back, to the node that it leaves: from one that
  // is met, and where its limits moved.
  void lead_back(const Leads& leads) {
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
      if (layout_.axis_of(e).outer || std::min(room(e), room_before_[e]) >= leads.back_within)
        continue;
      const Edge& edge = edges_[e];
      if (leads.back[2 * e] && (moved_.edges[e] || met_[edge.to_node])) move_end(e, edge.from_node);
      if (leads.back[2 * e + 1] && (moved_.edges[e] || met_[edge.from_node]))
        move_end(e, edge.to_node);
    }
  }

  // Metres between the limits of an edge.
  double room(int e) const {
    const SectionLimit &start = layout_.streets.limits[2 * e],
                       &end = layout_.streets.limits[2 * e + 1];
    return end.abscissa - start.abscissa;
  }

  void lead_followers_on() {
    for (std::size_t n = 0; n < nodes_.size(); ++n)
      for (const int other : layout_.junctions[n].followed)
        if (turned_[other] != none && layout_.meets_outer(static_cast<int>(n)))
          spreads_to_[turned_[other]] = true;
  }

  void give_up(const FormerEdge& edge, bool of_changed) {
    given_up_.push_back({&edge.section, of_changed});
    for (const Point& end : {edge.line.front(), edge.line.back()}) {
      for (std::size_t n = 0; n < nodes_.size(); ++n)
        if (distance(nodes_[n].point, end) <= 3 * layout_.settings.tolerance) met_[n] = true;
      if (of_changed) ends_of_changed_.insert({end.x, end.y});
    }
  }

  void compare(int e, const FormerEdge& before) {
    const Edge& edge = edges_[e];
    const SectionLimit &start = layout_.streets.limits[2 * e],
                       &end = layout_.streets.limits[2 * e + 1];
    room_before_[e] = before.end.abscissa - before.start.abscissa;
    const auto& [sides, corners, medians] = layout_.streets.beside;
    moved_.beside[e] =
        sides[2 * e] != before.beside_left || sides[2 * e + 1] != before.beside_right ||
        medians[2 * e] != before.median_left || medians[2 * e + 1] != before.median_right;
    // An arc may move beyond a limit that stays; borders tell where it ends.
    const bool same_arcs = (start.shared <= 0 && end.shared <= 0) ||
                           before.borders.places == section_borders(layout_, e).places;
    const bool same_start = stays(before.start, start) && same_arcs,
               same_end = stays(before.end, end) && same_arcs;
    // Where another edge comes to a dead end, its round end goes.
    const bool rounded =
        layout_.settings.round_dead_ends && (met_[edge.from_node] || met_[edge.to_node]);
    if (same_start && same_end && !rounded) {
      moved_.sections[e] = &before.section;
      return;
    }
    moved_.edges[e] = true;
    given_up_.push_back({&before.section, false});
    // Lanes of crossed limits end at the other one's.
    const bool crossed =
        before.start.abscissa >= before.end.abscissa || limits_crossed(layout_.streets, e);
    // Lanes share out the width that a widening street has at its start.
    const Roadway& roadway = layout_.streets.roadways[e];
    const bool shared_anew = !same_start && roadway.width != roadway.width_end;
    const bool tapers_on = (!same_start && (tapers_at(e, end.abscissa - before_limit) ||
                                            tapered_at(e, before, before.end, -before_limit))) ||
                           (!same_end && (tapers_at(e, start.abscissa + before_limit) ||
                                          tapered_at(e, before, before.start, before_limit)));
    const bool both = crossed || shared_anew || tapers_on || bends_where_limits_moved(e, before);
    if (both || !same_start) move_end(e, edge.from_node);
    if (both || !same_end) move_end(e, edge.to_node);
  }

  // Whether the kerbs still change there, so that a limit that moved at the other end turns them. A
  // change ends at the far limit where the section has no room for more.
  bool tapers_at(int e, double abscissa) const {
    const WidthProfile& profile = layout_.streets.roadways[e].profile;
    if (profile.empty()) return false;
    const WidthProfile::Place at = profile.at(abscissa);
    const Arm& arm = layout_.arms[2 * e];
    return std::abs(at.left - half_at(arm, abscissa, +1)) > rounding ||
           std::abs(at.right - half_at(arm, abscissa, -1)) > rounding;
  }

  // Whether a kerb of the former section came aslant to its limit: a change filled the section, and
  // lanes were turned there.  The kerbs of a street that widens all along are always aslant.
  bool tapered_at(int e, const FormerEdge& before, const FormerLimit& limit, double inside) const {
    const Roadway& roadway = layout_.streets.roadways[e];
    if (roadway.width != roadway.width_end || limit.border_line.empty()) return false;
    const Point along = position_at(edges_[e].line, limit.abscissa + inside).direction;
    const auto at_limit = [&](const Point& p) {
      return distance_to_line(p, limit.border_line) <= same_place;
    };
    const auto aslant = [&](const Point& from, const Point& to) {
      return at_limit(from) != at_limit(to) &&
             std::abs(cross(to - from, along)) > least_slant * distance(from, to);
    };
    for (const Polygon& polygon : before.section.ground)
      for (const Ring& ring : polygon)
        for (std::size_t i = 0; i < ring.size(); ++i)
          if (aslant(ring[i], ring[(i + 1) % ring.size()])) return true;
    return false;
  }

  // Lanes may have another last segment at their far end then.
  bool bends_where_limits_moved(int e, const FormerEdge& before) const {
    const Line& line = edges_[e].line;
    const SectionLimit &start = layout_.streets.limits[2 * e],
                       &end = layout_.streets.limits[2 * e + 1];
    const auto [first, start_end] = std::minmax(before.start.abscissa, start.abscissa);
    const auto [end_start, last] = std::minmax(before.end.abscissa, end.abscissa);
    const Arm& arm = layout_.arms[2 * e];
    const double margin = std::max(arm.half_start, arm.half_end) + std::abs(arm.roadway_offset);
    bool moved = false, stays = false;
    double abscissa = 0;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      abscissa += distance(line[i - 1], line[i]);
      if (abscissa <= first - margin || abscissa >= last + margin) continue;
      const bool by_moved = (first < start_end && abscissa <= start_end + margin) ||
                            (end_start < last && abscissa >= end_start - margin);
      (by_moved ? moved : stays) = true;
    }
    return moved && !stays;
  }

  void move_end(int e, int node) {
    moved_.nodes[node] = true;
    lead_on(e, node);
  }

  // A corner there looked at a node that is met.
  bool follows_met(std::size_t node) const {
    const auto& followed = layout_.junctions[node].followed;
    return std::any_of(followed.begin(), followed.end(), [&](int other) { return met_[other]; });
  }

  // At one place may lie a node of each level.
  void compare_nodes() {
    std::map<std::tuple<double, double, int>, std::size_t> at;
    for (int n = 0; n < static_cast<int>(nodes_.size()); ++n)
      if (!layout_.junctions[n].ends.empty())
        at.insert({{nodes_[n].point.x, nodes_[n].point.y, layout_.level_of(n)}, n});
    for (const FormerNode& node : former_.nodes) {
      const auto kept = at.find({node.point.x, node.point.y, node.intersection.level});
      if (kept == at.end() || moved_.nodes[kept->second])
        given_up_.push_back(
            {&node.intersection, ends_of_changed_.count({node.point.x, node.point.y}) > 0});
      else
        moved_.intersections[kept->second] = &node.intersection;
    }
  }

  const Layout& layout_;
  const std::vector<Edge>& edges_;
  const std::vector<Node>& nodes_;
  const Former& former_;
  std::vector<bool> met_;
  std::vector<int> turned_;  // by node: an edge there that turned
  std::vector<bool> spreads_to_;
  std::vector<double> room_before_;  // by edge that was there: metres between its limits
  Affected moved_;
  std::vector<GivenUp> given_up_;
  std::set<std::pair<double, double>> ends_of_changed_;
};

// Marks those whose surface lies by ground that was given up: they may get some of it, or close no
// hole there any more.
void mark_by(const std::vector<GivenUp>& given_up,
             const std::vector<const FormerSurface*>& surfaces, std::vector<bool>& affected) {
  std::vector<Box> boxes;
  for (const FormerSurface* surface : surfaces)
    boxes.push_back(surface == nullptr ? Box{} : box_of(surface->ground));
  const BoxIndex index(boxes);
  for (const auto& [ground, of_changed] : given_up)
    for (const int i : index.near(box_of(ground->ground), near_enough))
      if (!affected[i] && (of_changed || surfaces[i]->contested) &&
          come_near(surfaces[i]->ground, ground->ground, near_enough))
        affected[i] = true;
}

}  // namespace

Affected find_affected(Layout& layout, const Former& former, const LeadsOn& leads_on) {
  Change change(layout, former);
  Affected moved = change.moved(leads_on);
  auto &edges = layout.streets.affected_edges, &nodes = layout.streets.affected_nodes;
  edges = moved.edges;
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (moved.beside[e]) edges[e] = true;
  nodes = moved.nodes;
  layout.streets.spreads_to = change.spreads_to();
  mark_by(change.given_up(), moved.sections, edges);
  mark_by(change.given_up(), moved.intersections, nodes);
  moved.given_up = change.given_up();
  return moved;
}

}  // namespace streetgen
