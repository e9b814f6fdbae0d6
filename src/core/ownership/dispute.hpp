// Two claims on the same ground: which of them owns a place.
#pragma once

#include <optional>
#include <vector>

#include "geometry/prepared_surface.hpp"
#include "geometry/voronoi_border.hpp"
#include "ownership/claim.hpp"

namespace streetgen {

// A claim and its ground, which comes in unsettled.
struct Disputant {
  const Claim* claim;
  const PreparedSurface* ground;
};

// Where the axes of the two cross, all shared ground is the more important one's, unless it holds
// the other's node; else each place is that of the nearer axis.
class Dispute {
 public:
  Dispute(const Disputant& a, const Disputant& b);

  bool crossed() const { return crossed_; }
  bool first_owns(const Point& place) const;
  // Lines within the shared ground, and a little beyond, where the owner changes.
  const std::vector<Line>& border() const { return border_; }

 private:
  bool crossed_ = false;
  bool first_owns_all_ = false;
  std::optional<VoronoiBorder> nearest_;
  std::vector<Line> border_;
};

}  // namespace streetgen
