#include "streetgen/network.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <tuple>

#include "geometry/box_index.hpp"
#include "geometry/enclosing_circle.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"
#include "support/disjoint_sets.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

// One vertex of one axis.
struct AxisVertex {
  int axis;
  int index;
  double abscissa;
  Point point;
  bool end;
};

// Where a group of vertices or a crossing lies.
struct AxisPoint {
  int axis;
  Point point;
};

// Where an axis is cut: at a group of joined vertices, or at a crossing.
struct Cut {
  double abscissa;
  int group;
  bool operator<(const Cut& other) const {
    return std::tie(abscissa, group) < std::tie(other.abscissa, other.group);
  }
};

// The cuts of one axis, in order.
class Cuts {
 public:
  void add(const Cut& cut) { cuts_.insert(cut); }
  auto begin() const { return cuts_.begin(); }
  auto end() const { return cuts_.end(); }

  // The nearest cut within `reach` of an abscissa for which `wanted` is true.
  template <class Wanted>
  const Cut* near(double abscissa, double reach, Wanted wanted) const {
    const int any = std::numeric_limits<int>::min();
    const Cut* nearest = nullptr;
    for (auto cut = cuts_.lower_bound({abscissa - reach, any});
         cut != cuts_.end() && cut->abscissa <= abscissa + reach; ++cut)
      if (wanted(*cut) && (nearest == nullptr || std::abs(cut->abscissa - abscissa) <
                                                     std::abs(nearest->abscissa - abscissa)))
        nearest = &*cut;
    return nearest;
  }

 private:
  std::multiset<Cut> cuts_;
};

class NetworkBuilder {
 public:
  NetworkBuilder(const std::vector<NetworkAxis>& axes, double tolerance, Crossing crossing)
      : tolerance_(tolerance + std::min(same_place, tolerance / 1000)),
        crossing_(crossing),
        groups_(0) {
    for (const NetworkAxis& axis : axes) axes_.push_back(&axis);
    std::sort(axes_.begin(), axes_.end(),
              [](const NetworkAxis* a, const NetworkAxis* b) { return a->axis_id < b->axis_id; });
  }

  Network build() {
    read_vertices();
    join_vertices();
    cut_at_joined_vertices();
    cut_at_ends_on_segments();
    cut_at_crossings();
    join_near_cuts();
    make_nodes();
    make_edges();
    number_nodes();
    return std::move(out_);
  }

 private:
  const Line& line(int axis) const { return lines_[axis]; }

  void read_vertices() {
    for (int a = 0; a < static_cast<int>(axes_.size()); ++a) {
      Line kept;
      for (const Point& p : axes_[a]->line)
        if (kept.empty() || distance(kept.back(), p) > 0) kept.push_back(p);
      lines_.push_back(kept);
      first_.push_back(static_cast<int>(vertices_.size()));
      double abscissa = 0;
      for (int i = 0; i < static_cast<int>(kept.size()); ++i) {
        if (i > 0) abscissa += distance(kept[i - 1], kept[i]);
        const bool end = i == 0 || i + 1 == static_cast<int>(kept.size());
        vertices_.push_back({a, i, abscissa, kept[i], end});
      }
      lengths_.push_back(abscissa);
    }
    first_.push_back(static_cast<int>(vertices_.size()));
    groups_ = Groups(static_cast<int>(vertices_.size()));
    cuts_.resize(axes_.size());
  }

  bool may_join(const AxisVertex& u, const AxisVertex& v, double apart) const {
    if (u.axis == v.axis) {
      if (std::abs(u.index - v.index) <= 1) return false;
      return (u.end && v.end && lengths_[u.axis] > 3 * tolerance_) || apart <= same_place;
    }
    return axes_[u.axis]->level == axes_[v.axis]->level || u.end || v.end;
  }

