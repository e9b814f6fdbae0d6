#include "kerb/find_kerbs.hpp"

#include <algorithm>
#include <utility>

#include "geometry/box_index.hpp"
#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "kerb/free_border.hpp"
#include "kerb/kerb_place.hpp"
#include "kerb/kerb_rows.hpp"
#include "kerb/moved_border.hpp"
#include "ownership/claim_index.hpp"
#include "roadway/street_surface.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/progress.hpp"

namespace streetgen {

namespace {

// One surface an edge, then one a node, then one a neighbour.
class RoadwayBorder {
 public:
  RoadwayBorder(Layout& layout, const Affected& moved,
                const std::map<int, MultiPolygon>& beyond_reach,
                const std::optional<std::vector<Neighbour>>& neighbours)
      : layout_(layout),
        streets_(layout.streets),
        edges_(static_cast<int>(layout.axes.size())),
        moved_(moved),
        beyond_reach_(beyond_reach),
        neighbours_(neighbours),
        grounds_(edges_ + layout.junctions.size()),
        wanted_(grounds_.size()),
        corner_from_(2 * layout.axes.size(), -1) {
    for (std::size_t c = 0; c < streets_.corners.size(); ++c) {
      const Corner& corner = streets_.corners[c];
      corner_from_[slot({corner.edge_a, corner.at_start_a})] = static_cast<int>(c);
    }
  }

  void find() {
    gather_grounds();
    want_affected();
    want_beside_changes();
    want_sections_at_nodes();
    std::vector<Box> boxes;
    for (int i = 0; i < count(); ++i) boxes.push_back(extent_of(i));
    if (neighbours_)
      for (const Neighbour& neighbour : *neighbours_) boxes.push_back(box_of(neighbour.ground));
    index_ = BoxIndex(boxes);
    for (int i = 0; i < count(); ++i) {
      if (!wanted_[i]) continue;
      poll_cancel();
      tell_progress("kerbs", i, grounds_.size());
      append_kerbs(i);
    }
    streets_.edges_with_kerbs.assign(wanted_.begin(), wanted_.begin() + edges_);
    streets_.nodes_with_kerbs.assign(wanted_.begin() + edges_, wanted_.end());
  }

 private:
  int count() const { return static_cast<int>(grounds_.size()); }
  bool outer(int i) const {
    return i < edges_ ? layout_.axis_of(i).outer : layout_.outer(i - edges_);
  }
  int level_of(int i) const {
    return i < edges_ ? streets_.network.edges[i].level : layout_.level_of(i - edges_);
  }
  const FormerSurface* former_of(int i) const {
    return i < edges_ ? moved_.sections[i] : moved_.intersections[i - edges_];
  }
  bool affected(int i) const {
    return i < edges_ ? moved_.edges[i] || streets_.affected_edges[i]
                      : moved_.nodes[i - edges_] || streets_.affected_nodes[i - edges_];
  }

  // As computed in this run, or else as it was before.
  void gather_grounds() {
    for (int i = 0; i < count(); ++i)
      if (former_of(i) != nullptr) grounds_[i] = &former_of(i)->ground;
    for (const Section& section : streets_.sections) grounds_[section.edge] = &section.surface;
    for (const Intersection& intersection : streets_.intersections)
      grounds_[edges_ + intersection.node] = &intersection.surface;
  }

  void want_affected() {
    for (int i = 0; i < count(); ++i) wanted_[i] = !outer(i) && affected(i);
    for (int e = 0; e < edges_; ++e)
      if (moved_.beside[e])
        for (const int i : beside(e))
          if (!outer(i)) wanted_[i] = true;
  }

  void want_beside_changes() {
    if (std::all_of(wanted_.begin(), wanted_.end(), [](bool wanted) { return wanted; })) return;
    MovedBorder moved;
    for (const GivenUp& given_up : moved_.given_up)
      moved.toggle(given_up.surface->ground, given_up.surface->level);
    for (const Section& section : streets_.sections) toggle(moved, section.edge);
    for (const Intersection& intersection : streets_.intersections)
      toggle(moved, edges_ + intersection.node);
    moved.settle();
    for (int i = 0; i < count(); ++i)
      if (!wanted_[i] && !outer(i) && grounds_[i] != nullptr && moved.lies_along(*grounds_[i]))
        wanted_[i] = true;
  }

  void toggle(MovedBorder& moved, int i) const {
    moved.toggle(*grounds_[i], level_of(i));
    if (former_of(i) != nullptr) moved.toggle(former_of(i)->ground, former_of(i)->level);
  }

  // A kerb of an intersection names one of the edges there.
  void want_sections_at_nodes() {
    for (std::size_t n = 0; n < layout_.junctions.size(); ++n)
      if (wanted_[edges_ + n])
        for (const EdgeEnd& end : layout_.junctions[n].ends)
          if (!outer(end.edge)) wanted_[end.edge] = true;
  }

  // Holds its ground; of what is not built yet, wherever that may lie.
  Box extent_of(int i) const {
    if (grounds_[i] != nullptr) return box_of(*grounds_[i]);
    if (!outer(i) || neighbours_) return {};
    return (i < edges_ ? section_extent(layout_, i)
                       : intersection_extent(layout_.arms_of(i - edges_),
                                             layout_.junctions[i - edges_].gaps))
        .box;
  }

