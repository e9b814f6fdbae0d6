// Cars on the links of a city, for programs that simulate traffic.  Wilkie, Sewall and Lin,
// section 3.1.
//
// A link is a lane in one direction, or a movement: the path of a car from lane to lane at a
// junction.  The lanes inside of a junction are no links.  A place is a link and metres along it in
// the direction of its traffic.  A car is at the place of its front.  This header needs the
// standard library alone: a simulator of one's own needs nothing else.
//
// Lengths are metres, times seconds, speeds metres a second, angles radians counter-clockwise from
// east.  Left and right are those of a driver.  Indices count from 0; -1 is none.  A network is as
// its maker fills it: an index of a link that it lacks is refused (invalid_input), also each
// number that is not finite.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace streetgen {

// Lists of many owners in one array.
template <class Row>
struct RowsOf {
  struct List {
    const Row* first;
    const Row* last;
    const Row* begin() const { return first; }
    const Row* end() const { return last; }
    int size() const { return static_cast<int>(last - first); }
    bool empty() const { return first == last; }
    const Row& operator[](int i) const { return first[i]; }
  };

  std::vector<std::int32_t> starts{0};  // the first row of each owner, and the number of all rows
  std::vector<Row> rows;

  // An owner beyond the last one has none.
  List of(int owner) const {
    if (owner + 1 >= static_cast<int>(starts.size())) return {nullptr, nullptr};
    return {rows.data() + starts[owner], rows.data() + starts[owner + 1]};
  }
  // The rows of one owner are added together, and owners in their order.
  void add(const Row& row) { rows.push_back(row); }
  void end_owner() { starts.push_back(static_cast<std::int32_t>(rows.size())); }
};

// Kinds of traffic, as bits.
namespace traffic {
constexpr std::uint8_t car = 1, bus = 2, carpool = 4, cycle = 8, all = 15;
}

struct Link {
  std::int64_t link_id = 0;  // key of the view `link`
  double length = 0;         // positive
  double stretch = 1;        // metres of its course a metre of its length
  float speed = 0;           // that is allowed
  float width = 0;           // of the lane; of a movement that of the lane it leads to
  float stop = 0;            // where a car waits that may not leave it, metres along the link
  std::int32_t from_node = -1, to_node = -1;  // a movement has its node, or nodes, of the junction
  std::int32_t junction = -1;                 // that a movement crosses; that a lane leads to
  std::int32_t plan = -1;                     // signal plan that a movement obeys
  // The next link of who knows no route: the movement that turns least, of equal ones that of the
  // smallest key; of a movement its lane.
  std::int32_t straight_on = -1;
  // The other direction of a lane for both directions: it lies on the same ground, from end to
  // start.  A movement has none.
  std::int32_t opposite = -1;
  std::uint8_t traffic = traffic::all;
  bool movement = false;
};

// A piece of the course of a link: a straight line, or an arc where it has a curvature.  It ends
// where the next one begins, or with the course.
struct LinkPiece {
  double metres = 0;  // along the course, where it begins
  double x = 0, y = 0, heading = 0;
  double curvature = 0;  // one by metres, positive to the left
};

struct LinkHeight {
  float metres = 0, height = 0;  // straight in between
};

// A stretch beside which another link lies, both in parts of equal shares.
struct LinkBeside {
  std::int32_t link = -1;
  bool left = false;
  bool may_change = false;  // whether a car may change to it
  bool opposite = false;    // whether its traffic comes towards: its places then fall
  float from = 0, to = 0;   // metres along this link
  float other_from = 0, other_to = 0;
};

// The right of one movement against another one that needs some of its ground.
enum class Precedence : std::uint8_t {
  goes_first,  // the other one gives way
  gives_way,
  by_arrival,  // neither has the right: who comes first goes first
  by_signal,   // they never have green together
};

struct LinkConflict {
  std::int32_t link = -1;  // the other movement
  Precedence precedence = Precedence::by_arrival;
  // A car of usual width stands on ground that both need between these, metres along this link.
  // Its front comes there at the first, and its rear leaves at the second.
  float from = 0, to = 0;
  float other_from = 0, other_to = 0;
};

