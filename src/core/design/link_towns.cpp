// Networks of links: all pairs, the worst removed first.
#include <algorithm>
#include <cmath>
#include <queue>
#include <set>
#include <string>
#include <tuple>

#include "design/link_graph.hpp"
#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "streetgen/road_network.hpp"
#include "support/infinite.hpp"

namespace streetgen {
namespace {

constexpr std::size_t most_towns = 1000;

using Pair = std::pair<std::size_t, std::size_t>;
Pair pair_of(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

// A link that may go, and the shortest way without it.
struct Candidate {
  TownLink link;
  TownWay way;
  double worth() const { return link.benefit - link.cost; }
};

// A candidate in the queue of those to go: no link is worth less than it was known to be, since
// the ways beside it get longer as links go.
struct Queued {
  double worth;
  std::size_t candidate;
  bool operator<(const Queued& other) const {
    return std::tie(worth, candidate) > std::tie(other.worth, other.candidate);
  }
};

std::vector<Point> places_of(const std::vector<Town>& towns) {
  std::vector<Point> places;
  for (const Town& town : towns) places.push_back(planar(town.point) * 1e-3);
  return places;
}

class NetworkBuilder {
 public:
  NetworkBuilder(const std::vector<Town>& towns, const NetworkWish& wish)
      : towns_(towns), wish_(wish), graph_(places_of(towns)) {
    for (const auto& [a, b] : wish.rejected) taken_.insert(pair_of(a, b));
  }

  void add(RoadNetwork network) {
    for (TownLink link : wish_.by_hand)
      if (link.network == network) keep(measured(link.a, link.b, network, true));
    const int lowest = static_cast<int>(network);
    std::vector<Candidate> candidates;
    for (std::size_t a = 0; a < towns_.size(); ++a) {
      poll_cancel();
      for (std::size_t b = a + 1; b < towns_.size(); ++b) {
        const int kind_a = static_cast<int>(towns_[a].kind),
                  kind_b = static_cast<int>(towns_[b].kind);
        if (std::max(kind_a, kind_b) != lowest || taken_.count({a, b}) > 0) continue;
        candidates.push_back({measured(a, b, network, false), {}});
        graph_.put(a, b);
      }
    }
    if (wish_.benefit == LinkBenefit::of_network)
      remove_worst_shared(candidates);
    else
      remove_worst(candidates);
    for (const Candidate& candidate : candidates) keep(candidate.link);
  }

  std::vector<TownLink> take() { return std::move(links_); }

 private:
  TownLink measured(std::size_t a, std::size_t b, RoadNetwork network, bool by_hand) const {
    TownLink link{a, b, network, 0, 0, 0, 0, by_hand};
    link.length = link.cost = graph_.length(a, b);
    link.utilisation =
        towns_[a].importance * towns_[b].importance / 1e6 / link.length / link.length;
    link.benefit = infinite;
    return link;
  }

  void keep(const TownLink& link) {
    links_.push_back(link);
    taken_.insert(pair_of(link.a, link.b));
    graph_.put(link.a, link.b);
  }

  void find_way(Candidate& candidate) {
    const TownLink& link = candidate.link;
    const double least = candidate.way.towns.empty() ? link.length : candidate.way.length;
    candidate.way = graph_.way_beside(link.a, link.b, least);
    settle_benefit(candidate);
  }

  void settle_benefit(Candidate& candidate) const {
    TownLink& link = candidate.link;
    link.benefit = candidate.way.length == infinite
                       ? infinite
                       : wish_.factor * link.utilisation * (candidate.way.length - link.length);
  }

  // Whether all links of the way that was found are still there.
  bool way_stands(const Candidate& candidate) const {
    const std::vector<std::size_t>& towns = candidate.way.towns;
    for (std::size_t i = 1; i < towns.size(); ++i)
      if (!graph_.has(towns[i - 1], towns[i])) return false;
    return !towns.empty();
  }

  // The worst goes first. A link is looked at when it may be the worst, and one that is worth its
  // cost stays so.
  void remove_worst(std::vector<Candidate>& candidates) {
    std::vector<bool> gone(candidates.size(), false);
    std::vector<Queued> entries;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const TownLink& link = candidates[i].link;
      // No benefit, less what rounding may take of it.
      entries.push_back({-link.cost - wish_.factor * link.utilisation * link.length * 1e-12, i});
    }
    std::priority_queue<Queued> queue(std::less<Queued>(), std::move(entries));
    while (!queue.empty()) {
      poll_cancel();
      const std::size_t i = queue.top().candidate;
      queue.pop();
      Candidate& worst = candidates[i];
      if (way_stands(worst)) {
        graph_.remove(worst.link.a, worst.link.b);
        gone[i] = true;
        continue;
      }
      find_way(worst);
      if (worst.worth() < 0) queue.push({worst.worth(), i});
    }
    std::vector<Candidate> left;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (gone[i]) continue;
      // A link is worth what it spares among those that stay.
      if (!way_stands(candidates[i])) find_way(candidates[i]);
      left.push_back(std::move(candidates[i]));
    }
    candidates = std::move(left);
  }

