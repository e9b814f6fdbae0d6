#include "ownership/settle_owners.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/surface_distance.hpp"
#include "ownership/claim_index.hpp"
#include "ownership/covered_arc.hpp"
#include "ownership/crowd.hpp"
#include "ownership/hole.hpp"
#include "ownership/ownership.hpp"
#include "ownership/slit.hpp"
#include "ownership/street_claim.hpp"
#include "roadway/section_borders.hpp"
#include "roadway/street_surface.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/progress.hpp"

namespace streetgen {

namespace {

// A surface whose neighbours took less than this keeps its method.
constexpr double contested_at_least = 0.01;

// One claim an edge, then one a node.
class Owners {
 public:
  Owners(Layout& layout, const Affected& moved)
      : layout_(layout),
        edges_(static_cast<int>(layout.axes.size())),
        moved_(moved.edges),
        was_(moved.sections),
        given_up_(moved.given_up),
        turned_(moved.turned),
        beside_(moved.beside),
        surfaces_(edges_ + layout.junctions.size()),
        built_(surfaces_.size()),
        served_(surfaces_.size()),
        beside_change_(surfaces_.size()) {
    moved_.insert(moved_.end(), moved.nodes.begin(), moved.nodes.end());
    was_.insert(was_.end(), moved.intersections.begin(), moved.intersections.end());
    claims_.reserve(surfaces_.size());
    for (int e = 0; e < edges_; ++e) claims_.push_back(claim_of_section(layout, e));
    for (std::size_t n = 0; n < layout.junctions.size(); ++n)
      claims_.push_back(claim_of_intersection(layout, static_cast<int>(n)));
    for (std::size_t i = 0; i < claims_.size(); ++i) claims_[i].surface = &surfaces_[i].ground;
  }

  // What claims of one level cover their owners cover, but where another level takes of it.
  void want_beyond_reach() {
    for (int i = 0; i < static_cast<int>(claims_.size()); ++i) {
      if (!outer(i) || !tiles_with_other_level(i)) continue;
      const std::vector<int> near = vicinity().near(vicinity().extents()[i].box);
      claims_[i].wanted =
          std::any_of(near.begin(), near.end(), [&](int other) { return !outer(other); });
    }
  }

  void settle() {
    const std::vector<Hole> holes = build_what_matters();
    find_covered_arcs(holes);
    settle_ownership(geos_, claims_, disputes_);
    give_holes(geos_, claims_, holes);
    leave_what_stays();
    give_rows();
  }

  std::map<int, MultiPolygon> beyond_reach() {
    std::map<int, MultiPolygon> settled;
    for (int i = 0; i < static_cast<int>(claims_.size()); ++i)
      if (claims_[i].wanted && outer(i)) settled.emplace(i, std::move(surfaces_[i].ground));
    return settled;
  }

 private:
  // Whether it was not built yet.
  bool build(int i) {
    if (built_[i]) return false;
    built_[i] = true;
    poll_cancel();
    if (i < edges_) {
      tell_progress("sections", i, edges_);
      surfaces_[i] = section_of(geos_, layout_, i);
    } else {
      tell_progress("intersections", i - edges_, claims_.size() - edges_);
      surfaces_[i] = intersection_of(geos_, layout_, i - edges_);
    }
    return true;
  }

  // Whether any of them was not built yet.
  bool build(const std::vector<bool>& needed) {
    bool more = false;
    for (int i = 0; i < static_cast<int>(claims_.size()); ++i)
      if (needed[i]) more = build(i) || more;
    return more;
  }

