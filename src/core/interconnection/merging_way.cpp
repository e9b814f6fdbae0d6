#include "interconnection/merging_way.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "interconnection/movement_angle.hpp"
#include "interconnection/turn.hpp"

namespace streetgen {

namespace {

constexpr double slanting = 35;  // degrees: who turns more gives way to all lanes of the street

bool slants_in(const Way& way, int in, int out) {
  const double angle = turn_angle(way.from->in[in].direction, way.to->out[out].direction);
  return in_steps(std::abs(angle)) <= in_steps(slanting);
}

// From where a movement comes, as its street that goes out looks back along itself: degrees, the
// greater, the farther to the left.
double comes_from(const Way& way) {
  const Point back = way.from->stand - way.to->stand;
  return norm(back) > 0 ? turn_angle(back, way.to->course * -1) : 0;
}

// Whether another way leads cars into the same street.
bool enters_beside(const Way& other, const Way& way) {
  return other.to == way.to && !other.movement->forbidden(LaneKind::general) && !other.turns_back();
}

// Of several ways straight on into one street that which keeps its lanes: as way_through.
const Way& main_into(const Ways& of_node, const Way& way) {
  const Way* main = &way;
  for (const Way& other : of_node)
    if (enters_beside(other, way) && other.nearly_straight() &&
        other.off_course() < main->off_course())
      main = &other;
  return *main;
}

}  // namespace

void leave_to_main(const Ways& of_node, Way& way) {
  if (!way.nearly_straight()) return;
  const Way& main = main_into(of_node, way);
  const int m = static_cast<int>(way.goals.size());
  if (main.from == way.from || m < 2) return;
  const int through = static_cast<int>(group_of(main.from->in, LaneKind::general).size());
  const int left = std::clamp(m - through, 1, m);
  if (comes_from(main) > comes_from(way))
    way.goals.erase(way.goals.begin(), way.goals.end() - left);
  else
    way.goals.erase(way.goals.begin() + left, way.goals.end());
}

std::optional<bool> entered_from_left(const Ways& of_node, const Way& way) {
  bool left = false, right = false;
  for (const Way& other : of_node)
    if (other.movement != way.movement && enters_beside(other, way))
      (comes_from(other) > comes_from(way) ? left : right) = true;
  return left == right ? std::nullopt : std::optional(left);
}

bool crosses_beside(const Ways& of_node, const Way& way, int in, int out) {
  if (!slants_in(way, in, out)) return false;
  for (const Way& other : of_node) {
    if (other.from == way.from || !enters_beside(other, way)) continue;
    const int side = comes_from(other) > comes_from(way) ? 1 : -1;
    for (int i = 0; i < static_cast<int>(other.from->in.size()); ++i)
      for (int o = 0; o < static_cast<int>(other.to->out.size()); ++o)
        if (other.at(i, o).plausible && slants_in(other, i, o) && (o - out) * side > 0) return true;
  }
  return false;
}

}  // namespace streetgen
