#include "roadway/ground_beside.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/box_index.hpp"
#include "geometry/closed_ring.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "roadway/street_face.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

const double opposite = std::cos(M_PI / 6);      // of the directions of two carriageways
const double nearly_along = std::cos(M_PI / 4);  // of two that part
const double spread = std::cos(M_PI / 3);        // of two at the end of a median
constexpr double longer_than_wide = 2;           // a median; else it may be a block
constexpr double goes_on_to = 1.5;       // a median, beyond its greatest width, where it goes on
constexpr double separator = 4;          // metres: the widest between carriageways of one direction
constexpr double places_apart = 5;       // metres along an edge, at most
constexpr double least_stretch = 15;     // metres of an edge that have a kind of their own
constexpr double largest_island = 400;   // square metres between kerbs
constexpr double least_turn = M_PI / 8;  // of a ring within the reach, radians

// Traffic runs along a side of a face, which is walked counter-clockwise, or against it.
enum class Flow { along, against, both };

// Sides in a row that go on from each other.
struct Run {
  Flow flow;
  double length;
  std::int64_t street;
};

class GroundBeside {
 public:
  explicit GroundBeside(const Layout& layout)
      : layout_(layout), edges_(layout.streets.network.edges) {
    std::vector<Box> boxes;
    for (const Edge& edge : edges_) {
      Box box;
      for (const Point& p : edge.line) box.add(p);
      boxes.push_back(box);
      widest_ = std::max(widest_, farthest_kerb(static_cast<int>(boxes.size()) - 1));
    }
    index_ = BoxIndex(boxes);
    look_at_small_faces();
  }

  BesideEdges find() const {
    BesideEdges found{std::vector<Beside>(2 * edges_.size()),
                      std::vector<Beside>(2 * edges_.size()),
                      std::vector<std::vector<double>>(2 * edges_.size())};
    for (int e = 0; e < static_cast<int>(edges_.size()); ++e) {
      poll_cancel();
      if (layout_.axis_of(e).outer) continue;
      for (const bool at_start : {true, false}) {
        const EdgeEnd end{e, at_start};
        found.sides[slot(end)] = beside(end, found.medians[slot(end)]);
      }
    }
    for (int n = 0; n < static_cast<int>(layout_.junctions.size()); ++n) {
      if (layout_.outer(n) || layout_.junctions[n].dead_end()) continue;
      const auto& ends = layout_.junctions[n].ends;
      for (std::size_t gap = 0; gap < ends.size(); ++gap)
        found.corners[slot(ends[gap])] = at_corner({n, gap});
    }
    return found;
  }

 private:
  double farthest_kerb(int e) const { return layout_.arms[2 * e].reach(); }

  Flow flow_of(const EdgeEnd& end) const {
    const StreetAxis& axis = layout_.axis_of(end.edge);
    if (axis.leads_forward == axis.leads_backward) return Flow::both;
    return axis.leads_forward == end.at_start ? Flow::along : Flow::against;
  }

  static bool may_be_one(std::int64_t street, std::int64_t other) {
    return street == other || street == 0 || other == 0;
  }

  Beside beside(const EdgeEnd& end, std::vector<double>& medians) const {
    if (lies_within_ring(end)) return Beside::island;
    if (const std::optional<Beside> small = small_[slot(end)]) return *small;
    if (closes_median(end)) return Beside::median;
    medians = beside_other(end);
    const double size = length(layout_.arm(end).line);
    double together = 0;
    for (std::size_t k = 1; k < medians.size(); k += 2) together += medians[k] - medians[k - 1];
    if (medians.size() == 2 && medians[0] == 0 && medians[1] == size) medians.clear();
    return 2 * together > size ? Beside::median : Beside::outer;
  }

  // A ring that its source names turns towards its island.
  bool lies_within_ring(const EdgeEnd& end) const {
    if (!layout_.axis_of(end.edge).on_ring) return false;
    double turn = turn_of(layout_.arm(end).line);
    const double here = length(layout_.arm(end).line);
    for (const bool ahead : {true, false}) {
      std::vector<int> passed{end.edge};
      EdgeEnd last = end;
      for (double along = here / 2; along < reach();) {
        const std::optional<EdgeEnd> next = along_ring(last, ahead);
        if (!next || std::count(passed.begin(), passed.end(), next->edge) > 0) break;
        passed.push_back(next->edge);
        turn += turn_between(ahead ? last : *next, ahead ? *next : last) +
                turn_of(layout_.arm(*next).line);
        along += length(layout_.arm(*next).line);
        last = *next;
      }
    }
    return turn > least_turn;
  }

