// Kerbs that follow each other about a block, and how wide their sidewalks are.
#pragma once

#include <vector>

#include "streetgen/sidewalk.hpp"

namespace streetgen {

// A width at a place of a kerb; linear between two of them.
struct WidthKnot {
  double abscissa, width;
};

// A way from a kerb with a sidewalk to one that has none.
struct SidewalkEnd {
  int beside = 0;     // the kerb with the sidewalk
  bool ahead = true;  // the way begins at the end of that kerb, else at its start
  double width = 0;   // metres, of the sidewalk
  std::vector<int>
      on;        // kerbs without a width of their own, in their order from `beside`: one or more
  int none = 0;  // the kerb without a sidewalk
};

// The direction of the first piece of a kerb, or of the last one.
Point direction_at(const Line& line, bool at_start);

class KerbChains {
 public:
  KerbChains(const std::vector<SidewalkKerb>& kerbs, double transition);

  // The kerb that begins where this one ends, or ends where this one begins; -1: none.
  int next(int kerb) const { return next_[kerb]; }
  int previous(int kerb) const { return previous_[kerb]; }
  // Ascending, from the start of the kerb to its end; empty where it has no sidewalk.
  const std::vector<WidthKnot>& widths(int kerb) const { return widths_[kerb]; }
  const std::vector<SidewalkEnd>& ends() const { return ends_; }

 private:
  void link();
  void widen(int from, double transition);
  void lead_on(SidewalkEnd end);
  void put(int kerb, double start, double end, const std::vector<WidthKnot>& change);

  const std::vector<SidewalkKerb>& kerbs_;
  std::vector<int> next_, previous_;
  std::vector<double> lengths_;
  std::vector<std::vector<WidthKnot>> widths_;
  std::vector<SidewalkEnd> ends_;
};

}  // namespace streetgen