  // Beyond reach: as far as settled, or as claimed.
  const MultiPolygon& claim(int i) {
    const auto settled = beyond_reach_.find(i);
    if (settled != beyond_reach_.end()) return settled->second;
    const auto [built, fresh] = built_.try_emplace(i);
    if (fresh)
      built->second =
          (i < edges_ ? section_of(geos_, layout_, i) : intersection_of(geos_, layout_, i - edges_))
              .ground;
    return built->second;
  }

  // The roadway goes on from a section to the intersections at its ends, whatever their level, and
  // past sections and intersections that have no ground.
  template <class IsMeant>
  bool goes_on_to(int i, const IsMeant& is_meant) const {
    std::vector<int> passed{i};
    for (std::size_t k = 0; k < passed.size(); ++k)
      for (const int next : beside(passed[k])) {
        if (is_meant(next)) return true;
        if (has_no_ground(next) && std::find(passed.begin(), passed.end(), next) == passed.end())
          passed.push_back(next);
      }
    return false;
  }
  std::vector<int> beside(int i) const {
    std::vector<int> found;
    if (i < edges_) {
      const Edge& edge = streets_.network.edges[i];
      found = {edges_ + edge.from_node, edges_ + edge.to_node};
    } else {
      for (const EdgeEnd& end : layout_.junctions[i - edges_].ends) found.push_back(end.edge);
    }
    return found;
  }
  bool has_no_ground(int i) const {
    if (grounds_[i] != nullptr || !outer(i)) return grounds_[i] == nullptr || grounds_[i]->empty();
    return neighbours_ &&
           std::none_of(neighbours_->begin(), neighbours_->end(),
                        [&](const Neighbour& neighbour) { return is(i, neighbour); });
  }
  bool is(int i, const Neighbour& neighbour) const {
    const auto& nodes = streets_.network.nodes;
    const auto& places = neighbour.nodes;
    if (i >= edges_) return places.size() == 1 && same(places[0], nodes[i - edges_].point);
    const Edge& edge = streets_.network.edges[i];
    const Point &from = nodes[edge.from_node].point, &to = nodes[edge.to_node].point;
    return places.size() == 2 && ((same(places[0], from) && same(places[1], to)) ||
                                  (same(places[1], from) && same(places[0], to)));
  }
  bool tile(int i, int other) const {
    return goes_on_to(i, [&](int next) { return next == other; });
  }
  // One that is not given has an end at a node that is.
  bool tile(int i, const Neighbour& neighbour) const {
    const auto ends_at = [&](int node) {
      return std::any_of(neighbour.nodes.begin(), neighbour.nodes.end(), [&](const Point& place) {
        return same(place, streets_.network.nodes[node - edges_].point);
      });
    };
    const bool is_section = neighbour.nodes.size() == 2;
    if (is_section && i >= edges_ && ends_at(i)) return true;
    return goes_on_to(i, [&](int next) {
      return next >= edges_ && ends_at(next) && (!is_section || has_no_ground(next));
    });
  }

  void share(int i, FreeBorder& border) {
    const int level = level_of(i);
    for (const int other : index_.near(border.box(), same_place)) {
      if (other == i) continue;
      if (other >= count()) {
        const Neighbour& neighbour = (*neighbours_)[other - count()];
        const bool other_level = neighbour.level != level;
        if (!other_level || tile(i, neighbour)) border.share_with(neighbour.ground, other_level);
        continue;
      }
      const bool same_level = level_of(other) == level;
      if (!same_level && !tile(i, other)) continue;
      if (grounds_[other] != nullptr)
        border.share_with(*grounds_[other], !same_level);
      else if (same_level)
        border.share_with_claim(claim(other));
      else
        border.share_with(claim(other), true);
    }
    border.share_with_itself();
  }

  void append_kerbs(int i) {
    if (grounds_[i] == nullptr || grounds_[i]->empty()) return;
    FreeBorder border(*grounds_[i]);
    share(i, border);
    KerbRows rows(layout_, i < edges_ ? i : -1, i < edges_ ? -1 : i - edges_, level_of(i),
                  streets_.kerbs);
    for (const BorderLoop& loop : border.loops()) {
      if (i < edges_) {
        const BorderLoop cut = cut_at_medians(layout_, i, loop);
        rows.append(cut, places_of_section(layout_, i, cut));
        continue;
      }
      const BorderLoop cut = cut_at_dead_ends(layout_, i - edges_, loop);
      rows.append(cut, places_of_intersection(layout_, i - edges_, corner_from_, cut));
    }
  }

  Layout& layout_;
  Streets& streets_;
  const int edges_;
  const Affected& moved_;
  const std::map<int, MultiPolygon>& beyond_reach_;
  const std::optional<std::vector<Neighbour>>& neighbours_;
  std::vector<const MultiPolygon*> grounds_;  // nullptr: none, or beyond reach
  std::vector<bool> wanted_;
  std::vector<int> corner_from_;  // by slot: the corner counter-clockwise from there
  BoxIndex index_;
  Geos geos_;
  std::map<int, MultiPolygon> built_;
};

}  // namespace

void find_kerbs(Layout& layout, const Affected& moved,
                const std::map<int, MultiPolygon>& beyond_reach,
                const std::optional<std::vector<Neighbour>>& neighbours) {
  RoadwayBorder(layout, moved, beyond_reach, neighbours).find();
}

}  // namespace streetgen