  // What is wanted, and whatever may take part in what that becomes.
  std::vector<bool> needed_by_wanted() {
    if (all_wanted()) return std::vector<bool>(claims_.size(), true);
    std::vector<bool> needed(claims_.size());
    for (int i = 0; i < static_cast<int>(claims_.size()); ++i) {
      if (!claims_[i].wanted || served_[i]) continue;
      needed[i] = true;
      for (const int other : vicinity().opponents(i)) needed[other] = true;
    }
    for (const Crowd& crowd : crowds_about())
      if (any_claim(crowd, [&](int i) { return claims_[i].wanted; }))
        each_claim(crowd, [&](int i) { needed[i] = true; });
    for (int i = 0; i < static_cast<int>(claims_.size()); ++i) {
      if (!claims_[i].wanted || served_[i]) continue;
      served_[i] = true;
      for (const int other : vicinity().enclosing(i, needed)) needed[other] = true;
    }
    return needed;
  }

  std::vector<bool> needed_by(const std::vector<Hole>& holes) {
    std::vector<bool> needed(claims_.size());
    if (built_ == std::vector<bool>(claims_.size(), true)) return needed;
    for (const Hole& hole : holes)
      for (const int i : vicinity().near(box_of({{hole.ring}}))) needed[i] = true;
    return needed;
  }

  Vicinity& vicinity() {
    if (!vicinity_) {
      std::vector<Extent> extents;
      for (int e = 0; e < edges_; ++e) extents.push_back(section_extent(layout_, e));
      for (std::size_t n = 0; n < layout_.junctions.size(); ++n)
        extents.push_back(
            intersection_extent(layout_.arms_of(static_cast<int>(n)), layout_.junctions[n].gaps));
      vicinity_.emplace(std::move(extents), claims_, slit_width());
    }
    return *vicinity_;
  }

  // Where there may be a crowd, or may have been one: of the claims by their extents, and after
  // them of what was given up.
  const std::vector<Crowd>& crowds_about() {
    if (!crowds_) {
      const std::vector<Extent>& extents = vicinity().extents();
      std::vector<Box> boxes;
      for (const Extent& extent : extents) boxes.push_back(extent.box);
      for (const GivenUp& given_up : given_up_) boxes.push_back(box_of(given_up.surface->ground));
      crowds_ = crowds(boxes, most_overlaps(), [&](int i, const Box& square) {
        return i >= static_cast<int>(extents.size()) || extents[i].meets({square, {square}}, 0);
      });
    }
    return *crowds_;
  }

  double slit_width() const { return layout_.settings.slit_width; }
  std::size_t most_overlaps() const { return layout_.settings.overlaps_maximal; }

  template <class Use>
  void each_claim(const Crowd& crowd, Use use) const {
    for (const int i : crowd.members)
      if (i < static_cast<int>(claims_.size())) use(i);
  }

  template <class Holds>
  bool any_claim(const Crowd& crowd, Holds holds) const {
    bool any = false;
    each_claim(crowd, [&](int i) { any = any || holds(i); });
    return any;
  }

  // Whether the claim was not wanted yet.
  bool mark_affected(int i) {
    if (claims_[i].wanted) return false;
    claims_[i].wanted = true;
    auto& streets = layout_.streets;
    if (i < edges_) {
      if (!layout_.axis_of(i).outer) streets.affected_edges[i] = true;
      // An arc on the border of the section may be kerb no more, or again.
      const Edge& edge = streets.network.edges[i];
      for (const bool at_start : {true, false})
        if (streets.limits[slot({i, at_start})].shared > 0)
          mark_affected(edges_ + (at_start ? edge.from_node : edge.to_node));
    } else if (!layout_.outer(i - edges_)) {
      streets.affected_nodes[i - edges_] = true;
    }
    return true;
  }

  // What claims the same ground as something that moved.
  void ask_opponents() {
    const std::vector<std::vector<int>> all = opponents(claims_, disputes_);
    for (int i = 0; i < static_cast<int>(claims_.size()); ++i)
      if (moved_[i])
        for (const int other : all[i]) mark_affected(other);
  }

  bool all_wanted() const {
    return std::all_of(claims_.begin(), claims_.end(), [](const Claim& c) { return c.wanted; });
  }

