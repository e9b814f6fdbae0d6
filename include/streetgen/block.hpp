// City blocks: the ground that streets enclose.  StreetGen paper, 2.5 and figure 13.
//
// A block is a face of the network of one level, less the roadway of that level. The face outside
// of all streets is none.
#pragma once

#include <vector>

#include "streetgen/geometry.hpp"
#include "streetgen/kerb.hpp"
#include "streetgen/method.hpp"
#include "streetgen/network.hpp"

namespace streetgen {

// A block is what its rectangle tells: the one with the area and the perimeter of its ground.
enum class BlockKind {
  block,
  island,   // small, or what a roundabout goes round
  strip,    // narrow and long: between carriageways
  roadway,  // no ground is left
};
const char* block_kind_name(BlockKind kind) noexcept;

struct BlockSettings {
  double island_area = 300;     // square metres; a block with less is an island, 0: no block is
  double strip_width = 12;      // metres; a strip's rectangle is no wider, 0: none is a strip
  double strip_elongation = 4;  // and at least so many times as long as wide
};

// By hand: the kind of the block that holds the place.
struct BlockOverride {
  Point place;
  BlockKind kind = BlockKind::block;
};

struct BlocksInput {
  std::vector<Line> edges;  // of one level, in the order of their places
  std::vector<bool> on_rings{};  // by edge, whether it is part of a roundabout; empty: none is
  // The border of the roadway of that level, in pieces whose ends meet; of an edge that is not
  // given, edge is -1.
  std::vector<Kerb> kerbs;
  BlockSettings settings;
  std::vector<BlockOverride> overrides;  // of two for one block the later holds
  // Not all edges of the level may be given: then sides of the given ones, or parts of these,
  // beside faces that stay as they are.  Such faces do not come out, and all edges about the others
  // have to be given.
  std::vector<EdgeSide> kept;
};

struct BlockSide {
  EdgeSide side;
  int ring = 1;  // 1 goes about the block, others about islands of streets within
};

struct Block {
  std::vector<BlockSide> sides;  // from the smallest place of the first ring on, ring by ring
  MultiPolygon surface;          // ground; empty where the face is roadway all over
  BlockKind kind = BlockKind::block;
  // covered: no ground is left; axis_bound: where a street has no roadway of the level its axis
  // bounds the block; robust_fallback: kerbs are missing, or cross.
  Method method = Method::hypothesis;
  // False where a ring of kerbs has a gap, and where axes bound it: it then depends on kerbs of any
  // street about it.
  bool has_all_kerbs = true;
};

struct Blocks {
  std::vector<Block> blocks;      // in the order of their smallest places
  std::vector<EdgeSide> outside;  // sides in no block
};

// Rings of the ground are walked along kerbs. Deterministic; the order of the kerbs does not
// matter.
Blocks blocks(const BlocksInput& input);

}  // namespace streetgen
