// The guide of a curve from lane to lane: points of the path, and how far it may leave each.
#pragma once

#include <vector>

#include "road/arc_chain.hpp"
#include "streetgen/plan_view.hpp"

namespace streetgen {

struct PathGuide {
  ChainPlace from, to;  // the last heading has counted the turns of the path
  double length = 0;    // metres
  Line points;
  std::vector<double> reach;  // metres from each point
  double most_curvature = 0;  // one by metres

  // Headings at the ends and in the middles between points, which go on from one to the next.
  std::vector<double> stations, headings;
};

// The path is moved so that its ends lie at the places.  Its curves are as wide as the path; where
// an end leads elsewhere than its lane, they may be as tight as `least_curve_radius` or half the
// lane, and have room beside that end.
PathGuide path_guide(const Line& path, const ChainPlace& from, const ChainPlace& to,
                     double tolerance, double lane_width);

// Arcs that turn as the guide does, each over an equal share of its turns and of its length.
std::vector<ChainArc> first_arcs(const PathGuide& guide, int count);

}  // namespace streetgen