  // The edge of the ring that goes on at the far end, or that comes to the near one, seen in the
  // direction of `end`.
  std::optional<EdgeEnd> along_ring(const EdgeEnd& end, bool ahead) const {
    const Edge& edge = edges_[end.edge];
    const int node = end.at_start == ahead ? edge.to_node : edge.from_node;
    for (const EdgeEnd& other : layout_.junctions[node].ends)
      if (other.edge != end.edge && layout_.axis_of(other.edge).on_ring)
        return ahead ? other : EdgeEnd{other.edge, !other.at_start};
    return {};
  }

  static double turn_at(const Point& before, const Point& after) {
    return std::atan2(cross(before, after), dot(before, after));
  }
  static double turn_of(const Line& line) {
    double turn = 0;
    for (std::size_t i = 2; i < line.size(); ++i)
      turn += turn_at(line[i - 1] - line[i - 2], line[i] - line[i - 1]);
    return turn;
  }
  double turn_between(const EdgeEnd& before, const EdgeEnd& after) const {
    const Line &a = layout_.arm(before).line, &b = layout_.arm(after).line;
    return turn_at(a.back() - a[a.size() - 2], b[1] - b[0]);
  }

  std::vector<Run> runs_of(const StreetFace& face) const {
    std::vector<Run> runs;
    const auto goes_on = [&](const FaceSide& side) {
      return layout_.junctions[side.corner.node].ends.size() == 2;
    };
    // From a corner where streets meet.
    std::size_t first = 0;
    while (first < face.size() && goes_on(face[first])) ++first;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const FaceSide& side = face[(first + k) % face.size()];
      const Flow flow = flow_of(side.end);
      const double size = length(layout_.arm(side.end).line);
      if (!runs.empty() && goes_on(side) && runs.back().flow == flow)
        runs.back().length += size;
      else
        runs.push_back({flow, size, layout_.axis_of(side.end.edge).street});
    }
    return runs;
  }

  // Each side walks about its face, as far as it knows it.
  void look_at_small_faces() {
    small_.resize(2 * edges_.size());
    for (int n = 0; n < static_cast<int>(layout_.junctions.size()); ++n) {
      poll_cancel();
      const auto& ends = layout_.junctions[n].ends;
      for (std::size_t gap = 0; gap < ends.size(); ++gap) {
        const StreetFace face = face_beside(layout_, {n, gap});
        if (on_one_level(layout_, face)) small_[slot(ends[gap])] = beside_small(face);
      }
    }
  }

  // A small face is of one kind all about, for the sides that know it.
  std::optional<Beside> beside_small(const StreetFace& face) const {
    if (face.empty()) return {};
    const Ring ring = ring_of(layout_, face);
    const double size = ring.empty() ? 0 : signed_area(ring);
    if (size < layout_.settings.least_island()) return {};
    const std::vector<Run> runs = runs_of(face);
    const auto one_way = [](const Run& run) { return run.flow != Flow::both; };
    if (std::none_of(runs.begin(), runs.end(), one_way)) return {};
    const double ground = size - under_roadway(face);
    double about = 0;
    for (const Run& run : runs) about += run.length;
    if (is_lens(runs) && ground <= widest_median() * about / 2) return Beside::median;
    if (runs.size() == 3 && size < layout_.settings.island_area)
      return parts(runs) ? Beside::splitter : Beside::island;
    if (ground < largest_island) return Beside::island;
    return {};
  }

  double under_roadway(const StreetFace& face) const {
    double covered = 0;
    for (const FaceSide& side : face) {
      const Arm& arm = layout_.arm(side.end);
      covered += length(arm.line) * (arm.start_to(+1) + arm.end_to(+1)) / 2;
    }
    return covered;
  }

  // Two carriageways part and join again, or two links close them.
  static bool is_lens(const std::vector<Run>& runs) {
    if (runs.size() == 2) return are_a_pair(runs[0], runs[1]);
    if (runs.size() != 4) return false;
    for (const std::size_t i : {0, 1}) {
      const Run &a = runs[i], &b = runs[i + 2], &link = runs[i + 1], &other = runs[(i + 3) % 4];
      if (are_a_pair(a, b) && a.length + b.length > longer_than_wide * (link.length + other.length))
        return true;
    }
    return false;
  }

  static bool are_a_pair(const Run& a, const Run& b) {
    return a.flow == b.flow && a.flow != Flow::both && may_be_one(a.street, b.street);
  }

  // A street parts at just one corner.
  static bool parts(const std::vector<Run>& runs) {
    int corners = 0;
    for (std::size_t i = 0; i < runs.size(); ++i)
      if (are_a_pair(runs[i], runs[(i + 1) % runs.size()])) ++corners;
    return corners == 1;
  }

  // Where another carriageway lies there: from, to …, metres along the edge.
  std::vector<double> beside_other(const EdgeEnd& end) const {
    if (flow_of(end) == Flow::both) return {};
    const double size = length(layout_.arm(end).line);
    const int count = std::max(1, static_cast<int>(std::ceil(size / places_apart)));
    std::vector<bool> beside, goes_on;
    for (int k = 0; k < count; ++k) {
      const std::optional<Hit> other = other_carriageway(end, size, (k + 0.5) / count * size);
      beside.push_back(other && begins_median(*other));
      goes_on.push_back(other.has_value());
    }
    for (int k = 1; k < count; ++k)
      if (beside[k - 1] && goes_on[k]) beside[k] = true;
    for (int k = count - 1; k > 0; --k)
      if (beside[k] && goes_on[k - 1]) beside[k - 1] = true;
    if (!end.at_start) std::reverse(beside.begin(), beside.end());
    join_short(beside, static_cast<int>(std::ceil(least_stretch / size * count)));
    std::vector<double> stretches;
    for (int k = 0; k < count; ++k) {
      if (!beside[k]) continue;
      if (k == 0 || !beside[k - 1]) stretches.push_back(size * k / count);
      if (k + 1 == count || !beside[k + 1])
        stretches.push_back(k + 1 == count ? size : size * (k + 1) / count);
    }
    return stretches;
  }

  // Runs of fewer than `least` become as their neighbours: the shortest first, and of equal ones
  // those that are true.
  static void join_short(std::vector<bool>& values, int least) {
    const int count = static_cast<int>(values.size());
    while (true) {
      int shortest = count, at = 0;
      for (int from = 0, to = 0; from < count; from = to) {
        while (to < count && values[to] == values[from]) ++to;
        if (to - from < shortest || (to - from == shortest && values[from] && !values[at]))
          shortest = to - from, at = from;
      }
      if (shortest == count || shortest >= least) return;
      for (int k = at; k < at + shortest; ++k) values[k] = !values[k];
    }
  }

  struct Hit {
    int edge;
    double away;         // metres
    Point direction;     // of the edge
    double ground = 0;   // metres between the kerbs
    double against = 0;  // cosine of the angle at which traffic there runs against that here
  };

  // The carriageway of the same street beyond the ground on the left, where one may be.
  std::optional<Hit> other_carriageway(const EdgeEnd& end, double size, double abscissa) const {
    const Arm& arm = layout_.arm(end);
    const LinePosition at = position_at(arm.line, abscissa);
    const double own = half_at(arm, abscissa, +1), most = goes_on_to * widest_median();
    std::optional<Hit> hit = first_across(end.edge, planar(at.point), unit(planar(at.direction)),
                                          own, std::min(own + most + widest_, reach()));
    if (!hit) return {};
    const EdgeEnd other{hit->edge, true};
    if (flow_of(other) == Flow::both) return {};
    hit->against = -(flow_of(end) == Flow::along ? 1 : -1) *
                   (flow_of(other) == Flow::along ? 1 : -1) *
                   dot(unit(planar(at.direction)), hit->direction);
    hit->ground = hit->away - own - farthest_kerb(hit->edge);
    const std::int64_t street = layout_.axis_of(end.edge).street,
                       other_street = layout_.axis_of(hit->edge).street;
    const bool named = street != 0 && other_street != 0;
    if (hit->ground > goes_on_to * widest_beside(*hit) || !may_be_one(street, other_street) ||
        (!named && size < longer_than_wide * hit->away))
      return {};
    return hit;
  }
  bool begins_median(const Hit& other) const {
    return std::abs(other.against) >= opposite && other.ground <= widest_beside(other);
  }
  // Ground to the other direction, and to a carriageway that runs along; none where they cross.
  double widest_beside(const Hit& other) const {
    if (std::abs(other.against) < spread) return -std::numeric_limits<double>::infinity();
    return other.against > 0 ? widest_median() : std::min(separator, widest_median());
  }
  double widest_median() const { return layout_.settings.median_width_maximal; }
  double reach() const { return layout_.settings.reach; }

  // The first edge on the left of a place that lies off the roadway there.
  std::optional<Hit> first_across(int own, const Point& at, const Point& along, double kerb,
                                  double far) const {
    const Point across = left_normal(along);
    Box box;
    box.add(at);
    box.add(at + across * far);
    std::optional<Hit> first;
    index_.each_near(box, 0, [&](int e) {
      if (e == own || edges_[e].level != edges_[own].level) return;
      const Line& line = edges_[e].line;
      for (std::size_t i = 1; i < line.size(); ++i) {
        const Point from = line[i - 1] - at, side = line[i] - line[i - 1];
        const double sine = cross(across, side);
        if (sine == 0) continue;
        const double away = cross(from, side) / sine, share = cross(from, across) / sine;
        if (share < 0 || share > 1 || away < kerb || away > far) continue;
        if (!first || away < first->away || (away == first->away && e < first->edge))
          first = Hit{e, away, unit(planar(side))};
      }
    });
    return first;
  }

  // Carriageways of one street go on along the face from both ends of a link, or of a street that
  // crosses.
  bool closes_median(const EdgeEnd& end) const {
    const FaceSide side{end, corner_beside(layout_, end)};
    const EdgeEnd after = side_after(layout_, side).end, before = side_before(layout_, side).end;
    if (after.edge == before.edge || !are_a_pair(after, before)) return false;
    const Arm &on = layout_.arm(after), &back = layout_.arm(before);
    const Line& across = layout_.arm(end).line;
    const double apart = length(across) - on.start_to(+1) - back.end_to(+1);
    const Point away = unit(planar(on.line[1] - on.line[0])),
                away_too = unit(planar(back.line[back.line.size() - 2] - back.line.back()));
    // Carriageways spread towards a roundabout, so those of one name may lie farther apart there.
    const std::int64_t street = layout_.axis_of(after.edge).street;
    const bool named = street != 0 && street == layout_.axis_of(before.edge).street;
    const double most = (named ? 2 : 1) * widest_median();
    // Both lie on the left of it.
    const bool beyond = cross(across.back() - across.front(), away) > 0 &&
                        cross(across.back() - across.front(), away_too) > 0;
    return beyond && apart <= most && dot(away, away_too) > spread;
  }

  bool are_a_pair(const EdgeEnd& a, const EdgeEnd& b) const {
    return flow_of(a) == flow_of(b) && flow_of(a) != Flow::both &&
           may_be_one(layout_.axis_of(a.edge).street, layout_.axis_of(b.edge).street);
  }

  Beside at_corner(const CornerPlace& corner) const {
    const Junction& junction = layout_.junctions[corner.node];
    const EdgeEnd &first = junction.ends[corner.gap], &second = junction.next(corner.gap);
    const EdgeEnd arrives{second.edge, !second.at_start};
    if (lies_within_ring(first) || lies_within_ring(arrives)) return Beside::island;
    if (const std::optional<Beside> small = small_[slot(first)]) return *small;
    if (parts_at_corner(first, second) || closes_median(first) || closes_median(arrives))
      return Beside::median;
    return lies_at_median(first, false) && lies_at_median(arrives, true) ? Beside::median
                                                                         : Beside::outer;
  }

  // A street parts there into its two directions, and the ground lies between them.
  bool parts_at_corner(const EdgeEnd& first, const EdgeEnd& second) const {
    const Line &line = layout_.arm(first).line, &other = layout_.arm(second).line;
    const Point a = unit(planar(line[1] - line[0])), b = unit(planar(other[1] - other[0]));
    return first.edge != second.edge && are_a_pair(first, {second.edge, !second.at_start}) &&
           dot(a, b) > nearly_along && cross(a, b) > 0;
  }

  // Another carriageway lies beside it near one of its ends.
  bool lies_at_median(const EdgeEnd& end, bool at_far_end) const {
    if (flow_of(end) == Flow::both) return false;
    const double size = length(layout_.arm(end).line), near = std::min(places_apart, size / 2);
    const std::optional<Hit> other = other_carriageway(end, size, at_far_end ? size - near : near);
    return other && begins_median(*other);
  }

  const Layout& layout_;
  const std::vector<Edge>& edges_;
  std::vector<std::optional<Beside>> small_;  // by slot: what small faces are
  BoxIndex index_;
  double widest_ = 0;  // metres from an edge to its farther kerb
};

}  // namespace

BesideEdges ground_beside(const Layout& layout) { return GroundBeside(layout).find(); }

const char* beside_name(Beside beside) noexcept {
  switch (beside) {
    case Beside::outer:
      return "outer";
    case Beside::median:
      return "median";
    case Beside::splitter:
      return "splitter";
    case Beside::island:
      return "island";
  }
  return "";
}

}  // namespace streetgen