  // What comes into one square with something that moved, or came there before.
  void ask_crowds() {
    if (all_wanted()) return;
    for (const Crowd& crowd : crowds_about())
      if (crowd.members.back() >= static_cast<int>(claims_.size()) ||
          any_claim(crowd, [&](int i) { return bool(moved_[i]); }))
        each_claim(crowd, [&](int i) { mark_affected(i); });
  }

  // From the surfaces as they were built.
  void leave_to_crowds() {
    for (auto& [i, whole] : wholes_) {
      surfaces_[i].ground = std::move(whole);
      claims_[i].whole = nullptr;
    }
    wholes_.clear();
    for (auto& [i, left] : left_by_crowds(geos_, claims_, most_overlaps())) {
      claims_[i].whole = &wholes_.emplace(i, std::move(surfaces_[i].ground)).first->second;
      surfaces_[i].ground = std::move(left);
    }
  }

  // Whose ground before, holes that it was given included, lies where something that moved lies
  // now.
  void ask_below_moved() {
    if (std::all_of(was_.begin(), was_.end(), [](const auto* was) { return was == nullptr; }))
      return;
    for (int i = 0; i < static_cast<int>(claims_.size()); ++i) {
      if (!moved_[i] || surfaces_[i].ground.empty()) continue;
      const PreparedSurface ground(surfaces_[i].ground);
      for (const int j : vicinity().near(ground.box().grown(hole_extent)))
        if (!claims_[j].wanted && was_[j] != nullptr &&
            overlap(ground, PreparedSurface(was_[j]->ground)))
          mark_affected(j);
    }
  }

  // Who claims ground that was given up, wherever the ground lies that it was left.
  void ask_above_given_up() {
    for (const GivenUp& given_up : given_up_) {
      if (given_up.surface->ground.empty()) continue;
      const PreparedSurface ground(given_up.surface->ground);
      for (const int i : vicinity().near(ground.box().grown(slit_width()))) {
        if (claims_[i].wanted || was_[i] == nullptr) continue;
        if (was_[i]->contested) build(i);
        if (overlap(ground,
                    PreparedSurface(was_[i]->contested ? surfaces_[i].ground : was_[i]->ground)) ||
            held_slit_beside(i, given_up.surface->ground))
          mark_affected(i);
      }
    }
  }

  // Whether it had more than it claims, and that ground may have been a slit beside what is gone.
  bool held_slit_beside(int i, const MultiPolygon& gone) {
    if (slit_width() <= 0 || was_[i]->contested) return false;
    build(i);
    return !same(was_[i]->ground, surfaces_[i].ground) &&
           come_near(was_[i]->ground, gone, slit_width());
  }

  bool outer(int i) const {
    return i < edges_ ? layout_.axis_of(i).outer : layout_.outer(i - edges_);
  }

  // Turned edges, and intersections at their ends, that share ground with what lies beyond reach.
  void lead_turned_on() {
    std::set<int> beside;  // what lies beyond reach
    for (const auto& [i, j] : disputes_) {
      if (outer(i)) beside.insert(j);
      if (outer(j)) beside.insert(i);
    }
    if (!turned_.empty())
      for (const Crowd& crowd : crowds_about())
        if (any_claim(crowd, [&](int i) { return outer(i); }))
          each_claim(crowd, [&](int i) { beside.insert(i); });
    for (const Turned& turned : turned_)
      for (const int e : turned.edges) {
        const Edge& edge = layout_.streets.network.edges[e];
        for (const int i : {e, edges_ + edge.from_node, edges_ + edge.to_node})
          if (beside.count(i) > 0) layout_.streets.spreads_to[e] = true;
      }
  }

