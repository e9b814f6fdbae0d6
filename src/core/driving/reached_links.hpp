// The links that a car may be on a little later.
#pragma once

#include <cstdint>
#include <vector>

#include "streetgen/traffic.hpp"

namespace streetgen {

struct ReachedLink {
  std::int32_t link = -1;
  double start = 0;          // metres from the car to where the link starts, along the way
  std::int32_t from = -1;    // the row by which it is reached; -1: the car is on it
  std::uint8_t changes = 0;  // of lanes on the way
};

// Those that begin within `metres` of a place, its own link first, with at most two changes of
// lanes; to a lane of the other direction at most one.  Each link once, with the fewest changes.
class ReachedLinks {
 public:
  explicit ReachedLinks(const TrafficNetwork& network) : network_(&network) {}

  void look(const LinkPlace& place, double metres);
  const std::vector<ReachedLink>& rows() const { return rows_; }
  // The row of a link; -1: none.
  int row_of(int link) const;
  // The links that lead to a row, without that of the car.
  std::vector<std::int32_t> way_to(int row) const;

 private:
  void reach(const ReachedLink& row);
  void go_on(std::size_t from, double metres);
  void change(const ReachedLink& row, int index);

  const TrafficNetwork* network_;
  std::vector<ReachedLink> rows_;
};

}  // namespace streetgen
