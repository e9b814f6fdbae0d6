#include "lane/lane_taper.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

constexpr double same_share = 1e-9;  // of a width: what differs by less differs by rounding

// A lane that turns or merges so, and goes on no other way, lies on one side.
constexpr unsigned ends_on_left = turn::reverse | turn::leftwards | turn::merge_right;
constexpr unsigned ends_on_right = turn::rightwards | turn::merge_left;

enum class Class { driving, cycle, parking };

Class class_of(const LaneWish& lane) {
  if (lane.kind == LaneKind::cycle) return Class::cycle;
  return lane.kind == LaneKind::parking ? Class::parking : Class::driving;
}

// Indices of the lanes towards the node, or away from it, from left to right as one drives.
std::vector<int> driven(const LanesAtNode& at, bool towards_node) {
  const bool along_axis = towards_node != at.at_start;
  std::vector<int> lanes;
  for (int i = 0; i < static_cast<int>(at.lanes.size()); ++i)
    if (!at.lanes[i].both_ways && at.lanes[i].along_axis == along_axis) lanes.push_back(i);
  if (!along_axis) std::reverse(lanes.begin(), lanes.end());
  return lanes;
}

std::vector<int> of_class(const std::vector<LaneWish>& all, const std::vector<int>& lanes,
                          Class wanted) {
  std::vector<int> found;
  for (const int i : lanes)
    if (class_of(all[i]) == wanted) found.push_back(i);
  return found;
}

// The lanes that are too many, by the side of the others on which they lie.
struct Split {
  int left = 0, right = 0;
};

Split split(const std::vector<LaneWish>& all, const std::vector<int>& lanes, int too_many,
            DrivingSide side) {
  const auto marked = [&](int i, unsigned sideways) {
    const unsigned turns = all[i].turns;
    return (turns & sideways) != 0 && (turns & ~sideways) == 0;
  };
  const auto count = [&](auto from, auto to, unsigned sideways) {
    return static_cast<int>(std::find_if(from, to, [&](int i) { return !marked(i, sideways); }) -
                            from);
  };
  const int left = count(lanes.begin(), lanes.end(), ends_on_left);
  const int right = count(lanes.rbegin(), lanes.rend(), ends_on_right);
  if (side == DrivingSide::right) {
    const int outer = std::min(right, too_many), inner = std::min(left, too_many - outer);
    return {inner, too_many - inner};
  }
  const int outer = std::min(left, too_many), inner = std::min(right, too_many - outer);
  return {too_many - inner, inner};
}

std::vector<double> widths_at(const std::vector<double>& own, double width) {
  std::vector<double> widths;
  for (std::size_t i = 1; i < own.size(); ++i) widths.push_back((own[i] - own[i - 1]) * width);
  return widths;
}

// Ground beside the lanes takes what it can of a change, and leaves the rest of it.
void take(double& beside, double& change) {
  if (beside <= same_share) return;
  const double wider = std::max(0.0, beside + change);
  change -= wider - beside;
  beside = wider;
}

// In proportion to their widths.
void add(std::vector<double>& widths, const std::vector<int>& lanes, double change) {
  double total = 0;
  for (const int i : lanes) total += widths[i];
  for (const int i : lanes) widths[i] = std::max(0.0, widths[i] * (1 + change / total));
}

}  // namespace

