#include "simulation/let_in_cars.hpp"

#include <algorithm>

#include "simulation/driver_sight.hpp"
#include "simulation/signal_aspect.hpp"

namespace streetgen {

namespace {

constexpr int longest_chain = 64;  // links
constexpr double slack = 1.5;      // seconds that one may wait before a stretch for another one

// The links that a car claims at once, up to where it has room to stand.
class LinkChain {
 public:
  LinkChain(const CarRun& run, const LetInRequest& request)
      : run_(run),
        request_(request),
        driver_(run.drivers[request.car]),
        at_(request.before),
        patient_(driver_.asked < 0 || run.time - driver_.asked < run.rules.patience) {}

  bool found() {
    to_start_ = request_.to_end;
    for (int i = 0; i < longest_chain; ++i) {
      const int movement = go_on(run_, driver_, at_);
      if (movement < 0 || !may_enter(movement)) return false;
      add(movement);
      crossed_ = crossed_ || run_.crossed[movement];
      passed_.clear();
      const Rest rest = find_rest();
      if (rest == Rest::farther) {
        parts.insert(parts.end(), passed_.begin(), passed_.end());
        continue;
      }
      no_room = rest == Rest::none;
      return !no_room;
    }
    return false;
  }

  struct Part {
    std::int32_t link;
    double to_start;
  };
  std::vector<Part> parts;
  std::uint32_t let_in() const { return at_.passed; }
  std::int32_t target = -1;  // the link on which room is reserved
  bool no_room = false;

 private:
  enum class Rest { here, none, farther };

  void add(int link) {
    if (run_.guarded[link] || run_.link(link).opposite >= 0) parts.push_back({link, to_start_});
    to_start_ += run_.link(link).length;
  }

  bool may_enter(int movement) const {
    const Aspect aspect = aspect_at(*run_.network, movement, run_.time);
    // A signal behind a lane that is too short to wait there is passed after a cycle.
    const int plan = run_.link(movement).plan;
    const bool obeys = parts.empty() || plan < 0 ||
                       plan >= static_cast<int>(run_.network->plans.size()) || driver_.asked < 0 ||
                       run_.time - driver_.asked < run_.network->plans[plan].cycle;
    if (obeys &&
        stops_for(aspect, driver_.speed, request_.to_stop, run_.rules.amber_deceleration))
      return false;
    for (const LinkConflict& c : run_.network->conflicts.of(movement))
      if (!fits(movement, c)) return false;
    return true;
  }

  // Whether the time on a stretch that another movement needs, too, leaves the others theirs.
  bool fits(int movement, const LinkConflict& c) const {
    const auto& others = run_.claims[c.link];
    const bool gives_way = c.precedence == Precedence::gives_way;
    const Arrival& arrival = run_.arrivals[c.link];
    const bool arrives = gives_way && arrival.step == run_.steps && arrival.car != request_.car;
    if (others.empty() && !arrives) return true;
    const double most = run_.link(movement).speed;
    const double into = seconds_for(to_start_ + c.from, driver_.speed, most);
    for (const GroundClaim& other : others) {
      const Driver& first = run_.drivers[other.car];
      if (other.car == request_.car) continue;
      const double left =
          other.start + c.other_to + std::max(0., first.length - run_.rules.car_length) - first.way;
      if (left > 0 && seconds_for(left, first.speed, run_.link(c.link).speed) > into + slack)
        return false;
    }
    if (!arrives || (!patient_ && arrival.stands)) return true;
    const double beyond = to_start_ + c.to + std::max(0., driver_.length - run_.rules.car_length);
    return seconds_for(beyond, driver_.speed, most) + run_.rules.time_margin <
           arrival.seconds + c.other_from / run_.link(c.link).speed;
  }

  // Whether a car that may have to wait on a link is there, or comes to it: who passes the link
  // would claim what is behind it, and wait for that car.
  bool rests_on(int link) const {
    if (run_.reserved[link] > 0) return true;
    for (int car = run_.cars.rearmost(link); car >= 0; car = run_.cars.ahead(car))
      if (may_wait(run_.drivers[car])) return true;
    return false;
  }

  // Metres of a link that the one takes yet who went last from it.
  double tail_on(int link) const {
    const LastLeft& last = run_.last_left[link];
    if (last.car < 0 || last.car == request_.car) return 0;
    const Driver& other = run_.drivers[last.car];
    if (!other.here || other.car_id != last.car_id) return 0;
    return std::clamp(run_.room_of(other) - (other.way - last.way), 0., run_.link(link).length);
  }

  // Goes on behind a movement to where the car can stand clear of others.
  Rest find_rest() {
    double room = 0, taken = 0;
    bool two_way = false, somebody_rests = false;
    target = -1;
    for (int i = 0; i < longest_chain; ++i) {
      WayPlace next = at_;
      const int to = go_on(run_, driver_, next);
      if (to == way_ends) return Rest::here;
      const double need = run_.room_of(driver_);
      if (to == must_change || run_.guarded[to]) {
        if (i == 0) return crossed_ ? Rest::farther : Rest::here;  // a movement follows another one
        room -= run_.link(at_.link).length - run_.link(at_.link).stop;
        if (!crossed_ && !two_way) return Rest::here;
        if (to != must_change && (two_way || room < need))
          return somebody_rests ? Rest::none : Rest::farther;
        return room - taken >= need ? Rest::here : Rest::none;
      }
      if (target >= 0 && !two_way && room - taken >= need) return Rest::here;
      const int opposite = run_.link(to).opposite;
      if (opposite >= 0) {
        if (others_on(run_, opposite, request_.car)) return Rest::none;
        const Arrival& arrival = run_.arrivals[opposite];
        const double waits = run_.drivers[std::max(0, arrival.car)].asked;
        if (patient_ && arrival.step == run_.steps && waits >= 0 &&
            run_.time - waits > run_.rules.patience)
          return Rest::none;
      }
      at_ = next;
      if (opposite < 0) passed_.push_back({to, to_start_});
      add(to);
      two_way = opposite >= 0;
      const bool rested_on = rests_on(to);
      somebody_rests = somebody_rests || rested_on;
      if (two_way) {
        room = taken = 0;
        target = -1;
        crossed_ = true;
      } else {
        target = to;
        room += run_.link(to).length;
        taken += run_.occupied[to] + run_.reserved[to] + tail_on(to);
        // Who stands there may want to go elsewhere, and no room behind is of use.
        if (rested_on && room - taken < need && run_.network->next.of(to).size() > 1)
          return Rest::none;
      }
    }
    return Rest::none;
  }

