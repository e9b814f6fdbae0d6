#include "interconnection/join_lanes.hpp"

#include "interconnection/approach.hpp"
#include "interconnection/look_ahead.hpp"
#include "interconnection/only_way.hpp"
#include "interconnection/tight_path.hpp"

namespace streetgen {

void join_lanes(const std::vector<Leg>& legs, std::vector<Movement>& movements) {
  const Ways ways = ways_of(legs, movements);
  for (const Leg& leg : legs) join_approach(ways, leg);
  reach_every_lane(ways, legs);
  drop_tight_paths(ways);
  look_ahead(ways);
}

}  // namespace streetgen
