#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/box.hpp"
#include "geometry/box_index.hpp"
#include "geometry/offset.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/walk_network.hpp"

namespace streetgen {

namespace {

constexpr double least_gap = 10;    // metres of a side between mapped stretches that get a walk
constexpr double beside_end = 0.5;  // metres; a place that is nearer to an end of a walk is there

class Walks {
 public:
  explicit Walks(const std::vector<WalkedKerb>& kerbs)
      : kerbs_(kerbs), next_(kerbs.size(), -1), previous_(kerbs.size(), -1) {
    BoxIndex starts;
    for (std::size_t k = 0; k < kerbs.size(); ++k)
      starts.add(box_of(kerbs[k].line.front(), kerbs[k].line.front()), static_cast<int>(k));
    for (std::size_t k = 0; k < kerbs.size(); ++k) {
      const Point& end = kerbs[k].line.back();
      for (const int n : starts.near(box_of(end, end), same_site))
        if (next_[k] < 0 && previous_[n] < 0) {
          next_[k] = n;
          previous_[n] = static_cast<int>(k);
        }
    }
    for (std::size_t k = 0; k < kerbs.size(); ++k)
      if (round_corner(static_cast<int>(k)) && !round_corner(previous_[k]))
        join_corner(static_cast<int>(k));
  }

  std::vector<BuiltWalk> behind_kerbs() const {
    std::vector<BuiltWalk> walks;
    for (std::size_t k = 0; k < kerbs_.size(); ++k) {
      poll_cancel();
      if (walked(static_cast<int>(k))) add_walks(static_cast<int>(k), walks);
    }
    return walks;
  }

  std::optional<BuiltWalk> across(const CrossedArm& arm) const {
    const int from = walk_beyond(arm.arrives, true), to = walk_beyond(arm.leaves, false);
    BuiltWalk walk;
    if (from >= 0 && to >= 0 && from != to) {
      walk.line = {end_of(from, from == arm.arrives), end_of(to, to != arm.leaves)};
      if (!arm.street.empty()) lead_over(arm.street, walk.line);
      walk.loose_start = mapped_at(from, from == arm.arrives);
      walk.loose_end = mapped_at(to, to != arm.leaves);
    } else if ((from >= 0 || to >= 0) && !arm.street.empty()) {
      const int side = from >= 0 ? from : to;
      const bool at_end = from >= 0 ? from == arm.arrives : to != arm.leaves;
      const Point place = end_of(side, at_end);
      walk.line = {place, position_at(arm.street, nearest_abscissa(place, arm.street)).point};
      walk.loose_start = mapped_at(side, at_end);
    }
    walk.line = distinct(planar(std::move(walk.line)));
    if (walk.line.size() < 2) return std::nullopt;
    return walk;
  }

 private:
  bool round_corner(int kerb) const {
    return kerb >= 0 && kerbs_[kerb].leads_on && kerbs_[kerb].offset > 0;
  }

  // The kerb of a corner may have several parts, and one walk goes round them.
  void join_corner(int first) {
    WalkedKerb& whole = kerbs_[first];
    double area = whole.offset * length(whole.line);
    for (int next = next_[first]; round_corner(next); next = next_[first]) {
      const Line& line = kerbs_[next].line;
      area += kerbs_[next].offset * length(line);
      whole.line.insert(whole.line.end(), line.begin() + 1, line.end());
      kerbs_[next].offset = 0;
      next_[first] = next_[next];
      if (next_[first] >= 0) previous_[next_[first]] = first;
    }
    whole.offset = area / length(whole.line);
  }

  // The kerb itself where somebody walks behind it; else the first one beyond a corner.
  int walk_beyond(int kerb, bool ahead) const {
    if (kerb < 0) return -1;
    if (kerbs_[kerb].offset > 0) return kerb;
    const int first = kerb;
    do {
      kerb = ahead ? next_[kerb] : previous_[kerb];
    } while (kerb >= 0 && kerb != first && kerbs_[kerb].leads_on);
    return kerb >= 0 && kerb != first && kerbs_[kerb].offset > 0 ? kerb : -1;
  }

  // The straight way from side to side may lead past the end of a street, as where streets bend.
  static void lead_over(const Line& street, Line& across) {
    for (std::size_t i = 1; i < street.size(); ++i)
      if (crossing(across[0], across[1], street[i - 1], street[i])) return;
    const Point middle = (across[0] + across[1]) * 0.5;
    across.insert(across.begin() + 1, position_at(street, nearest_abscissa(middle, street)).point);
  }

