// The network on foot: lines behind kerbs and across streets, and what these make with the lines of
// a source.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

struct WalkedKerb {
  Line line;              // with the roadway on its right
  double offset = 0;      // metres from it to the middle of its walk; 0: nobody walks there
  bool leads_on = false;  // of a corner or a dead end: walked where walks begin at both of its ends
  // Stretches whose walk is a line of the source, metres along the kerb, ascending.
  std::vector<std::pair<double, double>> mapped;
};

// The end of a street at a junction, which people cross there.
struct CrossedArm {
  int arrives = -1;  // index of the kerb that ends there; -1: none
  int leaves = -1;   // index of the kerb that starts there
  Line street;       // empty, or the line along which one walks where the street has no sidewalk
};

// A walk that no source maps.
struct BuiltWalk {
  Line line;
  int kerb = -1;  // index of the kerb that it lies behind; -1: it crosses an arm
  int arm = -1;   // index of that arm
  // The end lies beside a walk of the source, and has to be joined to that.
  bool loose_start = false;
  bool loose_end = false;
};

// Walks behind kerbs that follow each other share their ends, and so do crossings of arms with
// them. Kerbs follow each other where they share an end. An arm is crossed from the first walk on
// one side to the first one on the other, by way of its street where that is walked along; one that
// has a walk on one side alone, and is itself walked along, is entered from there.
std::vector<BuiltWalk> built_walks(const std::vector<WalkedKerb>& kerbs,
                                   const std::vector<CrossedArm>& arms);

struct WalkLine {
  Line line;
  int level = 0;
  bool mapped = false;  // by a source: it meets other such lines at vertices that they share alone
  // Metres that are cut off a loose end which leads beyond the last walk that the line meets.
  double excess_start = 0;
  double excess_end = 0;
  // Metres over which another loose end is led on to the nearest walk of its level, or else, where
  // it is mapped, of any level; 0: it stays loose.
  double reach_start = 0;
  double reach_end = 0;
};

// A piece of a line between two nodes.
struct WalkLink {
  int line = 0;  // index
  int part = 1;  // number along the line
  int parts = 1;
  std::int64_t id = 0;  // of its shape; that of a node is of its place
  std::int64_t from_node = 0;
  std::int64_t to_node = 0;
  Line geometry;
};

// Links by line and part. Lines meet where they share a vertex, on whatever levels, and where they
// cross on one level, or one ends within 1 cm of the other, and one of them is not mapped. Ends of
// links of a level that are nearer than that are one node, and what lies within one is no link.
std::vector<WalkLink> walk_network(const std::vector<WalkLine>& lines);

// A walk that is there already, or the shortest one over an area, between two of its places.
struct AreaWalk {
  int from = 0;  // index of a place
  int to = 0;
  Line line;  // empty: only the length is known
  double metres = 0;
};

// The walks over an area that one misses: the shortest between two places where all walks that are
// there, or were found before, shorter ones first, lead round by over `detour` times as far, and
// over 5 m. They bend only where the area bends inwards. Between places that the area parts there
// is none.
std::vector<AreaWalk> walks_over_area(const MultiPolygon& area, const std::vector<Point>& places,
                                      const std::vector<AreaWalk>& there, double detour);

// Both nodes of a link.
using WalkEnds = std::pair<std::int64_t, std::int64_t>;

// The part of the network that each link belongs to, named by its first link.
std::vector<int> walk_parts(const std::vector<WalkEnds>& links);

}  // namespace streetgen
