#include "interconnection/plausibility.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "geometry/polyline.hpp"
#include "interconnection/mirrored_legs.hpp"
#include "interconnection/movement_angle.hpp"
#include "interconnection/turn.hpp"
#include "lane/lane_succession.hpp"
#include "lane/turn_mark.hpp"

namespace streetgen {

namespace {

constexpr double slight = 0.9;     // of the angle of a slight turn: parallel lanes
constexpr double sharp = 100;      // degrees: beyond it a tight movement is one that none takes
constexpr double noticeable = 20;  // degrees: a path that turns less has no tight radius
constexpr double most_off_course = 45;    // degrees, of a way that may be the one straight on
constexpr double importance_weight = 10;  // degrees that a step of importance is worth
constexpr int alone = 10;                 // lanes to what goes the same way, where nothing does

// The lanes of a leg that lead as those of one kind, by their index among all; those in the middle
// apart.
using Group = std::vector<int>;

// One movement as its approach sees it.
struct Way {
  Movement* movement;
  const Leg* to;
  double angle;   // of the movement; one that turns back is the outermost on its side
  double order;   // the greater, the farther to the left: by the angle and by where it leads
  Group goals{};  // where lanes of the kind that is assigned go on
};

Group group_of(const std::vector<LaneEnd>& lanes, LaneKind kind) {
  Group group;
  for (int i = 0; i < static_cast<int>(lanes.size()); ++i)
    if (leads_as(lanes[i].kind) == kind && !lanes[i].middle) group.push_back(i);
  return group;
}

Group middle_of(const std::vector<LaneEnd>& lanes) {
  Group group;
  for (int i = 0; i < static_cast<int>(lanes.size()); ++i)
    if (lanes[i].middle) group.push_back(i);
  return group;
}

// The lanes in which those of a kind go on: lanes of their kind, else the general ones.
Group targets(const Leg& leg, LaneKind kind) {
  Group same = group_of(leg.out, kind);
  return same.empty() && kind != LaneKind::general ? group_of(leg.out, LaneKind::general) : same;
}

class Plausibility {
 public:
  Plausibility(const std::vector<Leg>& legs, std::vector<Movement>& movements)
      : legs_(legs), movements_(movements) {}

  void run() {
    for (Movement& movement : movements_) {
      const Leg &from = legs_[movement.from], &to = legs_[movement.to];
      const double order = movement_order(from, to) + 360 * movement.side;
      movement.verdicts.resize(from.in.size() * to.out.size());
      ways_.push_back({&movement, &to, movement_angle(from, to), order});
    }
    for (int leg = 0; leg < static_cast<int>(legs_.size()); ++leg) approach(leg);
    reach_every_lane();
    drop_tight();
  }

 private:
  const Leg& from(const Way& way) const { return legs_[way.movement->from]; }
  static Verdict& at(const Way& way, int in, int out) {
    return way.movement->verdicts[in * way.to->out.size() + out];
  }
  static double radius(const Way& way, int in, int out) {
    return way.movement->radius[in * way.to->out.size() + out];
  }
  static bool turns_back(const Way& way) { return way.movement->turns_back; }
  // Of an ordinary turn one path stays, however tight it is.
  bool ordinary(const Way& way) const {
    return std::min(std::abs(way.angle), std::abs(outset_angle(from(way), *way.to))) <= sharp;
  }
  static bool drivable(const Way& way, int in, int out) {
    return way.movement->drivable[in * way.to->out.size() + out];
  }
  static bool tight(const Way& way, int in, int out) {
    return !drivable(way, in, out) ||
           (std::abs(way.angle) > noticeable && radius(way, in, out) < way.movement->least_radius);
  }

  void approach(int leg) {
    unsigned marked = 0;
    for (const LaneEnd& lane : legs_[leg].in) marked |= lane.turns;
    const Group middle = middle_of(legs_[leg].in);
    const std::vector<const Movement*> turns =
        middle.empty() ? std::vector<const Movement*>{} : turn_off(leg, middle);
    for (const LaneKind kind : {LaneKind::general, LaneKind::bus, LaneKind::cycle}) {
      const Group lanes = group_of(legs_[leg].in, kind);
      if (lanes.empty()) continue;
      std::vector<Way> open = open_ways(leg, lanes, kind, marked & turn::reverse);
      if (kind == LaneKind::general) leave_to_middle(lanes, turns, open);
      assign(lanes, kind, open);
    }
  }

