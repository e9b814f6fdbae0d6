#include "mesh/breakline.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/space.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

constexpr double longest_line = 200;  // metres from an axis to the border

double distance_in_space(const Point& p, const Point& a, const Point& b) {
  const Point along = b - a;
  const double square = space::dot(along, along);
  const double share = square > 0 ? std::clamp(space::dot(p - a, along) / square, 0.0, 1.0) : 0;
  return space::distance(p, a + along * share);
}

// A place of an axis, and its metres along it.
struct Stop {
  double abscissa;
  Point place;
  bool on_border = false;
  int vertex = -1;  // none yet
};

class Walk {
 public:
  Walk(BorderNet& net, std::size_t surface, const MultiPolygon& ground)
      : net_(net), surface_(surface), ground_(ground), box_(box_of(ground)) {}

  void along(const Line& axis, Breaklines& found) {
    double before = 0;
    for (std::size_t i = 0; i < axis.size(); ++i) {
      if (i > 0) {
        meet(axis[i - 1], axis[i], before);
        before += distance(axis[i - 1], axis[i]);
      }
      stops_.push_back({before, planar(axis[i])});
    }
    join_to_border();
    for (std::size_t i = 1; i < stops_.size(); ++i) {
      const Point middle = (stops_[i - 1].place + stops_[i].place) * 0.5;
      if (holds(middle)) add(vertex(stops_[i - 1]), vertex(stops_[i]), found.along);
    }
    for (std::size_t i = 1; i + 1 < stops_.size(); ++i)
      if (!stops_[i].on_border) across(i, found.across);
  }

  void onwards(int from, int end, std::vector<BorderNet::Segment>& found) {
    add_to_border(end, unit(net_.point(end) - net_.point(from)), found);
  }

 private:
  bool holds(const Point& p) const { return box_.holds(p, 0) && inside(p, ground_); }

  // Calls use(side, share of the segment, share of the side).
  template <class Use>
  void crossings(const Point& from, const Point& to, double margin, Use use) const {
    const Point along = to - from;
    const Box box = box_of(from, to).grown(margin);
    if (!box_.meets(box)) return;
    for (const int side : net_.sides(surface_)) {
      const Point &a = net_.from(side), &b = net_.to(side);
      if (!box.meets(box_of(a, b))) continue;
      const double turn = cross(along, b - a);
      if (turn == 0) continue;
      const double t = cross(a - from, b - a) / turn, u = cross(a - from, along) / turn;
      const double slack = margin / norm(along), end = same_place / norm(b - a);
      // At the end of a side neither side may quite be met.
      if (t >= -slack && t <= 1 + slack && u >= -end && u <= 1 + end) use(side, t, u);
    }
  }

  void meet(const Point& from, const Point& to, double before) {
    const double size = distance(from, to);
    if (size <= rounding) return;
    crossings(planar(from), planar(to), vertex_reach, [&](int side, double t, double u) {
      const int vertex = net_.divide(side, u);
      borders_.push_back(vertex);
      stops_.push_back({before + t * size, net_.point(vertex), true, vertex});
    });
  }

  // A point of the axis on the border is the border's vertex.
  void join_to_border() {
    std::stable_sort(stops_.begin(), stops_.end(),
                     [](const Stop& a, const Stop& b) { return a.abscissa < b.abscissa; });
    std::vector<Stop> kept;
    for (const Stop& stop : stops_)
      if (stop.on_border || std::none_of(borders_.begin(), borders_.end(), [&](int vertex) {
            return distance(net_.point(vertex), stop.place) <= 2 * vertex_reach;
          }))
        kept.push_back(stop);
    stops_.swap(kept);
  }

  int vertex(Stop& stop) {
    if (stop.vertex < 0) stop.vertex = net_.vertex(stop.place);
    return stop.vertex;
  }
  static void add(int from, int to, std::vector<BorderNet::Segment>& found) {
    if (from != to) found.emplace_back(from, to);
  }

