// The kerb to which a piece of a border belongs.
#pragma once

#include <vector>

#include "kerb/free_border.hpp"
#include "layout/layout.hpp"
#include "streetgen/beside.hpp"

namespace streetgen {

struct KerbPlace {
  int edge = 0;
  KerbSide side = KerbSide::left;
  Method method = Method::hypothesis;
  int corner = -1;  // in streets.corners, where the piece is a chord of its arc
  Beside beside = Beside::outer;
};
inline bool operator==(const KerbPlace& a, const KerbPlace& b) {
  return a.edge == b.edge && a.side == b.side && a.method == b.method && a.corner == b.corner &&
         a.beside == b.beside;
}

// The border of a section, cut across where a median beside the edge begins or ends.
BorderLoop cut_at_medians(const Layout& layout, int edge, const BorderLoop& loop);

// One for each piece; those of shared pieces mean nothing.
std::vector<KerbPlace> places_of_section(const Layout& layout, int edge, const BorderLoop& loop);

// The border of an intersection that goes round the dead end of an edge, cut there in the axis: one
// half belongs to either corner beside the edge.
BorderLoop cut_at_dead_ends(const Layout& layout, int node, const BorderLoop& loop);

// corner_from[slot(end)]: the corner counter-clockwise from there; -1: none.
std::vector<KerbPlace> places_of_intersection(const Layout& layout, int node,
                                              const std::vector<int>& corner_from,
                                              const BorderLoop& loop);

}  // namespace streetgen
