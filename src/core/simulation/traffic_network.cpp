#include "streetgen/traffic_network.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>
#include <utility>

#include "geometry/polyline.hpp"
#include "road/heading.hpp"
#include "simulation/lane_places.hpp"
#include "simulation/smooth_course.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "streetgen/link_conflict.hpp"

namespace streetgen {

namespace {

// Metres.  Lanes whose ends are no farther apart touch.
constexpr double touching = 0.1;
// Metres: length of a movement between lanes that touch.
constexpr double least_length = 1e-7;
// Friction between tyres and road times gravity, m/s2.
constexpr double grip = 0.7 * 9.81;
// Radians.  Where lanes that touch turn more, no heading lies between theirs.
constexpr double sharpest_touch = M_PI / 2;

std::string named(const TrafficLink& link) { return "link " + std::to_string(link.link_id); }

class Builder {
 public:
  explicit Builder(const TrafficSource& source) : source_(source) {}

  TrafficNetwork build() {
    network_.left_hand = source_.left_hand;
    order();
    join();
    bend_touching_ends();
    draw_courses();
    write_links();
    write_lists();
    return std::move(network_);
  }

 private:
  const TrafficLink& given(int link) const { return source_.links[order_[link]]; }

  int found(std::int64_t key) const {
    const auto at = index_.find(key);
    return at == index_.end() ? -1 : at->second;
  }

  // Links by their keys, without movements whose lanes are not there.
  void order() {
    std::unordered_map<std::int64_t, bool> lanes;
    for (const TrafficLink& link : source_.links)
      if (!link.movement) lanes.emplace(link.link_id, true);
    for (int i = 0; i < static_cast<int>(source_.links.size()); ++i) {
      const TrafficLink& link = source_.links[i];
      if (!link.movement || (lanes.count(link.lane_in) && lanes.count(link.lane_out)))
        order_.push_back(i);
    }
    std::sort(order_.begin(), order_.end(), [&](int a, int b) {
      return source_.links[a].link_id < source_.links[b].link_id;
    });
    for (int i = 0; i < static_cast<int>(order_.size()); ++i) {
      const TrafficLink& link = given(i);
      if (!index_.emplace(link.link_id, i).second)
        throw Error(ErrorKind::invalid_input, named(link) + " stands more than once in the list");
      if (link.movement) continue;
      if (length(link.line) == 0)
        throw Error(ErrorKind::invalid_input, named(link) + " has no length");
      if (link.edge < 0 || link.edge >= static_cast<int>(source_.edges.size()))
        throw Error(ErrorKind::invalid_input, named(link) + " has no edge");
    }
  }

  void join() {
    next_.resize(order_.size());
    before_.resize(order_.size());
    const auto follow = [&](int from, int to) {
      next_[from].push_back(to);
      before_[to].push_back(from);
    };
    for (int i = 0; i < static_cast<int>(order_.size()); ++i) {
      if (!given(i).movement) continue;
      follow(found(given(i).lane_in), i);
      follow(i, found(given(i).lane_out));
    }
  }

  double end_heading(int lane) const {
    const Line line = distinct(given(lane).line);
    return heading_of(line.back() - line[line.size() - 2]);
  }
  double start_heading(int lane) const {
    const Line line = distinct(given(lane).line);
    return heading_of(line[1] - line[0]);
  }

  // Each pair of lanes that touch bends its ends; at an end with several the straightest counts.
  void bend_touching_ends() {
    struct Touch {
      double turn;
      int movement;
    };
    std::vector<Touch> touches;
    for (int i = 0; i < static_cast<int>(order_.size()); ++i) {
      if (!given(i).movement || length(given(i).line) > touching) continue;
      const double from = end_heading(before_[i][0]), to = start_heading(next_[i][0]);
      const double turn = turn_from(along(from), along(to));
      if (std::abs(turn) < sharpest_touch) touches.push_back({turn, i});
    }
    std::stable_sort(touches.begin(), touches.end(), [](const Touch& a, const Touch& b) {
      return std::abs(a.turn) < std::abs(b.turn);
    });
    ends_.resize(order_.size());
    for (const Touch& touch : touches) {
      const int from = before_[touch.movement][0], to = next_[touch.movement][0];
      auto& leaving = ends_[from].heading_to;
      auto& entering = ends_[to].heading_from;
      if (!leaving && !entering) leaving = end_heading(from) + touch.turn / 2;
      if (!entering) entering = leaving;
      if (!leaving) leaving = entering;
    }
  }

