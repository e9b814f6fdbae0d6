// Which surfaces take part in what another one becomes, told before they are built.
#pragma once

#include <optional>
#include <vector>

#include "geometry/box.hpp"
#include "geometry/box_index.hpp"
#include "layout/layout.hpp"
#include "ownership/ownership.hpp"

namespace streetgen {

// Boxes that hold a surface together.
struct Extent {
  Box box;  // holds all parts
  std::vector<Box> parts;

  void add(const Box& part);
  bool meets(const Extent& other, double margin) const;
};

// Holds the section between two abscissas, round ends included.
Extent section_extent(const Arm& arm, double start, double end);
// Holds the section of an edge.
Extent section_extent(const Layout& layout, int edge);

// Holds the intersection; gaps[i] lies between arms[i] and arms[i + 1], none at a dead end.
Extent intersection_extent(const std::vector<Arm>& arms, const std::vector<Gap>& gaps);

// Claims by where their surfaces may lie.
class Vicinity {
 public:
  // extents[i] is that of claims[i]; the claims outlive the vicinity. Claims `slit_width` metres
  // apart may leave a slit.
  Vicinity(std::vector<Extent> extents, const std::vector<Claim>& claims, double slit_width);

  // Those that may share ground or a slit with the claim and tile with it, or with one that does.
  std::vector<int> opponents(int claim);
  // Those that may close a ring around a hole beside the claim, within `hole_extent` of it; none
  // where all near it are known.
  std::vector<int> enclosing(int claim, const std::vector<bool>& known);
  std::vector<int> near(const Box& box) const;
  const std::vector<Extent>& extents() const { return extents_; }

 private:
  const std::vector<int>& touching(int claim);

  std::vector<Extent> extents_;
  const std::vector<Claim>& claims_;
  double slit_width_;
  BoxIndex index_;
  std::vector<std::optional<std::vector<int>>> touching_;
  std::vector<int> place_;  // among those near the claim that is asked about
};

}  // namespace streetgen