  template <class Use>
  void near_pairs(const BoxIndex& index, double reach, Use use) {
    for (int i = 0; i < static_cast<int>(vertices_.size()); ++i) {
      poll_cancel();
      Box box;
      box.add(vertices_[i].point);
      index.each_near(box, reach, [&](int j) {
        if (j <= i) return;
        const double apart = distance(vertices_[i].point, vertices_[j].point);
        if (apart <= reach && may_join(vertices_[i], vertices_[j], apart)) use(i, j);
      });
    }
  }

  BoxIndex vertex_index() const {
    std::vector<Box> boxes(vertices_.size());
    for (std::size_t i = 0; i < vertices_.size(); ++i) boxes[i].add(vertices_[i].point);
    return BoxIndex(boxes);
  }

  void join_vertices() {
    const BoxIndex index = vertex_index();
    join_bounded([&](double reach, auto use) { near_pairs(index, reach, use); });
  }

  // Joins the groups of all pairs within the tolerance. A chain of them may grow too wide: then
  // only what coincides is joined.
  template <class Pairs>
  void join_bounded(Pairs pairs) {
    Groups joined = groups_;
    pairs(tolerance_, [&](int i, int j) { joined.join(i, j); });
    std::vector<Box> extent(groups_.size());
    for (int i = 0; i < groups_.size(); ++i) extent[joined.of(i)].add(place_of(i).point);
    std::map<int, Line> far;  // the points of groups that may be too wide
    for (int i = 0; i < groups_.size(); ++i) {
      const Box& box = extent[joined.of(i)];
      if (std::hypot(box.max_x - box.min_x, box.max_y - box.min_y) > 3 * tolerance_)
        far[joined.of(i)].push_back(place_of(i).point);
    }
    std::set<int> wide;
    for (auto& [group, points] : far) {
      // In the order of a line the circle would be sought anew at each point.
      std::shuffle(points.begin(), points.end(), std::minstd_rand{});
      const Circle about = enclosing_circle(points);
      if (2 * about.radius <= 3 * tolerance_) continue;
      wide.insert(group);
      const std::int64_t axis_id = axes_[place_of(group).axis]->axis_id;
      out_.reports.push_back(
          {NetworkIssue::wide_cluster, axis_id, axis_id, about.centre, 2 * about.radius});
    }
    for (int i = 0; i < groups_.size(); ++i)
      if (wide.count(joined.of(i)) == 0) groups_.join(i, joined.of(i));
    if (wide.empty()) return;
    pairs(same_place, [&](int i, int j) {
      if (wide.count(joined.of(i)) != 0) groups_.join(i, j);
    });
  }

  void cut_at_joined_vertices() {
    std::vector<int> members(vertices_.size(), 0);
    for (int i = 0; i < static_cast<int>(vertices_.size()); ++i) ++members[groups_.of(i)];
    for (int i = 0; i < static_cast<int>(vertices_.size()); ++i)
      if (const int group = groups_.of(i); members[group] > 1 || vertices_[i].end)
        cuts_[vertices_[i].axis].add({vertices_[i].abscissa, group});
  }

  struct Segment {
    int axis;
    int index;  // from vertex index to index + 1
    double abscissa;
  };

  void index_segments() {
    std::vector<Box> boxes;
    for (int a = 0; a < static_cast<int>(axes_.size()); ++a)
      for (int i = 0; i + 1 < static_cast<int>(line(a).size()); ++i) {
        segments_.push_back({a, i, vertices_[first_[a] + i].abscissa});
        Box box;
        box.add(line(a)[i]);
        box.add(line(a)[i + 1]);
        boxes.push_back(box);
      }
    segment_index_ = BoxIndex(boxes);
    segment_boxes_ = std::move(boxes);
  }

  bool cut_near(int axis, double abscissa, int group) const {
    return cuts_[axis].near(abscissa, 4 * tolerance_,
                            [&](const Cut& cut) { return cut.group == group; }) != nullptr;
  }

  // Vertices that would have joined, but for the width of their cluster.
  bool parted(int i, int j) {
    const AxisVertex &u = vertices_[i], &v = vertices_[j];
    const double apart = distance(u.point, v.point);
    return apart <= tolerance_ && may_join(u, v, apart) && groups_.of(i) != groups_.of(j);
  }

