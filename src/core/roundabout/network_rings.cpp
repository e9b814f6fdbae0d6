#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "geometry/enclosing_circle.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/ring_simplicity.hpp"
#include "geometry/tolerance.hpp"
#include "network/walk.hpp"
#include "roundabout/roundness.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/roundabout.hpp"
#include "streetgen/street_network.hpp"

namespace streetgen {

namespace {

Network network_of(const std::vector<RingAxis>& axes, const RingSettings& settings) {
  std::vector<StreetAxis> streets;
  for (const RingAxis& axis : axes) {
    StreetAxis street;
    street.axis_id = axis.axis_id;
    street.line = axis.line;
    street.level = axis.level;
    street.width = axis.width;
    street.width_end = axis.width_end;
    street.roadway_offset = axis.roadway_offset;
    street.importance = axis.importance;
    street.leads_forward = axis.leads_forward;
    street.leads_backward = axis.leads_backward;
    street.on_ring = axis.tagged;
    street.controls = axis.controls;
    streets.push_back(std::move(street));
  }
  return network_without_end_reports(streets, settings.tolerance, settings.crossing,
                                     settings.controls);
}

// A closed way of a walk, which leaves out what hangs into the ground within.
struct Loop {
  Walk steps;
  std::set<int> edges;  // of the whole walk
  int other_loops = 0;  // of the same walk
};

// A loop within the bounds.
struct RingFace {
  Loop loop;
  Ring line;
  Roundness shape;
  bool tagged = false;
};

class RingFinder {
 public:
  RingFinder(const std::vector<RingAxis>& axes, const RingSettings& settings)
      : settings_(settings), network_(network_of(axes, settings)), ends_(network_.nodes.size()) {
    for (const RingAxis& axis : axes) {
      one_way_[axis.axis_id] = axis.one_way;
      if (axis.tagged) tagged_.insert(axis.axis_id);
    }
    for (int e = 0; e < static_cast<int>(network_.edges.size()); ++e) {
      lengths_.push_back(length(network_.edges[e].line));
      ends_[network_.edges[e].from_node].push_back({e, true});
      ends_[network_.edges[e].to_node].push_back({e, false});
    }
    for (int n = 0; n < static_cast<int>(network_.nodes.size()); ++n) from_west_.push_back(n);
    std::sort(from_west_.begin(), from_west_.end(),
              [&](int a, int b) { return std::pair(place(a).x, a) < std::pair(place(b).x, b); });
  }

  std::vector<NetworkRing> find() const {
    const std::vector<RingFace> faces = find_faces();
    std::vector<int> face_of(2 * network_.edges.size(), -1);  // by slot
    for (int f = 0; f < static_cast<int>(faces.size()); ++f)
      for (const EdgeEnd& step : faces[f].loop.steps) face_of[slot(step)] = f;
    std::vector<int> halves;
    for (const RingFace& face : faces) halves.push_back(other_half(faces, face_of, face));
    std::vector<NetworkRing> rings;
    for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
      poll_cancel();
      const int other = halves[f];
      if (other < 0 || halves[other] != f)
        rings.push_back(ring_of({&faces[f]}, faces[f].loop.steps));
      else if (f < other)
        rings.push_back(ring_of({&faces[f], &faces[other]},
                                way_about(faces[f].loop.steps, faces[other].loop.steps)));
    }
    return rings;
  }

 private:
  const Point& place(int node) const { return network_.nodes[node].point; }
  int begins(const EdgeEnd& step) const {
    const Edge& edge = network_.edges[step.edge];
    return step.at_start ? edge.from_node : edge.to_node;
  }
  double size_of(const Walk& steps) const {
    double size = 0;
    for (const EdgeEnd& step : steps) size += lengths_[step.edge];
    return size;
  }

  EdgeEnd back(const EdgeEnd& step) const { return {step.edge, !step.at_start}; }