ChangingLanes changing_lanes(const LanesAtNode& here, const LanesAtNode& there, DrivingSide side) {
  ChangingLanes changing;
  for (const bool towards : {true, false}) {
    const std::vector<int> all_mine = driven(here, towards), all_theirs = driven(there, !towards);
    for (const Class wanted : {Class::driving, Class::cycle, Class::parking}) {
      const std::vector<int> mine = of_class(here.lanes, all_mine, wanted);
      const std::vector<int> theirs = of_class(there.lanes, all_theirs, wanted);
      const int more = static_cast<int>(mine.size()) - static_cast<int>(theirs.size());
      if (more > 0) {
        const Split ends = split(here.lanes, mine, more, side);
        changing.ending.insert(changing.ending.end(), mine.begin(), mine.begin() + ends.left);
        changing.ending.insert(changing.ending.end(), mine.end() - ends.right, mine.end());
      } else if (more < 0 && !all_mine.empty()) {
        const Split begins = split(there.lanes, theirs, -more, side);
        const std::vector<int>& next = mine.empty() ? all_mine : mine;
        if (begins.left > 0) changing.beside.push_back(next.front());
        if (begins.right > 0) changing.beside.push_back(next.back());
      }
    }
  }
  const auto shared = [](const LanesAtNode& at) {
    return std::count_if(at.lanes.begin(), at.lanes.end(),
                         [](const LaneWish& lane) { return lane.both_ways; });
  };
  if (shared(here) > shared(there))
    for (int i = 0; i < static_cast<int>(here.lanes.size()); ++i)
      if (here.lanes[i].both_ways) changing.ending.push_back(i);
  for (std::vector<int>* lanes : {&changing.ending, &changing.beside}) {
    std::sort(lanes->begin(), lanes->end());
    lanes->erase(std::unique(lanes->begin(), lanes->end()), lanes->end());
  }
  return changing;
}

std::vector<LaneShares> tapered_shares(const LaneStrip& strip, const std::vector<double>& own,
                                       const TaperedLanes& tapered) {
  std::vector<LaneShares> borders(own.size());
  if (strip.profile.empty()) {
    for (std::size_t p = 0; p < own.size(); ++p) borders[p] = {own[p]};
    return borders;
  }
  for (const MergingStretch& stretch : strip.merging)
    borders.resize(borders.size() + stretch.lanes);
  const double middle = length(strip.axis) / 2;
  for (const WidthProfile::Place& place : strip.profile.places) {
    const double half = strip.half_at(place.abscissa);
    const auto merging = [&](int side) {
      std::vector<double> widths;
      for (const MergingStretch& stretch : strip.merging)
        if (stretch.side == side)
          widths.insert(widths.end(), stretch.lanes,
                        stretch.width_at(place.abscissa) / stretch.lanes);
      return widths;
    };
    const std::vector<double> first = merging(+1), last = merging(-1);
    const auto sum_of = [](const std::vector<double>& some) {
      return std::accumulate(some.begin(), some.end(), 0.0);
    };
    double left = place.left - sum_of(first) - half - strip.roadway_offset;
    double right = place.right - sum_of(last) - half + strip.roadway_offset;
    double beside_left = own.front() * 2 * half, beside_right = (1 - own.back()) * 2 * half;
    take(beside_left, left);
    take(beside_right, right);
    const ChangingLanes& end = place.abscissa < middle ? tapered.start : tapered.end;
    const std::vector<int>& lanes = left + right < 0 ? end.ending : end.beside;
    std::vector<double> widths = widths_at(own, 2 * half);
    std::vector<int> on_left, on_right;
    // One in the middle lies on neither side.
    for (const int i : lanes)
      if (const double aside = own[i] + own[i + 1] - 1; std::abs(aside) > same_share)
        (aside < 0 ? on_left : on_right).push_back(i);
    if (on_left.empty() || on_right.empty()) {
      add(widths, lanes, left + right);
    } else {
      add(widths, on_left, left);
      add(widths, on_right, right);
    }
    widths.insert(widths.begin(), first.begin(), first.end());
    widths.insert(widths.end(), last.begin(), last.end());
    const double total = beside_left + sum_of(widths) + beside_right;
    double sum = beside_left;
    for (std::size_t p = 0; p < borders.size(); ++p) {
      borders[p].push_back(p + 1 == borders.size() ? 1 - beside_right / total : sum / total);
      if (p < widths.size()) sum += widths[p];
    }
  }
  return borders;
}

}  // namespace streetgen
