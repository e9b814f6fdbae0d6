#include "interconnection/served_lanes.hpp"

#include <algorithm>
#include <cmath>

#include "interconnection/movement_angle.hpp"
#include "interconnection/turn.hpp"
#include "lane/turn_mark.hpp"

namespace streetgen {

namespace {

constexpr double slight = 0.9;  // of the angle of a slight turn: parallel lanes

void add(Group& group, const Group& more) {
  group.insert(group.end(), more.begin(), more.end());
  std::sort(group.begin(), group.end());
  group.erase(std::unique(group.begin(), group.end()), group.end());
}

std::size_t nearest_way(const Ways& ways, double angle) {
  return std::min_element(ways.begin(), ways.end(),
                          [&](const Way& a, const Way& b) {
                            return in_steps(std::abs(a.angle - angle)) <
                                   in_steps(std::abs(b.angle - angle));
                          }) -
         ways.begin();
}

std::size_t nearest_mark(const std::vector<double>& said, double angle) {
  return std::min_element(said.begin(), said.end(),
                          [&](double a, double b) {
                            return in_steps(std::abs(a - angle)) < in_steps(std::abs(b - angle));
                          }) -
         said.begin();
}

bool bears(const LaneEnd& lane, double angle) {
  if (lane.turns == 0) return angle == 0;
  return std::any_of(std::begin(marked_turns), std::end(marked_turns),
                     [&](const MarkedTurn& m) { return lane.turns & m.bit && m.angle == angle; });
}

// From left to right, the way straight on first.
std::vector<Group> in_order(const Group& lanes, const Ways& ways) {
  const int n = static_cast<int>(lanes.size()), k = static_cast<int>(ways.size());
  std::vector<Group> served(k);
  const auto serve = [&](int j, int first, int last) {
    for (int i = first; i < last; ++i) served[j].push_back(lanes[i]);
  };
  const auto width = [&](int j) { return static_cast<int>(ways[j].goals.size()); };
  const int through = way_through(ways);
  if (through < 0) {
    int total = 0, before = 0;
    for (int j = 0; j < k; ++j) total += width(j);
    for (int j = 0; j < k; ++j) {
      serve(j, n * before / total, (n * (before + width(j)) + total - 1) / total);
      before += width(j);
    }
    return served;
  }
  int left = 0, right = 0, extra = std::max(0, n - width(through));
  int left_wanted = 0, right_wanted = 0;
  for (int j = 0; j < through; ++j) left_wanted = std::max(left_wanted, width(j));
  for (int j = through + 1; j < k; ++j) right_wanted = std::max(right_wanted, width(j));
  while (extra > 0 && (left < left_wanted || right < right_wanted)) {
    const bool to_left = left < left_wanted && (left <= right || right == right_wanted);
    ++(to_left ? left : right);
    --extra;
  }
  serve(through, left, n - right);
  for (int j = 0; j < through; ++j) serve(j, 0, std::max(left, 1));
  for (int j = through + 1; j < k; ++j) serve(j, n - std::max(right, 1), n);
  return served;
}

// An outermost lane on which nothing is marked takes the turns on its side that no mark means.
void serve_unmarked(const std::vector<LaneEnd>& in, const Group& lanes,
                    const std::vector<std::size_t>& onwards, std::vector<Group>& served) {
  const auto serve = [&](int lane, auto first, auto last) {
    if (in[lane].turns == 0)
      for (auto j = first; j != last && served[*j].empty(); ++j) served[*j] = {lane};
  };
  serve(lanes.front(), onwards.begin(), onwards.end());
  serve(lanes.back(), onwards.rbegin(), onwards.rend());
}

std::vector<Group> by_marks(const std::vector<LaneEnd>& in, const Group& lanes, const Ways& ways) {
  std::vector<double> said;  // angles, from left to right
  std::vector<std::size_t> onwards;
  for (const MarkedTurn& mark : marked_turns)
    if ((said.empty() || said.back() != mark.angle) &&
        std::any_of(lanes.begin(), lanes.end(), [&](int i) { return bears(in[i], mark.angle); }))
      said.push_back(mark.angle);
  for (std::size_t j = 0; j < ways.size(); ++j)
    if (!ways[j].turns_back()) onwards.push_back(j);
  bool one_to_one = said.size() == onwards.size();
  for (std::size_t k = 0; one_to_one && k < said.size(); ++k)
    one_to_one = answers(ways[onwards[k]].angle, said[k]);
  std::vector<Group> served(ways.size());
  for (std::size_t k = 0; k < said.size(); ++k) {
    // As many marks as ways that answer them: one to one from left to right; else the way nearest
    // to the mark, and those of its kind that no mark is nearer to.
    std::vector<std::size_t> meant;
    if (one_to_one) {
      meant = {onwards[k]};
    } else {
      meant = {nearest_way(ways, said[k])};
      for (const std::size_t j : onwards)
        if (j != meant.front() && nearest_mark(said, ways[j].angle) == k &&
            turn_of(ways[j].angle) == turn_of(said[k] * slight))
          meant.push_back(j);
      std::sort(meant.begin(), meant.end());
    }
    Group bearing;
    Ways subset;
    for (const int i : lanes)
      if (bears(in[i], said[k])) bearing.push_back(i);
    for (const std::size_t j : meant) subset.push_back(ways[j]);
    const std::vector<Group> shared = in_order(bearing, subset);
    for (std::size_t j = 0; j < meant.size(); ++j) add(served[meant[j]], shared[j]);
  }
  serve_unmarked(in, lanes, onwards, served);
  for (std::size_t j = 0; j < ways.size(); ++j)
    if (ways[j].turns_back())
      for (const int i : lanes)
        if (in[i].turns & turn::reverse) add(served[j], {i});
  return served;
}

}  // namespace

unsigned marks_on(const std::vector<LaneEnd>& in, const Group& lanes) {
  unsigned marked = 0;
  for (const int i : lanes) marked |= in[i].turns;
  return marked;
}

std::vector<Group> served_lanes(const std::vector<LaneEnd>& in, const Group& lanes,
                                const Ways& ways) {
  return marks_on(in, lanes) ? by_marks(in, lanes, ways) : in_order(lanes, ways);
}

}  // namespace streetgen
