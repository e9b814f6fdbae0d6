#include "interconnection/look_ahead.hpp"

#include <cstdlib>
#include <optional>

#include "interconnection/merging_way.hpp"
#include "interconnection/only_way.hpp"

namespace streetgen {

namespace {

// Metres, of a path without which one would stand on the wrong lane: two of them turn back over a
// median as one of twice the radius does.
constexpr double tightest_radius = 2;

template <class Take>
void each_pair(const Way& way, Take take) {
  for (int in = 0; in < static_cast<int>(way.from->in.size()); ++in)
    for (int out = 0; out < static_cast<int>(way.to->out.size()); ++out) take(in, out);
}

struct LanePair {
  int in = 0, out = 0;
};

bool wide_enough(const Way& way, int in, int out) {
  return !way.tight(in, out) ||
         (way.drivable(in, out) && way.movement->radius[way.pair(in, out)] >= tightest_radius);
}

// The pair nearest to those that are plausible, from a lane that takes the way to one that serves
// some of what is missing.
std::optional<LanePair> nearest_to(const Ways& of_node, const Way& way, unsigned missing,
                                   const std::vector<LanePair>& taken) {
  std::optional<LanePair> best;
  int least = 0;
  each_pair(way, [&](int in, int out) {
    if (!(way.to->out[out].ahead & missing) || !for_cars(way, in, out) ||
        !wide_enough(way, in, out) || way.forbidden(in, out) || way.from->in[in].middle ||
        crosses_beside(of_node, way, in, out))
      return;
    bool takes = false, crosses = false;
    int aside = 0;
    for (const LanePair& pair : taken) {
      takes = takes || pair.in == in;
      crosses = crosses || (pair.in - in) * (pair.out - out) < 0;
      if (pair.in == in) aside = std::abs(pair.out - out);
    }
    if (!takes || crosses || (best && aside >= least)) return;
    best = {in, out};
    least = aside;
  });
  return best;
}

}  // namespace

void look_ahead(const Ways& of_node) {
  for (const Way& way : of_node) {
    if (way.turns_back() || way.movement->forbidden(LaneKind::general)) continue;
    unsigned missing = 0;
    for (const LaneEnd& lane : way.to->out) missing |= lane.ahead;
    if (missing == 0) continue;
    std::vector<LanePair> taken;
    each_pair(way, [&](int in, int out) {
      if (!way.at(in, out).plausible || !for_cars(way, in, out)) return;
      taken.push_back({in, out});
      missing &= ~way.to->out[out].ahead;
    });
    while (missing != 0) {
      const std::optional<LanePair> pair = nearest_to(of_node, way, missing, taken);
      if (!pair) break;
      way.at(pair->in, pair->out) = {true, Reason::look_ahead};
      taken.push_back(*pair);
      missing &= ~way.to->out[pair->out].ahead;
    }
  }
}

}  // namespace streetgen