enum class Aspect : std::uint8_t { none, red, amber, permitted, protected_green };

struct SignalPlan {
  std::int64_t controller_id = 0;
  float cycle = 0;         // positive
  float start_offset = 0;  // when a cycle begins
};

// What a movement is shown from `since` on, seconds of the cycle, to the next such row or the end
// of the cycle.
struct SignalAspect {
  float since = 0;
  Aspect aspect = Aspect::red;
};

struct TrafficNetwork {
  std::vector<Link> links;    // by link_id
  RowsOf<std::int32_t> next;  // links that a link leads to; a movement leads to one
  RowsOf<std::int32_t> before;
  RowsOf<LinkPiece> pieces;
  RowsOf<LinkHeight> heights;  // none: the link is flat
  RowsOf<LinkBeside> beside;   // by from
  RowsOf<LinkConflict> conflicts;
  RowsOf<SignalAspect> aspects;  // by since; none: the link has no signal
  std::vector<SignalPlan> plans;
  std::vector<std::int64_t> nodes, junctions;  // their keys
  bool left_hand = false;                      // traffic keeps left

  int size() const { return static_cast<int>(links.size()); }
};

// Refuses (invalid_input) a network of which a list has not a part for each link, an index is none
// of the network, a number is not finite, a length or cycle is not positive, or links do not go on
// from lane to movement and to lane.
void require_sound(const TrafficNetwork& network);

struct LinkPlace {
  std::int32_t link = -1;
  double metres = 0;
};

// The index of the link of a key; -1: none.  Links are in the order of their keys.
int link_of(const TrafficNetwork& network, std::int64_t link_id);

// What a signal shows a link at a time, before or after the start of its plan.  Before the first
// row of a cycle the last one holds.  A link without rows: none.
Aspect aspect_at(const TrafficNetwork& network, int link, double time);

// How a car stands whose rear axle is at a place.  A link without a piece: zeros.
struct LinkFrame {
  double x = 0, y = 0, height = 0;
  double heading = 0;    // from -pi to pi
  double curvature = 0;  // one by metres, positive to the left
  double steering = 0;   // angle of the front wheels, radians, positive to the left
  double grade = 0;      // of the link, metres of height a metre, positive uphill
};

// At a place of a link, clamped.  The steering angle is that of a car with `wheelbase` metres
// between its axles on this curvature.
LinkFrame frame(const TrafficNetwork& network, const LinkPlace& place, double wheelbase = 2.7);

// The place beside a place that is clamped to its link, on the link to its left or right; link -1:
// none there.  Where two stretches meet, the first one counts.
struct NeighbourPlace {
  LinkPlace place;
  bool may_change = false;  // whether a car may change there
  bool opposite = false;    // whether the traffic there comes towards
};
NeighbourPlace beside(const TrafficNetwork& network, const LinkPlace& place, bool left);

// The place of the nearest link, no farther than `reach` metres; link -1: none.  A link has ground
// half its width to each side of its course.  Where a point lies on the ground of several links and
// a height is given, links count up to `storey` metres farther in height than the nearest one.  A
// heading that is given makes a link `metres_a_radian` farther for each radian that it leads
// elsewhere.  Of links that are equally near within a micrometre that of the smallest key counts.  Refused (invalid_input):
// numbers that are not finite, a reach below 0.
constexpr double storey = 2, metres_a_radian = 3;
struct LocatedPlace {
  LinkPlace place;
  double offset = 0;  // metres to the left of the link there
};
// The place of a link that is nearest to a point.
struct NearPlace {
  LocatedPlace located;
  double distance = 0, heading = 0;  // of the link there, radians
};
class LinkPlaces {
 public:
  // The network stays as it is and where it is.
  explicit LinkPlaces(const TrafficNetwork& network);
  ~LinkPlaces();
  LinkPlaces(LinkPlaces&&) noexcept;
  LinkPlaces& operator=(LinkPlaces&&) noexcept;