  // Trips of all pairs of towns go the shortest way, and count on each link of it.
  void share_trips(std::vector<Candidate>& candidates) {
    const std::size_t n = towns_.size();
    std::vector<double> trips(n * n, 0);
    for (std::size_t from = 0; from < n; ++from) {
      if (towns_[from].importance <= 0) continue;
      poll_cancel();
      const LinkGraph::Ways ways = graph_.ways(from);
      for (std::size_t to = from + 1; to < n; ++to) {
        if (towns_[to].importance <= 0 || ways.length[to] == infinite) continue;
        const double straight = graph_.length(from, to);
        const double both =
            towns_[from].importance * towns_[to].importance / 1e6 / straight / straight;
        for (std::size_t at = to; at != from; at = ways.before[at]) {
          const Pair pair = pair_of(at, ways.before[at]);
          trips[pair.first * n + pair.second] += both;
        }
      }
    }
    for (Candidate& candidate : candidates) {
      candidate.link.utilisation = trips[candidate.link.a * n + candidate.link.b];
      settle_benefit(candidate);
    }
  }

  // Trips move to other links as links go, so that all are known anew each time.
  void remove_worst_shared(std::vector<Candidate>& candidates) {
    for (;;) {
      for (Candidate& candidate : candidates)
        if (!way_stands(candidate)) find_way(candidate);
      share_trips(candidates);
      const auto worst = std::min_element(
          candidates.begin(), candidates.end(),
          [](const Candidate& p, const Candidate& q) { return p.worth() < q.worth(); });
      if (worst == candidates.end() || !(worst->worth() < 0)) break;
      graph_.remove(worst->link.a, worst->link.b);
      candidates.erase(worst);
    }
  }

  const std::vector<Town>& towns_;
  const NetworkWish& wish_;
  LinkGraph graph_;
  std::set<Pair> taken_;  // linked already, or rejected
  std::vector<TownLink> links_;
};

void check_towns(const std::vector<Town>& towns) {
  if (towns.size() > most_towns)
    throw Error(ErrorKind::invalid_input,
                std::to_string(towns.size()) + " nodes are to be linked, the most is " +
                    std::to_string(most_towns),
                "Design parts of the country one by one, or leave villages out.");
  for (std::size_t i = 0; i < towns.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (distance(planar(towns[i].point), planar(towns[k].point)) < 1)
        throw Error(ErrorKind::invalid_input,
                    "nodes " + std::to_string(k + 1) + " and " + std::to_string(i + 1) +
                        " lie at one place",
                    "Delete one of both, or move it by a metre and more.");
}

}  // namespace

std::vector<TownLink> link_towns(const std::vector<Town>& towns, const NetworkWish& wish) {
  check_towns(towns);
  NetworkBuilder builder(towns, wish);
  for (RoadNetwork network : {RoadNetwork::highway, RoadNetwork::secondary, RoadNetwork::rural})
    builder.add(network);
  return builder.take();
}

std::vector<TownLinkCrossing> link_crossings(const std::vector<Town>& towns,
                                         const std::vector<TownLink>& links) {
  std::vector<Box> boxes(links.size());
  for (std::size_t i = 0; i < links.size(); ++i)
    for (std::size_t end : {links[i].a, links[i].b}) boxes[i].add(planar(towns[end].point));
  const BoxIndex index(boxes);
  std::vector<TownLinkCrossing> found;
  for (std::size_t i = 0; i < links.size(); ++i) {
    poll_cancel();
    for (const int near : index.near(boxes[i], 0)) {
      const std::size_t k = static_cast<std::size_t>(near);
      const TownLink &p = links[i], &q = links[k];
      if (k <= i || p.network != q.network || p.a == q.a || p.a == q.b || p.b == q.a || p.b == q.b)
        continue;
      const auto place = crossing(planar(towns[p.a].point), planar(towns[p.b].point),
                                  planar(towns[q.a].point), planar(towns[q.b].point));
      if (place) found.push_back({*place, i, k});
    }
  }
  return found;
}

}  // namespace streetgen