  const CarRun& run_;
  const LetInRequest& request_;
  const Driver& driver_;
  WayPlace at_;
  double to_start_ = 0;
  bool patient_;
  bool crossed_ = false;      // others need the ground of a movement of the chain
  std::vector<Part> passed_;  // links behind a movement
};

}  // namespace

bool may_wait(const Driver& driver) {
  return driver.let_in <= driver.at.passed || driver.at.passed == driver.let_in_from ||
         driver.at.passed == driver.last_let_in_from;
}

bool others_on(const CarRun& run, int link, int car) {
  for (const GroundClaim& c : run.claims[link])
    if (c.car != car) return true;
  const int rearmost = run.cars.rearmost(link);
  return rearmost >= 0 && (rearmost != car || run.cars.foremost(link) != car);
}

void claim(CarRun& run, int car, int link, double to_start) {
  Driver& driver = run.drivers[car];
  run.claims[link].push_back({car, ++run.orders, driver.way + to_start});
  driver.claims.push_back(link);
}

namespace {

// Who waits for long turns elsewhere, so that no circle of full lanes stays: who finds no room
// wherever some is, in one step or another.  Where it was let in it goes.
void choose_anew(const CarRun& run, Driver& driver) {
  if (driver.asked < 0 || driver.let_in > driver.at.passed) return;
  const double since = driver.no_room ? driver.asked : std::max(driver.asked, driver.chose);
  if (run.time - since <= (driver.no_room ? 1 : 6) * run.rules.patience) return;
  ++driver.turned;
  driver.chose = run.time;
}

}  // namespace

void let_in_cars(CarRun& run) {
  std::sort(run.requests.begin(), run.requests.end(),
            [&](const LetInRequest& a, const LetInRequest& b) {
              const double since_a = a.asked < 0 ? run.time : a.asked;
              const double since_b = b.asked < 0 ? run.time : b.asked;
              if (since_a != since_b) return since_a < since_b;
              if (a.to_end != b.to_end) return a.to_end < b.to_end;
              return run.drivers[a.car].car_id < run.drivers[b.car].car_id;
            });
  for (const LetInRequest& request : run.requests) {
    Driver& driver = run.drivers[request.car];
    LinkChain chain(run, request);
    const bool found = chain.found();
    driver.no_room = chain.no_room;
    if (found) {
      for (const LinkChain::Part& part : chain.parts)
        claim(run, request.car, part.link, part.to_start);
      driver.last_let_in_from = request.before.passed;
      if (driver.let_in <= driver.at.passed) driver.let_in_from = request.before.passed;
      driver.let_in = chain.let_in();
      driver.asked = -1;
      if (chain.target >= 0) {
        driver.reserved.push_back({chain.target, run.room_of(driver)});
        run.reserved[chain.target] += run.room_of(driver);
      }
    } else {
      if (driver.asked < 0 && driver.speed < 1) driver.asked = run.time;
      choose_anew(run, driver);
    }
  }
}

namespace {

void give_up_room(CarRun& run, Driver& driver) {
  for (const ReservedRoom& r : driver.reserved) run.reserved[r.link] -= r.metres;
  driver.reserved.clear();
}

template <class Which>
void drop_where(CarRun& run, int car, const Which& which) {
  Driver& driver = run.drivers[car];
  for (std::size_t i = 0; i < driver.claims.size();) {
    auto& claims = run.claims[driver.claims[i]];
    const auto mine = std::find_if(claims.begin(), claims.end(), [&](const GroundClaim& c) {
      return c.car == car && which(c, driver.claims[i]);
    });
    if (mine == claims.end()) {
      ++i;
    } else {
      claims.erase(mine);
      driver.claims.erase(driver.claims.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
}

}  // namespace

void take_back(CarRun& run, int car) {
  Driver& driver = run.drivers[car];
  if (!may_wait(driver)) return;
  driver.let_in = driver.at.passed;
  drop_where(run, car, [&](const GroundClaim& c, int) { return c.start > driver.way; });
  give_up_room(run, driver);
}

void give_up_all(CarRun& run, int car) {
  drop_where(run, car, [](const GroundClaim&, int) { return true; });
  give_up_room(run, run.drivers[car]);
}

void occupy(CarRun& run, Driver& driver) {
  run.occupied[driver.at.link] += run.room_of(driver);
  ++run.passed[driver.at.link];
  for (std::size_t i = 0; i < driver.reserved.size(); ++i)
    if (driver.reserved[i].link == driver.at.link) {
      run.reserved[driver.at.link] -= driver.reserved[i].metres;
      driver.reserved.erase(driver.reserved.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    }
}

void give_up_claims(CarRun& run, int car) {
  const Driver& driver = run.drivers[car];
  drop_where(run, car, [&](const GroundClaim& c, int link) {
    return driver.way >=
           c.start + run.clear_at[link] + std::max(0., driver.length - run.rules.car_length);
  });
}

}  // namespace streetgen
