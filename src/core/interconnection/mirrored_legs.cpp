#include "interconnection/mirrored_legs.hpp"

#include <algorithm>
#include <utility>

namespace streetgen {

namespace {

unsigned mirrored(unsigned turns) {
  unsigned out = turns & (turn::reverse | turn::through);
  for (const auto& [left, right] :
       {std::pair(turn::sharp_left, turn::sharp_right), std::pair(turn::left, turn::right),
        std::pair(turn::slight_left, turn::slight_right),
        std::pair(turn::merge_left, turn::merge_right)})
    out |= (turns & left ? right : 0) | (turns & right ? left : 0);
  return out;
}

void mirror(std::vector<LaneEnd>& lanes) {
  std::reverse(lanes.begin(), lanes.end());
  for (LaneEnd& lane : lanes) {
    lane.turns = mirrored(lane.turns);
    lane.place.y = -lane.place.y;
    lane.direction.y = -lane.direction.y;
    lane.aside = -lane.aside;
  }
}

}  // namespace

void mirror(std::vector<Leg>& legs, std::vector<Movement>& movements) {
  std::reverse(legs.begin(), legs.end());
  for (Leg& leg : legs) {
    mirror(leg.in);
    mirror(leg.out);
    leg.outset.y = -leg.outset.y;
    leg.course.y = -leg.course.y;
    leg.stand.y = -leg.stand.y;
  }
  const int last = static_cast<int>(legs.size()) - 1;
  std::reverse(movements.begin(), movements.end());
  for (Movement& movement : movements) {
    movement.from = last - movement.from;
    movement.to = last - movement.to;
    movement.side = -movement.side;
    std::reverse(movement.radius.begin(), movement.radius.end());
    std::reverse(movement.drivable.begin(), movement.drivable.end());
    std::reverse(movement.verdicts.begin(), movement.verdicts.end());
  }
}

}  // namespace streetgen
