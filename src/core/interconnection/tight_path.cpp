#include "interconnection/tight_path.hpp"

#include <algorithm>
#include <cmath>

#include "interconnection/movement_angle.hpp"
#include "interconnection/only_way.hpp"

namespace streetgen {

namespace {

constexpr double sharp = 100;  // degrees: beyond it a tight movement is one that none takes

// Of an ordinary turn one path stays, however tight it is.
bool ordinary(const Way& way) {
  return std::min(std::abs(way.angle), std::abs(outset_angle(*way.from, *way.to))) <= sharp;
}

// Whether another path takes the movement: one for cars, where this one is.
bool taken_beside(const Way& way, int in, int out) {
  for (int i = 0; i < static_cast<int>(way.from->in.size()); ++i)
    for (int o = 0; o < static_cast<int>(way.to->out.size()); ++o)
      if (way.at(i, o).plausible && (i != in || o != out) &&
          (for_cars(way, i, o) || !for_cars(way, in, out)))
        return true;
  return false;
}

void drop_if_tight(const Ways& of_node, const Way& way, int in, int out) {
  Verdict& verdict = way.at(in, out);
  if (!verdict.plausible || !way.tight(in, out)) return;
  const bool corner = !way.drivable(in, out);
  if (!corner &&
      (verdict.reason == Reason::turn_lanes || (ordinary(way) && !taken_beside(way, in, out))))
    return;
  std::vector<LikelyPair> instead;
  const bool cars = for_cars(way, in, out);
  if (!leads_on(of_node, *way.from, in, cars, &verdict))
    instead.push_back(likeliest_on(of_node, *way.from, in, cars));
  if (!reached(of_node, *way.to, out, cars, &verdict))
    instead.push_back(likeliest_to(of_node, *way.to, out, cars));
  if (corner) verdict.reason = Reason::not_drivable;
  if (!std::all_of(instead.begin(), instead.end(), [](const LikelyPair& p) { return p.easy; }))
    return;
  for (const LikelyPair& pair : instead) *pair.verdict = {true, Reason::only_way};
  verdict = {false, corner ? Reason::not_drivable : Reason::radius};
}

}  // namespace

void drop_tight_paths(const Ways& of_node) {
  for (const Way& way : of_node)
    for (int i = 0; i < static_cast<int>(way.from->in.size()); ++i)
      for (int o = 0; o < static_cast<int>(way.to->out.size()); ++o)
        drop_if_tight(of_node, way, i, o);
}

}  // namespace streetgen
