// Shortest ways between towns over the links that are left. A link is as long as it is straight.
#pragma once

#include <cstddef>
#include <vector>

#include "design/town_grid.hpp"
#include "streetgen/geometry.hpp"
#include "support/infinite.hpp"

namespace streetgen {

// Towns from one to another, ends included; without a way none, and the length is infinite.
struct TownWay {
  double length = infinite;
  std::vector<std::size_t> towns;
};

class LinkGraph {
 public:
  // Places of the towns, in the unit of all lengths.
  explicit LinkGraph(const std::vector<Point>& places);
  void put(std::size_t a, std::size_t b);
  void remove(std::size_t a, std::size_t b);
  bool has(std::size_t a, std::size_t b) const { return linked_[a * places_.size() + b]; }
  double length(std::size_t a, std::size_t b) const;

  // The shortest way that does not use the link between both. It lies within an ellipse about both,
  // so only the towns in ever wider ellipses are looked at; `least` is a length that it surely has.
  TownWay way_beside(std::size_t a, std::size_t b, double least);

  // Lengths of the shortest ways from a town to all, and the town before each.
  struct Ways {
    std::vector<double> length;
    std::vector<std::size_t> before;
  };
  Ways ways(std::size_t from) const;

 private:
  struct Reached {
    double bound;  // length so far, and straight on
    std::size_t town;
    bool operator<(const Reached& other) const { return bound > other.bound; }
  };
  TownWay way_within(std::size_t a, std::size_t b);
  template <class Use>
  void each_neighbour(std::size_t town, Use use);

  std::vector<Point> places_;
  TownGrid grid_;
  std::vector<bool> linked_;  // by both towns
  std::vector<std::vector<std::size_t>>
      neighbours_;  // links that went are left out when it is read
  // The state of the search: the towns in the ellipse, and what is known of each.
  std::vector<std::size_t> within_;
  std::vector<bool> inside_;
  std::vector<double> so_far_;
  std::vector<std::size_t> before_;
  std::vector<Reached> queue_;
};

}  // namespace streetgen
