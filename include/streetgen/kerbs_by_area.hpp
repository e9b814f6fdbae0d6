// The kerbs of a street where its roadway was surveyed as areas.
#pragma once

#include <optional>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// The course of a roadway beside its axis, metres.
struct KerbsByArea {
  double width = 0;           // kerb to kerb
  double roadway_offset = 0;  // from the axis to the middle, left positive
};

// Areas tell of kerbs no farther than this from the axis, metres.
constexpr double area_reach = 25;

// Areas no farther apart are one, metres.
constexpr double area_touching = 0.1;

// Metres beyond the kerbs that areas tell in which a street takes what it has of an area.
constexpr double area_beyond_kerb = 6;

// The middle one of all places along the axis that lie within areas tells each kerb; areas that
// touch are one. None where less than 0.3 of the axis is within, as where a junction alone was
// surveyed, or where areas have no border beside the axis within area_reach. A side without a
// border, or one over 10 m away and over twice as far as the other and 2 m, as where both
// carriageways of a street are one area, has its kerb as far away as the other.
std::optional<KerbsByArea> kerbs_by_area(const Line& axis, const std::vector<MultiPolygon>& areas);

}  // namespace streetgen
