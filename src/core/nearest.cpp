#include "nearest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double same_site = 1e-5;  // metres
constexpr double noise = 1e-6;      // metres
constexpr double beyond = 1;        // metres
constexpr double stride = 2;        // metres: sites in a row are no farther apart
constexpr std::size_t worth_an_index = 1024;
constexpr double infinite = std::numeric_limits<double>::infinity();

std::vector<Site> distinct_sites(const std::vector<Site>& sites, const Point& origin) {
  std::vector<int> order(sites.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return sites[i].point.x < sites[j].point.x; });
  std::vector<bool> repeated(sites.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    for (std::size_t l = k; l-- > 0;) {
      const Point &p = sites[order[k]].point, &q = sites[order[l]].point;
      if (p.x - q.x > same_site) break;
      if (std::abs(p.y - q.y) <= same_site) repeated[std::max(order[k], order[l])] = true;
    }
  std::vector<Site> out;
  for (std::size_t i = 0; i < sites.size(); ++i)
    if (!repeated[i]) out.push_back({planar(sites[i].point - origin), sites[i].first});
  return out;
}

// Without those that are nearest nowhere in the box.
void drop_far(std::vector<Site>& sites, const Box& box) {
  const auto square = [](double x, double y) { return x * x + y * y; };
  double enough = infinite;
  for (const Site& site : sites)
    enough = std::min(enough, square(std::max(site.point.x - box.min_x, box.max_x - site.point.x),
                                     std::max(site.point.y - box.min_y, box.max_y - site.point.y)));
  const auto far = [&](const Site& site) {
    return square(std::max({box.min_x - site.point.x, 0.0, site.point.x - box.max_x}),
                  std::max({box.min_y - site.point.y, 0.0, site.point.y - box.max_y})) >
           enough + noise;
  };
  sites.erase(std::remove_if(sites.begin(), sites.end(), far), sites.end());
}