  void draw_courses() {
    courses_.resize(order_.size());
    for (const bool movement : {false, true}) {
      for (int i = 0; i < static_cast<int>(order_.size()); ++i) {
        if (given(i).movement != movement) continue;
        poll_cancel();
        if (!movement)
          courses_[i] = lane_course(given(i).line, ends_[i]);
        else
          courses_[i] = movement_course(given(i).line, courses_[before_[i][0]],
                                        courses_[next_[i][0]], given(i).width);
        if (!courses_[i].empty()) continue;
        if (!movement)
          throw Error(ErrorKind::invalid_input, named(given(i)) + " turns back on itself");
        const auto& lane = courses_[before_[i][0]];
        courses_[i] = {{0, place_at(lane, length(lane)), least_length, 0, 0}};
      }
    }
  }

  double speed_of(int link) const {
    const TrafficLink& one = given(link);
    if (!one.movement) return one.speed;
    const double lanes = std::min(given(before_[link][0]).speed, given(next_[link][0]).speed);
    const auto radius = tightest_radius(courses_[link]);
    return radius ? std::min(lanes, std::sqrt(grip * *radius)) : lanes;
  }

  static int number_of(std::int64_t key, std::vector<std::int64_t>& keys,
                       std::unordered_map<std::int64_t, int>& numbers) {
    const auto [at, fresh] = numbers.emplace(key, static_cast<int>(keys.size()));
    if (fresh) keys.push_back(key);
    return at->second;
  }

  int straight_on(int link) const {
    int best = -1;
    double least = 0;
    for (const int next : next_[link]) {
      if (!given(link).movement && !given(next).movement) continue;
      const auto& course = courses_[next];
      const double turn =
          given(link).movement
              ? 0
              : std::abs(turn_from(along(course.front().start.heading),
                                   along(place_at(course, length(course)).heading)));
      if (best < 0 || turn < least - 1e-9) best = next, least = turn;
    }
    return best;
  }

  void write_links() {
    std::unordered_map<std::int64_t, int> nodes, junctions, plans;
    for (const SignalPlan& plan : source_.plans) {
      plans.emplace(plan.controller_id, static_cast<int>(network_.plans.size()));
      network_.plans.push_back(plan);
    }
    for (int i = 0; i < static_cast<int>(order_.size()); ++i) {
      const TrafficLink& one = given(i);
      Link link;
      link.link_id = one.link_id;
      link.length = std::max(length(one.line), least_length);
      link.stretch = length(courses_[i]) / link.length;
      link.speed = speed_of(i);
      link.width = one.width;
      link.stop = std::max(0.0, link.length - one.stop);
      const std::int64_t from = one.movement ? given(before_[i][0]).to_node : one.from_node;
      const std::int64_t to = one.movement ? given(next_[i][0]).from_node : one.to_node;
      link.from_node = number_of(from, network_.nodes, nodes);
      link.to_node = number_of(to, network_.nodes, nodes);
      if (one.junction != 0)
        link.junction = number_of(one.junction, network_.junctions, junctions);
      if (const auto plan = plans.find(one.controller); plan != plans.end())
        link.plan = plan->second;
      link.straight_on = straight_on(i);
      if (one.other_way != 0) link.opposite = found(one.other_way);
      link.traffic = one.traffic;
      link.movement = one.movement;
      network_.links.push_back(link);
    }
  }

  template <class Row>
  static void add_all(RowsOf<Row>& lists, const std::vector<Row>& rows) {
    for (const Row& row : rows) lists.add(row);
    lists.end_owner();
  }

  std::vector<std::vector<LinkBeside>> neighbours(const std::vector<LanePlaces>& places) const {
    std::vector<std::vector<LinkBeside>> lists(order_.size());
    for (const TrafficBeside& beside : source_.beside) {
      const int link = found(beside.link), other = found(beside.other);
      if (link < 0 || other < 0 || given(link).movement || given(other).movement)
        throw Error(ErrorKind::invalid_input,
                    "link " + std::to_string(link < 0 ? beside.link : beside.other) +
                        " lies beside another one, and is no lane");
      const auto stretches =
          stretches_beside(beside, places[place_[link]], places[place_[other]], other);
      lists[link].insert(lists[link].end(), stretches.begin(), stretches.end());
    }
    for (auto& list : lists)
      std::stable_sort(list.begin(), list.end(), [](const LinkBeside& a, const LinkBeside& b) {
        return a.from < b.from;
      });
    return lists;
  }

  // A movement climbs evenly from lane to lane.
  std::vector<std::vector<LinkHeight>> heights(const std::vector<LanePlaces>& places) const {
    std::vector<std::vector<LinkHeight>> lists(order_.size());
    for (int i = 0; i < static_cast<int>(order_.size()); ++i)
      if (!given(i).movement)
        lists[i] = lane_heights(source_.edges[given(i).edge], given(i), places[place_[i]]);
    for (int i = 0; i < static_cast<int>(order_.size()); ++i) {
      if (!given(i).movement) continue;
      const auto &in = lists[before_[i][0]], &out = lists[next_[i][0]];
      if (in.empty() || out.empty()) continue;
      lists[i] = {{0, in.back().height},
                  {static_cast<float>(network_.links[i].length), out.front().height}};
    }
    return lists;
  }

