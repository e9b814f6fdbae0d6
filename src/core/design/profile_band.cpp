#include "design/profile_band.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {
namespace {

constexpr int half_band = 7;
constexpr int band = 2 * half_band + 1;
// Cost of a metre by which a rule is broken, far above what any road costs.
constexpr double broken = 1e8;

using Band = std::array<double, band>;
using Sides = std::array<Band, band>;  // cost by height at the start and at the end

double side_cost(const DesignSite& site, const SectionCost& section, const ProfileSide& side,
                 double length, double from, double to) {
  double sum = 0;
  for (const GroundSample& s : side.samples) {
    const double cost =
        section.cost(from + s.share * (to - from) - s.ground, s.cross_slope, s.zone);
    sum += std::min(cost, 1e6);
  }
  sum *= side.samples.empty() ? 0 : length / side.samples.size();
  sum += site.rules.climb_cost * std::abs(to - from);
  const double excess = std::abs(to - from) - site.rules.grade * length;
  if (excess > 1e-9) sum += broken * excess;
  for (const HeightLimit& limit : side.limits) {
    const double height = from + limit.abscissa * (to - from);
    sum += broken * (std::max(0.0, limit.low - height) + std::max(0.0, height - limit.high));
  }
  return sum;
}

// The cost of a parabola between two grades that does not fit in half of both sides.
double bend_cost(const DesignRules& rules, double before, double after, double room) {
  const double change = after - before;
  const double excess = std::abs(change) * (change < 0 ? rules.crest : rules.sag) - room;
  return excess > 1e-9 ? broken * excess * 0.01 : 0;
}

}  // namespace

void improve_profile(const DesignSite& site, const SectionCost& section,
                     const std::vector<ProfileSide>& sides, double step,
                     std::vector<ProfileStation>& stations) {
  const std::size_t n = stations.size();
  const auto height = [&](std::size_t i, int k) {
    return stations[i].height + (stations[i].fixed ? 0 : (k - half_band) * step);
  };
  const auto allowed = [&](std::size_t i, int k) { return !stations[i].fixed || k == half_band; };
  const auto run = [&](std::size_t i) { return stations[i + 1].abscissa - stations[i].abscissa; };
  // best[a][b]: least cost of a way whose last two stations have heights a and b.
  Sides best;
  std::vector<std::array<std::array<std::int8_t, band>, band>> parents(n);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    poll_cancel();
    Sides side;
    for (int a = 0; a < band; ++a)
      for (int b = 0; b < band; ++b)
        side[a][b] = allowed(i, a) && allowed(i + 1, b) ? side_cost(site, section, sides[i], run(i),
                                                                    height(i, a), height(i + 1, b))
                                                        : infinite;
    if (i == 0) {
      best = side;
      continue;
    }
    const double room = std::min(run(i - 1), run(i));
    Sides next;
    for (int b = 0; b < band; ++b)
      for (int c = 0; c < band; ++c) {
        double least = infinite;
        int parent = half_band;
        if (side[b][c] < infinite)
          for (int a = 0; a < band; ++a) {
            if (!(best[a][b] < least)) continue;
            const double cost =
                best[a][b] + bend_cost(site.rules, (height(i, b) - height(i - 1, a)) / run(i - 1),
                                       (height(i + 1, c) - height(i, b)) / run(i), room);
            if (cost < least) least = cost, parent = a;
          }
        next[b][c] = least + side[b][c];
        parents[i + 1][b][c] = static_cast<std::int8_t>(parent);
      }
    best = next;
  }
  int b = half_band, c = half_band;
  for (int a = 0; a < band; ++a)
    for (int k = 0; k < band; ++k)
      if (best[a][k] < best[b][c]) b = a, c = k;
  for (std::size_t i = n - 1;; --i) {
    const double moved = height(i, c);
    const int before = i > 1 ? parents[i][b][c] : 0;
    stations[i].height = moved;
    if (i == 1) {
      stations[0].height = height(0, b);
      break;
    }
    c = b;
    b = before;
  }
}

}  // namespace streetgen