  void cut_at_ends_on_segments() {
    index_segments();
    std::vector<std::pair<int, Cut>> found;
    for (int v = 0; v < static_cast<int>(vertices_.size()); ++v) {
      const AxisVertex& vertex = vertices_[v];
      if (!vertex.end) continue;
      poll_cancel();
      Box box;
      box.add(vertex.point);
      std::map<int, std::pair<double, double>> best;  // axis -> distance, abscissa
      std::set<int> left;                             // axes with a vertex of the same wide cluster
      for (const int s : segment_index_.near(box, tolerance_)) {
        const Segment& segment = segments_[s];
        const Point &a = line(segment.axis)[segment.index],
                    &b = line(segment.axis)[segment.index + 1];
        for (const int i :
             {first_[segment.axis] + segment.index, first_[segment.axis] + segment.index + 1})
          if (parted(v, i)) left.insert(segment.axis);
        const double size = distance(a, b);
        const double along = std::clamp(dot(vertex.point - a, b - a) / size, 0.0, size);
        const double abscissa = segment.abscissa + along;
        const double apart = distance(vertex.point, a + (b - a) * (along / size));
        if (apart > tolerance_) continue;
        if (segment.axis == vertex.axis && std::abs(abscissa - vertex.abscissa) <= 4 * tolerance_)
          continue;
        const auto slot = best.try_emplace(segment.axis, apart, abscissa).first;
        if (apart < slot->second.first) slot->second = {apart, abscissa};
      }
      for (const auto& [axis, place] : best)
        if (left.count(axis) == 0 && !cut_near(axis, place.second, groups_.of(v)))
          found.push_back({axis, {place.second, groups_.of(v)}});
    }
    for (const auto& [axis, cut] : found) cuts_[axis].add(cut);
  }

  bool meet_near(int a, double at_a, int b, double at_b) const {
    return cuts_[a].near(at_a, 4 * tolerance_,
                         [&](const Cut& cut) { return cut_near(b, at_b, cut.group); }) != nullptr;
  }

  void cut_at_crossings() {
    struct Found {
      int a, b;
      double at_a, at_b;
      Point point;
    };
    std::vector<Found> found;
    for (int s = 0; s < static_cast<int>(segments_.size()); ++s) {
      poll_cancel();
      const Segment& one = segments_[s];
      const Point &p = line(one.axis)[one.index], &q = line(one.axis)[one.index + 1];
      for (const int t : segment_index_.near(segment_boxes_[s], 0)) {
        if (t <= s) continue;
        const Segment& other = segments_[t];
        if (axes_[one.axis]->level != axes_[other.axis]->level) continue;
        if (one.axis == other.axis && std::abs(one.index - other.index) <= 1) continue;
        const Point &r = line(other.axis)[other.index], &w = line(other.axis)[other.index + 1];
        const double d = cross(q - p, w - r);
        if (d == 0) continue;
        const double u = cross(r - p, w - r) / d, v = cross(r - p, q - p) / d;
        if (u < 0 || u > 1 || v < 0 || v > 1) continue;
        const double at_a = one.abscissa + u * distance(p, q);
        const double at_b = other.abscissa + v * distance(r, w);
        if (meet_near(one.axis, at_a, other.axis, at_b)) continue;
        Point point = p + (q - p) * u;
        found.push_back({one.axis, other.axis, at_a, at_b, point});
      }
    }
    for (const Found& f : found) {
      if (crossing_ == Crossing::over) {
        out_.reports.push_back(
            {NetworkIssue::crossing, axes_[f.a]->axis_id, axes_[f.b]->axis_id, f.point, 0});
        continue;
      }
      if (meet_near(f.a, f.at_a, f.b, f.at_b)) continue;
      // A node that one of the two already has there is the node of the crossing; other crossings
      // are joined with it later.
      int group = -1;
      double least = infinite;
      for (const auto& [axis, at] : {std::pair(f.a, f.at_a), std::pair(f.b, f.at_b)}) {
        const Cut* cut = cuts_[axis].near(
            at, tolerance_, [&](const Cut& other) { return crossings_.count(other.group) == 0; });
        if (cut == nullptr || std::abs(cut->abscissa - at) >= least) continue;
        least = std::abs(cut->abscissa - at);
        group = cut->group;
      }
      if (group < 0) {
        group = groups_.add();
        crossings_[group] = {f.a, f.point};
      }
      if (!cut_near(f.a, f.at_a, group)) cuts_[f.a].add({f.at_a, group});
      if (!cut_near(f.b, f.at_b, group)) cuts_[f.b].add({f.at_b, group});
    }
  }

