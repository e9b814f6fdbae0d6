#include "lane/lane_succession.hpp"

#include <algorithm>
#include <cstdlib>

namespace streetgen {

namespace {

constexpr double as_far = 1e-6;  // square metres: moves that differ by less differ by rounding

// The lanes at one end of the list that merge towards the others.
template <class At>
int merging(At first, At end, unsigned mark) {
  return static_cast<int>(
      std::find_if(first, end, [&](const LaneAbreast& lane) { return !(lane.turns & mark); }) -
      first);
}

// The squares of the ways aside where `skipped` lanes of the longer list lie left of the others.
double moved_aside(const std::vector<LaneAbreast>& longer, const std::vector<LaneAbreast>& shorter,
                   int skipped) {
  double moved = 0;
  for (std::size_t i = 0; i < shorter.size(); ++i) {
    const double aside = longer[i + skipped].aside - shorter[i].aside;
    moved += aside * aside;
  }
  return moved;
}

}  // namespace

int succession(const std::vector<LaneAbreast>& in, const std::vector<LaneAbreast>& out,
               DrivingSide side) {
  const int n = static_cast<int>(in.size()), m = static_cast<int>(out.size());
  const bool end = n > m;
  const std::vector<LaneAbreast>&longer = end ? in : out, &shorter = end ? out : in;
  int least_left = 0, most_left = std::abs(n - m);
  if (end) {
    const int left = merging(in.begin(), in.end(), turn::merge_right);
    const int right = merging(in.rbegin(), in.rend(), turn::merge_left);
    least_left = std::min(left, most_left);
    most_left = std::max(least_left, most_left - right);
  }
  // From the one in which outer lanes alone change.
  const int step = side == DrivingSide::right ? +1 : -1;
  int best = step > 0 ? least_left : most_left;
  double least = moved_aside(longer, shorter, best);
  for (int skipped = best + step; skipped >= least_left && skipped <= most_left; skipped += step) {
    const double moved = moved_aside(longer, shorter, skipped);
    if (moved < least - as_far) {
      least = moved;
      best = skipped;
    }
  }
  return end ? -best : best;
}

}  // namespace streetgen
