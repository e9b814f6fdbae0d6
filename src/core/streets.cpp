#include "streetgen/streets.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include "around.hpp"
#include "by_hand.hpp"
#include "geos.hpp"
#include "hole.hpp"
#include "ownership.hpp"
#include "polyline.hpp"
#include "ring.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/progress.hpp"
#include "transition.hpp"
#include "vicinity.hpp"

namespace streetgen {

namespace {

// A surface whose neighbours took less than this keeps its method.
constexpr double contested_at_least = 0.01;

struct Around {
  std::vector<EdgeEnd> ends;  // counter-clockwise
  std::vector<Gap> gaps;      // between ends[i] and ends[i + 1]
  std::optional<Transition> transition;
  int along = 0;              // index in ends: the axis that the transition is seen along
  std::vector<int> followed;  // further nodes that a corner looked at
};

// The named steps; each reads what the ones before it wrote.
class Pipeline {
 public:
  Pipeline(const std::vector<StreetAxis>& axes, const StreetSettings& settings,
           const StreetOverrides& overrides, const Former& former)
      : settings_(settings), overrides_(overrides), former_(former) {
    for (const StreetAxis& axis : axes) {
      axes_.emplace(axis.axis_id, &axis);
      lengths_.emplace(axis.axis_id, length(axis.line));
    }
    std::vector<NetworkAxis> lines;
    for (const StreetAxis& axis : axes) lines.push_back({axis.axis_id, axis.line, axis.level});
    out_.network = network(lines, settings.tolerance, settings.crossing);
  }

  Streets run() {
    orient_arms();
    place_overrides();
    solve_corners();
    settle_limits();
    join_borders();
    ask_around_changes();
    build_surfaces(rings_of_surfaces());
    settle_owners();
    return std::move(out_);
  }

 private:
  const StreetAxis& axis_of(int edge) const { return *axes_.at(out_.network.edges[edge].axis_id); }

  void orient_arms() {
    const auto& edges = out_.network.edges;
    arms_.resize(2 * edges.size());
    around_.resize(out_.network.nodes.size());
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
      const Edge& edge = edges[e];
      const StreetAxis& axis = axis_of(e);
      const double total = lengths_.at(axis.axis_id);
      const auto half = [&](double abscissa) {
        return (axis.width + (axis.width_end - axis.width) *
                                 (total > 0 ? std::clamp(abscissa / total, 0.0, 1.0) : 0)) /
               2;
      };
      const double start = half(edge.start_abscissa), end = half(edge.end_abscissa);
      out_.roadways.push_back({2 * start, 2 * end, axis.importance});
      const Line line = distinct(planar(edge.line));
      arms_[2 * e] = {line, start, end, 0, {}};
      arms_[2 * e + 1] = {reversed(line), end, start, 0, {}};
      around_[edge.from_node].ends.push_back({e, true});
      around_[edge.to_node].ends.push_back({e, false});
    }
    for (Around& around : around_) {
      std::vector<Arm> arms;
      for (const EdgeEnd& end : around.ends) arms.push_back(arms_[slot(end)]);
      std::vector<EdgeEnd> sorted;
      for (const std::size_t i : counter_clockwise(arms)) sorted.push_back(around.ends[i]);
      around.ends = std::move(sorted);
    }
  }

  void place_overrides() {
    const EndsOfNode ends_of = [&](int node) -> const std::vector<EdgeEnd>& {
      return around_[node].ends;
    };
    limits_by_hand_ = limits_by_hand(out_.network, arms_, ends_of, overrides_.limits);
    radii_by_hand_ =
        radii_by_hand(out_.network, arms_, ends_of, overrides_.corners, settings_.tolerance);
  }

  double wanted_radius(const EdgeEnd& a, const EdgeEnd& b) const {
    const double ra = axis_of(a.edge).radius, rb = axis_of(b.edge).radius;
    if (ra <= 0 || rb <= 0) return 0;
    switch (settings_.radius_rule) {
      case RadiusRule::max:
        return std::max(ra, rb);
      case RadiusRule::mean:
        return (ra + rb) / 2;
      case RadiusRule::min:
        break;
    }
    return std::min(ra, rb);
  }