  // Nodes within the tolerance of each other along an axis are one: those of ends on either side of
  // it, say.
  void join_near_cuts() {
    join_bounded([&](double reach, auto use) {
      for (const Cuts& cuts : cuts_) {
        const Cut* before = nullptr;
        for (const Cut& cut : cuts) {
          if (before != nullptr && cut.abscissa - before->abscissa <= reach)
            use(before->group, cut.group);
          before = &cut;
        }
      }
    });
  }

  AxisPoint place_of(int group) const {
    if (const auto crossing = crossings_.find(group); crossing != crossings_.end())
      return crossing->second;
    return {vertices_[group].axis, vertices_[group].point};
  }

  // Where the most arms meet of those that join; of places where as many do, the middle.
  Point place_of_node(const std::vector<int>& members) const {
    const auto arms_of = [&](int i) {
      if (i >= static_cast<int>(vertices_.size())) return 4;
      return vertices_[i].end ? 1 : 2;
    };
    const auto arms_at = [&](const Point& place) {
      int arms = 0;
      for (const int i : members)
        if (distance(place_of(i).point, place) <= same_place) arms += arms_of(i);
      return arms;
    };
    const auto is_place = [](const Point& place) {
      return [&](const Point& other) { return distance(other, place) <= same_place; };
    };
    std::vector<Point> best;
    int most = 0;
    for (const int i : members) {
      const Point& place = place_of(i).point;
      const int arms = arms_at(place);
      if (arms > most) best.clear();
      most = std::max(most, arms);
      if (arms == most && std::none_of(best.begin(), best.end(), is_place(place)))
        best.push_back(place);
    }
    Point sum;
    for (const Point& place : best) sum = sum + (place - best.front());
    return best.front() + sum * (1.0 / static_cast<double>(best.size()));
  }

  // Of groups whose members lie in several places, in the order of their axes.
  std::map<int, std::vector<int>> members_apart() {
    std::map<int, std::vector<int>> members;
    for (int i = 0; i < groups_.size(); ++i)
      if (const int group = groups_.of(i);
          group != i && distance(place_of(i).point, place_of(group).point) > 0)
        members.try_emplace(group);
    for (int i = 0; !members.empty() && i < groups_.size(); ++i)
      if (const auto all = members.find(groups_.of(i)); all != members.end())
        all->second.push_back(i);
    return members;
  }

  void make_nodes() {
    const std::map<int, std::vector<int>> apart = members_apart();
    node_of_.assign(groups_.size(), -1);
    for (int a = 0; a < static_cast<int>(axes_.size()); ++a)
      for (const Cut& cut : cuts_[a]) {
        const int group = groups_.of(cut.group);
        if (node_of_[group] < 0) {
          const auto members = apart.find(group);
          node_of_[group] = static_cast<int>(out_.nodes.size());
          out_.nodes.push_back(
              {members == apart.end() ? place_of(group).point : place_of_node(members->second),
               {}});
        }
        out_.nodes[node_of_[group]].anchors.push_back({axes_[a]->axis_id, cut.abscissa});
      }
  }

