// Surfaces built from axes and kerbs: border lines, sections, intersections, buffers, strips and
// crossings.  Paper, 2.5 and figure 22.
#pragma once

#include <optional>
#include <vector>

#include "streetgen/geometry.hpp"

namespace streetgen {

// The line across the axis at `abscissa` (clamped to the axis), normal to the local
// substring at +-0.1 m, from the left kerb to the right kerb.  roadway_offset: metres from the
// axis to the middle of the roadway, left positive.
Line border_line(const Line& axis, double abscissa, double width, double roadway_offset = 0);

// The roadway of the axis between two abscissas, with flat ends and round outer bends.
MultiPolygon section_surface(const Line& axis, double width, double start_abscissa,
                             double end_abscissa);

// Axes in any order, all starting at the node; radii[i] belongs to the corner from axes[i]
// to the next axis counter-clockwise.  Ends at each axis' farthest tangent point.
MultiPolygon intersection_surface(const std::vector<Line>& axes, const std::vector<double>& widths,
                                  const std::vector<double>& radii);

// The same with true arcs: the exterior ring piece by piece; empty where the ring cannot be
// built piece by piece (the straight surface then holds).
CurvedRing intersection_ring(const std::vector<Line>& axes, const std::vector<double>& widths,
                             const std::vector<double>& radii);

enum class Side { both, left, right };
enum class Ends { flat, round };

// The union of discs along the line whose radius is linear between the vertices' radii
// (side: only the part left or right of the line).  radii.size() == line.size(), each >= 0.
MultiPolygon variable_buffer(const Line& line, const std::vector<double>& radii,
                             Side side = Side::both, Ends ends = Ends::flat);

// The strip on the left of a kerb, which has the roadway on its right. Its width changes linearly
// from the start of the kerb to the end. Round about outer bends, flat at both ends; arcs become
// chords within a millimetre. Empty where both widths are 0.
MultiPolygon offset_strip(const CurvedLine& kerb, double width_start, double width_end);
MultiPolygon offset_strip(const Line& kerb, double width_start, double width_end);

// The roadway under a pedestrian crossing that is `width` wide between its parallel borders.
// `angle` turns counter-clockwise from the axis' direction at `abscissa` (clamped) to the way
// across. Each border goes left and right from the axis to the kerb, up to ten times the width;
// none: no surface. The kerb between them is followed. It is cut straight where it goes farther
// than a width beyond the borders or where the ring would cross itself.
std::optional<Polygon> crossing_surface(const Line& axis, const CurvedLine& kerb_left,
                                        const CurvedLine& kerb_right, double abscissa, double width,
                                        double angle);
std::optional<Polygon> crossing_surface(const Line& axis, const Line& kerb_left,
                                        const Line& kerb_right, double abscissa, double width,
                                        double angle);

}  // namespace streetgen
