#include "lane/lane_wishes.hpp"

#include <algorithm>

#include "lane/lane_layout.hpp"

namespace streetgen {

namespace {

bool marked(const LanesOfAxis& axis) {
  const auto turns = [](const LaneWish& lane) { return lane.turns != 0; };
  const AxisLanes& lanes = axis.lanes;
  return std::any_of(lanes.forward.begin(), lanes.forward.end(), turns) ||
         std::any_of(lanes.backward.begin(), lanes.backward.end(), turns);
}

}  // namespace

LaneWishes::LaneWishes(std::vector<LanesOfAxis> axes, std::vector<LaneOverride> overrides,
                       const std::vector<Circulation>& circulations, const LaneSettings& settings)
    : axes_(std::move(axes)),
      overrides_(std::move(overrides)),
      circulations_(circulations),
      settings_(settings) {
  std::sort(axes_.begin(), axes_.end(),
            [](const LanesOfAxis& a, const LanesOfAxis& b) { return a.axis_id < b.axis_id; });
  std::stable_sort(
      overrides_.begin(), overrides_.end(),
      [](const LaneOverride& a, const LaneOverride& b) { return a.axis_id < b.axis_id; });
}

bool LaneWishes::mark_any() const { return std::any_of(axes_.begin(), axes_.end(), marked); }

bool LaneWishes::on_ring(const Edge& edge) const {
  if (circulates(edge)) return true;
  const LanesOfAxis* axis = axis_of(edge);
  return axis != nullptr && axis->on_ring;
}

const LanesOfAxis* LaneWishes::axis_of(const Edge& edge) const {
  const auto axis = std::lower_bound(
      axes_.begin(), axes_.end(), edge.axis_id,
      [](const LanesOfAxis& a, std::int64_t axis_id) { return a.axis_id < axis_id; });
  return axis != axes_.end() && axis->axis_id == edge.axis_id ? &*axis : nullptr;
}

LaneWishes::OfEdge LaneWishes::of(const Edge& edge) const {
  const LanesOfAxis* axis = axis_of(edge);
  OfEdge found;
  found.lanes = across(axis != nullptr ? axis->lanes : AxisLanes{}, settings_.driving_side);
  if (const Circulation* circulation = circulations_.of(edge))
    turn_round(*circulation, found.lanes);
  // Long vehicles turn on the lanes of a ring.
  if (on_ring(edge))
    for (LaneWish& lane : found.lanes) lane.widest = 0;
  decide(edge, found);
  return found;
}

void LaneWishes::decide(const Edge& edge, OfEdge& found) const {
  const int count = static_cast<int>(found.lanes.size());
  found.decisions.resize(count);
  auto by_hand = std::lower_bound(
      overrides_.begin(), overrides_.end(), edge.axis_id,
      [](const LaneOverride& o, std::int64_t axis_id) { return o.axis_id < axis_id; });
  for (; by_hand != overrides_.end() && by_hand->axis_id == edge.axis_id; ++by_hand) {
    if (by_hand->abscissa < edge.start_abscissa || by_hand->abscissa >= edge.end_abscissa) continue;
    for (int p = 1; p <= count; ++p) {
      if (ordinality_of(p, count, settings_.order) != by_hand->ordinality) continue;
      LaneWish& wish = found.lanes[p - 1];
      if (by_hand->direction != LaneOverride::Direction::as_is) {
        wish.along_axis = by_hand->direction != LaneOverride::Direction::against;
        wish.both_ways = by_hand->direction == LaneOverride::Direction::both;
      }
      if (by_hand->width > 0) {
        wish.width = by_hand->width;
        wish.yields = false;
      }
      if (!by_hand->line.empty()) found.decisions[p - 1].line = &by_hand->line;
      found.decisions[p - 1].by_hand = true;
    }
  }
}

}  // namespace streetgen