  void make_edges() {
    for (int a = 0; a < static_cast<int>(axes_.size()); ++a) {
      const std::size_t before = out_.edges.size();
      for (auto next = cuts_[a].begin(); next != cuts_[a].end();) {
        const Cut& from = *next++;
        if (next == cuts_[a].end()) break;
        const Cut& to = *next;
        const int from_group = groups_.of(from.group), to_group = groups_.of(to.group);
        const bool back = from_group == to_group;
        if (to.abscissa - from.abscissa <= (back ? 4 * tolerance_ : 0)) continue;
        Edge edge;
        edge.axis_id = axes_[a]->axis_id;
        edge.from_node = node_of_[from_group];
        edge.to_node = node_of_[to_group];
        edge.level = axes_[a]->level;
        edge.start_abscissa = from.abscissa;
        edge.end_abscissa = to.abscissa;
        edge.line.push_back(out_.nodes[edge.from_node].point);
        auto vertex = std::upper_bound(
            vertices_.begin() + first_[a], vertices_.begin() + first_[a + 1], from.abscissa,
            [](double abscissa, const AxisVertex& v) { return abscissa < v.abscissa; });
        for (; vertex != vertices_.begin() + first_[a + 1] && vertex->abscissa < to.abscissa;
             ++vertex)
          if (distance(vertex->point, edge.line.back()) > 0) edge.line.push_back(vertex->point);
        const Point& last = out_.nodes[edge.to_node].point;
        while (edge.line.size() > 1 && distance(edge.line.back(), last) == 0) edge.line.pop_back();
        edge.line.push_back(last);
        if (edge.line.size() == 2 && distance(edge.line[0], edge.line[1]) == 0) continue;
        out_.edges.push_back(std::move(edge));
      }
      if (out_.edges.size() == before)
        out_.reports.push_back({NetworkIssue::collapsed_axis, axes_[a]->axis_id, axes_[a]->axis_id,
                                axes_[a]->line.front(), lengths_[a]});
    }
  }

  // Nodes without an edge go; the rest are numbered by their smallest anchor.
  void number_nodes() {
    std::vector<bool> used(out_.nodes.size(), false);
    for (const Edge& edge : out_.edges) used[edge.from_node] = used[edge.to_node] = true;
    const auto less = [](const NodeAnchor& a, const NodeAnchor& b) {
      return std::tie(a.axis_id, a.abscissa) < std::tie(b.axis_id, b.abscissa);
    };
    std::vector<int> order;
    for (int n = 0; n < static_cast<int>(out_.nodes.size()); ++n) {
      std::sort(out_.nodes[n].anchors.begin(), out_.nodes[n].anchors.end(), less);
      if (used[n]) order.push_back(n);
    }
    std::sort(order.begin(), order.end(), [&](int i, int j) {
      return less(out_.nodes[i].anchors.front(), out_.nodes[j].anchors.front());
    });
    std::vector<int> number(out_.nodes.size(), -1);
    std::vector<Node> nodes;
    for (const int n : order) {
      number[n] = static_cast<int>(nodes.size());
      nodes.push_back(std::move(out_.nodes[n]));
    }
    out_.nodes = std::move(nodes);
    for (Edge& edge : out_.edges) {
      edge.from_node = number[edge.from_node];
      edge.to_node = number[edge.to_node];
    }
  }

  double tolerance_;  // metres, with the noise of coordinates
  Crossing crossing_;
  std::vector<const NetworkAxis*> axes_;  // by axis_id
  std::vector<Line> lines_;
  std::vector<double> lengths_;
  std::vector<AxisVertex> vertices_;  // by (axis_id, index)
  std::vector<int> first_;
  Groups groups_;
  std::vector<Cuts> cuts_;
  std::vector<Segment> segments_;
  std::vector<Box> segment_boxes_;
  BoxIndex segment_index_;
  std::map<int, AxisPoint> crossings_;
  std::vector<int> node_of_;  // by group, -1: none
  Network out_;
};

}  // namespace

Network network(const std::vector<NetworkAxis>& axes, double tolerance, Crossing crossing) {
  return NetworkBuilder(axes, tolerance, crossing).build();
}

}  // namespace streetgen
