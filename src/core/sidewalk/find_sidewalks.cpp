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

}  // namespace

std::vector<Sidewalk> find_sidewalks(std::vector<SidewalkKerb> kerbs, double transition) {
  for (SidewalkKerb& kerb : kerbs) kerb.line = without_noise(kerb.line);
  const KerbChains chains(kerbs, transition);
  std::vector<Strip> strips = strips_behind(kerbs, chains);
  std::vector<Sidewalk> sidewalks;
  {
    SharedGround shared(kerbs, chains, strips);
    for (int i = 0; i < static_cast<int>(kerbs.size()); ++i) {
      if (!kerbs[i].wanted || strips[i].surface.empty()) continue;
      Sidewalk sidewalk;
      sidewalk.kerb = i;
      sidewalk.width =
          kerbs[i].width && kerbs[i].course.empty() ? *kerbs[i].width : strips[i].width;
      if (strips[i].narrow) sidewalk.method = Method::contested;
      const std::vector<int> rivals = shared.rivals(i);
      if (!rivals.empty() || !strips[i].plain) {
        sidewalk.surface = shared.ground_of(i, rivals);
        if (sidewalk.surface.empty()) continue;
        const double lost = area(strips[i].surface) - area(sidewalk.surface);
        if (lost > noticed) sidewalk.method = Method::contested;
      }
      if (kerbs[i].by_hand) sidewalk.method = Method::by_hand;
      sidewalks.push_back(std::move(sidewalk));
    }
  }
  // A strip that is all its own is moved, since those of a city take much memory.
  for (Sidewalk& sidewalk : sidewalks)
    if (sidewalk.surface.empty()) sidewalk.surface = std::move(strips[sidewalk.kerb].surface);
  return sidewalks;
}

}  // namespace streetgen