  // Those that shared ground with it.
  void lead_turned_on_from_given_up() {
    for (const Turned& turned : turned_)
      for (const FormerSurface* before : turned.surfaces) {
        if (before->ground.empty()) continue;
        const PreparedSurface ground(before->ground);
        for (const int i : vicinity().near(ground.box())) {
          if (!outer(i) || !tile(claims_[turned.edges.front()], claims_[i])) continue;
          build(i);
          if (overlap(ground, PreparedSurface(surfaces_[i].ground)))
            layout_.streets.spreads_to[turned.edges.front()] = true;
        }
      }
  }

  bool tiles_with_other_level(int i) const {
    return std::any_of(claims_[i].edges.begin(), claims_[i].edges.end(), [&](int e) {
      const Edge& edge = layout_.streets.network.edges[e];
      return claims_[edges_ + edge.from_node].joins_levels ||
             claims_[edges_ + edge.to_node].joins_levels;
    });
  }

  bool ask_around(const std::vector<Hole>& holes) {
    bool more = false;
    for (const Hole& hole : holes)
      for (const int i : hole.around) more = mark_affected(i) || more;
    return more;
  }

  // Gives the holes beside what is wanted.
  std::vector<Hole> build_what_matters() {
    ask_above_given_up();
    lead_turned_on_from_given_up();
    for (;;) {
      build(needed_by_wanted());
      leave_to_crowds();
      disputes_ = disputes(claims_);
      ask_opponents();
      ask_crowds();
      ask_below_moved();
      if (build(needed_by_wanted())) continue;
      std::vector<Hole> holes = holes_between(claims_, disputes_, layout_.settings.least_island());
      for (Hole& slit :
           slits_between(claims_, holes, slit_width(), layout_.settings.kerb_radius_minimal,
                         layout_.settings.least_island()))
        holes.push_back(std::move(slit));
      if (build(needed_by(holes)) || ask_around(holes)) continue;
      lead_turned_on();
      vicinity_.reset();
      return holes;
    }
  }

  // Of claims as they come in, so that it does not matter which of them are settled.
  void find_covered_arcs(const std::vector<Hole>& holes) {
    const std::vector<std::vector<int>> all = opponents(claims_, disputes_);
    std::vector<MultiPolygon> filled;
    for (const Hole& hole : holes) filled.push_back({{hole.ring}});
    const std::vector<PreparedSurface> paved(filled.begin(), filled.end());
    const std::vector<Box> changed = changed_ground(paved);
    for (Corner& corner : layout_.streets.corners) {
      const int node = edges_ + corner.node;
      if (!corner.arc || !claims_[node].wanted) continue;
      const auto holds = [&](int i, const Point& p) {
        return claims_[i].level == claims_[node].level && inside(p, as_it_came(i));
      };
      const std::vector<int> own = with_arc(corner);
      const auto on_roadway = [&](const Point& p) {
        return std::any_of(own.begin(), own.end(),
                           [&](int i) {
                             return holds(i, p) ||
                                    std::any_of(all[i].begin(), all[i].end(),
                                                [&](int other) { return holds(other, p); });
                           }) ||
               std::any_of(paved.begin(), paved.end(),
                           [&](const PreparedSurface& hole) { return hole.holds(p); });
      };
      Box box = box_of(corner.arc->start, corner.arc->end);
      box.add(corner.arc->middle);
      if (std::any_of(changed.begin(), changed.end(),
                      [&](const Box& ground) { return ground.meets(box, same_place); }))
        beside_change_[node] = true;
      corner.covered = covered(corner, on_roadway);
    }
  }

  // The claims on whose border an arc lies: beyond limits that were brought near, of the sections.
  std::vector<int> with_arc(const Corner& corner) const {
    std::vector<int> claims{edges_ + corner.node};
    for (const EdgeEnd& end :
         {EdgeEnd{corner.edge_a, corner.at_start_a}, EdgeEnd{corner.edge_b, corner.at_start_b}})
      if (layout_.streets.limits[slot(end)].shared > 0) claims.push_back(end.edge);
    return claims;
  }

  const MultiPolygon& as_it_came(int i) const {
    return claims_[i].whole != nullptr ? *claims_[i].whole : *claims_[i].surface;
  }

