// Surfaces that may claim ground, and their rank.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// The segments of its axis in which an edge's line begins and ends, metres; 0: those of the line.
struct EndSegments {
  double first = 0, last = 0;     // their lengths
  double before = 0, beyond = 0;  // what of them lies before the line begins, and beyond its end
};

// Part of an edge's line.
struct Stretch {
  const Line* line = nullptr;
  double from = 0, to = 0;  // metres along it
  EndSegments segments{};
};

// A surface that may claim ground.
struct Claim {
  MultiPolygon* surface = nullptr;
  const MultiPolygon* whole = nullptr;  // the surface before crowds took of it; nullptr: the same
  int level = 0;
  std::vector<Stretch> skeleton;           // the pieces of axis that the surface was built on
  int importance = 99;                     // of its most important axis, 1 the highest
  double width = 0;                        // of its widest axis, metres
  std::vector<std::int64_t> axis_lengths;  // of the axes of its edges, millimetres, longest first
  std::int64_t axis_id = 0;                // the smallest of its axes, to break ties
  std::int64_t order_key = 0;              // distinct within one axis_id, to break ties
  std::vector<int> edges;                  // that the surface covers or ends on
  std::optional<Point> node;               // that it is the intersection of
  bool joins_levels = false;               // its edges lie on several
  bool wanted = true;         // its ground is to be settled, not only that of others against it
  double contested_area = 0;  // out: square metres left to others
};

// Levels overlap freely, but an intersection tiles with all its sections.
bool tile(const Claim& a, const Claim& b);

// Rank where nothing nearer decides: the more important, the wider, that of the longer axes, the
// longest first.  No edit of another axis changes these.  Claims equal in all are told by axis_id
// and order_key.
bool before(const Claim& a, const Claim& b);

}  // namespace streetgen
