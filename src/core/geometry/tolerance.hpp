// How near counts as the same.  Each meaning stands here once, with the reason for its size; the
// assertions below say which must be smaller than which.
#pragma once

namespace streetgen {

// Sines and cosines are rounded to this share: lines that turn by less are straight.
constexpr double straight_sine = 1e-12;

// Radians.  Directions that turn by less from one another differ by noise.  A bound of an angle
// lies this far beside its round number, at which streets are drawn.
constexpr double same_angle = 1e-6;

// Metres.  An offset that is smaller lies on the axis itself, and points that are nearer repeat
// each other: rounding alone keeps them apart.
constexpr double rounding = 1e-9;

// Metres.  The arrangement's grid has a step of at most a tenth of a micrometre.  A point this far
// beside a border lies in the face on that side.
constexpr double beside_border = 2e-8;

// Metres.  Sides of rings that come nearer may cross after one more rounding.
constexpr double sides_touch = 1e-7;

// Metres.  A place whose distance to an axis falls short of the offset by less lies on the border.
constexpr double border_slack = 1e-7;

// Metres.  Two points that are nearer were computed in two ways and are the same.
constexpr double same_place = 1e-6;

// Metres.  Sites of two axes that are nearer are one site of a Voronoi border.
constexpr double same_site = 1e-5;

// Metres.  A piece of a line that is shorter has no direction but the noise of its ends.
constexpr double least_piece = 1e-5;

// Metres.  Places are looked at this far beyond the geometry that they belong to, so that
// coordinates computed in two ways lie within.
constexpr double coordinate_margin = 1e-3;

// Metres.  Half widths that differ by less go on as one street.
constexpr double same_width = 5e-3;

// Square metres.  A hole that is smaller is the noise of coordinates.
constexpr double least_hole = 1e-7;

// Square metres.  A part of a surface that is smaller is not worth keeping.
constexpr double least_part = 1e-6;

// A step beside a border stays on its side of a touching border, and a slack within one place.
static_assert(rounding < beside_border && beside_border < sides_touch);
static_assert(border_slack < same_place && sides_touch < same_place);
// One place belongs to one site, and a margin covers the noise of both.
static_assert(same_place < least_piece && same_place < same_site && same_site < coordinate_margin);
// A street that keeps its width is not told from another by a margin.
static_assert(coordinate_margin < same_width);
static_assert(least_hole < least_part);

}  // namespace streetgen
