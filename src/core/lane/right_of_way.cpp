#include "lane/right_of_way.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

constexpr double as_straight = 10 * M_PI / 180;  // angles that differ by less are equal

bool leads_on(const RankedArm& a, const RankedArm& b) {
  return (a.comes && b.leaves) || (b.comes && a.leaves);
}

// Where a street parts into its carriageways, or they come together, no paths cross.
bool parts_into_carriageways(const std::vector<RankedArm>& arms) {
  std::vector<const RankedArm*> one_way;
  for (const RankedArm& arm : arms)
    if (arm.comes != arm.leaves) one_way.push_back(&arm);
  return arms.size() == 3 && one_way.size() == 2 && one_way[0]->comes != one_way[1]->comes &&
         dot(one_way[0]->direction, one_way[1]->direction) > 0;
}

// The smaller the better.
auto rank_of_pair(const RankedArm& a, const RankedArm& b) {
  const double bend = M_PI - std::acos(std::clamp(dot(a.direction, b.direction), -1.0, 1.0));
  return std::tuple(std::llround(bend / as_straight), -(a.width + b.width),
                    std::min(a.axis_id, b.axis_id), std::max(a.axis_id, b.axis_id), bend);
}

}  // namespace

std::vector<bool> arms_that_wait(const std::vector<RankedArm>& arms) {
  const auto coming = std::count_if(arms.begin(), arms.end(), [](auto& arm) { return arm.comes; });
  std::vector<bool> waits(arms.size());
  if (coming < 2 || parts_into_carriageways(arms)) return waits;
  int best = arms.front().importance;
  for (const RankedArm& arm : arms) best = std::min(best, arm.importance);
  std::vector<std::size_t> most;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    waits[i] = arms[i].importance > best;
    if (!waits[i]) most.push_back(i);
  }
  if (most.size() < 3) return waits;
  std::size_t first = arms.size(), second = arms.size();
  for (const std::size_t i : most)
    for (const std::size_t j : most)
      if (i < j && leads_on(arms[i], arms[j]) &&
          (first == arms.size() ||
           rank_of_pair(arms[i], arms[j]) < rank_of_pair(arms[first], arms[second])))
        first = i, second = j;
  if (first == arms.size()) return waits;
  for (const std::size_t i : most) waits[i] = i != first && i != second;
  return waits;
}

}  // namespace streetgen
