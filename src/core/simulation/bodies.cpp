// Links on which a long car stands behind the link of its front.
#include <algorithm>

#include "simulation/path_ahead.hpp"
#include "streetgen/traffic.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

// Links that a car passes at most in one step along its path.
constexpr int most_links_passed = 16;

// How straight one comes from a link to the next one: 0 to 2.
int straightness(const TrafficNetwork& network, int from, int to) {
  if (network.links[from].straight_on != to) return 0;
  if (!network.links[from].movement) return 2;
  const auto lanes = network.before.of(from);
  return std::any_of(lanes.begin(), lanes.end(),
                     [&](int lane) { return network.links[lane].straight_on == from; })
             ? 2
             : 1;
}

}  // namespace

// The link that leads to a link: that of the route, which begins at `on_route`, else the
// straightest one, of equal ones the first; -1: none does.
int Traffic::before_of(int link, const Standing& car, std::uint32_t& on_route) const {
  if (on_route != off_route && on_route > 0) {
    const auto& route = routes[car.route];
    const int before = on_route < route.size() ? route[on_route - 1] : -1;
    if (before >= 0 && before < network_->size() && leads(*network_, before, link)) {
      --on_route;
      return before;
    }
  }
  on_route = off_route;
  int best = -1, best_straightness = -1;
  for (const std::int32_t before : network_->before.of(link)) {
    const int straight = straightness(*network_, before, link);
    if (straight < best_straightness || (straight == best_straightness && before > best)) continue;
    best = before;
    best_straightness = straight;
  }
  return best;
}

// Whether a car comes to a link from its own: along its path, or to a next link.  Then the links
// that it leaves are those that it came by.
bool Traffic::came_along(const Standing& car, int to) {
  PathAhead path = path_of(car);
  came_by_.push_back(car.link);
  for (int i = 0; i < most_links_passed; ++i) {
    const int next = path.next();
    if (next == to) {
      std::reverse(came_by_.begin(), came_by_.end());
      return true;
    }
    if (next < 0) break;
    path.go_on(next);
    came_by_.push_back(next);
  }
  came_by_.assign(1, car.link);
  if (leads(*network_, car.link, to)) return true;
  came_by_.clear();
  return false;
}

// Lets a car stand on the links that it came by, as far as it is long, and each once.
void Traffic::stand(int car) {
  Standing& standing = cars_[car];
  double covered = standing.metres;
  std::uint32_t on_route = standing.on_route;
  int last_link = standing.link, last_body = -1;
  for (std::size_t i = 0; covered < standing.length; ++i) {
    const int on = before_of(last_link, standing, on_route);
    const int link = i < came_by_.size() ? came_by_[i] : on;
    if (link != on) on_route = off_route;
    if (link < 0 || link == standing.link) return;
    for (int b = standing.bodies; b >= 0; b = bodies_[b].next_of_car)
      if (bodies_[b].link == link) return;
    const int body = new_body({car, link, -1, on_links_[link].bodies});
    on_links_[link].bodies = body;
    (last_body < 0 ? standing.bodies : bodies_[last_body].next_of_car) = body;
    covered += network_->links[link].length;
    last_link = link;
    last_body = body;
  }
}

int Traffic::new_body(const Body& body) {
  const int index = free_body_;
  if (index < 0) {
    bodies_.push_back(body);
    return static_cast<int>(bodies_.size()) - 1;
  }
  free_body_ = bodies_[index].next_of_car;
  bodies_[index] = body;
  return index;
}

void Traffic::stand_up(int car) {
  for (int body = cars_[car].bodies; body >= 0;) {
    std::int32_t* on_link = &on_links_[bodies_[body].link].bodies;
    while (*on_link != body) on_link = &bodies_[*on_link].next_on_link;
    *on_link = bodies_[body].next_on_link;
    const int next = bodies_[body].next_of_car;
    bodies_[body].next_of_car = free_body_;
    free_body_ = body;
    body = next;
  }
  cars_[car].bodies = -1;
}

std::vector<std::int32_t> Traffic::links_under(int car) const {
  std::vector<std::int32_t> links{standing(car).link};
  for (int b = cars_[car].bodies; b >= 0; b = bodies_[b].next_of_car)
    links.push_back(bodies_[b].link);
  return links;
}

double Traffic::rear_on(int link) const {
  double rear = infinite;
  for (int b = on_links_[link].bodies; b >= 0; b = bodies_[b].next_on_link)
    rear = std::min(rear, way_to_front(b) - cars_[bodies_[b].car].length);
  return rear;
}

// Metres from the start of the link of a body to the front of its car.
double Traffic::way_to_front(int body) const {
  double way = cars_[bodies_[body].car].metres;
  for (int b = cars_[bodies_[body].car].bodies;; b = bodies_[b].next_of_car) {
    way += network_->links[bodies_[b].link].length;
    if (b == body) return way;
  }
}

}  // namespace streetgen