// Ends of edges that meet come out of each edge a little different.
void join_ends(std::vector<std::pair<Point, Point>>& edges) {
  std::vector<Point*> ends;
  for (auto& [from, to] : edges) ends.insert(ends.end(), {&from, &to});
  std::sort(ends.begin(), ends.end(), [](const Point* p, const Point* q) { return p->x < q->x; });
  for (std::size_t k = 0; k < ends.size(); ++k)
    for (std::size_t l = k; l-- > 0 && ends[k]->x - ends[l]->x <= 2 * noise;)
      if (std::abs(ends[k]->y - ends[l]->y) <= 2 * noise) *ends[k] = *ends[l];
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
class NearestOwner::Edge {
 public:
  Edge(const Point& p, const Point& q)
      : p_(p), middle_((q - p) * 0.5), along_(left_normal(unit(q - p))) {}

  // Takes off what is nearer to another site.
  void leave_to(int site, const Point& at) {
    const Point away = at - p_;
    const double slope = dot(along_, away), most = dot(away, away) / 2 - dot(middle_, away);
    if (slope > 0)
      end(last_, -1, most / slope, site);
    else if (slope < 0)
      end(first_, 1, most / slope, site);
    else if (most < 0)
      last_.at = -infinite;
  }
  // Takes off what lies outside.
  void clip(const Box& box) {
    const Point start = p_ + middle_;
    clip(along_.x, start.x, box.min_x, box.max_x);
    clip(along_.y, start.y, box.min_y, box.max_y);
  }
  double size() const { return last_.at - first_.at; }
  std::pair<Point, Point> ends() const { return {place(first_.at), place(last_.at)}; }
  // The farthest that it comes from the two sites.
  double reach() const {
    return std::max(norm(middle_ + along_ * first_.at), norm(middle_ + along_ * last_.at));
  }
  // Sites that are as near at its ends.
  std::vector<int> neighbours() const {
    std::vector<int> sites;
    for (const End* end : {&first_, &last_})
      for (const auto& [at, site] : end->sites)
        if (std::abs(at - end->at) <= noise) sites.push_back(site);
    return sites;
  }

 private:
  struct End {
    double at;
    std::vector<std::pair<double, int>> sites{};
  };
  void end(End& end, int inwards, double at, int site) {
    const double ahead = (at - end.at) * inwards;
    if (ahead < -noise) return;
    if (ahead > noise) end.sites.clear();
    end.sites.emplace_back(at, site);
    if (ahead > 0) end.at = at;
  }
  void clip(double slope, double start, double least, double most) {
    if (slope == 0) return;
    const double low = ((slope > 0 ? least : most) - start) / slope;
    const double high = ((slope > 0 ? most : least) - start) / slope;
    first_.at = std::max(first_.at, low);
    last_.at = std::min(last_.at, high);
  }
  Point place(double at) const { return p_ + middle_ + along_ * at; }

  Point p_, middle_, along_;
  End first_{-infinite}, last_{infinite};
};

NearestOwner::NearestOwner(const std::vector<Site>& sites, const Box& within)
    : within_{0, 0, within.max_x - within.min_x, within.max_y - within.min_y},
      origin_{within.min_x, within.min_y, 0},
      sites_(distinct_sites(sites, origin_)) {
  drop_far(sites_, within_);
  if (sites_.size() < worth_an_index) return;
  std::vector<Box> boxes;
  for (const Site& site : sites_) boxes.push_back(box_of(site.point, site.point));
  index_.emplace(boxes);
}

double NearestOwner::square(int site, const Point& p) const {
  const Point away = sites_[site].point - p;
  return dot(away, away);
}

template <class Use>
void NearestOwner::each_near(const Point& p, double reach, Use use) const {
  if (index_)
    for (const int i : index_->near(box_of(p, p), reach)) use(i);
  else
    for (int i = 0; i < size(); ++i) use(i);
}

int NearestOwner::nearest(const Point& p, int end) const {
  for (double reach = 8;; reach *= 2) {
    int best = -1;
    double least = index_ ? reach * reach : infinite;
    each_near(p, reach, [&](int i) {
      const double apart = square(i, p);
      if (i >= end || apart >= least) return;
      best = i;
      least = apart;
    });
    if (best >= 0) return best;
  }
}

bool NearestOwner::first_owns(const Point& place) const {
  return sites_[nearest(place - origin_, size())].first;
}

NearestOwner::Edge NearestOwner::edge_between(int first, int second) const {
  const Point &p = sites_[first].point, &q = sites_[second].point;
  for (double reach = std::max(8.0, 2 * distance(p, q));; reach *= 2) {
    Edge edge(p, q);
    std::size_t asked = 0;
    each_near(p, reach, [&](int i) {
      ++asked;
      if (i != first && i != second) edge.leave_to(i, sites_[i].point);
    });
    // A site that is nearer to a place of the edge lies within twice its reach.
    if (asked == sites_.size() || 2 * edge.reach() <= reach) return edge;
  }
}

// Lines that join all sites meet every line of the border, which has sites on both its sides: from
// each site to the one before, or where that is far to the nearest before.
std::vector<std::pair<int, int>> NearestOwner::some_pairs() const {
  std::vector<std::pair<int, int>> pairs;
  Point asked;
  double apart = 0;  // metres: no site of the other owner lies nearer to the place asked last
  for (int next = 1; next < size(); ++next) {
    const Point& to = sites_[next].point;
    const bool goes_on = distance(sites_[next - 1].point, to) <= stride;
    const int before = goes_on ? next - 1 : nearest(to, next);
    const Point& from = sites_[before].point;
    const double size = distance(from, to);
    const Point middle = (from + to) * 0.5;
    const bool owner = sites_[next].first;
    if (sites_[before].first == owner) {
      // No other owner's cell lies on the way if none of its sites is nearer than the way is long.
      if (distance(middle, asked) + size < apart) continue;
      asked = middle;
      const double reach = std::max(16.0, 2 * size);
      double least = reach * reach;
      each_near(middle, reach, [&](int i) {
        if (sites_[i].first != owner) least = std::min(least, square(i, middle));
      });
      apart = std::sqrt(least);
      if (apart > size) continue;
    }
    apart = 0;
    double at = 0;
    for (int now = before; now != next;) {
      const Point& p = sites_[now].point;
      int then = next;
      double soonest = 1;
      each_near(from + (to - from) * at, 2 * size, [&](int i) {
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
      at = soonest;
    }
  }
  return pairs;
}

// From edge to edge, by the sites at their ends.
std::vector<std::pair<Point, Point>> NearestOwner::border() const {
  std::vector<std::pair<Point, Point>> edges;
  const auto started = some_pairs();
  std::set<std::pair<int, int>> seen(started.begin(), started.end());
  std::vector<std::pair<int, int>> open(seen.begin(), seen.end());
  const Box shown = within_.grown(beyond);
  while (!open.empty()) {
    poll_cancel();
    const auto [first, second] = open.back();
    open.pop_back();
    Edge edge = edge_between(first, second);
    if (edge.size() < -noise) continue;
    for (const int site : edge.neighbours()) {
      const std::pair<int, int> pair =
          sites_[site].first ? std::pair(site, second) : std::pair(first, site);
      if (seen.insert(pair).second) open.push_back(pair);
    }
    edge.clip(shown);
    if (edge.size() > noise) edges.push_back(edge.ends());
  }
  join_ends(edges);
  for (auto& [from, to] : edges) {
    from = origin_ + from;
    to = origin_ + to;
  }
  return edges;
}

}  // namespace streetgen