  // The arm with the axes that go on in its direction, up to `reach` from the node: at each
  // further node the one that turns least, of the same level and width.
  Arm longer(const EdgeEnd& end, std::vector<int>& followed) const {
    constexpr double least_cosine = 0.866;  // 30 degrees
    Arm arm = arms_[slot(end)];
    if (arm.half_start != arm.half_end) return arm;
    EdgeEnd last = end;
    while (length(arm.line) < settings_.reach) {
      const Edge& edge = out_.network.edges[last.edge];
      const Point direction = unit(arm.line.back() - arm.line[arm.line.size() - 2]);
      double best = least_cosine;
      const EdgeEnd* next = nullptr;
      followed.push_back(last.at_start ? edge.to_node : edge.from_node);
      for (const EdgeEnd& other : around_[followed.back()].ends) {
        const Arm& on = arms_[slot(other)];
        const double cosine = dot(direction, unit(on.line[1] - on.line[0]));
        if (other.edge == last.edge || out_.network.edges[other.edge].level != edge.level ||
            std::abs(on.half_start - arm.half_start) > same_width ||
            std::abs(on.half_end - arm.half_start) > same_width || cosine <= best)
          continue;
        best = cosine;
        next = &other;
      }
      if (next == nullptr) break;
      const Line& on = arms_[slot(*next)].line;
      arm.line.insert(arm.line.end(), on.begin() + 1, on.end());
      last = *next;
    }
    return arm;
  }

  // Between ends[i] and the next.
  SolvedCorner solve(Around& around, std::size_t i, double radius, bool by_hand) const {
    std::vector<const Arm*> arms;
    for (const EdgeEnd& end : around.ends) arms.push_back(&arms_[slot(end)]);
    const CornerWish wish{radius, settings_.max_arc_distance, settings_.radius_minimal, by_hand};
    SolvedCorner solved = solve_corner(arms, i, wish);
    const bool reduced = solved.method == Method::radius_reduced;
    if (solved.method != Method::no_arc && !(reduced && settings_.short_axis == ShortAxis::follow))
      return solved;
    const EdgeEnd &a = around.ends[i], &b = around.ends[(i + 1) % around.ends.size()];
    const auto followed = follow_corner(arms_[slot(a)], arms_[slot(b)], longer(a, around.followed),
                                        longer(b, around.followed), wish);
    return followed && (!reduced || followed->gap.corner.radius >= radius) ? *followed : solved;
  }

  // Of two ends where the width changes each is an end of its axis.
  void choose_transition(Around& around) const {
    const auto key = [&](int i) {
      const EdgeEnd& end = around.ends[i];
      return std::pair(axis_of(end.edge).axis_id, !end.at_start);
    };
    const int smaller = key(0) < key(1) ? 0 : 1;
    around.transition = settings_.transition;
    around.along = smaller;
    for (const int i : {1 - smaller, smaller}) {
      const StreetAxis& axis = axis_of(around.ends[i].edge);
      const auto& own = around.ends[i].at_start ? axis.transition_start : axis.transition_end;
      if (!own) continue;
      around.transition = own;
      around.along = i;
    }
  }

  static Corner without_arc(Corner corner, Method method) {
    corner.radius = 0;
    corner.centre.reset();
    corner.arc.reset();
    corner.method = method;
    return corner;
  }

