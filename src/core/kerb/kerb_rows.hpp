// The kerbs of one surface: pieces of its border put together.
#pragma once

#include <vector>

#include "kerb/kerb_place.hpp"

namespace streetgen {

// Appends the kerbs of section `edge` (node -1) or of the intersection `node`, whose border is
// given: as long as pieces of one place follow each other, from `first_place` on about each ring.
class KerbRows {
 public:
  KerbRows(const Layout& layout, int edge, int node, int level, std::vector<Kerb>& kerbs);

  void append(const BorderLoop& loop, const std::vector<KerbPlace>& places);

 private:
  std::size_t begin_of(const BorderLoop& loop, const std::vector<KerbPlace>& places) const;
  void append_row(const KerbPlace& place, Line line);

  const Layout& layout_;
  const int node_, level_;
  Point first_place_;
  std::vector<Kerb>& kerbs_;
  const std::size_t before_;  // how many there were
};

}  // namespace streetgen