  // Where an arc may be kerb that was none before, or the other way round, though the ground of its
  // node stays.  None where nothing was there before.
  std::vector<Box> changed_ground(const std::vector<PreparedSurface>& paved) const {
    std::vector<Box> changed;
    if (std::all_of(was_.begin(), was_.end(), [](const auto* was) { return was == nullptr; }))
      return changed;
    for (int i = 0; i < static_cast<int>(claims_.size()); ++i)
      if (moved_[i] && !as_it_came(i).empty()) changed.push_back(box_of(as_it_came(i)));
    for (const GivenUp& given_up : given_up_)
      if (!given_up.surface->ground.empty()) changed.push_back(box_of(given_up.surface->ground));
    for (const PreparedSurface& hole : paved) changed.push_back(hole.box());
    return changed;
  }

  // What neither moved nor got or lost ground, and has beside it what it had: the same ground, and
  // the same arcs.  In a crowd the same ground may have come about otherwise.
  void leave_what_stays() {
    auto& streets = layout_.streets;
    std::vector<bool> in_crowd(claims_.size());
    if (crowds_)
      for (const Crowd& crowd : *crowds_) each_claim(crowd, [&](int i) { in_crowd[i] = true; });
    for (int i = 0; i < static_cast<int>(claims_.size()); ++i)
      if (claims_[i].wanted && !in_crowd[i] && was_[i] != nullptr && !(i < edges_ && beside_[i]) &&
          !beside_change_[i] && same(was_[i]->ground, surfaces_[i].ground))
        (i < edges_ ? streets.affected_edges
                    : streets.affected_nodes)[i < edges_ ? i : i - edges_] = false;
  }

  template <class Row>
  void settle_row(Row& row, int i) {
    row.method = claims_[i].whole != nullptr                      ? Method::crowded
                 : claims_[i].contested_area > contested_at_least ? Method::contested
                                                                  : surfaces_[i].method;
    row.contested_area = claims_[i].contested_area;
    row.surface = std::move(surfaces_[i].ground);
  }

  void give_rows() {
    Streets& streets = layout_.streets;
    for (int e = 0; e < edges_; ++e) {
      if (!streets.affected_edges[e]) continue;
      Section section;
      section.edge = e;
      settle_row(section, e);
      section.borders = section_borders(layout_, e);
      streets.sections.push_back(std::move(section));
    }
    for (int i = edges_; i < static_cast<int>(claims_.size()); ++i) {
      const int node = i - edges_;
      if (!streets.affected_nodes[node] || layout_.junctions[node].dead_end()) continue;
      Intersection intersection;
      intersection.node = node;
      intersection.level = claims_[i].level;
      settle_row(intersection, i);
      streets.intersections.push_back(std::move(intersection));
    }
  }

  Layout& layout_;
  const int edges_;
  Geos geos_;
  std::vector<bool> moved_;  // by claim, as are those that follow
  std::vector<const FormerSurface*> was_;
  const std::vector<GivenUp>& given_up_;
  const std::vector<Turned>& turned_;
  const std::vector<bool>& beside_;  // by edge
  std::vector<Surface> surfaces_;
  std::vector<bool> built_, served_;  // served: what it needs was told
  std::vector<bool> beside_change_;   // an arc of the node
  std::vector<Claim> claims_;
  std::optional<Vicinity> vicinity_;
  std::optional<std::vector<Crowd>> crowds_;
  std::map<int, MultiPolygon> wholes_;  // of what came into a crowd, as it was built
  std::vector<std::pair<int, int>> disputes_;
};

}  // namespace

std::map<int, MultiPolygon> settle_owners(Layout& layout, const Affected& moved, bool with_border) {
  Owners owners(layout, moved);
  if (with_border) owners.want_beyond_reach();
  owners.settle();
  return owners.beyond_reach();
}

}  // namespace streetgen
