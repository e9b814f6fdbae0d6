#include "height/least_height.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <set>

#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

// A place of a road whose height is solved for.
struct Station {
  double at;
  int vertex;  // that of a node, which roads share, or its own
};

// From a vertex at height z, vertex `to` has at least z + rise, less the grade of the road by
// length.
struct Step {
  int to;
  double rise;
  double length;
  int lift;  // -1: along a road
  int road;  // -1: a lift
};

struct Origin {
  int vertex;  // -1: none
  int lift, road;
};

class Solver {
 public:
  Solver(const std::vector<GradedRoad>& roads, const std::vector<Lift>& lifts,
         const std::vector<LeastHeight>& by_hand)
      : roads_(roads), lifts_(lifts) {
    for (const GradedRoad& road : roads) grade_.push_back(road.grade);
    for (std::size_t r = 0; r < roads.size(); ++r) {
      std::set<double> places;
      for (const HeightPoint& point : roads[r].ground) places.insert(point.at);
      places_.push_back(std::move(places));
    }
    for (const Lift& lift : lifts) {
      places_[lift.from].insert(within(lift.from, lift.from_at));
      places_[lift.to].insert(within(lift.to, lift.to_at));
    }
    for (const LeastHeight& height : by_hand)
      places_[height.road].insert(within(height.road, height.at));
    for (std::size_t r = 0; r < roads.size(); ++r) place_stations(static_cast<int>(r));
    for (const LeastHeight& height : by_hand) {
      double& least = ground_[vertex_at(height.road, height.at)];
      least = std::max(least, height.z);
    }
    for (std::size_t l = 0; l < lifts.size(); ++l) {
      const Lift& lift = lifts[l];
      steps_[vertex_at(lift.from, lift.from_at)].push_back(
          {vertex_at(lift.to, lift.to_at), lift.rise, 0, static_cast<int>(l), -1});
    }
  }

  LeastHeights solve() {
    passed_over_.assign(lifts_.size(), false);
    while (!raise()) poll_cancel();
    LeastHeights least;
    for (std::size_t r = 0; r < roads_.size(); ++r)
      least.roads.push_back(line(static_cast<int>(r)));
    least.grades = grade_;
    return least;
  }

 private:
  double within(int road, double at) const {
    return std::clamp(at, roads_[road].ground.front().at, roads_[road].ground.back().at);
  }

  int vertex(double ground) {
    ground_.push_back(ground);
    stays_.push_back(false);
    steps_.emplace_back();
    return static_cast<int>(ground_.size()) - 1;
  }

  int vertex_of_node(std::int64_t node, double ground) {
    const auto [found, made] = node_.try_emplace(node, -1);
    if (made) found->second = vertex(ground);
    ground_[found->second] = std::max(ground_[found->second], ground);
    return found->second;
  }

  void place_stations(int r) {
    const GradedRoad& road = roads_[r];
    std::vector<Station> stations;
    const double end = road.ground.back().at;
    stations.push_back({0, vertex_of_node(road.from_node, road.ground.front().z)});
    for (const double at : places_[r])
      if (at > stations.back().at + same_place && at < end - same_place)
        stations.push_back({at, vertex(height_at(road.ground, at))});
    stations.push_back({end, vertex_of_node(road.to_node, road.ground.back().z)});
    if (!road.left.empty())
      for (const Station& station : stations)
        if (height_at(road.ground, station.at) < height_at(road.left, station.at) - same_place)
          stays_[station.vertex] = true;
    for (std::size_t i = 1; i < stations.size(); ++i) {
      const double length = stations[i].at - stations[i - 1].at;
      steps_[stations[i - 1].vertex].push_back({stations[i].vertex, 0, length, -1, r});
      steps_[stations[i].vertex].push_back({stations[i - 1].vertex, 0, length, -1, r});
    }
    stations_.push_back(std::move(stations));
  }

  int vertex_at(int road, double at) const {
    const std::vector<Station>& stations = stations_[road];
    const auto nearest =
        std::min_element(stations.begin(), stations.end(), [&](const Station& p, const Station& q) {
          return std::abs(p.at - at) < std::abs(q.at - at);
        });
    return nearest->vertex;
  }

  double rise_of(const Step& step) const {
    return step.road < 0 ? step.rise : -grade_[step.road] * step.length;
  }

  bool is_higher(double wanted, const Step& step) const {
    return wanted > height_[step.to] + rounding_of_heights;
  }

  bool raises_any(int v) const {
    return std::any_of(steps_[v].begin(), steps_[v].end(), [&](const Step& step) {
      return is_higher(height_[v] + rise_of(step), step);
    });
  }

