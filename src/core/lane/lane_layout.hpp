// The layout of the lanes of one edge: their order, their shares of the roadway, their lines.
#pragma once

#include <vector>

#include "streetgen/lane.hpp"

namespace streetgen {

// A line along a strip: its share of the roadway from the left kerb, at each place of the strip's
// profile; one share where there is no profile.
using LaneShares = std::vector<double>;

// The piece of an edge that its lanes cover.
struct LaneStrip {
  Line axis;              // planar, without repeated points
  double half_start = 0;  // half widths of the roadway at the ends of the axis
  double half_end = 0;
  double from = 0, to = 0;      // abscissas, from < to
  Line from_border, to_border;  // from the left kerb to the right one
  WidthProfile profile{};       // where it is not empty, in the place of the half widths
  double roadway_offset = 0;    // metres from the axis to the middle of the roadway, left positive
  std::vector<MergingStretch> merging{};
  double width() const { return 2 * half_at(from); }  // metres, without what a profile changes
  double share_at(double abscissa, const LaneShares& shares) const;
  // Metres to the left of the axis.
  double offset_at(double abscissa, const LaneShares& shares) const;
  double half_at(double abscissa) const;  // as the axis has it
};

// From the left kerb to the right kerb in the direction of the axis.
std::vector<LaneWish> across(const AxisLanes& lanes, DrivingSide side);

int ordinality_of(int position, int count, LaneOrder order);
LaneSide side_of(int position, int count);

// The shares of the roadway, from the left kerb, where each lane begins, and where the last one
// ends.  Lanes fill the roadway, unless stated widths, or the widest that others grow to, leave
// some of it: that lies beside the lanes, half of it at either kerb.  Of cycle and parking lanes
// alone nothing is left.  Where the roadway is short, lanes that state no width share that, down to
// half of their least; beyond that all lanes do.
std::vector<double> lane_shares(const std::vector<LaneWish>& wishes, double width,
                                double narrowest);

// Of the roadway; one between lanes and what lies beside them is none.
bool is_kerb(const LaneShares& shares);

// Along the strip; ends on the borders.
Line line_at_shares(const LaneStrip& strip, const LaneShares& shares);

}  // namespace streetgen
