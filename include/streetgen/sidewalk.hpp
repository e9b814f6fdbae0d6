// Sidewalks: strips on the left of kerbs, which have the roadway on their right.
//
// Each is as wide as wanted behind its kerb, round about outer bends. Where the widths of two
// sections differ, the width changes linearly along the kerb of the corner between them. It also
// changes along a kerb with a course of widths. Behind a
// straight piece of kerb the back line is straight, and it goes on to meet that of the next piece:
// it has no dent, and the sidewalk is nowhere narrower. Towards a section without a sidewalk it
// goes on along its street to the corner. There the back line goes straight on to the kerb, or the
// sidewalk ends square. Ground that two sidewalks want belongs to the nearer kerb, and none lies on
// a roadway.
#pragma once

#include <optional>
#include <vector>

#include "streetgen/geometry.hpp"
#include "streetgen/method.hpp"

namespace streetgen {

// A width at a place along a kerb.
struct WidthAt {
  double share = 0;  // of its length, from its start; below 0 and over 1 beyond its ends
  double width = 0;  // metres
};

// A kerb with what is known of the ground behind it.
struct SidewalkKerb {
  Line line;
  int level = 0;
  // Metres behind it, 0: none; without a value it leads from the width of the kerb before to that
  // of the kerb after.
  std::optional<double> width;
  // The width at places along it, ascending; it changes straight from one to the next. A kerb without
  // a width has none.
  std::vector<WidthAt> course;
  // The kerb is that of a dead end, or beside no city: a sidewalk leads on along it where both
  // sides have one.
  bool across = false;
  bool ends = false;     // the roadway goes on there: no sidewalk leads around
  bool wanted = true;    // its sidewalk comes out; else the kerb is there for the others
  bool by_hand = false;  // the width is a user's
};

struct Sidewalk {
  int kerb = 0;  // index
  double width = 0;  // metres: as wanted, of one that changes the mean
  MultiPolygon surface;
  Method method = Method::hypothesis;  // contested where other kerbs hold part of it, or by_hand
};

// The wanted kerbs with a sidewalk, in their order. A change of width takes `transition`
// metres of kerb. Kerbs follow each other where one ends as the next one starts.
std::vector<Sidewalk> find_sidewalks(std::vector<SidewalkKerb> kerbs, double transition);

}  // namespace streetgen