  // From lanes in the middle traffic turns off to the left, or goes on to the middle of a street
  // that alone goes on.  Gives the movements that it takes.
  std::vector<const Movement*> turn_off(int leg, const Group& lanes) {
    std::vector<Way> open = open_ways(leg, lanes, LaneKind::general, false);
    for (const Way& way : open) judge_all(way, lanes, Reason::lane_kind);
    open.erase(
        std::remove_if(open.begin(), open.end(), [&](const Way& w) { return turns_back(w); }),
        open.end());
    const bool goes_on = open.size() == 1 && goes_on_alone(open.front());
    const int through = way_through(open);
    std::vector<const Movement*> taken;
    for (int j = 0; j < static_cast<int>(open.size()); ++j) {
      Way& way = open[j];
      const bool left = through < 0 ? way.angle > 0 : j < through;
      if (!goes_on && !left) continue;
      way.goals = goes_on ? middle_of(way.to->out) : targets(*way.to, LaneKind::general);
      if (way.goals.empty()) continue;
      connect(way, lanes, Reason::lane_order);
      if (!goes_on) taken.push_back(way.movement);
    }
    return taken;
  }

  // Who turns off from the middle does so from no lane beside it, unless it is marked or has no
  // other way.
  void leave_to_middle(const Group& lanes, const std::vector<const Movement*>& turns,
                       std::vector<Way>& open) const {
    const auto left_to_middle = [&](const Way& way) {
      return std::find(turns.begin(), turns.end(), way.movement) != turns.end();
    };
    for (const int i : lanes)
      if (from_lane(open, i).turns & turn::leftwards) return;
    if (std::all_of(open.begin(), open.end(), left_to_middle)) return;
    open.erase(std::remove_if(open.begin(), open.end(), left_to_middle), open.end());
  }

  // The ways that lanes of a kind may take, from left to right; of the others it says why not.
  std::vector<Way> open_ways(int leg, const Group& lanes, LaneKind kind, bool may_turn_back) {
    std::vector<Way> open;
    bool onwards = false;
    for (const Way& way : ways_)
      if (way.movement->from == leg && !way.movement->forbidden(kind))
        onwards = onwards || !turns_back(way);
    for (const Way& way : ways_) {
      if (way.movement->from != leg) continue;
      const bool back = onwards && turns_back(way) && !may_turn_back;
      if (way.movement->forbidden(kind) || back)
        judge_all(way, lanes, back ? Reason::u_turn : Reason::lane_kind);
      else
        open.push_back(way);
    }
    std::stable_sort(open.begin(), open.end(),
                     [](const Way& a, const Way& b) { return a.order > b.order; });
    return open;
  }

  // A restriction that holds is the reason.
  void judge_all(const Way& way, const Group& lanes, Reason reason) const {
    for (const int in : lanes)
      for (int out = 0; out < static_cast<int>(way.to->out.size()); ++out)
        at(way, in, out) = {false, forbidden(way, in, out) ? Reason::restriction : reason};
  }

  void assign(const Group& lanes, LaneKind kind, const std::vector<Way>& open) {
    std::vector<Way> ways;
    unsigned marked = 0;
    for (const int i : lanes) marked |= from_lane(open, i).turns;
    const Reason reason = marked ? Reason::turn_lanes : Reason::lane_order;
    for (const Way& way : open) {
      Group goals = targets(*way.to, kind);
      for (const int i : lanes)
        for (int o = 0; o < static_cast<int>(way.to->out.size()); ++o)
          at(way, i, o).reason =
              std::find(goals.begin(), goals.end(), o) == goals.end() ? Reason::lane_kind : reason;
      if (goals.empty()) continue;
      ways.push_back(way);
      ways.back().goals = std::move(goals);
    }
    if (ways.empty()) return;
    const auto served = marked ? serve_marked(lanes, ways) : serve_in_order(lanes, ways);
    for (std::size_t j = 0; j < ways.size(); ++j)
      if (!served[j].empty()) connect(ways[j], served[j], reason);
  }

