#include "lane/lane_change.hpp"

#include <algorithm>

namespace streetgen {

namespace {

struct Beside {
  const Lane& left;
  const Lane& right;
};

// The lanes on both sides of a line.  Of two merging lanes on different parts of an edge the outer
// one lies beside the lanes that go all along.
Beside lanes_beside(const std::vector<Lane>& lanes, int position) {
  const Lane &left = lanes[position - 1], &right = lanes[position];
  if (left.kind != LaneKind::merging || right.kind != LaneKind::merging ||
      (left.start == right.start && left.end == right.end))
    return {left, right};
  const auto goes_all_along = [](const Lane& lane) { return lane.kind != LaneKind::merging; };
  if (left.side == LaneSide::right) {
    const auto inner = std::find_if(lanes.rbegin(), lanes.rend(), goes_all_along);
    return {inner == lanes.rend() ? left : *inner, right};
  }
  const auto inner = std::find_if(lanes.begin(), lanes.end(), goes_all_along);
  return {left, inner == lanes.end() ? right : *inner};
}

bool one_traffic(const Lane& a, const Lane& b) {
  return carries_traffic(a.kind) && carries_traffic(b.kind) &&
         (a.kind == LaneKind::cycle) == (b.kind == LaneKind::cycle);
}

template <class Row>
bool of_lower_axis(const Row& a, const Row& b) {
  return a.axis_id < b.axis_id;
}

template <class Row>
auto rows_of(const std::vector<Row>& rows, std::int64_t axis_id) {
  Row wanted;
  wanted.axis_id = axis_id;
  return std::equal_range(rows.begin(), rows.end(), wanted, of_lower_axis<Row>);
}

}  // namespace

LaneChanges::LaneChanges(std::vector<LaneChange> by_hand, std::vector<LeavingOfAxis> leaving)
    : by_hand_(std::move(by_hand)), leaving_(std::move(leaving)) {
  std::stable_sort(by_hand_.begin(), by_hand_.end(), of_lower_axis<LaneChange>);
  std::stable_sort(leaving_.begin(), leaving_.end(), of_lower_axis<LeavingOfAxis>);
}

void LaneChanges::settle(const Edge& edge, const std::vector<Lane>& lanes,
                         std::vector<LaneSeparator>& separators) const {
  for (LaneSeparator& separator : separators) {
    separator.leftwards = separator.rightwards = separator.dashed;
    if (separator.kind != SeparatorKind::same_direction) continue;
    const auto& [left, right] = lanes_beside(lanes, separator.position);
    const Change rightwards = change(edge, lanes, left, right, separator.dashed);
    const Change leftwards = change(edge, lanes, right, left, separator.dashed);
    separator.leftwards = leftwards.allowed;
    separator.rightwards = rightwards.allowed;
    if (rightwards.said || leftwards.said)
      separator.dashed = rightwards.allowed || leftwards.allowed;
  }
}

LaneChanges::Change LaneChanges::change(const Edge& edge, const std::vector<Lane>& lanes,
                                        const Lane& from, const Lane& to, bool dashed) const {
  Change found;
  const auto [first, last] = rows_of(by_hand_, edge.axis_id);
  for (auto row = first; row != last; ++row)
    if (row->abscissa >= edge.start_abscissa && row->abscissa < edge.end_abscissa &&
        row->from == from.ordinality && row->to == to.ordinality)
      found = {true, row->allowed};
  if (found.said) return found;
  if (!one_traffic(from, to)) return {false, false};
  found = by_source(edge, lanes, from, to);
  return found.said ? found : Change{false, dashed};
}

LaneChanges::Change LaneChanges::by_source(const Edge& edge, const std::vector<Lane>& lanes,
                                           const Lane& from, const Lane& to) const {
  const auto [first, last] = rows_of(leaving_, edge.axis_id);
  if (first == last || from.along_axis != to.along_axis || from.kind == LaneKind::merging ||
      to.kind == LaneKind::merging)
    return {};
  const auto comes_before = [&](const Lane& lane) {
    return lane.along_axis == from.along_axis && drives(lane.kind) &&
           (from.along_axis ? lane.position < from.position : lane.position > from.position);
  };
  const auto place =
      static_cast<std::size_t>(std::count_if(lanes.begin(), lanes.end(), comes_before));
  const LeavingLanes& list = from.along_axis ? first->forward : first->backward;
  if (!drives(from.kind) || place >= list.size() || !list[place]) return {};
  const bool leftwards = (to.position < from.position) == from.along_axis;
  return {true, leftwards ? list[place]->left : list[place]->right};
}

}  // namespace streetgen