  LocatedPlace locate(double x, double y, double reach, std::optional<double> heading = {},
                      std::optional<double> height = {}) const;
  // Each link no farther than `reach` metres once, by index, whatever its height.  Refused as above.
  std::vector<NearPlace> near(double x, double y, double reach) const;

 private:
  struct Index;
  std::unique_ptr<const Index> index_;
};

// The links that lie ahead of a place, the first its own, as far as `horizon` metres: those of a
// route where the place is on it, then and else straight on.  A ring without exit ends at the
// horizon.  A route may name a link beside the one before it: the path ends there, where a car must
// change.  Refused (invalid_input): a horizon below 0 or beyond `farthest_horizon`.
constexpr double farthest_horizon = 1e6;
std::vector<std::int32_t> free_path(const TrafficNetwork& network, const LinkPlace& place,
                                    double horizon, const std::vector<std::int32_t>& route = {});

// Refuses (invalid_input) a route whose link neither follows the one before it nor lies beside it,
// and names both by their keys.
void check_route(const TrafficNetwork& network, const std::vector<std::int32_t>& route);

constexpr double longest_car = 100;

struct Car {
  std::int64_t car_id = 0;  // tells who is ahead of two at one place: the smaller one
  LinkPlace place;          // of its front
  double speed = 0;
  float length = 5, width = 1.8F;
  std::int32_t route = -1;           // index into Traffic::routes; -1: straight on
  std::uint8_t kind = traffic::car;  // one of the bits of traffic
};

// What is ahead of a car: who stands on the first link of its path on which anybody does, front or
// body, and there is the next one.  A body counts whose front has left the path, such as that of a
// long car that turns off.  A car that comes towards on a lane for both directions stands in the
// way.  What stops the car before it reaches that one counts instead: a signal, the end of its
// path.
struct Leader {
  enum class Kind : std::uint8_t {
    car,
    stationary,  // virtual: the end of a lane, a red signal, a place to change at
    moving,      // virtual: at the speed limit, at the horizon, where nobody is nearer
  } kind = Kind::moving;
  std::int32_t car = -1;  // index
  double distance = 0;    // from front to front along the path; of a virtual one the gap
  double gap = 0;         // from its rear to the front of who follows; below 0 they overlap
  double speed = 0;       // of a car that comes towards below 0; its gap is to its front
};

// Who counts as a leader of those that come from another path into the same lane.  A signal that
// stops them before keeps them out.
enum class MergingLeader : std::uint8_t {
  none,
  by_place,  // who has less way to where the paths meet; the distance is what they have less
  by_time,   // who is there first at its speed; the distance is what is left when it is there
};

struct LeaderRules {
  double horizon = 1000;  // 0 or more
  double time = 0;        // for signals
  MergingLeader merging = MergingLeader::none;
  double merging_reach = 100;     // from where on both see each other, before their paths meet
  bool stationary_end = false;    // at the horizon stands a car; else it moves at the speed limit
  double amber_deceleration = 3;  // metres a second squared: who can stop so at amber does
};

// A front no farther than this behind a stop place still waits there.
constexpr double stop_overshoot = 0.1;

class PathAhead;

// Cars on a network, those of each link in their order.  A car that is longer than the part of its
// link behind its front stands on the links that it came by, too: those that it was moved along,
// then those before it on its route, then those that lead there straight on.  A car takes 56 bytes
// and 16 for each link that its front has left; a link takes 32.
class Traffic {
 public:
  // The network stays as it is and where it is.  Refused (invalid_input): a length that is not
  // positive and finite, an index of a link that is none.
  explicit Traffic(const TrafficNetwork& network);

  const TrafficNetwork& network() const { return *network_; }
  void reserve(int cars) { cars_.reserve(cars); }

  // Refused (invalid_input): a place off the link, a length that is not positive or beyond
  // `longest_car`, a route that is not there.  Indices stay while other cars are added and removed.
  int add(const Car& car);
  void remove(int car);
  // Along its path, or to a place of any link: its order among the cars of that link follows.  A
  // car that comes by no next link stands as if it were added there.
  void move(int car, const LinkPlace& to);
  void set_speed(int car, double speed);
  void set_route(int car, int route);

