// Networks of links: all pairs, the worst removed first.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "streetgen/road_network.hpp"
#include "terrain/link_graph.hpp"

namespace streetgen {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::size_t most_towns = 1000;

using Pair = std::pair<std::size_t, std::size_t>;
Pair pair_of(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

// A link that may go, and the shortest way without it.
struct Candidate {
  TownLink link;
  double alternative = infinite;
  std::vector<Pair> way;
  double worth() const { return link.benefit - link.cost; }
};

class NetworkBuilder {
 public:
  NetworkBuilder(const std::vector<Town>& towns, const NetworkWish& wish)
      : towns_(towns), wish_(wish), graph_(towns.size()) {
    for (const auto& [a, b] : wish.rejected) taken_.insert(pair_of(a, b));
  }

  void add(RoadNetwork network) {
    for (TownLink link : wish_.by_hand)
      if (link.network == network) keep(measured(link.a, link.b, network, true));
    const int lowest = static_cast<int>(network);
    std::vector<Candidate> candidates;
    for (std::size_t a = 0; a < towns_.size(); ++a)
      for (std::size_t b = a + 1; b < towns_.size(); ++b) {
        const int kind_a = static_cast<int>(towns_[a].kind),
                  kind_b = static_cast<int>(towns_[b].kind);
        if (std::max(kind_a, kind_b) != lowest || taken_.count({a, b}) > 0) continue;
        candidates.push_back({measured(a, b, network, false), infinite, {}});
        graph_.put(a, b, candidates.back().link.length);
      }
    for (Candidate& candidate : candidates) find_alternative(candidate);
    remove_worst(candidates);
    for (const Candidate& candidate : candidates) keep(candidate.link);
  }

  std::vector<TownLink> take() { return std::move(links_); }

 private:
  TownLink measured(std::size_t a, std::size_t b, RoadNetwork network, bool by_hand) const {
    TownLink link{a, b, network, 0, 0, 0, 0, by_hand};
    link.length = link.cost = distance(planar(towns_[a].point), planar(towns_[b].point)) / 1000;
    link.utilisation =
        towns_[a].importance * towns_[b].importance / 1e6 / link.length / link.length;
    link.benefit = infinite;
    return link;
  }

  void keep(const TownLink& link) {
    links_.push_back(link);
    taken_.insert(pair_of(link.a, link.b));
    graph_.put(link.a, link.b, link.length);
  }

  void find_alternative(Candidate& candidate) {
    TownLink& link = candidate.link;
    graph_.remove(link.a, link.b);
    const LinkGraph::Ways ways = graph_.ways(link.a, link.b);
    graph_.put(link.a, link.b, link.length);
    candidate.alternative = ways.length[link.b];
    candidate.way.clear();
    if (candidate.alternative < infinite)
      for (std::size_t at = link.b; at != link.a; at = ways.before[at])
        candidate.way.push_back(pair_of(at, ways.before[at]));
    settle_benefit(candidate);
  }

  void settle_benefit(Candidate& candidate) const {
    TownLink& link = candidate.link;
    link.benefit = candidate.alternative == infinite
                       ? infinite
                       : wish_.factor * link.utilisation * (candidate.alternative - link.length);
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
        const double straight =
            distance(planar(towns_[from].point), planar(towns_[to].point)) / 1000;
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

  void remove_worst(std::vector<Candidate>& candidates) {
    const bool shared = wish_.benefit == LinkBenefit::of_network;
    while (!candidates.empty()) {
      poll_cancel();
      if (shared) share_trips(candidates);
      const auto worst = std::min_element(
          candidates.begin(), candidates.end(),
          [](const Candidate& p, const Candidate& q) { return p.worth() < q.worth(); });
      if (!(worst->worth() < 0)) break;
      const Pair gone = pair_of(worst->link.a, worst->link.b);
      graph_.remove(gone.first, gone.second);
      candidates.erase(worst);
      for (Candidate& candidate : candidates)
        if (std::find(candidate.way.begin(), candidate.way.end(), gone) != candidate.way.end())
          find_alternative(candidate);
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

std::vector<LinkCrossing> link_crossings(const std::vector<Town>& towns,
                                         const std::vector<TownLink>& links) {
  std::vector<LinkCrossing> found;
  for (std::size_t i = 0; i < links.size(); ++i)
    for (std::size_t k = i + 1; k < links.size(); ++k) {
      const TownLink &p = links[i], &q = links[k];
      if (p.network != q.network || p.a == q.a || p.a == q.b || p.b == q.a || p.b == q.b) continue;
      const auto place = crossing(planar(towns[p.a].point), planar(towns[p.b].point),
                                  planar(towns[q.a].point), planar(towns[q.b].point));
      if (place) found.push_back({*place, i, k});
    }
  return found;
}

}  // namespace streetgen
