// Things joined to groups, transitively; a group is called after its smallest member.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace streetgen {

class Groups {
 public:
  explicit Groups(int size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0); }
  int add() {
    parent_.push_back(static_cast<int>(parent_.size()));
    return parent_.back();
  }
  int of(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int i, int j) {
    i = of(i), j = of(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }
  int size() const { return static_cast<int>(parent_.size()); }

 private:
  std::vector<int> parent_;
};

}  // namespace streetgen
