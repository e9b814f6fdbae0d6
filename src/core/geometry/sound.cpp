#include "streetgen/sound.hpp"

#include <algorithm>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/ring_simplicity.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double shortest = 1e-6;  // metres

}  // namespace

bool surely_valid(const MultiPolygon& surface) {
  return surface.size() == 1 && surface[0].size() == 1 && surface[0][0].size() > 3 &&
         simple(surface).value_or(false);
}

bool share_ground(const MultiPolygon& a, const MultiPolygon& b) {
  return overlap(PreparedSurface(a), PreparedSurface(b));
}

bool lies_on(const Line& line, const std::vector<MultiPolygon>& surfaces) {
  std::vector<PreparedSurface> grounds;
  grounds.reserve(surfaces.size());
  for (const MultiPolygon& surface : surfaces) grounds.emplace_back(surface);
  for (std::size_t i = 1; i < line.size(); ++i) {
    poll_cancel();
    const Point from = line[i - 1], along = line[i] - from;
    std::vector<double> at{0, 1};
    for (const PreparedSurface& ground : grounds) ground.cut(from, line[i], at);
    std::sort(at.begin(), at.end());
    for (std::size_t k = 1; k < at.size(); ++k) {
      // Between two places where a boundary is met, a piece lies wholly on a surface or off it.
      if ((at[k] - at[k - 1]) * norm(along) <= shortest) continue;
      const Point middle = from + along * ((at[k - 1] + at[k]) / 2);
      if (std::none_of(grounds.begin(), grounds.end(),
                       [&](const PreparedSurface& ground) { return ground.holds(middle); }))
        return false;
    }
  }
  return true;
}

}  // namespace streetgen
