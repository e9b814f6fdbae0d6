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

// From a vertex at height z, vertex `to` has at least z + rise.
struct Step {
  int to;
  double rise;
  int lift;  // -1: along a road
};

class Solver {
 public:
  Solver(const std::vector<GradedRoad>& roads, const std::vector<Lift>& lifts,
         const std::vector<LeastHeight>& by_hand)
      : roads_(roads), lifts_(lifts) {
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
          {vertex_at(lift.to, lift.to_at), lift.rise, static_cast<int>(l)});
    }
  }

  std::vector<HeightLine> solve() {
    passed_over_.assign(lifts_.size(), false);
    while (!raise()) poll_cancel();
    std::vector<HeightLine> lines;
    for (std::size_t r = 0; r < roads_.size(); ++r) lines.push_back(line(static_cast<int>(r)));
    return lines;
  }

 private:
  double within(int road, double at) const {
    return std::clamp(at, roads_[road].ground.front().at, roads_[road].ground.back().at);
  }

  int vertex(double ground) {
    ground_.push_back(ground);
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
    for (std::size_t i = 1; i < stations.size(); ++i) {
      const double drop = -road.grade * (stations[i].at - stations[i - 1].at);
      steps_[stations[i - 1].vertex].push_back({stations[i].vertex, drop, -1});
      steps_[stations[i].vertex].push_back({stations[i - 1].vertex, drop, -1});
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

  // Highest first, each vertex raises those beside and above it.  False where a circle of lifts was
  // found: one of them is passed over from then on.
  bool raise() {
    height_ = ground_;
    before_.assign(ground_.size(), {-1, -1});
    std::priority_queue<std::pair<double, int>> open;
    for (std::size_t v = 0; v < ground_.size(); ++v) open.push({height_[v], static_cast<int>(v)});
    while (!open.empty()) {
      const auto [height, v] = open.top();
      open.pop();
      if (height < height_[v]) continue;
      for (const Step& step : steps_[v]) {
        const double wanted = height + step.rise;
        if (wanted <= height_[step.to] + rounding_of_heights) continue;
        if (step.lift >= 0 && (passed_over_[step.lift] || closes_circle(v, step))) {
          if (passed_over_[step.lift]) continue;
          return false;
        }
        height_[step.to] = wanted;
        before_[step.to] = {v, step.lift};
        open.push({wanted, step.to});
      }
    }
    return true;
  }

  // Whether the vertex that the step raises raised vertex v; if so, the last lift of that circle is
  // passed over.
  bool closes_circle(int v, const Step& step) {
    std::map<int, std::size_t> seen;
    std::vector<int> walked;  // lifts, -1 between them
    for (int at = v; at >= 0; at = before_[at].first) {
      if (const auto [found, fresh] = seen.try_emplace(at, walked.size()); !fresh) {
        pass_over(
            std::vector<int>(walked.begin() + static_cast<long>(found->second), walked.end()));
        return true;
      }
      if (at == step.to) {
        walked.push_back(step.lift);
        pass_over(walked);
        return true;
      }
      walked.push_back(before_[at].second);
    }
    return false;
  }

  void pass_over(const std::vector<int>& circle) {
    const int last = *std::max_element(circle.begin(), circle.end());
    if (last >= 0) passed_over_[last] = true;
  }

  // Between two stations the ground is straight, and rises above it come from the two alone.
  HeightLine line(int r) const {
    const GradedRoad& road = roads_[r];
    const std::vector<Station>& stations = stations_[r];
    HeightLine out{{stations.front().at, height_[stations.front().vertex]}};
    for (std::size_t i = 1; i < stations.size(); ++i) {
      const HeightPoint p = out.back(), q{stations[i].at, height_[stations[i].vertex]};
      append_between(road, p, q, &out);
      out.push_back(q);
    }
    return out;
  }

  static void append_between(const GradedRoad& road, const HeightPoint& p, const HeightPoint& q,
                             HeightLine* out) {
    const double length = q.at - p.at;
    const double ground_p = height_at(road.ground, p.at), ground_q = height_at(road.ground, q.at);
    const double slope = (ground_q - ground_p) / length;
    // Metres from p to where the fall from p ends on the ground, and to where the rise to q begins.
    const double end_of_fall =
        road.grade + slope > 0 ? (p.z - ground_p) / (road.grade + slope) : length;
    const double begin_of_rise =
        road.grade - slope > 0 ? length - (q.z - ground_q) / (road.grade - slope) : 0;
    if (end_of_fall < begin_of_rise) {
      for (const double at : {end_of_fall, begin_of_rise})
        if (at > same_place && at < length - same_place)
          out->push_back({p.at + at, ground_p + slope * at});
      return;
    }
    // The two meet above the ground.
    const double meet = (p.z - q.z + road.grade * length) / (2 * road.grade);
    if (meet > same_place && meet < length - same_place)
      out->push_back({p.at + meet, p.z - road.grade * meet});
  }

  static constexpr double rounding_of_heights = 1e-9;  // metres

  const std::vector<GradedRoad>& roads_;
  const std::vector<Lift>& lifts_;
  std::vector<std::set<double>> places_;
  std::vector<std::vector<Station>> stations_;
  std::map<std::int64_t, int> node_;
  std::vector<double> ground_, height_;
  std::vector<std::vector<Step>> steps_;
  std::vector<std::pair<int, int>> before_;  // the vertex that raised it, and by which lift
  std::vector<bool> passed_over_;
};

}  // namespace

std::vector<HeightLine> least_heights(const std::vector<GradedRoad>& roads,
                                      const std::vector<Lift>& lifts,
                                      const std::vector<LeastHeight>& by_hand) {
  return Solver(roads, lifts, by_hand).solve();
}

}  // namespace streetgen
