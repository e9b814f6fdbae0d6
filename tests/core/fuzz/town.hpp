// Random towns, far worse than real ones; the seed says all.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "streetgen/street.hpp"

namespace streetgen::fuzz {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  bool one_in(int count) { return below(count) == 0; }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) / 9007199254740992.0);
  }
  // As likely between 0.1 and 1 as between 1 and 10.
  double scaled(double low, double high);
  template <class T>
  const T& of(const std::vector<T>& values) {
    return values[below(static_cast<int>(values.size()))];
  }

 private:
  std::mt19937_64 engine_;
};

struct Town {
  std::vector<StreetAxis> axes;
  StreetSettings settings;
};

// Crooked lines, stars of very acute angles, overlaps on one line, doubles, loops, ends that miss
// a node by about the tolerance, levels; at the origin, at 6.8e6 m or at 1e9 m.
Town random_town(std::uint64_t seed);

// About half of the limits and corners decided by hand, within their edges and beyond what fits.
StreetOverrides random_overrides(Random& random, const Streets& town);

// A crooked line of up to 40 points that starts at `from`.
Line random_line(Random& random, const Point& from);

}  // namespace streetgen::fuzz
