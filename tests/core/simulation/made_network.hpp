// Networks of links that tests make by hand or at random.
#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "streetgen/traffic.hpp"

namespace streetgen {
namespace simulation_test {

// Links are numbered as they come; keys are 10 times that, and 10.
class NetworkMaker {
 public:
  int lane(double length, float speed = 14) {
    Link link;
    link.link_id = 10 * static_cast<std::int64_t>(links_.size()) + 10;
    link.length = length;
    link.speed = speed;
    link.width = 3.5F;
    link.stop = static_cast<float>(length);
    links_.push_back(link);
    next_.emplace_back();
    aspects_.emplace_back();
    beside_.emplace_back();
    pieces_.emplace_back();
    conflicts_.emplace_back();
    return static_cast<int>(links_.size()) - 1;
  }
  // The first movement of a lane is straight on.
  int movement(int from, int to, double length, float speed = 8) {
    const int made = lane(length, speed);
    links_[made].movement = true;
    join(from, made);
    join(made, to);
    return made;
  }
  void join(int from, int to) {
    if (next_[from].empty()) links_[from].straight_on = to;
    next_[from].push_back(to);
  }
  void opposite(int a, int b) {
    links_[a].opposite = b;
    links_[b].opposite = a;
  }
  void signal(int movement, int plan, const std::vector<SignalAspect>& aspects) {
    links_[movement].plan = plan;
    aspects_[movement] = aspects;
  }
  // Green in a part of each cycle, then amber and red, by a plan of its own.
  void green(int movement, float cycle, float from, float amber, float red) {
    signal(movement, static_cast<int>(plans.size()),
           {{from, Aspect::protected_green}, {amber, Aspect::amber}, {red, Aspect::red}});
    if (from > 0) aspects_[movement].insert(aspects_[movement].begin(), {0, Aspect::red});
    plans.push_back({movement, cycle, 0});
  }
  // Both need the ground of these stretches.  The first one goes first, or it is by arrival or by
  // signal.
  void conflict(int link, float from, float to, int other, float other_from, float other_to,
                Precedence precedence = Precedence::goes_first) {
    conflicts_[link].push_back({other, precedence, from, to, other_from, other_to});
    if (precedence == Precedence::goes_first) precedence = Precedence::gives_way;
    conflicts_[other].push_back({link, precedence, other_from, other_to, from, to});
  }
  void beside(int link, const LinkBeside& row) { beside_[link].push_back(row); }
  // From metres on two lanes lie beside each other, so far along each, the second one on the left.
  void lanes_beside(int right, int left, float from, float to, bool right_may = true,
                    bool left_may = true) {
    beside(right, {left, true, right_may, false, from, to, from, to});
    beside(left, {right, false, left_may, false, from, to, from, to});
  }
  void piece(int link, const LinkPiece& row) { pieces_[link].push_back(row); }
  Link& link(int i) { return links_[i]; }
  const std::vector<int>& next(int i) const { return next_[i]; }
  int size() const { return static_cast<int>(links_.size()); }
  std::vector<SignalPlan> plans;

  TrafficNetwork network() const {
    TrafficNetwork made;
    made.links = links_;
    made.plans = plans;
    std::vector<std::vector<int>> before(links_.size());
    for (std::size_t i = 0; i < links_.size(); ++i)
      for (const int n : next_[i]) before[n].push_back(static_cast<int>(i));
    for (std::size_t i = 0; i < links_.size(); ++i) {
      add(made.next, next_[i]);
      add(made.before, before[i]);
      add(made.pieces, pieces_[i]);
      add(made.beside, beside_[i]);
      add(made.aspects, aspects_[i]);
      made.heights.end_owner();
      add(made.conflicts, conflicts_[i]);
    }
    return made;
  }

 private:
  template <class Row, class Rows>
  static void add(RowsOf<Row>& rows, const Rows& own) {
    for (const auto& row : own) rows.add(row);
    rows.end_owner();
  }

  std::vector<Link> links_;
  std::vector<std::vector<int>> next_;
  std::vector<std::vector<SignalAspect>> aspects_;
  std::vector<std::vector<LinkBeside>> beside_;
  std::vector<std::vector<LinkPiece>> pieces_;
  std::vector<std::vector<LinkConflict>> conflicts_;
};

// Lanes with up to three movements each, many shorter than a car; some have signals, some lie on
// the ground of another one.
inline NetworkMaker random_network(std::mt19937_64& random, int lanes) {
  const auto below = [&](int n) { return static_cast<int>(random() % n); };
  const auto length = [&] { return std::ldexp(1 + below(1000) / 1000.0, below(7)); };
  NetworkMaker made;
  for (int i = 0; i < lanes; ++i) made.lane(length(), 5 + below(20));
  for (int i = 0; i + 1 < lanes; i += 2)
    if (below(4) == 0) {
      made.link(i + 1).length = made.link(i).length;
      made.link(i + 1).stop = made.link(i).stop;
      made.opposite(i, i + 1);
    }
  for (int p = 0; p < 5; ++p) made.plans.push_back({p, 20.0F + 10 * p, 7.0F * p});
  for (int i = 0; i < lanes; ++i) {
    if (below(3) == 0) made.link(i).stop = static_cast<float>(made.link(i).length * 0.8);
    for (int k = below(4); k > 0; --k) {
      const int made_movement = made.movement(i, below(lanes), length() / 4);
      if (below(6) == 0)
        made.signal(made_movement, below(5),
                    {{0, Aspect::red}, {9, Aspect::permitted}, {15, Aspect::amber}});
    }
  }
  return made;
}

}  // namespace simulation_test
}  // namespace streetgen