  const LaneEnd& from_lane(const std::vector<Way>& ways, int i) const {
    static const LaneEnd none;
    return ways.empty() ? none : from(ways.front()).in[i];
  }

  // For each way, the lanes that take it: by what is marked on them.
  std::vector<Group> serve_marked(const Group& lanes, const std::vector<Way>& ways) const {
    std::vector<double> said;  // angles, from left to right
    std::vector<std::size_t> onwards;
    const auto bears = [&](int lane, double angle) {
      const unsigned turns = from_lane(ways, lane).turns;
      if (turns == 0) return angle == 0;
      return std::any_of(std::begin(marked_turns), std::end(marked_turns),
                         [&](const MarkedTurn& m) { return turns & m.bit && m.angle == angle; });
    };
    for (const MarkedTurn& mark : marked_turns)
      if ((said.empty() || said.back() != mark.angle) &&
          std::any_of(lanes.begin(), lanes.end(), [&](int i) { return bears(i, mark.angle); }))
        said.push_back(mark.angle);
    for (std::size_t j = 0; j < ways.size(); ++j)
      if (!turns_back(ways[j])) onwards.push_back(j);
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
      std::vector<Way> subset;
      for (const int i : lanes)
        if (bears(i, said[k])) bearing.push_back(i);
      for (const std::size_t j : meant) subset.push_back(ways[j]);
      const std::vector<Group> shared = serve_in_order(bearing, subset);
      for (std::size_t j = 0; j < meant.size(); ++j) add(served[meant[j]], shared[j]);
    }
    serve_unmarked(lanes, ways, onwards, served);
    for (std::size_t j = 0; j < ways.size(); ++j)
      if (turns_back(ways[j]))
        for (const int i : lanes)
          if (from_lane(ways, i).turns & turn::reverse) add(served[j], {i});
    return served;
  }

  // An outermost lane on which nothing is marked takes the turns on its side that no mark means.
  void serve_unmarked(const Group& lanes, const std::vector<Way>& ways,
                      const std::vector<std::size_t>& onwards, std::vector<Group>& served) const {
    const auto serve = [&](int lane, auto first, auto last) {
      if (from_lane(ways, lane).turns == 0)
        for (auto j = first; j != last && served[*j].empty(); ++j) served[*j] = {lane};
    };
    serve(lanes.front(), onwards.begin(), onwards.end());
    serve(lanes.back(), onwards.rbegin(), onwards.rend());
  }

  static void add(Group& group, const Group& more) {
    group.insert(group.end(), more.begin(), more.end());
    std::sort(group.begin(), group.end());
    group.erase(std::unique(group.begin(), group.end()), group.end());
  }

  static std::size_t nearest_way(const std::vector<Way>& ways, double angle) {
    return std::min_element(ways.begin(), ways.end(),
                            [&](const Way& a, const Way& b) {
                              return in_steps(std::abs(a.angle - angle)) <
                                     in_steps(std::abs(b.angle - angle));
                            }) -
           ways.begin();
  }

  static std::size_t nearest_mark(const std::vector<double>& said, double angle) {
    return std::min_element(said.begin(), said.end(),
                            [&](double a, double b) {
                              return in_steps(std::abs(a - angle)) < in_steps(std::abs(b - angle));
                            }) -
           said.begin();
  }

