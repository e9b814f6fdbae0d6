#include <algorithm>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/walk_network.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

constexpr double shortest = 1e-6;  // metres
constexpr double worth_it = 5;     // metres that a walk over an area saves at least

using Distances = std::vector<std::vector<double>>;

// Bends of a ring, with the area on its left, that lead inwards.
void add_inward_bends(const Ring& ring, std::vector<Point>& bends) {
  const std::size_t count = ring.size() < 4 ? 0 : ring.size() - 1;  // the last is the first
  for (std::size_t i = 0; i < count; ++i) {
    const Point &before = ring[(i + count - 1) % count], &here = ring[i],
                &after = ring[(i + 1) % count];
    if (cross(here - before, after - here) < 0) bends.push_back(here);
  }
}

bool sees(const PreparedSurface& area, const Point& from, const Point& to) {
  const Point along = to - from;
  std::vector<double> at{0, 1};
  area.cut(from, to, at);
  std::sort(at.begin(), at.end());
  for (std::size_t k = 1; k < at.size(); ++k) {
    if ((at[k] - at[k - 1]) * norm(along) <= shortest) continue;
    if (!area.reaches(from + along * ((at[k - 1] + at[k]) / 2))) return false;
  }
  return true;
}

// The shortest ways from a place along sights, as the place before each on them.
std::vector<int> ways_from(int start, const Distances& sights) {
  const int count = static_cast<int>(sights.size());
  std::vector<double> away(count, infinite);
  std::vector<int> before(count, -1);
  std::vector<bool> settled(count, false);
  away[start] = 0;
  for (int round = 0; round < count; ++round) {
    poll_cancel();
    int next = -1;
    for (int i = 0; i < count; ++i)
      if (!settled[i] && away[i] < infinite && (next < 0 || away[i] < away[next])) next = i;
    if (next < 0) break;
    settled[next] = true;
    for (int i = 0; i < count; ++i)
      if (away[next] + sights[next][i] < away[i]) {
        away[i] = away[next] + sights[next][i];
        before[i] = next;
      }
  }
  return before;
}

// Walks between places, and the ways along them.
class Ways {
 public:
  explicit Ways(std::size_t count) : metres_(count, std::vector<double>(count, infinite)) {
    for (std::size_t i = 0; i < count; ++i) metres_[i][i] = 0;
  }
  double metres(int from, int to) const { return metres_[from][to]; }
  void add(const AreaWalk& walk) {
    if (walk.metres >= metres_[walk.from][walk.to]) return;
    const std::vector<double> from_start = metres_[walk.from], from_end = metres_[walk.to];
    for (std::vector<double>& row : metres_) {
      const double along = row[walk.from] + walk.metres, back = row[walk.to] + walk.metres;
      for (std::size_t i = 0; i < row.size(); ++i)
        row[i] = std::min({row[i], along + from_end[i], back + from_start[i]});
    }
  }

 private:
  Distances metres_;
};

}  // namespace

std::vector<AreaWalk> walks_over_area(const MultiPolygon& area, const std::vector<Point>& places,
                                      const std::vector<AreaWalk>& there, double detour) {
  std::vector<Point> points = places;
  for (const Polygon& polygon : area)
    for (const Ring& ring : polygon) add_inward_bends(ring, points);
  const PreparedSurface ground(area);
  Distances sights(points.size(), std::vector<double>(points.size(), infinite));
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      poll_cancel();
      if (sees(ground, points[i], points[j]))
        sights[i][j] = sights[j][i] = distance(points[i], points[j]);
    }
  }
  std::vector<AreaWalk> found;
  for (int from = 0; from < static_cast<int>(places.size()); ++from) {
    const std::vector<int> before = ways_from(from, sights);
    for (int to = from + 1; to < static_cast<int>(places.size()); ++to) {
      if (before[to] < 0) continue;
      AreaWalk walk{from, to, {}, 0};
      for (int at = to; at >= 0; at = before[at]) walk.line.push_back(points[at]);
      std::reverse(walk.line.begin(), walk.line.end());
      walk.metres = length(walk.line);
      if (walk.metres > shortest) found.push_back(std::move(walk));
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const AreaWalk& a, const AreaWalk& b) { return a.metres < b.metres; });
  Ways ways(places.size());
  for (const AreaWalk& walk : there) {
    poll_cancel();
    ways.add(walk);
  }
  std::vector<AreaWalk> missed;
  for (AreaWalk& walk : found) {
    poll_cancel();
    const double round = ways.metres(walk.from, walk.to);
    if (round <= detour * walk.metres || round - walk.metres <= worth_it) continue;
    ways.add(walk);
    missed.push_back(std::move(walk));
  }
  return missed;
}

}  // namespace streetgen
