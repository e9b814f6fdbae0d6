// Who waits for whom, without a circle.
#pragma once

#include <cstdint>
#include <vector>

namespace streetgen {

class YieldOrder {
 public:
  explicit YieldOrder(int size)
      : words_((size + 63) / 64),
        waits_for_(static_cast<std::size_t>(size) * words_),
        size_(size) {}

  // Lets one wait for another one, unless that waits for it already, also by others.
  bool add(int waits, int goes) {
    if (waits == goes || holds(goes, waits)) return false;
    for (int i = 0; i < size_; ++i) {
      if (i != waits && !holds(i, waits)) continue;
      for (int w = 0; w < words_; ++w) row(i)[w] |= row(goes)[w];
      row(i)[goes / 64] |= std::uint64_t{1} << (goes % 64);
    }
    return true;
  }

 private:
  bool holds(int waits, int goes) { return row(waits)[goes / 64] >> (goes % 64) & 1; }
  std::uint64_t* row(int i) { return waits_for_.data() + static_cast<std::size_t>(i) * words_; }

  int words_;
  std::vector<std::uint64_t> waits_for_;  // a bit for each that it waits for, also by others
  int size_;
};

}  // namespace streetgen