  // Tagged ones first, then those that streets of all kinds close. No side of an edge is in two of
  // them.
  std::vector<RingFace> find_faces() const {
    std::vector<RingFace> faces;
    std::set<int> taken;  // slots
    if (!tagged_.empty()) add_faces(true, faces, taken);
    add_faces(false, faces, taken);
    return faces;
  }

  // Of one level each, then those that only edges of several levels close.
  void add_faces(bool tagged, std::vector<RingFace>& faces, std::set<int>& taken) const {
    const auto counts = [&](const Edge& edge) {
      return !tagged || tagged_.count(edge.axis_id) > 0;
    };
    std::set<int> levels;
    for (const Edge& edge : network_.edges)
      if (counts(edge)) levels.insert(edge.level);
    const auto add = [&](const Walk& walk, std::size_t levels_least) {
      Loop loop = longest_loop(walk);
      if (levels_of(loop.steps).size() < levels_least ||
          std::any_of(loop.steps.begin(), loop.steps.end(),
                      [&](const EdgeEnd& step) { return taken.count(slot(step)) > 0; }))
        return;
      const auto face = face_of_loop(std::move(loop), tagged);
      if (!face) return;
      for (const EdgeEnd& step : face->loop.steps) taken.insert(slot(step));
      faces.push_back(*face);
    };
    for (const int level : levels)
      for (const Walk& walk :
           walks(network_, [&](const Edge& edge) { return edge.level == level && counts(edge); }))
        add(walk, 1);
    if (levels.size() > 1)
      for (const Walk& walk : walks(network_, counts)) add(walk, 2);
  }

  // The only face with which this one is a double roundabout, or -1.
  int other_half(const std::vector<RingFace>& faces, const std::vector<int>& face_of,
                 const RingFace& face) const {
    std::set<int> halves;
    for (const EdgeEnd& step : face.loop.steps) {
      const int other = face_of[slot(back(step))];
      if (other >= 0 && is_double(face, faces[other])) halves.insert(other);
    }
    return halves.size() == 1 ? *halves.begin() : -1;
  }

  bool is_double(const RingFace& a, const RingFace& b) const {
    if (a.tagged != b.tagged || !are_halves(a.shape, b.shape)) return false;
    const Walk about = way_about(a.loop.steps, b.loop.steps);
    return !about.empty() &&
           enclosing_circle(line_of(about)).radius <= settings_.radius_greatest / 2;
  }

  // About two loops that share one piece of way; empty where they share none, or several.
  Walk way_about(const Walk& a, const Walk& b) const {
    Walk about = outside(a, b);
    const Walk rest = outside(b, a);
    if (about.empty() || rest.empty()) return {};
    about.insert(about.end(), rest.begin(), rest.end());
    for (std::size_t i = 0; i < about.size(); ++i)
      if (begins(back(about[i])) != begins(about[(i + 1) % about.size()])) return {};
    return about;
  }

  // The steps of a loop that the other one does not take back, from the first after these.
  Walk outside(const Walk& loop, const Walk& other) const {
    std::set<int> taken_back;
    for (const EdgeEnd& step : other) taken_back.insert(slot(back(step)));
    const auto shared = [&](const EdgeEnd& step) { return taken_back.count(slot(step)) > 0; };
    Walk steps = loop;
    const auto last = std::adjacent_find(
        steps.begin(), steps.end(),
        [&](const EdgeEnd& a, const EdgeEnd& b) { return shared(a) && !shared(b); });
    if (last != steps.end()) std::rotate(steps.begin(), last + 1, steps.end());
    steps.erase(std::remove_if(steps.begin(), steps.end(), shared), steps.end());
    return steps;
  }

  // How much of the way lies on each.
  std::map<int, double> levels_of(const Walk& steps) const {
    std::map<int, double> metres;
    for (const EdgeEnd& step : steps)
      metres[network_.edges[step.edge].level] += lengths_[step.edge];
    return metres;
  }