  // To the left and to the right, half way between both directions.
  void across(std::size_t at, std::vector<BorderNet::Segment>& found) {
    Stop& stop = stops_[at];
    if (!holds(stop.place)) return;
    const Point along =
        unit(unit(stop.place - stops_[at - 1].place) + unit(stops_[at + 1].place - stop.place));
    for (const double turn : {1.0, -1.0})
      add_to_border(vertex(stop), left_normal(along) * turn, found);
  }

  void add_to_border(int vertex, const Point& direction, std::vector<BorderNet::Segment>& found) {
    const Point from = net_.point(vertex);
    double least = 2, share = 0;
    int met = -1;
    crossings(from, from + direction * longest_line, 0, [&](int side, double t, double u) {
      if (t >= least) return;
      least = t;
      met = side;
      share = u;
    });
    if (met >= 0) add(vertex, net_.divide(met, share), found);
  }

  BorderNet& net_;
  std::size_t surface_;
  const MultiPolygon& ground_;
  Box box_;
  std::vector<Stop> stops_;
  std::vector<int> borders_;
};

// Whether they share more than a common end, or come nearer than a micrometre elsewhere.
bool meet(const BorderNet& net, const BorderNet::Segment& s, const BorderNet::Segment& t) {
  const auto near = [&](int vertex, const BorderNet::Segment& segment) {
    return vertex != segment.first && vertex != segment.second &&
           distance_to_segment(net.point(vertex), net.point(segment.first),
                               net.point(segment.second)) <= same_place;
  };
  if (near(s.first, t) || near(s.second, t) || near(t.first, s) || near(t.second, s)) return true;
  const bool joined =
      s.first == t.first || s.first == t.second || s.second == t.first || s.second == t.second;
  if (joined) return std::minmax(s.first, s.second) == std::minmax(t.first, t.second);
  return crossing(net.point(s.first), net.point(s.second), net.point(t.first), net.point(t.second))
      .has_value();
}

}  // namespace

Line without_slight_bends(const Line& line, double tolerance) {
  std::vector<bool> kept(line.size());
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double most = tolerance;
    std::size_t farthest = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = distance_in_space(line[i], line[first], line[last]);
      if (off <= most) continue;
      most = off;
      farthest = i;
    }
    if (farthest == first) continue;
    kept[farthest] = true;
    open.insert(open.end(), {{first, farthest}, {farthest, last}});
  }
  Line left;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (kept[i]) left.push_back(line[i]);
  return left;
}

void add_breaklines(BorderNet& net, std::size_t surface, const MultiPolygon& ground,
                    const Line& axis, Breaklines& breaklines) {
  Walk(net, surface, ground).along(axis, breaklines);
}

void end_at_border(BorderNet& net, std::size_t surface, const MultiPolygon& ground,
                   Breaklines& breaklines) {
  std::map<int, std::vector<int>> joined;
  for (const auto& [from, to] : breaklines.along) {
    joined[from].push_back(to);
    joined[to].push_back(from);
  }
  std::set<int> border;
  for (const int side : net.sides(surface))
    for (const int vertex : net.along(side)) border.insert(vertex);
  for (const auto& [end, others] : joined)
    if (others.size() == 1 && border.count(end) == 0)
      Walk(net, surface, ground).onwards(others.front(), end, breaklines.along);
}

std::vector<BorderNet::Segment> apart(const BorderNet& net,
                                      const std::vector<BorderNet::Segment>& border,
                                      const Breaklines& breaklines) {
  std::vector<BorderNet::Segment> all = border, kept;
  const auto box = [&](const BorderNet::Segment& s) {
    return box_of(net.point(s.first), net.point(s.second));
  };
  std::vector<Box> boxes;
  for (const BorderNet::Segment& side : border) boxes.push_back(box(side));
  BoxIndex index(boxes);
  for (const auto* lines : {&breaklines.along, &breaklines.across})
    for (const BorderNet::Segment& line : *lines) {
      if (index.any_near(box(line), same_place, [&](int i) { return meet(net, line, all[i]); }))
        continue;
      index.add(box(line), static_cast<int>(all.size()));
      all.push_back(line);
      kept.push_back(line);
    }
  return kept;
}

}  // namespace streetgen
