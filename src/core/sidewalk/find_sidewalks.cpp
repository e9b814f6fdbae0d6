#include <cmath>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "sidewalk/shared_ground.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/sidewalk.hpp"

namespace streetgen {

namespace {

constexpr double noticed = 1e-3;  // square metres that a contested sidewalk has lost

double middle_width(const std::vector<WidthKnot>& widths) {
  return (widths.front().width + widths.back().width) / 2;
}

}  // namespace

std::vector<Sidewalk> find_sidewalks(const std::vector<SidewalkKerb>& kerbs, double transition) {
  const KerbChains chains(kerbs, transition);
  const std::vector<Strip> strips = strips_behind(kerbs, chains);
  SharedGround shared(kerbs, chains, strips);
  std::vector<Sidewalk> sidewalks;
  for (int i = 0; i < static_cast<int>(kerbs.size()); ++i) {
    if (!kerbs[i].wanted || strips[i].surface.empty()) continue;
    Sidewalk sidewalk;
    sidewalk.kerb = i;
    sidewalk.width = kerbs[i].width.value_or(middle_width(chains.widths(i)));
    if (strips[i].narrow) sidewalk.method = Method::contested;
    const std::vector<int> rivals = shared.rivals(i);
    if (rivals.empty() && strips[i].plain) {
      sidewalk.surface = strips[i].surface;
    } else {
      sidewalk.surface = shared.ground_of(i, rivals);
      const double lost = area(strips[i].surface) - area(sidewalk.surface);
      if (lost > noticed) sidewalk.method = Method::contested;
    }
    if (kerbs[i].by_hand) sidewalk.method = Method::by_hand;
    if (!sidewalk.surface.empty()) sidewalks.push_back(std::move(sidewalk));
  }
  return sidewalks;
}

}  // namespace streetgen