  void solve_corners() {
    for (int n = 0; n < static_cast<int>(around_.size()); ++n) {
      Around& around = around_[n];
      const std::size_t degree = around.ends.size();
      if (degree < 2) continue;
      poll_cancel();
      tell_progress("corners", n, around_.size());
      for (std::size_t i = 0; i < degree; ++i) {
        const EdgeEnd &a = around.ends[i], &b = around.ends[(i + 1) % degree];
        const auto by_hand = radii_by_hand_.find({n, i});
        const bool decided = by_hand != radii_by_hand_.end();
        const double radius = decided ? by_hand->second : wanted_radius(a, b);
        SolvedCorner solved = solve(around, i, radius, decided);
        if (decided && solved.gap.corner.radius == radius) solved.method = Method::by_hand;
        widen_limits(arms_[slot(a)], arms_[slot(b)], solved);
        around.gaps.push_back(solved.gap);
        Corner corner{n, a.edge, a.at_start, b.edge, b.at_start, radius, 0, {}, {}, solved.method};
        if (solved.gap.corner.radius > 0) {
          corner.radius = solved.gap.corner.radius;
          corner.centre = solved.gap.corner.centre;
          corner.arc = solved.gap.corner.arc;
        }
        out_.corners.push_back(corner);
      }
      Arm &first = arms_[slot(around.ends[0])], &second = arms_[slot(around.ends[1])];
      if (degree == 2 && changes_width(first, second)) {
        choose_transition(around);
        for (auto corner = out_.corners.end() - 2; corner != out_.corners.end(); ++corner)
          *corner = without_arc(*corner, Method::transition);
        for (Arm* arm : {&first, &second})
          arm->limit = std::min(around.transition->length / 2, 0.4 * length(arm->line));
      }
      if (degree >= 3)
        for (const EdgeEnd& end : around.ends) {
          Arm& arm = arms_[slot(end)];
          arm.limit = std::max(arm.limit, least_limit(arm));
        }
    }
  }

  void settle_limits() {
    const auto& edges = out_.network.edges;
    out_.limits.resize(2 * edges.size());
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
      Arm &start = arms_[2 * e], &end = arms_[2 * e + 1];
      const double total = length(start.line);
      const auto &put_start = limits_by_hand_[2 * e], &put_end = limits_by_hand_[2 * e + 1];
      if (put_start) start.limit = *put_start;
      if (put_end) end.limit = *put_end;
      const double wanted_start = start.limit, wanted_end = end.limit;
      const bool crossed = start.limit + end.limit > total - 1e-3;
      const bool one_yields = crossed && put_start.has_value() != put_end.has_value();
      if (one_yields) {
        (put_start ? end : start).limit = total - (put_start ? start : end).limit;
      } else if (crossed) {
        const double sum = start.limit + end.limit;
        start.limit = sum > 0 ? total * start.limit / sum : total / 2;
        end.limit = total - start.limit;
      } else {
        const auto clear = [](const Arm& arm, bool put) {
          return put || arm.limit <= 0 ? arm.limit : kerb_clear_limit(arm, arm.limit);
        };
        const double clear_start = clear(start, put_start.has_value());
        const double clear_end = clear(end, put_end.has_value());
        if (clear_start + clear_end < total - 1e-3) {
          start.limit = clear_start;
          end.limit = clear_end;
        }
      }
      start.border = border_across(start, start.limit);
      end.border = crossed ? Line{start.border[1], start.border[0]} : border_across(end, end.limit);
      for (const bool at_start : {true, false}) {
        SectionLimit limit;
        limit.edge = e;
        limit.at_start = at_start;
        limit.wanted_abscissa = at_start ? wanted_start : total - wanted_end;
        limit.abscissa = at_start ? start.limit : total - end.limit;
        limit.point = place_at(edges[e].line, limit.abscissa).point;
        const bool put = (at_start ? put_start : put_end).has_value();
        limit.method = crossed && !(one_yields && put) ? Method::crossed_limits
                       : put                           ? Method::by_hand
                                                       : Method::hypothesis;
        out_.limits[2 * e + (at_start ? 0 : 1)] = limit;
      }
    }
  }

  std::array<double, 4> limits_of(int e) const {
    const SectionLimit &start = out_.limits[2 * e], &end = out_.limits[2 * e + 1];
    return {start.wanted_abscissa, start.abscissa, end.wanted_abscissa, end.abscissa};
  }

  void mark_near(const Point& place, std::vector<bool>& nodes) const {
    for (std::size_t n = 0; n < around_.size(); ++n)
      if (distance(out_.network.nodes[n].point, place) <= 3 * settings_.tolerance) nodes[n] = true;
  }