  // Each vertex raises those beside and above it, the highest one first.  False where roads were
  // made steeper, or a lift of a circle was passed over: then all is raised anew.
  bool raise() {
    height_ = ground_;
    before_.assign(ground_.size(), {-1, -1, -1});
    bool steeper = false;
    std::priority_queue<std::pair<double, int>> open;
    for (std::size_t v = 0; v < ground_.size(); ++v)
      if (raises_any(static_cast<int>(v))) open.push({height_[v], static_cast<int>(v)});
    while (!open.empty()) {
      const auto [height, v] = open.top();
      open.pop();
      if (height < height_[v]) continue;
      for (const Step& step : steps_[v]) {
        const double wanted = height + rise_of(step);
        if (!is_higher(wanted, step)) continue;
        if (step.lift >= 0 && passed_over_[step.lift]) continue;
        if (step.lift >= 0)
          if (const auto circle = circle_closed_by(v, step); !circle.empty()) {
            if (are_made_steeper(circle)) steeper = true;
            // Heights of this round may be those of grades that hold no more.
            if (steeper) continue;
            pass_over_last(circle);
            if (passed_over_[step.lift]) continue;
            return false;
          }
        if (stays_[step.to] && are_made_steeper(way_of(v, step))) steeper = true;
        height_[step.to] = wanted;
        before_[step.to] = {v, step.lift, step.road};
        open.push({wanted, step.to});
      }
    }
    return !steeper;
  }

  // What raised the vertex that the step raises, if that raised vertex v; else nothing.
  std::vector<Origin> circle_closed_by(int v, const Step& step) const {
    std::map<int, std::size_t> seen;
    std::vector<Origin> walked;
    for (int at = v; at >= 0; at = before_[at].vertex) {
      if (const auto [found, fresh] = seen.try_emplace(at, walked.size()); !fresh)
        return {walked.begin() + static_cast<long>(found->second), walked.end()};
      if (at == step.to) {
        walked.push_back({v, step.lift, step.road});
        return walked;
      }
      walked.push_back(before_[at]);
    }
    return {};
  }

  // The way by which the step came; one of lifts that close again leads in a circle.
  std::vector<Origin> way_of(int v, const Step& step) const {
    std::set<int> seen;
    std::vector<Origin> way{{v, step.lift, step.road}};
    for (int at = v; at >= 0 && seen.insert(at).second; at = before_[at].vertex)
      way.push_back(before_[at]);
    return way;
  }

  // Gives the roads of a way their greatest grades; did any not have it?
  bool are_made_steeper(const std::vector<Origin>& way) {
    bool steeper = false;
    for (const Origin& origin : way)
      if (origin.road >= 0 && grade_[origin.road] < roads_[origin.road].grade_greatest) {
        grade_[origin.road] = roads_[origin.road].grade_greatest;
        steeper = true;
      }
    return steeper;
  }

  void pass_over_last(const std::vector<Origin>& circle) {
    int last = -1;
    for (const Origin& origin : circle) last = std::max(last, origin.lift);
    if (last >= 0) passed_over_[last] = true;
  }

  // Between two stations the ground is straight, and rises above it come from the two alone.
  HeightLine line(int r) const {
    const GradedRoad& road = roads_[r];
    const std::vector<Station>& stations = stations_[r];
    HeightLine out{{stations.front().at, height_[stations.front().vertex]}};
    for (std::size_t i = 1; i < stations.size(); ++i) {
      const HeightPoint p = out.back(), q{stations[i].at, height_[stations[i].vertex]};
      append_between(road, grade_[r], p, q, &out);
      out.push_back(q);
    }
    return out;
  }

  static void append_between(const GradedRoad& road, double grade, const HeightPoint& p,
                             const HeightPoint& q, HeightLine* out) {
    const double length = q.at - p.at;
    const double ground_p = height_at(road.ground, p.at), ground_q = height_at(road.ground, q.at);
    const double slope = (ground_q - ground_p) / length;
    // Metres from p to where the fall from p ends on the ground, and to where the rise to q begins.
    const double end_of_fall = grade + slope > 0 ? (p.z - ground_p) / (grade + slope) : length;
    const double begin_of_rise =
        grade - slope > 0 ? length - (q.z - ground_q) / (grade - slope) : 0;
    if (end_of_fall < begin_of_rise) {
      for (const double at : {end_of_fall, begin_of_rise})
        if (at > same_place && at < length - same_place)
          out->push_back({p.at + at, ground_p + slope * at});
      return;
    }
    // The two meet above the ground.
    const double meet = (p.z - q.z + grade * length) / (2 * grade);
    if (meet > same_place && meet < length - same_place)
      out->push_back({p.at + meet, p.z - grade * meet});
  }

  static constexpr double rounding_of_heights = 1e-9;  // metres

  const std::vector<GradedRoad>& roads_;
  const std::vector<Lift>& lifts_;
  std::vector<std::set<double>> places_;
  std::vector<std::vector<Station>> stations_;
  std::map<std::int64_t, int> node_;
  std::vector<double> ground_, height_;
  std::vector<bool> stays_;  // vertices that rise last
  std::vector<std::vector<Step>> steps_;
  std::vector<Origin> before_;  // the vertex that raised it, and by what
  std::vector<double> grade_;   // of each road
  std::vector<bool> passed_over_;
};

}  // namespace

LeastHeights least_heights(const std::vector<GradedRoad>& roads, const std::vector<Lift>& lifts,
                           const std::vector<LeastHeight>& by_hand) {
  return Solver(roads, lifts, by_hand).solve();
}

}  // namespace streetgen
