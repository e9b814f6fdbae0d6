// SplitMix64 (Steele, Lea, Flood 2014): the same numbers on every machine.
#pragma once

#include <cstdint>

namespace streetgen {

class Random {
 public:
  explicit Random(std::uint64_t key) : state_(key) {}

  // A generator of its own for part `index`, whatever was drawn here.
  static Random part(std::uint64_t key, std::uint64_t index) {
    return Random(mixed(key ^ mixed(index + 1)));
  }

  std::uint64_t next() { return mixed(state_ += 0x9e3779b97f4a7c15ULL); }
  // Uniform in [0, 1), on the 2^53 numbers k / 2^53.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  bool chance(double probability) { return uniform() < probability; }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

}  // namespace streetgen