  // A corner is walked round where somebody walks at both of its ends, and a walk is missing there.
  bool walked(int kerb) const {
    if (kerbs_[kerb].offset <= 0) return false;
    if (!kerbs_[kerb].leads_on) return true;
    const int before = beside_corner(kerb, previous_), after = beside_corner(kerb, next_);
    return before >= 0 && after >= 0 && !(mapped_at(before, true) && mapped_at(after, false));
  }

  int beside_corner(int kerb, const std::vector<int>& towards) const {
    const int first = kerb;
    do {
      kerb = towards[kerb];
      if (kerb < 0 || kerb == first || kerbs_[kerb].offset <= 0) return -1;
    } while (kerbs_[kerb].leads_on);
    return kerb;
  }

  bool mapped_at(int kerb, bool at_end) const {
    const WalkedKerb& k = kerbs_[kerb];
    if (k.mapped.empty()) return false;
    return at_end ? k.mapped.back().second > length(k.line) - least_gap
                  : k.mapped.front().first < least_gap;
  }

  // The place where walks behind the kerb and the one beside it meet.
  Point end_of(int kerb, bool at_end) const {
    const int before = at_end ? kerb : previous_[kerb], after = at_end ? next_[kerb] : kerb;
    const Point& place = at_end ? kerbs_[kerb].line.back() : kerbs_[kerb].line.front();
    Point normal{};
    double offsets = 0;
    int walked = 0;
    const auto look = [&](int k, bool end) {
      if (k < 0 || kerbs_[k].offset <= 0) return;
      const Line& line = kerbs_[k].line;
      normal = normal + left_normal(local_direction(line, end ? length(line) : 0));
      offsets += kerbs_[k].offset;
      ++walked;
    };
    look(before, true);
    look(after, false);
    return planar(place + unit(normal) * (offsets / walked));
  }

  void add_walks(int kerb, std::vector<BuiltWalk>& walks) const {
    const WalkedKerb& k = kerbs_[kerb];
    const double whole = length(k.line);
    double from = 0;
    const auto add = [&](double to) {
      const bool loose_start = from > 0, loose_end = to < whole;
      if (to - from < ((loose_start || loose_end) ? least_gap : 0)) return;
      BuiltWalk walk;
      walk.kerb = kerb;
      walk.line = behind(kerb, from, to);
      walk.loose_start = loose_start || (k.leads_on && mapped_beside(previous_[kerb], true));
      walk.loose_end = loose_end || (k.leads_on && mapped_beside(next_[kerb], false));
      if (walk.line.size() > 1) walks.push_back(std::move(walk));
    };
    for (const auto& [start, end] : k.mapped) {
      add(std::max(start, from));
      from = std::max(from, end);
    }
    if (from < whole) add(whole);
  }

  bool mapped_beside(int kerb, bool at_end) const {
    return kerb >= 0 && !kerbs_[kerb].leads_on && mapped_at(kerb, at_end);
  }

  Line behind(int kerb, double from, double to) const {
    const WalkedKerb& k = kerbs_[kerb];
    const double whole = length(k.line);
    const Point start = from > 0 ? beside(k, from) : end_of(kerb, false);
    const Point end = to < whole ? beside(k, to) : end_of(kerb, true);
    Line line = planar(offset_line(planar(k.line), from, to, k.offset, k.offset));
    // About a corner that is tighter than the walk is far from it one walks straight.
    if (line.size() < 2 || length(line) > 2 * (to - from) + k.offset) line = {start, end};
    return led(std::move(line), start, end);
  }

  // From start to end, without turning back to what the line has beside them.
  static Line led(Line line, const Point& start, const Point& end) {
    Line out{start};
    for (const Point& p : line)
      if (distance(p, start) > beside_end && distance(p, end) > beside_end) out.push_back(p);
    out.push_back(end);
    return distinct(std::move(out));
  }

  static Point beside(const WalkedKerb& kerb, double abscissa) {
    const LinePosition at = position_at(kerb.line, abscissa);
    return planar(at.point + left_normal(at.direction) * kerb.offset);
  }

  std::vector<WalkedKerb> kerbs_;
  std::vector<int> next_, previous_;
};

}  // namespace

std::vector<BuiltWalk> built_walks(const std::vector<WalkedKerb>& kerbs,
                                   const std::vector<CrossedArm>& arms) {
  const Walks walks(kerbs);
  std::vector<BuiltWalk> all = walks.behind_kerbs();
  for (std::size_t a = 0; a < arms.size(); ++a)
    if (std::optional<BuiltWalk> walk = walks.across(arms[a])) {
      walk->arm = static_cast<int>(a);
      all.push_back(*std::move(walk));
    }
  return all;
}

}  // namespace streetgen
