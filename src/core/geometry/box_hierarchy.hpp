// Which boxes of a row lie near a box, where those that follow each other lie close: quick to make.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/box.hpp"
#include "support/infinite.hpp"

namespace streetgen {

// The boxes, and those of runs of them, and of runs of runs.
class BoxHierarchy {
 public:
  BoxHierarchy() = default;
  explicit BoxHierarchy(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
    for (std::size_t first = 0, last = boxes_.size(); first < last;
         first = last, last = boxes_.size()) {
      levels_.push_back(first);
      if (last - first <= run) break;
      for (std::size_t i = first; i < last; i += run) {
        Box all = boxes_[i];
        for (std::size_t k = i + 1; k < last && k < i + run; ++k) all = all.joined_with(boxes_[k]);
        boxes_.push_back(all);
      }
    }
    levels_.push_back(boxes_.size());
  }

  const Box& operator[](std::size_t i) const { return boxes_[i]; }

  // Whether `holds` is true of the index of any box that meets `box` grown by `margin`; asked in
  // ascending order, and only until it is.
  template <class Holds>
  bool any_near(const Box& box, double margin, Holds holds) const {
    if (levels_.size() < 2) return false;
    const std::size_t top = levels_.size() - 2;
    return any_of_run(box.grown(margin), top, 0, levels_[top + 1] - levels_[top], holds);
  }

  // Calls `use` with the index of each box that meets `box`, but for runs of which `done`, given
  // the index of their first, of the end and the box of all, says that they need none.
  template <class Done, class Use>
  void each_but(const Box& box, Done done, Use use) const {
    if (levels_.size() < 2) return;
    const std::size_t top = levels_.size() - 2;
    each_of_run_but(box, top, 0, levels_[top + 1] - levels_[top], run_size(top), done, use);
  }

  // The first of those with the least square; `square(i)` is that of a distance from p to what lies
  // in box i, or infinite.
  template <class Square>
  int nearest(const Point& p, Square square) const {
    Nearest found;
    if (levels_.size() < 2) return found.index;
    const std::size_t top = levels_.size() - 2;
    nearest_of_run(p, top, 0, levels_[top + 1] - levels_[top], square, found);
    return found.index;
  }

 private:
  static constexpr std::size_t run = 8;

  struct Nearest {
    double square = infinite;
    int index = -1;
  };

  // The nearest box first, so that most others hold nothing that is nearer.
  template <class Square>
  void nearest_of_run(const Point& p, std::size_t level, std::size_t first, std::size_t last,
                      Square& square, Nearest& found) const {
    last = std::min(last, levels_[level + 1] - levels_[level]);
    if (level == 0) {
      for (std::size_t i = first; i < last; ++i) {
        const int index = static_cast<int>(i);
        const double away = square(index);
        if (away < found.square || (away == found.square && index < found.index))
          found = {away, index};
      }
      return;
    }
    std::array<double, run> away;
    std::size_t nearest = first;
    for (std::size_t i = first; i < last; ++i) {
      away[i - first] = boxes_[levels_[level] + i].square_from(p);
      if (away[i - first] < away[nearest - first]) nearest = i;
    }
    nearest_of_run(p, level - 1, run * nearest, run * nearest + run, square, found);
    for (std::size_t i = first; i < last; ++i)
      if (i != nearest && away[i - first] <= found.square)
        nearest_of_run(p, level - 1, run * i, run * i + run, square, found);
  }

  template <class Holds>
  bool any_of_run(const Box& box, std::size_t level, std::size_t first, std::size_t last,
                  Holds& holds) const {
    const Box* const boxes = boxes_.data() + levels_[level];
    last = std::min(last, levels_[level + 1] - levels_[level]);
    for (std::size_t i = first; i < last; ++i) {
      if (!boxes[i].meets(box)) continue;
      if (level == 0 ? holds(i) : any_of_run(box, level - 1, run * i, run * i + run, holds))
        return true;
    }
    return false;
  }

  // `size`: how many boxes one of the level stands for.
  template <class Done, class Use>
  void each_of_run_but(const Box& box, std::size_t level, std::size_t first, std::size_t last,
                       std::size_t size, Done& done, Use& use) const {
    const Box* const boxes = boxes_.data() + levels_[level];
    last = std::min(last, levels_[level + 1] - levels_[level]);
    for (std::size_t i = first; i < last; ++i) {
      if (!boxes[i].meets(box)) continue;
      if (level == 0)
        use(i);
      else if (!done(i * size, std::min((i + 1) * size, levels_[1]), boxes[i]))
        each_of_run_but(box, level - 1, run * i, run * i + run, size / run, done, use);
    }
  }

  static std::size_t run_size(std::size_t level) {
    return level == 0 ? 1 : run * run_size(level - 1);
  }

  std::vector<Box> boxes_;
  std::vector<std::size_t> levels_;  // where they start, and the end
};

}  // namespace streetgen
