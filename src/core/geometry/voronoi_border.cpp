#include "geometry/voronoi_border.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

constexpr double beyond = 1;  // metres
constexpr double stride = 2;  // metres: sites in a row are no farther apart
constexpr int beside = 2;     // sites of a row
constexpr Box everywhere{-infinite, -infinite, infinite, infinite};

std::vector<Site> distinct_sites(const std::vector<Site>& sites, const Point& origin) {
  std::vector<std::pair<double, int>> order;  // by x
  order.reserve(sites.size());
  for (const Site& site : sites) order.emplace_back(site.point.x, static_cast<int>(order.size()));
  std::sort(order.begin(), order.end());
  std::vector<bool> repeated(sites.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    for (std::size_t l = k; l-- > 0 && order[k].first - order[l].first <= same_site;) {
      const int i = order[k].second, j = order[l].second;
      if (std::abs(sites[i].point.y - sites[j].point.y) <= same_site)
        repeated[std::max(i, j)] = true;
    }
  std::vector<Site> out;
  out.reserve(sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i)
    if (!repeated[i]) out.push_back({planar(sites[i].point - origin), sites[i].first});
  return out;
}

// Without those that are nearest nowhere in the box, told by parts of it.
template <int parts>  // a side
void drop_far(std::vector<Site>& sites, const Box& box) {
  struct Part {
    Box box;
    double enough = infinite;  // square of the distance that is no farther from any place in it
  };
  std::array<Part, parts * parts> all;
  const double width = (box.max_x - box.min_x) / parts, height = (box.max_y - box.min_y) / parts;
  for (int i = 0; i < parts * parts; ++i) {
    const Point corner{box.min_x + width * (i % parts), box.min_y + height * (i / parts), 0};
    all[i].box = box_of(corner, corner + Point{width, height, 0});
    for (const Site& site : sites)
      all[i].enough = std::min(all[i].enough, all[i].box.farthest_square(site.point));
  }
  const auto far = [&](const Site& site) {
    return std::none_of(all.begin(), all.end(), [&](const Part& part) {
      return part.box.square_from(site.point) <= part.enough + same_place;
    });
  };
  sites.erase(std::remove_if(sites.begin(), sites.end(), far), sites.end());
}

// Ends of edges that meet come out of each edge a little different.
void join_ends(std::vector<std::pair<Point, Point>>& edges) {
  std::vector<Point*> ends;
  for (auto& [from, to] : edges) ends.insert(ends.end(), {&from, &to});
  std::sort(ends.begin(), ends.end(), [](const Point* p, const Point* q) { return p->x < q->x; });
  for (std::size_t k = 0; k < ends.size(); ++k)
    for (std::size_t l = k; l-- > 0 && ends[k]->x - ends[l]->x <= 2 * same_place;)
      if (std::abs(ends[k]->y - ends[l]->y) <= 2 * same_place) *ends[k] = *ends[l];
  edges.erase(std::remove_if(edges.begin(), edges.end(),
                             [](const auto& edge) {
                               return edge.first.x == edge.second.x &&
                                      edge.first.y == edge.second.y;
                             }),
              edges.end());
}

}  // namespace

// What two cells share: a stretch of the line of places equally far from both sites, told by metres
// along it.
class VoronoiBorder::Edge {
 public:
  Edge(const Point& p, const Point& q)
      : p_(p), middle_((q - p) * 0.5), along_(left_normal(unit(q - p))) {}

  // Takes off what is nearer to another site. Whether that is as near at an end then.
  bool leave_to(const Point& site) {
    const auto [slope, most] = limit(site);
    if (slope > 0) {
      if (most > (last_ + 2 * same_place) * slope) return false;
      last_ = std::min(last_, most / slope);
    } else if (slope < 0) {
      if (most > (first_ - 2 * same_place) * slope) return false;
      first_ = std::max(first_, most / slope);
    } else {
      if (most < 0) last_ = -infinite;
      return false;
    }
    return true;
  }
  // Whether a site is as near at one of its ends.
  bool ends_at(const Point& site) const {
    const auto [slope, most] = limit(site);
    return slope != 0 && std::abs(most / slope - (slope > 0 ? last_ : first_)) <= same_place;
  }
  // Takes off what lies outside.
  void clip(const Box& box) {
    const Point start = p_ + middle_;
    clip(along_.x, start.x, box.min_x, box.max_x);
    clip(along_.y, start.y, box.min_y, box.max_y);
  }
  double size() const { return last_ - first_; }
  std::pair<Point, Point> ends() const { return {place(first_), place(last_)}; }
  bool open() const { return first_ == -infinite || last_ == infinite; }
  // Holds each site that is as near to a place of it as its two are: about its ends.
  Box reach() const {
    Box box;
    for (const double at : {first_, last_}) {
      const Point end = place(at);
      box = box.joined_with(box_of(end, end).grown(distance(end, p_) + same_place));
    }
    return box;
  }

 private:
  struct Limit {
    double slope, most;  // places nearer to the two: slope * metres <= most
  };
  Limit limit(const Point& site) const {
    const Point away = site - p_;
    return {dot(along_, away), dot(away, away) / 2 - dot(middle_, away)};
  }
  void clip(double slope, double start, double least, double most) {
    if (slope == 0) return;
    const double low = ((slope > 0 ? least : most) - start) / slope;
    const double high = ((slope > 0 ? most : least) - start) / slope;
    first_ = std::max(first_, low);
    last_ = std::min(last_, high);
  }
  Point place(double at) const { return p_ + middle_ + along_ * at; }

