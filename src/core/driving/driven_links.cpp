#include "driving/driven_links.hpp"

#include <algorithm>
#include <cmath>

#include "driving/reached_links.hpp"
#include "simulation/other_storeys.hpp"
#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

// Costs are squares of what is wrong by its usual size, as those of chances are.
constexpr double usual_offset = 1;     // metres from the middle of a lane
constexpr double usual_turn = 0.5;     // radians that an actor moves aslant to its lane
constexpr double most_turn_cost = 10;  // of who drives against the traffic
constexpr double change_cost = 2, other_way_cost = 4, break_cost = 40;
constexpr double least_move = 0.2;      // metres that tell a direction
constexpr double way_a_move = 1.5;      // metres of way a metre of the straight line, at most
constexpr double way_beyond_move = 5;   // and so many more
constexpr double farthest_move = 300;   // beyond it samples are not joined
constexpr double goes_back = 0.5;       // metres that a standing actor moves back

struct Candidate {
  NearPlace near;
  double cost = 0;     // of itself
  double sum = 0;      // of the best way here
  int before = -1;     // the candidate of the sample before
  bool against = false;
};
using Candidates = std::vector<Candidate>;

struct Move {
  bool known = false;
  double heading = 0;
};

// The direction in which the actor moves, from the sample before to the one after.
std::vector<Move> moves_of(const std::vector<DriveSample>& samples) {
  std::vector<Move> moves(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const DriveSample& from = samples[i > 0 ? i - 1 : i];
    const DriveSample& to = samples[std::min(i + 1, samples.size() - 1)];
    const double dx = to.x - from.x, dy = to.y - from.y;
    if (std::hypot(dx, dy) >= least_move)
      moves[i] = {true, std::atan2(dy, dx)};
    else if (i > 0)
      moves[i] = moves[i - 1];
  }
  return moves;
}

Candidates candidates_of(const TrafficNetwork& network, const LinkPlaces& places,
                         const DriveSample& sample, const Move& move, double reach) {
  std::vector<NearPlace> near = places.near(sample.x, sample.y, reach);
  near.erase(std::remove_if(near.begin(), near.end(),
                            [&](const NearPlace& n) {
                              const Link& link = network.links[n.located.place.link];
                              return n.distance > link.width / 2 + beside_lane;
                            }),
             near.end());
  if (std::isfinite(sample.height)) drop_other_storeys(network, sample.height, near);
  Candidates found;
  for (const NearPlace& n : near) {
    Candidate candidate;
    candidate.near = n;
    candidate.cost = std::pow(n.distance / usual_offset, 2);
    if (move.known) {
      const double turn = std::abs(std::remainder(n.heading - move.heading, 2 * M_PI));
      candidate.cost += std::min(most_turn_cost, std::pow(turn / usual_turn, 2));
      candidate.against = turn > M_PI / 2;
    }
    candidate.sum = candidate.cost;
    found.push_back(candidate);
  }
  return found;
}

double straight_line(const DriveSample& a, const DriveSample& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

double way_allowed(double move) { return way_a_move * move + way_beyond_move; }

// The cost of a change from one link to a place that was reached by a row.
double change_cost_of(const ReachedLink& row, const Candidate& from, const Candidate& to,
                      double most) {
  if (row.from < 0) {
    const double moved = to.near.located.place.metres - from.near.located.place.metres;
    return moved >= -goes_back || to.against ? 0 : other_way_cost;
  }
  if (row.start + to.near.located.place.metres > most && row.changes == 0) return break_cost;
  return row.changes == 0 ? 0 : row.changes == 1 ? change_cost : other_way_cost;
}

void join(ReachedLinks& reached, const Candidates& from, double move, Candidates& to) {
  const double most = way_allowed(move);
  for (Candidate& c : to) c.sum = infinite;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (move <= farthest_move) reached.look(from[i].near.located.place, most);
    for (Candidate& c : to) {
      const int row = move <= farthest_move ? reached.row_of(c.near.located.place.link) : -1;
      const double change =
          row < 0 ? break_cost : change_cost_of(reached.rows()[row], from[i], c, most);
      const double sum = from[i].sum + change + c.cost;
      if (sum >= c.sum) continue;
      c.sum = sum;
      c.before = static_cast<int>(i);
    }
  }
}

int best_of(const Candidates& candidates) {
  int best = 0;
  for (std::size_t i = 1; i < candidates.size(); ++i)
    if (candidates[i].sum < candidates[best].sum) best = static_cast<int>(i);
  return best;
}

}  // namespace

std::vector<DrivenPlace> driven_links(const TrafficNetwork& network, const LinkPlaces& places,
                                      const std::vector<DriveSample>& samples) {
  double widest = 0;
  for (const Link& link : network.links) widest = std::max<double>(widest, link.width);
  const std::vector<Move> moves = moves_of(samples);
  ReachedLinks reached(network);
  std::vector<Candidates> all(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i % 256 == 0) poll_cancel();
    all[i] = candidates_of(network, places, samples[i], moves[i], widest / 2 + beside_lane);
    if (i > 0 && !all[i].empty() && !all[i - 1].empty())
      join(reached, all[i - 1], straight_line(samples[i - 1], samples[i]), all[i]);
  }
  std::vector<DrivenPlace> driven(samples.size());
  for (std::size_t i = samples.size(), after = 0; i-- > 0;) {
    if (all[i].empty()) continue;
    const bool ends = i + 1 == samples.size() || all[i + 1].empty();
    const Candidate& own = all[i][ends ? best_of(all[i]) : all[i + 1][after].before];
    driven[i].near = own.near;
    driven[i].against = own.against;
    after = static_cast<std::size_t>(&own - all[i].data());
  }
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (i % 256 == 0) poll_cancel();
    const LinkPlace& from = driven[i - 1].near.located.place;
    const int to = driven[i].near.located.place.link;
    const double move = straight_line(samples[i - 1], samples[i]);
    if (from.link < 0 || to < 0 || move > farthest_move) continue;
    reached.look(from, way_allowed(move));
    const int row = reached.row_of(to);
    driven[i].joined = row >= 0 && reached.rows()[row].changes == 0;
    if (driven[i].joined) driven[i].way = reached.way_to(row);
  }
  return driven;
}

}  // namespace streetgen