  // Where a walk comes to a node for the second time a loop is closed.
  Loop longest_loop(const Walk& walk) const {
    std::map<int, int> times;
    for (const EdgeEnd& step : walk) ++times[step.edge];
    Walk open;
    std::map<int, std::size_t> since;  // by node: how many steps of the open way lead there
    std::vector<Walk> loops;
    for (const EdgeEnd& step : walk) {
      if (times[step.edge] > 1) continue;
      open.push_back(step);
      since.emplace(begins(step), open.size() - 1);
      const auto closed = since.find(begins({step.edge, !step.at_start}));
      if (closed == since.end()) continue;
      const std::size_t first = closed->second;
      loops.emplace_back(open.begin() + first, open.end());
      for (std::size_t i = first; i < open.size(); ++i) since.erase(begins(open[i]));
      open.resize(first);
    }
    if (loops.empty()) return {};
    const auto longest =
        std::max_element(loops.begin(), loops.end(),
                         [&](const Walk& a, const Walk& b) { return size_of(a) < size_of(b); });
    std::rotate(longest->begin(),
                std::min_element(longest->begin(), longest->end(),
                                 [](const auto& a, const auto& b) { return slot(a) < slot(b); }),
                longest->end());
    Loop loop{*longest, {}, static_cast<int>(loops.size()) - 1};
    for (const EdgeEnd& step : walk) loop.edges.insert(step.edge);
    return loop;
  }

  Ring line_of(const Walk& steps) const {
    Ring line;
    for (const EdgeEnd& step : steps) {
      const Line& edge = network_.edges[step.edge].line;
      for (const Point& p : step.at_start ? edge : reversed(edge))
        if (line.empty() || !same(line.back(), p)) line.push_back(planar(p));
    }
    if (!same(line.back(), line.front())) line.push_back(line.front());
    return line;
  }

  // A walk that leaves the ground within, across the ring without a node, would depend on all that
  // it comes to.
  bool lies_within(const std::set<int>& edges, const Circle& about) const {
    return std::all_of(edges.begin(), edges.end(), [&](int e) {
      const Line& line = network_.edges[e].line;
      return std::all_of(line.begin(), line.end(), [&](const Point& p) {
        return distance(planar(p), about.centre) <= about.radius + coordinate_margin;
      });
    });
  }

  std::optional<RingFace> face_of_loop(Loop loop, bool tagged) const {
    const double greatest = settings_.radius_greatest;
    // A source is believed that calls a tiny or a long ring a roundabout.
    const double least = tagged ? 0 : settings_.radius_least;
    const double size = size_of(loop.steps);
    if (loop.steps.empty() || size < 2 * M_PI * least ||
        (!tagged && size > 2 * M_PI * greatest / std::sqrt(settings_.shape_least)))
      return std::nullopt;
    RingFace face{std::move(loop), {}, {}, tagged};
    face.line = line_of(face.loop.steps);
    if (signed_area(face.line) <= 0 ||
        (!tagged && compactness_of(face.line) < settings_.shape_least) ||
        simple({{face.line}}) == false)
      return std::nullopt;
    const Circle about = enclosing_circle(face.line);
    if (about.radius > greatest || !lies_within(face.loop.edges, about)) return std::nullopt;
    const auto shape = roundness_of(face.line);
    if (!shape || shape->circle.radius < least) return std::nullopt;
    face.shape = *shape;
    return face;
  }