  // The nodes at which an edge came, went or got another line; those at which only a limit moved
  // are asked.
  std::vector<bool> met_nodes() {
    const auto& edges = out_.network.edges;
    const auto same = [](const Line& a, const Line& b) {
      return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                        [](const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; });
    };
    std::unordered_map<std::int64_t, std::vector<const FormerEdge*>> former;
    for (const FormerEdge& edge : former_.edges) former[edge.axis_id].push_back(&edge);
    std::vector<bool> met(around_.size());
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
      const Edge& edge = edges[e];
      if (axis_of(e).outer) continue;
      auto& lines = former[edge.axis_id];
      const auto kept = std::find_if(lines.begin(), lines.end(), [&](const FormerEdge* old) {
        return same(old->line, edge.line);
      });
      if (kept == lines.end() || axis_of(e).changed) {
        met[edge.from_node] = met[edge.to_node] = true;
        continue;
      }
      const auto before = (*kept)->limits, now = limits_of(e);
      lines.erase(kept);
      if (before == now) continue;
      // Lanes of crossed limits end at the other one's.
      const bool crossed = before[1] >= before[3] || limits_crossed(out_, e);
      if (crossed || before[0] != now[0] || before[1] != now[1])
        out_.asked_nodes[edge.from_node] = true;
      if (crossed || before[2] != now[2] || before[3] != now[3])
        out_.asked_nodes[edge.to_node] = true;
      out_.asked_edges[e] = true;
    }
    for (const auto& [axis_id, gone] : former)
      for (const FormerEdge* edge : gone)
        for (const Point& end : {edge->line.front(), edge->line.back()}) mark_near(end, met);
    for (const FormerPlace& place : former_.places)
      mark_near(place.point, place.met ? met : out_.asked_nodes);
    return met;
  }

  // The edges that changed axes can change, and the nodes.
  void ask_around_changes() {
    const auto& edges = out_.network.edges;
    out_.asked_edges.resize(edges.size());
    out_.asked_nodes.resize(around_.size());
    std::vector<bool> met = met_nodes();
    const std::vector<bool> moved = met;
    for (std::size_t n = 0; n < around_.size(); ++n)
      for (const int node : around_[n].followed)
        if (moved[node]) met[n] = true;
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
      const int from = edges[e].from_node, to = edges[e].to_node;
      if (axis_of(e).outer) continue;
      if (met[from] || met[to] || axis_of(e).beside) out_.asked_edges[e] = true;
      for (const int node : {from, to})
        if (met[node]) out_.asked_nodes[node] = true;
    }
  }

  bool asked(const Section& section) const { return out_.asked_edges[section.edge]; }
  bool asked(const Intersection& intersection) const { return out_.asked_nodes[intersection.node]; }

  // Border lines of neighbours that end on one kerb point end on the same.
  void join_borders() {
    for (const Around& around : around_)
      for (std::size_t i = 0; i < around.ends.size(); ++i) {
        const EdgeEnd& next = around.ends[(i + 1) % around.ends.size()];
        const Point& kerb = arms_[slot(around.ends[i])].border[0];
        Point& end = arms_[slot(next)].border[1];
        if (distance(kerb, end) > same_place) continue;
        end = kerb;
        if (limits_crossed(out_, next.edge))
          arms_[slot({next.edge, !next.at_start})].border[0] = kerb;
      }
    for (SectionLimit& limit : out_.limits) {
      const Line& border = arms_[slot({limit.edge, limit.at_start})].border;
      limit.border_line = limit.at_start ? border : Line{border[1], border[0]};
    }
  }

  bool dead_end(int node) const { return around_[node].ends.size() == 1; }

  std::vector<Arm> arms_of(int node) const {
    std::vector<Arm> arms;
    for (const EdgeEnd& end : around_[node].ends) arms.push_back(arms_[slot(end)]);
    return arms;
  }

  // Edges, then nodes: how far the surface of each is from the asked ones. Only what these may
  // depend on is built.
  std::vector<int> rings_of_surfaces() const {
    const std::size_t edges = out_.network.edges.size();
    std::vector<bool> asked = out_.asked_edges;
    asked.insert(asked.end(), out_.asked_nodes.begin(), out_.asked_nodes.end());
    if (std::find(asked.begin(), asked.end(), false) == asked.end())
      return std::vector<int>(asked.size());
    std::vector<Box> extents;
    for (std::size_t e = 0; e < edges; ++e)
      extents.push_back(section_extent(arms_[2 * e], out_.limits[2 * e].abscissa,
                                       out_.limits[2 * e + 1].abscissa));
    for (std::size_t n = 0; n < around_.size(); ++n)
      extents.push_back(intersection_extent(arms_of(n), around_[n].gaps));
    return rings(extents, asked);
  }

  void build_surfaces(const std::vector<int>& ring) {
    const auto& edges = out_.network.edges;
    for (int e = 0; e < static_cast<int>(edges.size()); ++e) {
      if (ring[e] == far_away) continue;
      poll_cancel();
      tell_progress("sections", e, edges.size());
      const SectionLimit &start = out_.limits[2 * e], &end = out_.limits[2 * e + 1];
      Section section;
      section.edge = e;
      if (limits_crossed(out_, e)) {
        section.method = Method::crossed_limits;
      } else {
        Built built = build_section(geos_, arms_[2 * e], start.abscissa, end.abscissa,
                                    start.border_line, end.border_line);
        section.method = built.by_union ? Method::robust_fallback : Method::hypothesis;
        section.surface = std::move(built.surface);
        if (settings_.round_dead_ends)
          for (const bool at_start : {true, false})
            if (dead_end(at_start ? edges[e].from_node : edges[e].to_node))
              section.surface =
                  with_round_end(geos_, section.surface, arms_[2 * e + (at_start ? 0 : 1)]);
      }
      fill_holes(section.surface, settings_.max_hole_area);
      out_.sections.push_back(std::move(section));
    }
    for (int n = 0; n < static_cast<int>(around_.size()); ++n) {
      const Around& around = around_[n];
      if (around.ends.size() < 2 || ring[edges.size() + n] == far_away) continue;
      poll_cancel();
      tell_progress("intersections", n, around_.size());
      const std::vector<Arm> arms = arms_of(n);
      Intersection intersection;
      intersection.node = n;
      intersection.level = level_of(around);
      if (around.transition) {
        // An axis that starts at the node goes on from it.
        const bool leaves = around.ends[around.along].at_start;
        const int from = leaves ? 1 - around.along : around.along;
        intersection.surface =
            build_transition(geos_, arms[from], arms[1 - from], around.transition->kind);
        intersection.method = Method::transition;
      } else {
        Built built = build_intersection(geos_, arms, around.gaps);
        intersection.method = built.by_union ? Method::robust_fallback : Method::hypothesis;
        intersection.surface = std::move(built.surface);
      }
      fill_holes(intersection.surface, settings_.max_hole_area);
      out_.intersections.push_back(std::move(intersection));
    }
  }

  // The level with most of the node's edges; ties: the lowest.
  int level_of(const Around& around) const {
    std::map<int, int> count;
    for (const EdgeEnd& end : around.ends) ++count[out_.network.edges[end.edge].level];
    return std::max_element(count.begin(), count.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
  }

  void add_axis(Claim& claim, int edge) const {
    const StreetAxis& axis = axis_of(edge);
    claim.importance = std::min(claim.importance, axis.importance);
    claim.width = std::max({claim.width, axis.width, axis.width_end});
    claim.axis_id = std::min(claim.axis_id, axis.axis_id);
  }

  bool outer(int node) const {
    const auto& ends = around_[node].ends;
    return std::all_of(ends.begin(), ends.end(),
                       [&](const EdgeEnd& end) { return axis_of(end.edge).outer; });
  }

  void ask(std::vector<Claim>& claims, int claim) {
    const int sections = static_cast<int>(out_.sections.size());
    claims[claim].wanted = true;
    if (claim < sections) {
      const int edge = out_.sections[claim].edge;
      if (!axis_of(edge).outer) out_.asked_edges[edge] = true;
    } else {
      const int node = out_.intersections[claim - sections].node;
      if (!outer(node)) out_.asked_nodes[node] = true;
    }
  }

  // What claims the same ground as they do.
  void ask_rivals(std::vector<Claim>& claims, const std::vector<std::pair<int, int>>& pairs) {
    std::vector<bool> asked;
    for (const Claim& claim : claims) asked.push_back(claim.wanted);
    for (const auto& [i, j] : pairs) {
      if (asked[i] && !asked[j]) ask(claims, j);
      if (asked[j] && !asked[i]) ask(claims, i);
    }
  }

  void settle_owners() {
    std::vector<Claim> claims;
    for (Section& section : out_.sections) {
      const SectionLimit &start = out_.limits[2 * section.edge],
                         &end = out_.limits[2 * section.edge + 1];
      const Arm& arm = arms_[2 * section.edge];
      Claim claim;
      claim.surface = &section.surface;
      claim.wanted = asked(section);
      const Edge& edge = out_.network.edges[section.edge];
      claim.level = edge.level;
      claim.edges = {section.edge};
      if (start.abscissa < end.abscissa)
        claim.skeleton.push_back({&arm.line, start.abscissa, end.abscissa});
      claim.axis_id = axis_of(section.edge).axis_id;
      claim.place = 2 * std::llround(1000 * edge.start_abscissa) + 1;
      add_axis(claim, section.edge);
      claims.push_back(std::move(claim));
    }
    for (Intersection& intersection : out_.intersections) {
      Claim claim;
      claim.surface = &intersection.surface;
      claim.wanted = asked(intersection);
      claim.level = intersection.level;
      const NodeAnchor& anchor = out_.network.nodes[intersection.node].anchors.front();
      claim.axis_id = anchor.axis_id;
      claim.place = 2 * std::llround(1000 * anchor.abscissa);
      for (const EdgeEnd& end : around_[intersection.node].ends) {
        const Arm& along = arms_[2 * end.edge];
        const double limit = arms_[slot(end)].limit, total = length(along.line);
        if (limit > 0)
          claim.skeleton.push_back(
              {&along.line, end.at_start ? 0 : total - limit, end.at_start ? limit : total});
        claim.edges.push_back(end.edge);
        add_axis(claim, end.edge);
      }
      claims.push_back(std::move(claim));
    }
    const auto pairs = disputes(claims);
    ask_rivals(claims, pairs);
    const auto holes = holes_between(geos_, claims, pairs, settings_.max_hole_area);
    for (const Hole& hole : holes)
      for (const int i : hole.around) ask(claims, i);
    settle_ownership(geos_, claims, pairs);
    give_holes(geos_, claims, holes);
    std::size_t i = 0;
    const auto read = [&](auto& rows) {
      for (auto& row : rows) {
        row.contested_area = claims[i++].contested_area;
        if (row.contested_area > contested_at_least) row.method = Method::contested;
      }
      rows.erase(
          std::remove_if(rows.begin(), rows.end(), [&](const auto& row) { return !asked(row); }),
          rows.end());
    };
    read(out_.sections);
    read(out_.intersections);
  }

  const StreetSettings& settings_;
  const StreetOverrides& overrides_;
  const Former& former_;
  std::unordered_map<std::int64_t, const StreetAxis*> axes_;
  std::unordered_map<std::int64_t, double> lengths_;
  Streets out_;
  std::vector<Arm> arms_;  // 2 * edge at its start, 2 * edge + 1 at its end
  std::vector<Around> around_;
  std::vector<std::optional<double>> limits_by_hand_;  // by slot, metres from the node
  RadiiByHand radii_by_hand_;
  Geos geos_;
};

}  // namespace

const char* method_name(Method method) noexcept {
  switch (method) {
    case Method::hypothesis:
      return "hypothesis";
    case Method::radius_reduced:
      return "radius_reduced";
    case Method::radius_minimal:
      return "radius_minimal";
    case Method::followed:
      return "followed";
    case Method::no_arc:
      return "no_arc";
    case Method::crossed_limits:
      return "crossed_limits";
    case Method::transition:
      return "transition";
    case Method::contested:
      return "contested";
    case Method::robust_fallback:
      return "robust_fallback";
    case Method::by_hand:
      return "by_hand";
  }
  return "";
}

bool limits_crossed(const Streets& streets, int edge) {
  return streets.limits[2 * edge].method == Method::crossed_limits ||
         streets.limits[2 * edge + 1].method == Method::crossed_limits;
}

Streets streets(const std::vector<StreetAxis>& axes, const StreetSettings& settings,
                const StreetOverrides& overrides, const Former& former) {
  return Pipeline(axes, settings, overrides, former).run();
}

}  // namespace streetgen
