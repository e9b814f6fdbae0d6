// Shortest ways between towns over the links that are left.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace streetgen {

class LinkGraph {
 public:
  explicit LinkGraph(std::size_t towns)
      : towns_(towns), length_(towns * towns, std::numeric_limits<double>::infinity()) {}
  void put(std::size_t a, std::size_t b, double length) {
    length_[a * towns_ + b] = length_[b * towns_ + a] = length;
  }
  void remove(std::size_t a, std::size_t b) { put(a, b, std::numeric_limits<double>::infinity()); }
  double length(std::size_t a, std::size_t b) const { return length_[a * towns_ + b]; }
  std::size_t towns() const { return towns_; }

  // Lengths of the shortest ways from a town, and the town before each; `to` ends the search early.
  struct Ways {
    std::vector<double> length;
    std::vector<std::size_t> before;
  };
  static constexpr std::size_t everywhere = static_cast<std::size_t>(-1);
  Ways ways(std::size_t from, std::size_t to = everywhere) const;

 private:
  std::size_t towns_;
  std::vector<double> length_;
};

}  // namespace streetgen