  // The junction of a movement, else its node.
  std::int64_t place_of(int link) const {
    return given(link).junction != 0 ? given(link).junction : given(before_[link][0]).to_node;
  }

  // A movement with what is known of its right of way.  States of a signal count by their times.
  ConflictMovement conflict_movement(int link) const {
    const TrafficLink& one = given(link);
    const TrafficLink &in = given(before_[link][0]), &out = given(next_[link][0]);
    ConflictMovement movement;
    movement.junction = place_of(link);
    movement.lane_in = std::min(in.link_id, in.other_way != 0 ? in.other_way : in.link_id);
    movement.lane_out = std::min(out.link_id, out.other_way != 0 ? out.other_way : out.link_id);
    movement.along_in = in.along;
    movement.along_out = out.along;
    movement.length = length(courses_[link]);
    movement.width = one.width;
    movement.course = pieces_of(link);
    movement.turn = one.turn;
    movement.rank = one.rank;
    movement.importance = one.importance;
    movement.precedence = one.precedence;
    for (std::size_t i = 0; i < one.aspects.size() && i < 64; ++i) {
      const std::uint64_t state = std::uint64_t{1} << i;
      if (one.aspects[i].aspect == Aspect::protected_green) movement.protected_states |= state;
      if (one.aspects[i].aspect == Aspect::permitted) movement.permitted_states |= state;
    }
    return movement;
  }

  static Precedence other_side(Precedence precedence) {
    if (precedence == Precedence::goes_first) return Precedence::gives_way;
    if (precedence == Precedence::gives_way) return Precedence::goes_first;
    return precedence;
  }

  std::vector<std::vector<LinkConflict>> conflicts() const {
    std::vector<int> links;
    std::vector<ConflictMovement> movements;
    for (int i = 0; i < static_cast<int>(order_.size()); ++i)
      if (given(i).movement) links.push_back(i);
    // Keys of movements come and go with edits: those of one junction are not beside each other.
    std::stable_sort(links.begin(), links.end(),
                     [&](int a, int b) { return place_of(a) < place_of(b); });
    for (const int link : links) movements.push_back(conflict_movement(link));
    std::vector<std::vector<LinkConflict>> lists(order_.size());
    const auto on_link = [&](int link, double metres) {
      return static_cast<float>(metres / network_.links[link].stretch);
    };
    for (const MovementConflict& pair : link_conflicts(movements, source_.left_hand)) {
      const int a = links[pair.first], b = links[pair.second];
      const float from_a = on_link(a, pair.first_from), to_a = on_link(a, pair.first_to);
      const float from_b = on_link(b, pair.second_from), to_b = on_link(b, pair.second_to);
      lists[a].push_back({b, pair.precedence, from_a, to_a, from_b, to_b});
      lists[b].push_back({a, other_side(pair.precedence), from_b, to_b, from_a, to_a});
    }
    return lists;
  }

  std::vector<LinkPiece> pieces_of(int link) const {
    std::vector<LinkPiece> pieces;
    for (const PlanPiece& piece : courses_[link])
      pieces.push_back({piece.s, piece.start.point.x, piece.start.point.y, piece.start.heading,
                        piece.curvature});
    return pieces;
  }

  void write_lists() {
    std::vector<LanePlaces> places;
    place_.assign(order_.size(), -1);
    for (int i = 0; i < static_cast<int>(order_.size()); ++i) {
      poll_cancel();
      if (given(i).movement) continue;
      place_[i] = static_cast<int>(places.size());
      places.emplace_back(source_.edges[given(i).edge], given(i));
    }
    const auto beside = neighbours(places);
    const auto climbs = heights(places);
    const auto meetings = conflicts();
    for (int i = 0; i < static_cast<int>(order_.size()); ++i) {
      add_all(network_.next, next_[i]);
      add_all(network_.before, before_[i]);
      add_all(network_.pieces, pieces_of(i));
      add_all(network_.heights, climbs[i]);
      add_all(network_.beside, beside[i]);
      add_all(network_.aspects, given(i).aspects);
      add_all(network_.conflicts, meetings[i]);
    }
  }

  const TrafficSource& source_;
  TrafficNetwork network_;
  std::vector<int> order_;  // of links: the rows of the source
  std::unordered_map<std::int64_t, int> index_;
  std::vector<std::vector<std::int32_t>> next_, before_;
  std::vector<ChainEnds> ends_;
  std::vector<std::vector<PlanPiece>> courses_;
  std::vector<int> place_;  // of lanes: where they are in a list of lanes
};

}  // namespace

TrafficNetwork traffic_network(const TrafficSource& source) { return Builder(source).build(); }

}  // namespace streetgen
