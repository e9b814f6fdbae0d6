#include "ownership/ownership.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>
#include <unordered_map>

#include "geometry/arrangement.hpp"
#include "geometry/border_stretches.hpp"
#include "geometry/crumb.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/tolerance.hpp"
#include "ownership/dispute.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/progress.hpp"

namespace streetgen {

namespace {

std::vector<std::pair<int, int>> overlapping_boxes(const std::vector<Claim>& claims,
                                                   const std::vector<PreparedSurface>& grounds) {
  std::vector<Box> boxes(claims.size());
  std::vector<int> order;
  for (std::size_t i = 0; i < claims.size(); ++i) {
    if (claims[i].surface->empty()) continue;
    boxes[i] = grounds[i].box();
    order.push_back(static_cast<int>(i));
  }
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return boxes[i].min_x < boxes[j].min_x; });
  std::vector<std::pair<int, int>> pairs;
  std::vector<std::pair<Box, int>> active;
  for (const int i : order) {
    for (std::size_t k = 0; k < active.size();) {
      const auto& [box, j] = active[k];
      if (box.max_x < boxes[i].min_x) {
        active[k] = active.back();
        active.pop_back();
        continue;
      }
      if (box.meets(boxes[i], -1e-6) && tile(claims[i], claims[j]))
        pairs.emplace_back(std::min(i, j), std::max(i, j));
      ++k;
    }
    active.emplace_back(boxes[i], i);
    poll_cancel();
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

constexpr std::size_t few_parties = 5;  // whose duels are all looked at

// Who owns what, of claims whose ground comes in unsettled.
class Settlement {
 public:
  Settlement(Geos& geos, const std::vector<Claim>& claims,
             const std::vector<std::pair<int, int>>& disputes)
      : geos_(geos),
        claims_(claims),
        disputes_(disputes),
        judged_(disputes.size()),
        first_(claims.size() + 1),
        opponents_(streetgen::opponents(claims, disputes)) {
    grounds_.reserve(claims.size());
    for (const Claim& claim : claims) grounds_.emplace_back(*claim.surface);
    for (std::size_t i = 0; i < claims.size(); ++i)
      if (claims[i].whole != nullptr) wholes_.emplace(i, *claims[i].whole);
    for (const auto& [i, j] : disputes) ++first_[i + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }

  bool disputed(int claim) const { return !opponents_[claim].empty(); }

  // The claim's ground, its opponents' and the borders against them make faces, each of which has
  // one owner: the same faces whatever else is settled.
  MultiPolygon ground_of(int claim) {
    poll_cancel();
    const MultiPolygon& surface = *claims_[claim].surface;
    const PreparedSurface& ground = grounds_[claim];
    std::vector<LineView> lines;
    append_rings(surface, lines);
    const auto near = [&](const Point& from, const Point& to) {
      poll_cancel();
      return ground.comes_near(from, to);
    };
    for (const int other : opponents_[claim])
      append_stretches(*claims_[other].surface, near, lines);
    const auto append_border = [&](std::size_t dispute) {
      for (const Line& line : dispute_of(dispute).border())
        if (near(line.front(), line.back())) lines.push_back(line);
    };
    const bool levels_meet =
        std::any_of(opponents_[claim].begin(), opponents_[claim].end(),
                    [&](int other) { return claims_[other].level != claims_[claim].level; });
    std::vector<int> all = opponents_[claim];
    all.insert(std::lower_bound(all.begin(), all.end(), claim), claim);
    each_dispute(all, [&](std::size_t dispute) {
      if (levels_meet || is_party(claim, dispute)) append_border(dispute);
    });
    std::optional<Arrangement> faces(lines);
    std::vector<Contest> contests = contests_in(claim, *faces);
    // Where lost ground may come back, it depends on the borders between opponents too.
    std::set<std::size_t> further;
    for (const Contest& contest : contests) {
      if (levels_meet) break;
      if (!contest.beaten(claim) || !(contest.won(claim) || contest.undecided())) continue;
      each_dispute(contest.parties, [&](std::size_t dispute) {
        if (!is_party(claim, dispute)) further.insert(dispute);
      });
    }
    const std::size_t before = lines.size();
    for (const std::size_t dispute : further) append_border(dispute);
    if (lines.size() > before) {
      faces.emplace(lines);
      contests = contests_in(claim, *faces);
    }
    std::vector<bool> kept;
    bool lost = false;
    kept.reserve(contests.size());
    for (Contest& contest : contests) {
      const bool held = !contest.parties.empty();
      kept.push_back(held && owns(claim, std::move(contest)));
      lost = lost || (held && !kept.back());
    }
    if (!lost) return surface;
    MultiPolygon rest = without_crumbs(faces->joined(kept));
    if (!geos_.valid(rest))
      return without_crumbs(faces->joined(kept, Arrangement::Vertices::on_grid));
    return rest;
  }

 private:
  bool is_party(int claim, std::size_t dispute) const {
    return disputes_[dispute].first == claim || disputes_[dispute].second == claim;
  }

  // The disputes between these, ascending as they are.
  template <class Use>
  void each_dispute(const std::vector<int>& parties, Use use) {
    for (auto i = parties.begin(); i != parties.end(); ++i)
      for (std::size_t d = first_[*i]; d < first_[*i + 1]; ++d)
        if (std::binary_search(i, parties.end(), disputes_[d].second)) use(d);
  }

  const Dispute& dispute_of(std::size_t dispute) {
    auto& slot = judged_[dispute];
    const auto [i, j] = disputes_[dispute];
    if (!slot) slot.emplace(Disputant{&claims_[i], &whole(i)}, Disputant{&claims_[j], &whole(j)});
    return *slot;
  }

  // A dispute is the same wherever crowds took of the two.
  const PreparedSurface& whole(int claim) const {
    const auto found = wholes_.find(claim);
    return found == wholes_.end() ? grounds_[claim] : found->second;
  }

  struct Duel {
    int winner, loser;
    bool crossed;
  };

  // Those that hold a place, ascending, and how they fare there against each other.
  struct Contest {
    std::vector<int> parties;
    std::vector<Duel> duels;

    bool beaten(int claim) const {
      return std::any_of(duels.begin(), duels.end(),
                         [&](const Duel& d) { return d.loser == claim; });
    }
    bool won(int claim) const {
      return std::any_of(duels.begin(), duels.end(),
                         [&](const Duel& d) { return d.crossed && d.winner == claim; });
    }
    bool undecided() const {
      return std::all_of(parties.begin(), parties.end(), [&](int party) { return beaten(party); });
    }
    // Of those that each lose to another: the ones that nobody beats but whom they beat in turn, by
    // way of others.
    std::vector<int> circle() const {
      const std::size_t count = parties.size();
      const auto at = [&](int party) {
        return std::lower_bound(parties.begin(), parties.end(), party) - parties.begin();
      };
      std::vector<std::vector<bool>> beats(count, std::vector<bool>(count));
      for (const Duel& d : duels) beats[at(d.winner)][at(d.loser)] = true;
      for (std::size_t by_way_of = 0; by_way_of < count; ++by_way_of)
        for (std::size_t i = 0; i < count; ++i)
          for (std::size_t j = 0; beats[i][by_way_of] && j < count; ++j)
            if (beats[by_way_of][j]) beats[i][j] = true;
      std::vector<int> first;
      for (std::size_t i = 0; i < count; ++i) {
        bool beaten = false;
        for (std::size_t j = 0; j < count; ++j) beaten = beaten || (beats[j][i] && !beats[i][j]);
        if (!beaten) first.push_back(parties[i]);
      }
      return first;
    }
    void leave(int claim) {
      parties.erase(std::find(parties.begin(), parties.end(), claim));
      duels.erase(
          std::remove_if(duels.begin(), duels.end(),
                         [&](const Duel& d) { return d.winner == claim || d.loser == claim; }),
          duels.end());
    }
  };

  // By face; of those off its ground an empty one.
  std::vector<Contest> contests_in(int claim, const Arrangement& faces) {
    const PreparedSurface& ground = grounds_[claim];
    std::vector<Contest> contests;
    contests.reserve(faces.places().size());
    for (const Point& place : faces.places()) {
      poll_cancel();
      contests.push_back(ground.holds(place) ? contest_at(claim, place) : Contest{});
    }
    return contests;
  }

  Contest contest_at(int claim, const Point& place) {
    Contest contest;
    contest.parties.reserve(opponents_[claim].size() + 1);
    contest.parties.push_back(claim);
    for (const int other : opponents_[claim])
      if (grounds_[other].holds(place)) contest.parties.push_back(other);
    std::sort(contest.parties.begin(), contest.parties.end());
    if (settled_by_champion(claim, place, contest)) return contest;
    contest.duels.clear();
    each_dispute(contest.parties,
                 [&](std::size_t dispute) { contest.duels.push_back(duel(dispute, place)); });
    return contest;
  }

  Duel duel(std::size_t dispute, const Point& place) {
    const Dispute& between = dispute_of(dispute);
    const auto [i, j] = disputes_[dispute];
    const bool first = between.first_owns(place);
    return {first ? i : j, first ? j : i, between.crossed()};
  }

  std::optional<Duel> duel(int i, int j, const Point& place) {
    const std::pair<int, int> pair(std::min(i, j), std::max(i, j));
    const auto end = disputes_.begin() + first_[pair.first + 1];
    const auto found = std::lower_bound(disputes_.begin() + first_[pair.first], end, pair);
    if (found == end || *found != pair) return std::nullopt;
    return duel(found - disputes_.begin(), place);
  }

  // One that beats all others leaves nothing to tell but how the claim fares: a few duels of each
  // instead of all.
  bool settled_by_champion(int claim, const Point& place, Contest& contest) {
    const auto& parties = contest.parties;
    if (parties.size() < few_parties) return false;
    int champion = parties.front();
    for (const int party : parties) {
      if (party == champion) continue;
      const auto met = duel(champion, party, place);
      if (!met) return false;
      champion = met->winner;
    }
    for (const int one : {champion, claim}) {
      for (const int party : parties) {
        if (party == one || (one == claim && party == champion)) continue;
        const auto met = duel(one, party, place);
        if (!met && one == champion) return false;
        if (met && one == champion && met->loser == one) return false;
        if (met) contest.duels.push_back(*met);
      }
      if (claim == champion) break;
    }
    return true;
  }

  // Who loses to nobody owns the place, and those that it beats leave. A crossing goes by rank, all
  // else by distance, where axes drawn one on the other are as near but for noise: of a circle of
  // losers the first winner of a crossing owns it, or the first.
  bool owns(int claim, Contest contest) const {
    while (contest.beaten(claim)) {
      const auto& parties = contest.parties;
      const auto unbeaten = std::find_if(parties.begin(), parties.end(),
                                         [&](int party) { return !contest.beaten(party); });
      const int owner = unbeaten != parties.end() ? *unbeaten : first_of(contest);
      if (owner == claim) return true;
      for (const Duel& d : std::vector<Duel>(contest.duels)) {
        if (d.winner != owner && d.loser != owner) continue;
        const int other = d.winner == owner ? d.loser : d.winner;
        if (other == claim) return false;
        contest.leave(other);
      }
      contest.leave(owner);
    }
    return true;
  }

  int first_of(const Contest& contest) const {
    const std::vector<int> circle = contest.circle();
    return *std::min_element(circle.begin(), circle.end(), [&](int i, int j) {
      return contest.won(i) != contest.won(j) ? contest.won(i) : before(claims_[i], claims_[j]);
    });
  }

  Geos& geos_;
  const std::vector<Claim>& claims_;
  const std::vector<std::pair<int, int>>& disputes_;
  std::vector<std::optional<Dispute>> judged_;  // by dispute
  std::vector<std::size_t> first_;              // dispute of each claim as the first of a pair
  std::vector<std::vector<int>> opponents_;     // by claim
  std::vector<PreparedSurface> grounds_;
  std::unordered_map<int, PreparedSurface> wholes_;  // where they are not these
};

}  // namespace

std::vector<std::pair<int, int>> disputes(const std::vector<Claim>& claims) {
  std::vector<PreparedSurface> grounds;
  for (const Claim& claim : claims) grounds.emplace_back(*claim.surface);
  std::vector<std::pair<int, int>> pairs;
  for (const auto& pair : overlapping_boxes(claims, grounds)) {
    poll_cancel();
    if (overlap(grounds[pair.first], grounds[pair.second])) pairs.push_back(pair);
  }
  return pairs;
}

std::vector<std::vector<int>> opponents(const std::vector<Claim>& claims,
                                        const std::vector<std::pair<int, int>>& disputes) {
  std::vector<std::vector<int>> rivals(claims.size());
  for (const auto& [i, j] : disputes) {
    rivals[i].push_back(j);
    rivals[j].push_back(i);
  }
  std::vector<std::vector<int>> opponents = rivals;
  for (int i = 0; i < static_cast<int>(claims.size()); ++i) {
    auto& all = opponents[i];
    for (std::size_t k = 0; k < all.size(); ++k)
      for (const int next : rivals[all[k]])
        if (claims[next].level != claims[i].level &&
            std::find(all.begin(), all.end(), next) == all.end() &&
            box_of(*claims[next].surface).meets(box_of(*claims[i].surface)))
          all.push_back(next);
    std::sort(all.begin(), all.end());
  }
  return opponents;
}

void settle_ownership(Geos& geos, std::vector<Claim>& claims,
                      const std::vector<std::pair<int, int>>& disputes) {
  Settlement settlement(geos, claims, disputes);
  std::vector<std::pair<int, MultiPolygon>> settled;
  for (int i = 0; i < static_cast<int>(claims.size()); ++i) {
    if (!claims[i].wanted || !settlement.disputed(i)) continue;
    tell_progress("owners", i, claims.size());
    settled.emplace_back(i, settlement.ground_of(i));
  }
  const auto lose = [](Claim& claim, const MultiPolygon& to_share, const MultiPolygon& left) {
    claim.contested_area = std::max(0.0, area(to_share) - area(left));
  };
  for (Claim& claim : claims)
    if (claim.whole != nullptr) lose(claim, *claim.whole, *claim.surface);
  for (auto& [i, ground] : settled) {
    Claim& claim = claims[i];
    lose(claim, claim.whole != nullptr ? *claim.whole : *claim.surface, ground);
    *claim.surface = std::move(ground);
  }
}

}  // namespace streetgen