  // Refused: an index that is none, or that of a car that was removed.
  Car car(int index) const;
  int count() const { return count_; }
  // Indices of cars are below it.
  int size() const { return static_cast<int>(cars_.size()); }
  bool holds(int car) const;

  // The cars whose front is on a link: the foremost, and the next ones behind each.  -1: no more.
  int foremost(int link) const { return on_links_[link].foremost; }
  int rearmost(int link) const { return on_links_[link].rearmost; }
  int behind(int car) const { return cars_[car].behind; }
  int ahead(int car) const { return cars_[car].ahead; }
  // The nearest car of a link with its front at metres or beyond, and the nearest one before.
  int first_from(int link, double metres) const;
  int last_before(int link, double metres) const;
  // Metres along a link to the rearmost car whose front has left it; below 0: it covers the whole
  // link; infinite: there is none.
  double rear_on(int link) const;
  // The links on which a car stands, from that of its front on.
  std::vector<std::int32_t> links_under(int car) const;

  Leader leader(int car, const LeaderRules& rules) const;
  // By index; of an index without a car as it comes.
  std::vector<Leader> leaders(const LeaderRules& rules) const;
  // Metres from a car's front to the rear of its leader, at most the horizon.
  double free_distance(int car, const LeaderRules& rules) const;

  std::vector<std::vector<std::int32_t>> routes;  // of links, each a next one, or one beside

 private:
  struct Standing {
    std::int64_t car_id;
    double metres, speed;
    float length, width;
    std::int32_t link;  // -1: removed
    std::int32_t route;
    std::int32_t ahead, behind;  // on its link; of one that was removed the next such one is behind
    std::int32_t bodies;         // the first of its links behind its front
    std::uint32_t kind : 8, on_route : 24;  // where it is on its route
  };
  // A link on which a car stands, and its front does not.
  struct Body {
    std::int32_t car, link;
    std::int32_t next_of_car;  // farther behind
    std::int32_t next_on_link;
  };
  // The cars of a link, and what a search for a leader asks of it, side by side.
  struct OnLink {
    double length;
    float stop;
    std::int32_t straight_on;
    std::int32_t foremost = -1, rearmost = -1, bodies = -1;
    bool has_signal, both_ways;
  };
  static constexpr std::uint32_t off_route = (1U << 24) - 1;

  const Standing& standing(int car) const;
  bool goes_before(int car, int other) const;
  void enter(int car, int after);
  void leave(int car);
  void find_on_route(Standing& car) const;
  int before_of(int link, const Standing& car, std::uint32_t& on_route) const;
  bool came_along(const Standing& car, int to);
  void stand(int car);
  void stand_up(int car);

  int new_body(const Body& body);
  double way_to_front(int body) const;

  PathAhead path_of(const Standing& car) const;
  Leader leader_on_path(int car, const LeaderRules& rules) const;
  Leader nearest_on(int car, int link, double start, bool own_link) const;
  Leader nearest_towards(int car, int link, double start, bool own_link) const;
  bool stopped_by_signal(double speed, int link, double gap, const LeaderRules& rules) const;
  void see_merging(int car, const LeaderRules& rules, Leader& leader) const;
  void see_on_branch(int car, int branch, int meeting, double way, const LeaderRules& rules,
                     Leader& leader) const;
  double way_by_branch(int car, int branch, int meeting, const LeaderRules& rules) const;
  void compare_merging(int car, int other, double way, double other_way, MergingLeader rule,
                       Leader& leader) const;

  const TrafficNetwork* network_;
  std::vector<Standing> cars_;
  std::vector<OnLink> on_links_;
  std::vector<Body> bodies_;
  std::vector<std::int32_t> came_by_;  // links behind a car that is moved, nearest first
  std::int32_t free_car_ = -1, free_body_ = -1;
  std::int32_t count_ = 0;
};

// The frame of a car's front, but with the direction from its rear to its front as heading: both
// are on the links on which it stands.  Refused: as Traffic::car.
LinkFrame body_frame(const Traffic& traffic, int car);

}  // namespace streetgen
