// The way of a car from link to link: along its route, then straight on.
#pragma once

#include <cstdint>
#include <vector>

#include "streetgen/traffic.hpp"

namespace streetgen {

// Whether one link leads to another.
bool leads(const TrafficNetwork& network, int link, int next);

// Refuses an index that is no link's.
void require_link(const TrafficNetwork& network, int link);

class PathAhead {
 public:
  // `on_route` is the place of the link on the route; -1: it is not on it.  No route: straight on.
  PathAhead(const TrafficNetwork& network, int link, const std::vector<std::int32_t>* route,
            int on_route)
      : network_(network), route_(route), link_(link), on_route_(route ? on_route : -1) {}

  int link() const { return link_; }

  // Whether the route tells what follows.
  bool follows_route() const {
    return on_route_ >= 0 && on_route_ + 1 < static_cast<int>(route_->size());
  }

  // The link that follows; -1: the path ends.
  int next() const {
    if (!follows_route()) return network_.links[link_].straight_on;
    const int next = (*route_)[on_route_ + 1];
    return leads(network_, link_, next) ? next : -1;
  }

  // Whether the path ends since the car must change to a link beside.
  bool must_change() const { return follows_route() && next() < 0; }

  // To the link that `next` gave.
  void go_on(int next) {
    on_route_ = follows_route() ? on_route_ + 1 : -1;
    link_ = next;
    if (on_route_ >= 0) return;
    // Brent's search for a ring: the link of a step that is a power of two is met again.
    if (++steps_ == watched_for_) {
      watched_ = link_;
      watched_for_ *= 2;
      round_ = false;
    } else {
      round_ = link_ == watched_;
    }
  }

  // Whether the path has been all the way round a ring without exit.
  bool round() const { return round_; }

 private:
  const TrafficNetwork& network_;
  const std::vector<std::int32_t>* route_;
  int link_, on_route_;
  int watched_ = -1, steps_ = 0, watched_for_ = 1;
  bool round_ = false;
};

}  // namespace streetgen
