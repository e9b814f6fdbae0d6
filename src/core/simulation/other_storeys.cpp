#include "simulation/other_storeys.hpp"

#include <algorithm>
#include <cmath>

#include "support/infinite.hpp"

namespace streetgen {

void drop_other_storeys(const TrafficNetwork& network, double height,
                        std::vector<NearPlace>& near) {
  const auto apart = [&](const NearPlace& n) {
    return std::abs(frame(network, n.located.place).height - height);
  };
  double least = infinite;
  for (const NearPlace& n : near) least = std::min(least, apart(n));
  near.erase(std::remove_if(near.begin(), near.end(),
                            [&](const NearPlace& n) { return apart(n) > least + storey; }),
             near.end());
}

}  // namespace streetgen
