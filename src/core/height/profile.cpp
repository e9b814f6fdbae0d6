#include "streetgen/profile.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>

#include "geometry/tolerance.hpp"
#include "height/joint_profile.hpp"
#include "streetgen/cancel.hpp"
#include "support/disjoint_sets.hpp"

namespace streetgen {

namespace {

// Crossings join edges to clusters, and nodes off the ground tie clusters, until the ground lies
// between them: then what one holds moves no other one, whatever else is solved in the same call.
class Clusters {
 public:
  Clusters(const std::vector<ProfileEdge>& edges, const std::vector<ProfileLift>& lifts,
           const std::vector<ProfileHeight>& by_hand, const ProfileRules& rules)
      : edges_(edges),
        lifts_(lifts),
        by_hand_(by_hand),
        rules_(rules),
        groups_(static_cast<int>(edges.size())) {
    for (int e = 0; e < groups_.size(); ++e) {
      meet(edges[e].from_node, edges[e].line.front().z, e);
      meet(edges[e].to_node, edges[e].line.back().z, e);
    }
    // Bridges that lead each other on are solved together, wherever they lie.
    for (int e = 0; e < groups_.size(); ++e) {
      if (edges[e].rise == 0) continue;
      if (!edges[e].ends_from) tie(edges[e].from_node);
      if (!edges[e].ends_to) tie(edges[e].to_node);
    }
    for (const ProfileLift& lift : lifts) groups_.join(lift.above, lift.below);
    out_.edges.resize(edges.size());
    out_.unmet.resize(lifts.size());
  }

  Profiles solve() {
    // What hangs together shows in rough heights, but for few edges.
    for (const Rounds rounds : {Rounds::rough, Rounds::all}) {
      is_fresh_.assign(edges_.size(), true);
      do {
        for (const auto& [group, cluster] : fresh_clusters()) {
          poll_cancel();
          solve(cluster, rounds);
        }
      } while (join_off_ground());
    }
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      out_.edges[e].tied_from = nodes_.at(edges_[e].from_node).tied;
      out_.edges[e].tied_to = nodes_.at(edges_[e].to_node).tied;
    }
    return std::move(out_);
  }

 private:
  struct Node {
    double ground;  // the greatest of its edges
    std::vector<int> edges;
    bool tied = false;
  };

  // Numbers of edges, lifts and heights by hand, each in the order of all.
  struct Cluster {
    std::vector<int> edges, lifts, by_hand;
  };

  void meet(std::int64_t node, double ground, int edge) {
    Node& met = nodes_.try_emplace(node, Node{ground, {}, false}).first->second;
    met.ground = std::max(met.ground, ground);
    met.edges.push_back(edge);
  }

  void tie(std::int64_t node) {
    Node& tied = nodes_.at(node);
    tied.tied = true;
    for (const int e : tied.edges) groups_.join(e, tied.edges.front());
  }

  std::map<int, Cluster> fresh_clusters() {
    std::map<int, Cluster> fresh;
    const auto add = [&](int edge, int number, std::vector<int> Cluster::*numbers) {
      if (is_fresh_[edge]) (fresh[groups_.of(edge)].*numbers).push_back(number);
    };
    for (std::size_t e = 0; e < edges_.size(); ++e)
      add(static_cast<int>(e), static_cast<int>(e), &Cluster::edges);
    for (std::size_t l = 0; l < lifts_.size(); ++l)
      add(lifts_[l].above, static_cast<int>(l), &Cluster::lifts);
    for (std::size_t h = 0; h < by_hand_.size(); ++h)
      add(by_hand_[h].edge, static_cast<int>(h), &Cluster::by_hand);
    return fresh;
  }

  void solve(const Cluster& cluster, Rounds rounds) {
    std::vector<ProfileEdge> edges;
    std::unordered_map<int, int> place;
    for (const int e : cluster.edges) {
      place[e] = static_cast<int>(edges.size());
      edges.push_back(edges_[e]);
    }
    std::vector<ProfileLift> lifts;
    for (const int l : cluster.lifts) {
      lifts.push_back(lifts_[l]);
      lifts.back().above = place.at(lifts_[l].above);
      lifts.back().below = place.at(lifts_[l].below);
    }
    std::vector<ProfileHeight> by_hand;
    for (const int h : cluster.by_hand) {
      by_hand.push_back(by_hand_[h]);
      by_hand.back().edge = place.at(by_hand_[h].edge);
    }
    Profiles solved = joint_profiles(edges, lifts, by_hand, rules_, rounds);
    for (std::size_t i = 0; i < edges.size(); ++i)
      out_.edges[cluster.edges[i]] = std::move(solved.edges[i]);
    for (std::size_t i = 0; i < lifts.size(); ++i) out_.unmet[cluster.lifts[i]] = solved.unmet[i];
  }

  // Whether any cluster grew: the edges of those are fresh.
  bool join_off_ground() {
    std::vector<int> joined;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const Line& road = out_.edges[e].line;
      join_at(&nodes_.at(edges_[e].from_node), road.front().z, &joined);
      join_at(&nodes_.at(edges_[e].to_node), road.back().z, &joined);
    }
    std::vector<bool> has_grown(edges_.size());
    for (const int e : joined) has_grown[groups_.of(e)] = true;
    for (std::size_t e = 0; e < edges_.size(); ++e)
      is_fresh_[e] = has_grown[groups_.of(static_cast<int>(e))];
    return !joined.empty();
  }

  void join_at(Node* node, double height, std::vector<int>* joined) {
    if (node->tied || std::abs(height - node->ground) <= same_place) return;
    node->tied = true;
    for (const int e : node->edges)
      if (groups_.of(e) != groups_.of(node->edges.front())) {
        groups_.join(e, node->edges.front());
        joined->push_back(e);
      }
  }

  const std::vector<ProfileEdge>& edges_;
  const std::vector<ProfileLift>& lifts_;
  const std::vector<ProfileHeight>& by_hand_;
  const ProfileRules& rules_;
  Groups groups_;  // of edges, a group for each cluster
  std::unordered_map<std::int64_t, Node> nodes_;
  std::vector<bool> is_fresh_;  // edges of clusters that grew since they were solved
  Profiles out_;
};

}  // namespace

Profiles profiles(const std::vector<ProfileEdge>& edges, const std::vector<ProfileLift>& lifts,
                  const std::vector<ProfileHeight>& by_hand, const ProfileRules& rules) {
  return Clusters(edges, lifts, by_hand, rules).solve();
}

}  // namespace streetgen