  // For each way, the lanes that take it: from left to right, the way straight on first.
  std::vector<Group> serve_in_order(const Group& lanes, const std::vector<Way>& ways) const {
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

  // The way that goes on nearest to straight, a change of importance set against the angle.
  int way_through(const std::vector<Way>& ways) const {
    int best = -1;
    long long least = 0;
    for (int j = 0; j < static_cast<int>(ways.size()); ++j) {
      if (!nearly_straight(ways[j])) continue;
      const long long cost = off_course(ways[j]);
      if (best >= 0 && cost >= least) continue;
      least = cost;
      best = j;
    }
    return best;
  }

  // In steps of an angle.
  long long off_course(const Way& way) const {
    return in_steps(std::abs(way.angle) +
                    importance_weight * std::abs(way.to->importance - from(way).importance));
  }

  // Lane by lane without crossing: lanes[i] goes on to goals[i + shift], the outermost twice.
  void connect(Way way, const Group& lanes, Reason reason) {
    leave_to_main(way);
    const Group& goals = way.goals;
    const int n = static_cast<int>(lanes.size()), m = static_cast<int>(goals.size());
    const int low = std::min(0, m - n), high = std::max(0, m - n);
    const auto goal = [&](int i, int shift) { return goals[std::clamp(i + shift, 0, m - 1)]; };
    int shift = 0;
    if (straight_on(way)) {
      shift = shift_straight_on(way, lanes, high);
    } else {
      // Along the kerb that it turns about, or as near to it as the radius allows.
      const int side = turns_back(way) ? (inner_left(way) ? 1 : -1) : (way.angle > 0 ? 1 : -1);
      const int first = side > 0 ? 0 : m - n;
      shift = first;
      for (int s = first; s >= low && s <= high; s += side) {
        bool fits = true;
        for (int i = 0; i < n; ++i) fits = fits && !tight(way, lanes[i], goal(i, s));
        if (fits) {
          shift = s;
          break;
        }
      }
    }
    for (int i = 0; i < n; ++i) {
      const int reached = drivable_goal(way, lanes[i], goal(i, shift));
      at(way, lanes[i], reached) = {true, reason};
      const int open = open_beside(way, lanes[i], reached);
      if (open >= 0) at(way, lanes[i], open) = {true, reason};
    }
  }

  bool straight_on(const Way& way) const {
    return turn_of(way.angle) == Turn::through || goes_on_alone(way);
  }

  static bool nearly_straight(const Way& way) {
    return in_steps(std::abs(way.angle)) <= in_steps(most_off_course);
  }

  // Of several ways straight on into one street that which keeps its lanes: as way_through.
  const Way& main_into(const Way& way) const {
    const Way* main = &way;
    for (const Way& other : ways_)
      if (other.to == way.to && !other.movement->forbidden(LaneKind::general) &&
          !turns_back(other) && nearly_straight(other) && off_course(other) < off_course(*main))
        main = &other;
    return *main;
  }

  // Who enters beside a street that goes on takes the lanes on his side, those that are left, so
  // that he crosses no path of it.
  void leave_to_main(Way& way) const {
    if (!nearly_straight(way)) return;
    const Way& main = main_into(way);
    const int m = static_cast<int>(way.goals.size());
    if (main.movement->from == way.movement->from || m < 2) return;
    const int through = static_cast<int>(group_of(from(main).in, LaneKind::general).size());
    const int left = std::clamp(m - through, 1, m);
    if (comes_from(main) > comes_from(way))
      way.goals.erase(way.goals.begin(), way.goals.end() - left);
    else
      way.goals.erase(way.goals.begin() + left, way.goals.end());
  }

  // The general lane nearest to a carpool lane in which a general lane goes on; -1: none is needed.
  int open_beside(const Way& way, int in, int reached) const {
    const auto general = [](const LaneEnd& lane) { return lane.kind == LaneKind::general; };
    if (!general(from(way).in[in]) || way.to->out[reached].kind != LaneKind::carpool) return -1;
    int best = -1;
    for (const int o : way.goals)
      if (general(way.to->out[o]) && !tight(way, in, o) &&
          (best < 0 || std::abs(o - reached) < std::abs(best - reached)))
        best = o;
    return best;
  }

  // In the place of a lane that no car comes to, the nearest one where the turn is wide enough.
  static int drivable_goal(const Way& way, int in, int wanted) {
    if (drivable(way, in, wanted)) return wanted;
    int best = -1;
    for (const int o : way.goals)
      if (!tight(way, in, o) && (best < 0 || std::abs(o - wanted) < std::abs(best - wanted)))
        best = o;
    return best < 0 ? wanted : best;
  }

  // Whether a street goes on as another, and neither leads elsewhere.
  bool goes_on_alone(const Way& way) const {
    return !turns_back(way) && std::all_of(ways_.begin(), ways_.end(), [&](const Way& other) {
      return other.movement == way.movement || turns_back(other) ||
             (other.movement->from != way.movement->from && other.to != way.to);
    });
  }

  // From where a movement comes, as its street that goes out looks back along itself: degrees, the
  // greater, the farther to the left.
  double comes_from(const Way& way) const {
    const Point back = from(way).stand - way.to->stand;
    return norm(back) > 0 ? turn_angle(back, way.to->course * -1) : 0;
  }

  // Lanes that others enter from one side are left to them; else lanes go on as they lie.
  int shift_straight_on(const Way& way, const Group& lanes, int high) const {
    if (high > 0) {
      bool from_left = false, from_right = false;
      for (const Way& other : ways_)
        if (other.to == way.to && other.movement != way.movement &&
            !other.movement->forbidden(LaneKind::general) && !turns_back(other))
          (comes_from(other) > comes_from(way) ? from_left : from_right) = true;
      if (from_left != from_right) return from_left ? high : 0;
    }
    const auto abreast = [](const std::vector<LaneEnd>& ends, const Group& group) {
      std::vector<LaneAbreast> found;
      for (const int i : group) found.push_back({ends[i].turns, ends[i].aside});
      return found;
    };
    return succession(abreast(from(way).in, lanes), abreast(way.to->out, way.goals),
                      DrivingSide::right);
  }

  // Whether the lanes beside the other direction are the left ones.
  bool inner_left(const Way& way) const {
    const auto &in = from(way).in, &out = way.to->out;
    return distance(in.front().place, out.front().place) <=
           distance(in.back().place, out.back().place);
  }

  bool spreads(int leg, int in, const Verdict* besides = nullptr) const {
    for (const Way& way : ways_)
      if (way.movement->from == leg)
        for (int o = 0; o < static_cast<int>(way.to->out.size()); ++o)
          if (at(way, in, o).plausible && &at(way, in, o) != besides) return true;
    return false;
  }

  bool reached(int leg, int out, const Verdict* besides = nullptr) const {
    for (const Way& way : ways_)
      if (way.movement->to == leg)
        for (int i = 0; i < static_cast<int>(from(way).in.size()); ++i)
          if (at(way, i, out).plausible && &at(way, i, out) != besides) return true;
    return false;
  }

  bool for_cars(const Way& way, int in, int out) const {
    return leads_as(from(way).in[in].kind) == LaneKind::general &&
           leads_as(way.to->out[out].kind) == LaneKind::general;
  }

  // Whether cars come to the pair and may not go on.
  bool leaves_cars_behind(const Way& way, int in, int out) const {
    return leads_as(from(way).in[in].kind) == LaneKind::general && !for_cars(way, in, out);
  }

  // Whether another path takes the movement: one for cars, where this one is.
  bool taken_beside(const Way& way, int in, int out) const {
    for (int i = 0; i < static_cast<int>(from(way).in.size()); ++i)
      for (int o = 0; o < static_cast<int>(way.to->out.size()); ++o)
        if (at(way, i, o).plausible && (i != in || o != out) &&
            (for_cars(way, i, o) || !for_cars(way, in, out)))
          return true;
    return false;
  }

  // Whether the lane takes the movement, to whichever lane.
  static bool takes(const Way& way, int in) {
    for (int o = 0; o < static_cast<int>(way.to->out.size()); ++o)
      if (at(way, in, o).plausible) return true;
    return false;
  }

  // The less, the likelier.  Of equals the first in the order of legs and lanes.
  using Cost = std::tuple<bool, bool, bool, bool, bool, long long>;

  // What else goes the same way: its distance from the pair, in lanes, and whether it crosses it.
  // Without any, the outermost lanes of the side to which one turns are the nearest.
  struct Astray {
    int lanes = 0;
    bool crosses = false;
  };
  Astray astray(const Way& way, int in, int out) const {
    const int n = static_cast<int>(from(way).in.size()), m = static_cast<int>(way.to->out.size());
    std::optional<int> nearest;
    bool crosses = false;
    for (int i = 0; i < n; ++i)
      for (int o = 0; o < m; ++o)
        if (at(way, i, o).plausible) {
          const int lanes = std::abs(i - in) + std::abs(o - out);
          nearest = std::min(nearest.value_or(lanes), lanes);
          crosses = crosses || (i - in) * (o - out) < 0;
        }
    if (nearest) return {*nearest, crosses};
    return {alone + (in_steps(way.angle) > 0 ? in + out : n - 1 - in + m - 1 - out), false};
  }

  Cost cost(const Way& way, int in, int out) const {
    const Verdict& verdict = at(way, in, out);
    const Astray beside = astray(way, in, out);
    return {verdict.reason == Reason::turn_lanes && !takes(way, in),
            turns_back(way),
            leaves_cars_behind(way, in, out),
            beside.crosses,
            tight(way, in, out),
            in_steps(std::abs(way.angle) + importance_weight * beside.lanes)};
  }

  bool forbidden(const Way& way, int in, int out) const {
    return way.movement->forbidden(from(way).in[in].kind, way.to->out[out].kind);
  }

  bool may(const Way& way, int i, int o) const {
    const LaneKind in = leads_as(from(way).in[i].kind), out = leads_as(way.to->out[o].kind);
    return !forbidden(way, i, o) && !from(way).in[i].middle && !way.to->out[o].middle &&
           (in == out || in == LaneKind::general || out == LaneKind::general);
  }

  struct Pair {
    Verdict* verdict = nullptr;
    bool easy = false;  // neither tight nor back
  };

  // Pairs that another kind of lane, or what is marked, would rule out are better than none.
  template <class Wanted>
  Pair likeliest(Wanted wanted) {
    Pair best;
    Cost least;
    for (const Way& way : ways_)
      for (int i = 0; i < static_cast<int>(from(way).in.size()); ++i)
        for (int o = 0; o < static_cast<int>(way.to->out.size()); ++o) {
          if (!wanted(way, i, o) || !may(way, i, o)) continue;
          const Cost now = cost(way, i, o);
          if (best.verdict && !(now < least)) continue;
          best = {&at(way, i, o), !tight(way, i, o) && !turns_back(way)};
          least = now;
        }
    return best;
  }

  Pair likeliest_on(int leg, int lane) {
    return likeliest(
        [&](const Way& way, int in, int) { return way.movement->from == leg && in == lane; });
  }

  Pair likeliest_to(int leg, int lane) {
    return likeliest([&](const Way& way, int, int out) {
      return way.movement->to == leg && out == lane && way.movement->from != leg;
    });
  }

  void reach_every_lane() {
    const auto add = [](const Pair& pair) {
      if (pair.verdict) *pair.verdict = {true, Reason::only_way};
    };
    for (int leg = 0; leg < static_cast<int>(legs_.size()); ++leg)
      for (int i = 0; i < static_cast<int>(legs_[leg].in.size()); ++i)
        if (!legs_[leg].in[i].middle && !spreads(leg, i)) add(likeliest_on(leg, i));
    for (int leg = 0; leg < static_cast<int>(legs_.size()); ++leg)
      for (int o = 0; o < static_cast<int>(legs_[leg].out.size()); ++o)
        if (!legs_[leg].out[o].middle && !reached(leg, o)) add(likeliest_to(leg, o));
  }

  // A tight path goes where both its lanes have another, or one that is neither tight nor back; of
  // an ordinary turn, its movement too. One with a corner says so where it stays as the only way.
  void drop_tight() {
    for (const Way& way : ways_)
      for (int i = 0; i < static_cast<int>(from(way).in.size()); ++i)
        for (int o = 0; o < static_cast<int>(way.to->out.size()); ++o) {
          Verdict& verdict = at(way, i, o);
          if (!verdict.plausible || !tight(way, i, o)) continue;
          const bool corner = !drivable(way, i, o);
          if (!corner &&
              (verdict.reason == Reason::turn_lanes || (ordinary(way) && !taken_beside(way, i, o))))
            continue;
          std::vector<Pair> instead;
          if (!spreads(way.movement->from, i, &verdict))
            instead.push_back(likeliest_on(way.movement->from, i));
          if (!reached(way.movement->to, o, &verdict))
            instead.push_back(likeliest_to(way.movement->to, o));
          if (corner) verdict.reason = Reason::not_drivable;
          if (!std::all_of(instead.begin(), instead.end(), [](const Pair& p) { return p.easy; }))
            continue;
          for (const Pair& pair : instead) *pair.verdict = {true, Reason::only_way};
          verdict = {false, corner ? Reason::not_drivable : Reason::radius};
        }
  }

  const std::vector<Leg>& legs_;
  std::vector<Movement>& movements_;
  std::vector<Way> ways_;
};

// No car drives on its street, whichever way.
bool closed_to_cars(const Leg& leg) {
  const auto open = [](const LaneEnd& lane) { return leads_as(lane.kind) == LaneKind::general; };
  return std::none_of(leg.in.begin(), leg.in.end(), open) &&
         std::none_of(leg.out.begin(), leg.out.end(), open);
}

// Whether traffic of a kind goes there from a general lane where others may not.
bool lets_in(const std::vector<Leg>& legs, const Movement& movement, LaneKind kind) {
  const Leg& to = legs[movement.to];
  if (movement.forbidden(kind)) return false;
  return movement.forbidden(LaneKind::general) ||
         (closed_to_cars(to) && !group_of(to.out, kind).empty());
}

// As traffic of a kind sees them: its own lanes and those for all are alike, unless it has both.
std::vector<Leg> seen_by(std::vector<Leg> legs, LaneKind kind) {
  for (Leg& leg : legs) {
    const bool own = closed_to_cars(leg);
    for (std::vector<LaneEnd>* lanes : {&leg.in, &leg.out})
      for (LaneEnd& lane : *lanes)
        if (own && lane.kind == kind) lane.kind = LaneKind::general;
  }
  return legs;
}

// Permission belongs to traffic and path: whoever may go where others may not does so from the
// lanes for all too, as though all might.
void let_in(const std::vector<Leg>& legs, std::vector<Movement>& movements, LaneKind kind) {
  const auto wanted = [&](const Movement& m) { return lets_in(legs, m, kind); };
  if (std::none_of(movements.begin(), movements.end(), wanted)) return;
  std::vector<Movement> tried = movements;
  for (Movement& movement : tried) {
    const bool forbidden = movement.forbidden(kind);
    movement.restricted.reset();
    if (forbidden) movement.restricted.set();
    movement.verdicts.clear();
  }
  const std::vector<Leg> seen = seen_by(legs, kind);
  Plausibility(seen, tried).run();
  for (std::size_t m = 0; m < movements.size(); ++m) {
    if (!wanted(movements[m])) continue;
    const std::vector<LaneEnd>&in = legs[movements[m].from].in, &out = legs[movements[m].to].out;
    for (std::size_t p = 0; p < movements[m].verdicts.size(); ++p) {
      Verdict& verdict = movements[m].verdicts[p];
      const LaneKind to = out[p % out.size()].kind;
      const bool for_all = leads_as(to) == LaneKind::general;
      const bool open = verdict.plausible && verdict.traffic.none() && for_all;
      if (leads_as(in[p / out.size()].kind) != LaneKind::general || open ||
          !tried[m].verdicts[p].plausible || !(for_all || to == kind))
        continue;
      verdict.plausible = true;
      verdict.reason = Reason::traffic;
      verdict.traffic.set(index_of(kind));
    }
  }
}

void choose(const std::vector<Leg>& legs, std::vector<Movement>& movements) {
  Plausibility(legs, movements).run();
  for (const LaneKind kind : {LaneKind::bus, LaneKind::carpool, LaneKind::cycle})
    let_in(legs, movements, kind);
}

}  // namespace

LaneKinds traffic_of(const Verdict& verdict, LaneKind in, LaneKind out) {
  if (verdict.traffic.any()) return verdict.traffic;
  const auto general = [](LaneKind kind) {
    return kind == LaneKind::general || kind == LaneKind::merging;
  };
  const LaneKind kind = !general(in) ? in : general(out) ? LaneKind::general : out;
  return LaneKinds().set(index_of(kind));
}

void choose_lanes(const std::vector<Leg>& legs, std::vector<Movement>& movements,
                  DrivingSide driving_side) {
  if (driving_side == DrivingSide::right) {
    choose(legs, movements);
    return;
  }
  std::vector<Leg> seen = legs;
  mirror(seen, movements);
  choose(seen, movements);
  mirror(seen, movements);
}

}  // namespace streetgen
