// The ground that a usual car sweeps along a movement, step by step.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/box.hpp"
#include "streetgen/link_conflict.hpp"

namespace streetgen {

// A rectangle that holds the car all along a step.
struct SweptStep {
  Point middle;
  double cosine = 1, sine = 0;  // of its heading
  double half_length = 0, half_width = 0;

  Box box() const;
  bool overlaps(const SweptStep& other) const;
};

// Steps from where the front is at the start to where the rear is at the end.
class SweptGround {
 public:
  explicit SweptGround(const ConflictMovement& movement);

  const Box& box() const { return whole_; }

  // The metres of the front from the first step that overlaps another ground to the end of the last
  // one; none: `to` is below 0.
  struct Stretch {
    double from = 0, to = -1;
  };
  Stretch within(const SweptGround& other) const;

 private:
  static constexpr std::size_t run = 8;  // steps that have a box together

  // The first step, or the last one, that overlaps another ground; none: the count of steps.
  std::size_t outermost(const SweptGround& other, bool first) const;
  bool meets(std::size_t step, const SweptGround& other,
             const std::vector<std::size_t>& runs) const;

  double length_of_step_ = 0;
  std::vector<SweptStep> steps_;
  std::vector<Box> boxes_, runs_;
  Box whole_;
};

}  // namespace streetgen