  NetworkRing ring_of(const std::vector<const RingFace*>& faces, const Walk& about) const {
    NetworkRing ring;
    ring.line = line_of(about);
    std::set<int> within;  // edges that are no arms
    for (const RingFace* face : faces) {
      ring.faces.push_back(face->line);
      for (const EdgeEnd& step : face->loop.steps) {
        ring.edges.push_back(edge_of(step.edge, step.at_start == settings_.counter_clockwise));
        ring.edges.back().face = static_cast<int>(ring.faces.size());
      }
      within.insert(face->loop.edges.begin(), face->loop.edges.end());
      ring.inside += face->loop.other_loops;
    }
    // As round as the less round half.
    Roundness shape = faces.front()->shape;
    if (faces.size() > 1 && faces.back()->shape.compactness < shape.compactness)
      shape = faces.back()->shape;
    if (faces.size() == 1) {
      const auto half = less_round_half(ring.line);
      ring.waist = half && half->compactness > shape.compactness;
      if (ring.waist) shape = *half;
    }
    ring.compactness = shape.compactness;
    ring.on_circle = shape.on_circle;
    const Circle circle =
        faces.size() == 1 ? faces.front()->shape.circle : roundness_of(ring.line).value().circle;
    ring.centre = circle.centre;
    ring.radius = circle.radius;
    add_traffic(about, ring);
    add_arms(about, within, ring);
    for (const RingFace* face : faces) ring.inside += nodes_within(face->line, ring.level);
    return ring;
  }

  RingEdge edge_of(int e, bool along_axis) const {
    const Edge& edge = network_.edges[e];
    return {edge.axis_id, edge.start_abscissa, edge.end_abscissa, along_axis};
  }

  void add_traffic(const Walk& steps, NetworkRing& ring) const {
    const double size = size_of(steps);
    for (const EdgeEnd& step : steps) {
      const OneWay one_way = one_way_.at(network_.edges[step.edge].axis_id);
      if (one_way == OneWay::no) continue;
      const bool along = step.at_start == settings_.counter_clockwise;
      ((one_way == OneWay::along) == along ? ring.one_way : ring.against) +=
          lengths_[step.edge] / size;
    }
    const std::map<int, double> metres = levels_of(steps);
    ring.level = std::max_element(metres.begin(), metres.end(), [](const auto& a, const auto& b) {
                   return a.second < b.second;
                 })->first;
  }

  void add_arms(const Walk& steps, const std::set<int>& within, NetworkRing& ring) const {
    int single = 0;
    for (const EdgeEnd& step : steps) {
      int arms = 0;
      for (const EdgeEnd& end : ends_[begins(step)]) {
        if (within.count(end.edge) > 0) continue;
        ring.arms.push_back(edge_of(end.edge, !end.at_start));
        ++arms;
      }
      ring.arm_nodes += arms > 0;
      single += arms == 1;
    }
    if (ring.arm_nodes > 0) ring.single_arm = static_cast<double>(single) / ring.arm_nodes;
  }

  // Of edges on the level.
  int nodes_within(const Ring& line, int level) const {
    const auto [west, east] = std::minmax_element(
        line.begin(), line.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
    const auto first = std::lower_bound(from_west_.begin(), from_west_.end(), west->x,
                                        [&](int n, double x) { return place(n).x < x; });
    int count = 0;
    for (auto n = first; n != from_west_.end() && place(*n).x <= east->x; ++n)
      count += std::any_of(
                   ends_[*n].begin(), ends_[*n].end(),
                   [&](const EdgeEnd& end) { return network_.edges[end.edge].level == level; }) &&
               inside(planar(place(*n)), Polygon{line}) &&
               distance_to_line(planar(place(*n)), line) > coordinate_margin;
    return count;
  }

  const RingSettings& settings_;
  Network network_;
  std::map<std::int64_t, OneWay> one_way_;
  std::set<std::int64_t> tagged_;           // axes
  std::vector<std::vector<EdgeEnd>> ends_;  // by node
  std::vector<double> lengths_;             // by edge, metres
  std::vector<int> from_west_;              // nodes
};

}  // namespace

std::vector<NetworkRing> network_rings(const std::vector<RingAxis>& axes,
                                       const RingSettings& settings) {
  return RingFinder(axes, settings).find();
}

}  // namespace streetgen
