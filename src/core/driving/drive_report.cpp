#include "streetgen/drive_report.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <string>
#include <unordered_set>

#include "driving/driven_links.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

namespace {

constexpr double longest_unseen = 1;     // seconds for which an actor counts after its sample
constexpr float least_length = 0.01F;   // metres of an actor that are left on its link

void check_samples(const std::vector<DriveSample>& samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const DriveSample& s = samples[i];
    if (s.actor < 0 || static_cast<std::size_t>(s.actor) >= samples.size())
      throw Error(ErrorKind::invalid_input,
                  "sample " + std::to_string(i) + " is of actor " + std::to_string(s.actor) +
                      ", expected 0 to " + std::to_string(samples.size() - 1));
    if (!(s.length > 0 && s.length <= longest_car))
      throw Error(ErrorKind::invalid_input,
                  "sample " + std::to_string(i) + " has a length of " + text_of(s.length) +
                      " m, expected above 0 and at most " + text_of(longest_car));
  }
}

// The samples that can be told, of each actor by their times.
struct Log {
  std::vector<std::vector<int>> of_actor;
  std::vector<int> by_time;
};

Log log_of(const std::vector<DriveSample>& samples, std::vector<DrivenSample>& driven) {
  Log log;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const DriveSample& s = samples[i];
    if (!std::isfinite(s.time))
      driven[i].finding = DriveFinding::no_time;
    else if (!std::isfinite(s.x) || !std::isfinite(s.y))
      driven[i].finding = DriveFinding::no_place;
    else
      log.by_time.push_back(static_cast<int>(i));
  }
  std::stable_sort(log.by_time.begin(), log.by_time.end(),
                   [&](int a, int b) { return samples[a].time < samples[b].time; });
  int actors = 0;
  for (const DriveSample& s : samples) actors = std::max(actors, s.actor + 1);
  log.of_actor.resize(actors);
  std::vector<int> told;
  for (const int i : log.by_time) {
    std::vector<int>& own = log.of_actor[samples[i].actor];
    if (!own.empty() && samples[own.back()].time == samples[i].time) {
      driven[i].finding = DriveFinding::twice;
      continue;
    }
    own.push_back(i);
    told.push_back(i);
  }
  log.by_time = std::move(told);
  return log;
}

// Where it is not logged: by the straight line from the sample before to the one after.
double speed_of(const std::vector<DriveSample>& own, std::size_t i) {
  if (std::isfinite(own[i].speed)) return own[i].speed;
  const DriveSample& from = own[i > 0 ? i - 1 : i];
  const DriveSample& to = own[std::min(i + 1, own.size() - 1)];
  return to.time > from.time ? std::hypot(to.x - from.x, to.y - from.y) / (to.time - from.time)
                             : not_logged;
}

// On a movement that of its slower lane; cars of a simulation turn as slowly as their tyres ask.
double allowed_speed(const TrafficNetwork& network, int link) {
  if (!network.links[link].movement) return network.links[link].speed;
  double least = std::numeric_limits<double>::infinity();
  for (const auto* lanes : {&network.before, &network.next})
    for (const int lane : lanes->of(link)) least = std::min<double>(least, network.links[lane].speed);
  return least;
}

// The ways of actors as routes, a new one where the last one does not go on.
class DrivenRoutes {
 public:
  DrivenRoutes(Traffic& traffic, std::size_t samples) : traffic_(traffic), of_sample_(samples, -1) {}

  void add(const std::vector<int>& own, const std::vector<DrivenPlace>& driven) {
    bool open = false;
    for (std::size_t i = 0; i < own.size(); ++i) {
      const int link = driven[i].near.located.place.link;
      if (link < 0) {
        open = false;
        continue;
      }
      if (!open || !driven[i].joined || comes_again(driven[i].way)) begin(link);
      open = true;
      for (const int next : driven[i].way)
        if (seen_.insert(next).second) traffic_.routes.back().push_back(next);
      of_sample_[own[i]] = static_cast<int>(traffic_.routes.size()) - 1;
    }
  }
  int of(int sample) const { return of_sample_[sample]; }

 private:
  void begin(int link) {
    traffic_.routes.push_back({link});
    seen_ = {link};
  }
  bool comes_again(const std::vector<std::int32_t>& way) const {
    return std::any_of(way.begin(), way.end(), [&](int link) { return seen_.count(link) > 0; });
  }

  Traffic& traffic_;
  std::vector<int> of_sample_;
  std::unordered_set<std::int32_t> seen_;
};

// The actors on the network, moved from sample to sample.
class LoggedTraffic {
 public:
  LoggedTraffic(const std::vector<DriveSample>& samples, Traffic& traffic, int actors)
      : samples_(samples), traffic_(traffic), last_(actors), actor_of_car_() {}