  Point p_, middle_, along_;
  double first_ = -infinite, last_ = infinite;
};

VoronoiBorder::VoronoiBorder(const std::vector<Site>& sites, const Box& within)
    : within_{0, 0, within.max_x - within.min_x, within.max_y - within.min_y},
      origin_{within.min_x, within.min_y, 0},
      sites_(distinct_sites(sites, origin_)) {
  drop_far<1>(sites_, within_);
  drop_far<2>(sites_, within_);
  std::vector<Box> boxes;
  boxes.reserve(2 * sites_.size());
  for (const Site& site : sites_) boxes.push_back(box_of(site.point, site.point));
  index_ = BoxHierarchy(std::move(boxes));
}

double VoronoiBorder::square(int site, const Point& p) const {
  const Point away = sites_[site].point - p;
  return dot(away, away);
}

template <class Use>
void VoronoiBorder::each_in(const Box& box, Use use) const {
  index_.any_near(box, 0, [&](std::size_t i) {
    use(static_cast<int>(i));
    return false;
  });
}

int VoronoiBorder::nearest(const Point& p, int end) const {
  return index_.nearest(p, [&](int i) { return i < end ? square(i, p) : infinite; });
}

bool VoronoiBorder::first_owns(const Point& place) const {
  return sites_[nearest(place - origin_, size())].first;
}

VoronoiBorder::Edge VoronoiBorder::edge_between(int first, int second,
                                                std::vector<int>& neighbours) const {
  Edge edge(sites_[first].point, sites_[second].point);
  // Those beside the two in their rows leave little to the others.
  for (const int site : {first, second})
    for (int i = std::max(0, site - beside); i <= std::min(site + beside, size() - 1); ++i)
      if (i != first && i != second) edge.leave_to(sites_[i].point);
  neighbours.clear();
  if (edge.size() < -same_place) return edge;
  each_in(edge.open() ? everywhere : edge.reach(), [&](int i) {
    if (i != first && i != second && edge.leave_to(sites_[i].point)) neighbours.push_back(i);
  });
  neighbours.erase(std::remove_if(neighbours.begin(), neighbours.end(),
                                  [&](int i) { return !edge.ends_at(sites_[i].point); }),
                   neighbours.end());
  return edge;
}

// Lines that join all sites meet every line of the border, which has sites on both its sides: from
// each site to the one before, or where that is far to the nearest before.
std::vector<std::pair<int, int>> VoronoiBorder::some_pairs() const {
  std::vector<std::pair<int, int>> pairs;
  Point asked;
  double apart = 0;  // metres: no site of the other owner lies nearer to the place asked last
  for (int next = 1; next < size(); ++next) {
    poll_cancel();
    const Point& to = sites_[next].point;
    const bool goes_on = distance(sites_[next - 1].point, to) <= stride;
    const int before = goes_on ? next - 1 : nearest(to, next);
    const Point& from = sites_[before].point;
    const double size = distance(from, to);
    if (const bool owner = sites_[next].first; sites_[before].first == owner) {
      // No other owner's cell lies on the way if none of its sites is nearer than the way is long.
      const Point middle = (from + to) * 0.5;
      if (distance(middle, asked) + size < apart) continue;
      asked = middle;
      const int other = index_.nearest(
          middle, [&](int i) { return sites_[i].first != owner ? square(i, middle) : infinite; });
      apart = other < 0 ? infinite : distance(sites_[other].point, middle);
      if (apart > size) continue;
    }
    apart = 0;
    // The nearest site of each place on the way is no farther than the nearer end.
    const Box way = box_of(from, to).grown(size / 2 + same_place);
    for (int now = before; now != next;) {
      const Point& p = sites_[now].point;
      int then = next;
      double soonest = 1;
      each_in(way, [&](int i) {
        const Point away = sites_[i].point - p;
        const double slope = dot(to - from, away);
        if (slope <= 0) return;
        const double share = (dot(away, away) / 2 - dot(from - p, away)) / slope;
        if (share >= soonest) return;
        soonest = share;
        then = i;
      });
      if (sites_[now].first != sites_[then].first)
        pairs.emplace_back(sites_[now].first ? now : then, sites_[now].first ? then : now);
      now = then;
    }
  }
  return pairs;
}

// From edge to edge, by the sites at their ends.
std::vector<std::pair<Point, Point>> VoronoiBorder::border() const {
  std::vector<std::pair<Point, Point>> edges;
  std::vector<std::pair<int, int>> seen = some_pairs();
  std::sort(seen.begin(), seen.end());
  seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
  std::vector<std::pair<int, int>> open = seen;
  std::vector<int> neighbours;
  const Box shown = within_.grown(beyond);
  while (!open.empty()) {
    poll_cancel();
    const auto [first, second] = open.back();
    open.pop_back();
    Edge edge = edge_between(first, second, neighbours);
    if (edge.size() < -same_place) continue;
    for (const int site : neighbours) {
      const std::pair<int, int> pair =
          sites_[site].first ? std::pair(site, second) : std::pair(first, site);
      const auto at = std::lower_bound(seen.begin(), seen.end(), pair);
      if (at != seen.end() && *at == pair) continue;
      seen.insert(at, pair);
      open.push_back(pair);
    }
    edge.clip(shown);
    if (edge.size() > same_place) edges.push_back(edge.ends());
  }
  join_ends(edges);
  for (auto& [from, to] : edges) {
    from = origin_ + from;
    to = origin_ + to;
  }
  return edges;
}

}  // namespace streetgen