  void put(int sample, const DrivenSample& driven, int route) {
    const DriveSample& s = samples_[sample];
    Last& last = last_[s.actor];
    last.sample = sample;
    seen_.push_back({s.time, s.actor});
    if (driven.located.place.link < 0) return take(last);
    const LinkPlace& at = driven.located.place;
    const double end = traffic_.network().links[at.link].length;
    LinkPlace place{at.link, std::clamp(at.metres, 0.0, end)};
    float length = s.length;
    // The rear of who drives against the traffic is ahead, as far as the link goes.
    if (driven.against) {
      const double rear = std::min(end, place.metres + s.length);
      length = std::max(least_length, static_cast<float>(rear - place.metres));
      place.metres = rear;
    }
    if (last.car >= 0 && traffic_.car(last.car).length != length) take(last);
    if (last.car < 0) {
      last.car = traffic_.add({s.actor, place, 0, length});
      actor_of_car_.resize(std::max<std::size_t>(actor_of_car_.size(), last.car + 1U));
      actor_of_car_[last.car] = s.actor;
    }
    traffic_.move(last.car, place);
    traffic_.set_route(last.car, route);
    const double speed = std::isfinite(driven.speed) ? driven.speed : 0;
    traffic_.set_speed(last.car, driven.against ? -speed : speed);
  }

  void forget_before(double time) {
    for (; !seen_.empty() && seen_.front().time < time - longest_unseen; seen_.pop_front()) {
      Last& last = last_[seen_.front().actor];
      if (samples_[last.sample].time == seen_.front().time) take(last);
    }
  }

  void find_leader(int sample, DrivenSample& driven) const {
    const Last& own = last_[samples_[sample].actor];
    if (own.car < 0 || own.sample != sample) return;
    const Leader leader =
        driven.against ? met_by(own.car) : traffic_.leader(own.car, LeaderRules());
    if (leader.kind != Leader::Kind::car) return;
    driven.leader = actor_of_car_[leader.car];
    const double since = samples_[sample].time - samples_[last_[driven.leader].sample].time;
    driven.gap = leader.gap + leader.speed * since;
    const double nearing = driven.speed - leader.speed;
    if (nearing > 0) driven.time_to_collision = std::max(0., driven.gap) / nearing;
  }

 private:
  struct Last {
    int sample = -1, car = -1;
  };
  struct Seen {
    double time;
    int actor;
  };
  // The leader of who drives against the traffic: the next one on the link that it meets.
  Leader met_by(int car) const {
    const int met = traffic_.behind(car);
    if (met < 0) return {};
    const Car own = traffic_.car(car), other = traffic_.car(met);
    const double gap = own.place.metres - own.length - other.place.metres;
    return {Leader::Kind::car, met, gap, gap, -other.speed};
  }
  void take(Last& last) {
    if (last.car >= 0) traffic_.remove(last.car);
    last.car = -1;
  }

  const std::vector<DriveSample>& samples_;
  Traffic& traffic_;
  std::vector<Last> last_;
  std::vector<int> actor_of_car_;
  std::deque<Seen> seen_;
};

TrafficNetwork without_signals(TrafficNetwork network) {
  network.aspects = {};
  return network;
}

}  // namespace

std::vector<DrivenSample> drive_report(const TrafficNetwork& given,
                                       const std::vector<DriveSample>& samples) {
  check_samples(samples);
  const TrafficNetwork network = without_signals(given);
  std::vector<DrivenSample> driven(samples.size());
  const Log log = log_of(samples, driven);
  const LinkPlaces places(network);
  Traffic traffic(network);
  DrivenRoutes routes(traffic, samples.size());
  for (const std::vector<int>& own : log.of_actor) {
    std::vector<DriveSample> of_one;
    for (const int i : own) of_one.push_back(samples[i]);
    const std::vector<DrivenPlace> found = driven_links(network, places, of_one);
    routes.add(own, found);
    for (std::size_t i = 0; i < own.size(); ++i) {
      DrivenSample& row = driven[own[i]];
      row.located = found[i].near.located;
      row.against = found[i].against;
      row.speed = speed_of(of_one, i);
      if (row.located.place.link < 0)
        row.finding = DriveFinding::off_road;
      else
        row.over_limit = row.speed - allowed_speed(network, row.located.place.link);
    }
  }
  LoggedTraffic logged(samples, traffic, static_cast<int>(log.of_actor.size()));
  for (std::size_t i = 0; i < log.by_time.size();) {
    poll_cancel();
    const std::size_t first = i;
    const double time = samples[log.by_time[i]].time;
    logged.forget_before(time);
    for (; i < log.by_time.size() && samples[log.by_time[i]].time == time; ++i)
      logged.put(log.by_time[i], driven[log.by_time[i]], routes.of(log.by_time[i]));
    for (std::size_t k = first; k < i; ++k)
      logged.find_leader(log.by_time[k], driven[log.by_time[k]]);
  }
  return driven;
}

}  // namespace streetgen
