#include "streetgen/detect_arcs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "geometry/fit_circle.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double short_chord = 3;           // metres
constexpr double turn_of_point = M_PI / 3;  // radians, the most
constexpr double share_of_point = 0.45;     // of an arc's turn, the most
constexpr double share_of_height = 0.1;     // of an arc's height, the most that its points lie off
constexpr double times_noise = 1.75;        // of the points of an arc, off which another is none
constexpr double stretch_of_noise = 15;     // times noise: a stretch that noise hardly turns
constexpr double share_of_tolerance = 0.2;  // that counts as such noise in any case
constexpr double vote_cell = 2;             // metres: centres in one cell vote for one circle
constexpr int least_support = 4;

// From the direction before the point to the one behind it, radians.
double turn_at(const Point& before, const Point& at, const Point& behind) {
  const Point a = at - before, b = behind - at;
  return std::atan2(cross(a, b), dot(a, b));
}

// Points `first` to `last` of the line, both on the circle.
struct Run {
  int first = 0, last = 0;
  Circle circle;
  int count() const { return last - first + 1; }
};

class ArcSearch {
 public:
  ArcSearch(const Line& line, const ArcBounds& bounds) : bounds_(bounds), points_(distinct(line)) {
    for (Point& p : points_) p.z = 0;
    closed_ = points_.size() > 3 && distance(points_.front(), points_.back()) <= same_place;
    sides_ = static_cast<int>(points_.size()) - 1;
    // Twice about: an arc may go on over the start.
    if (closed_)
      for (int i = 1; i <= sides_; ++i) points_.push_back(points_[i]);
    taken_.resize(sides_ > 0 ? sides_ : 0);
  }

  std::vector<DetectedArc> arcs() {
    if (sides_ < least_support - 1) return {};
    for (Run& seed : voted_runs()) {
      poll_cancel();
      if (is_taken(seed)) continue;
      grow(seed);
      leave_tangents(seed);
      if (is_taken(seed) || !is_arc(seed)) continue;
      for (int i = seed.first; i < seed.last; ++i) taken_[i % sides_] = true;
      found_.push_back(seed);
    }
    std::sort(found_.begin(), found_.end(),
              [](const Run& a, const Run& b) { return a.first < b.first; });
    std::vector<DetectedArc> arcs;
    for (const Run& run : found_) arcs.push_back(arc_of(run));
    return arcs;
  }

 private:
  // Quadruplets of points with the same number of sides between them, which lie on a circle: by the
  // votes for the cell of their centre, then the longest first.
  std::vector<Run> voted_runs() const {
    using Cell = std::pair<std::int64_t, std::int64_t>;
    std::map<Cell, int> votes;
    std::vector<std::pair<Cell, Run>> runs;
    const int starts = closed_ ? sides_ : static_cast<int>(points_.size());
    for (int step = 1; 3 * step <= sides_; step *= 2) {
      for (int i = 0; i < starts && i + 3 * step < static_cast<int>(points_.size()); ++i) {
        if (i % 256 == 0) poll_cancel();
        const Point four[4] = {points_[i], points_[i + step], points_[i + 2 * step],
                               points_[i + 3 * step]};
        const auto circle = fit_circle(four, 4);
        if (!circle || !fits(*circle) || !near(*circle, i, i + 3 * step)) continue;
        const Cell cell{std::llround(std::floor(circle->centre.x / vote_cell)),
                        std::llround(std::floor(circle->centre.y / vote_cell))};
        ++votes[cell];
        runs.push_back({cell, {i, i + 3 * step, *circle}});
      }
    }
    std::sort(runs.begin(), runs.end(), [&](const auto& a, const auto& b) {
      return std::tuple(-votes[a.first], -a.second.count(), a.second.first) <
             std::tuple(-votes[b.first], -b.second.count(), b.second.first);
    });
    std::vector<Run> sorted;
    for (const auto& [cell, run] : runs) sorted.push_back(run);
    return sorted;
  }

  // With room for what the noise of a few points does to a radius.
  bool fits(const Circle& circle) const {
    return circle.radius >= bounds_.radius_least / 2 &&
           circle.radius <= 2 * bounds_.radius_greatest;
  }

  bool near(const Circle& circle, int first, int last) const {
    for (int i = first; i <= last; ++i)
      if (deviation(circle, i) > bounds_.tolerance) return false;
    return true;
  }

  double deviation(const Circle& circle, int i) const {
    return std::abs(distance(points_[i], circle.centre) - circle.radius);
  }

  // About the centre, radians, counter-clockwise positive.
  double angle(const Circle& circle, int i) const {
    const Point a = points_[i] - circle.centre, b = points_[i + 1] - circle.centre;
    return std::atan2(cross(a, b), dot(a, b));
  }

  // Whether the side from point i on may be a chord of the circle, which turns as `sense` says.
  bool is_chord(const Circle& circle, int i, double sense) const {
    const double chord = distance(points_[i], points_[i + 1]), about = angle(circle, i);
    const double height = circle.radius * (1 - std::cos(about / 2));
    return about * sense > -2 * bounds_.tolerance / circle.radius &&
           std::abs(about) <= 2 * turn_of_point &&
           (chord <= short_chord || height <= 2 * bounds_.tolerance);
  }

  // To all points that go on from the run on its circle, fitted anew with them.
  void grow(Run& run) const {
    const int most = static_cast<int>(points_.size());
    for (int round = 0; round < 20; ++round) {
      const Run before = run;
      const double sense = turn(run) < 0 ? -1 : 1;
      while (run.last + 1 < most && run.count() <= sides_ && !taken_[run.last % sides_] &&
             deviation(run.circle, run.last + 1) <= bounds_.tolerance &&
             is_chord(run.circle, run.last, sense))
        ++run.last;
      while (run.first > 0 && run.count() <= sides_ && !taken_[(run.first - 1) % sides_] &&
             deviation(run.circle, run.first - 1) <= bounds_.tolerance &&
             is_chord(run.circle, run.first - 1, sense))
        --run.first;
      const auto circle = fit_circle(&points_[run.first], run.count());
      if (!circle) return;
      run.circle = *circle;
      // Points that the better circle leaves go.
      while (run.count() > least_support && deviation(run.circle, run.last) > bounds_.tolerance)
        --run.last;
      while (run.count() > least_support && deviation(run.circle, run.first) > bounds_.tolerance)
        ++run.first;
      if (run.first == before.first && run.last == before.last) return;
    }
  }

  // Ends that lie beside the circle of the others, by far more than these do, are on the straight
  // lines before and behind the arc: they would make it flatter or tighter.
  void leave_tangents(Run& run) const {
    while (run.count() > least_support + 1) {
      poll_cancel();
      const Run without_first = without(run, 1, 0), without_last = without(run, 0, 1);
      const double first = beside(without_first, run.first), last = beside(without_last, run.last);
      if (std::max(first, last) <= 1) return;
      run = first > last ? without_first : without_last;
    }
  }

  Run without(const Run& run, int before, int behind) const {
    Run rest{run.first + before, run.last - behind, run.circle};
    if (const auto circle = fit_circle(&points_[rest.first], rest.count())) rest.circle = *circle;
    return rest;
  }

  // How far the points of a run lie off its circle, by their squares.
  double noise(const Run& run) const {
    double squares = 0;
    for (int i = run.first; i <= run.last; ++i) squares += std::pow(deviation(run.circle, i), 2);
    return std::sqrt(squares / std::max(1, run.count() - 3));
  }

  // How far point i lies off the circle of a run, by what the points of that may lie off.
  double beside(const Run& run, int i) const {
    return deviation(run.circle, i) /
           std::max(times_noise * noise(run), share_of_tolerance * bounds_.tolerance);
  }

  double turn(const Run& run) const {
    double sum = 0;
    for (int i = run.first; i < run.last; ++i) sum += angle(run.circle, i);
    return sum;
  }

  bool is_taken(const Run& run) const {
    for (int i = run.first; i < run.last; ++i)
      if (taken_[i % sides_]) return true;
    return false;
  }

  // Whether the line turns by at most so much at each point of a run, between points at least a
  // stretch before and behind it.
  bool turns_at_most(const Run& run, double most, double stretch) const {
    int before = run.first, behind = run.first + 2;
    for (int i = run.first + 1; i < run.last; ++i) {
      if (i % 256 == 0) poll_cancel();
      const auto near = [&](int k) { return distance(points_[i], points_[k]) < stretch; };
      while (before > run.first && near(before)) --before;
      while (before < i - 1 && !near(before + 1)) ++before;
      behind = std::max(behind, i + 1);
      while (behind < run.last && near(behind)) ++behind;
      while (behind > i + 1 && !near(behind - 1)) --behind;
      if (std::abs(turn_at(points_[before], points_[i], points_[behind])) > most) return false;
    }
    return true;
  }

  bool is_arc(const Run& run) const {
    if (run.count() < least_support || run.circle.radius < bounds_.radius_least ||
        run.circle.radius > bounds_.radius_greatest || !near(run.circle, run.first, run.last))
      return false;
    const double all = turn(run), sense = all < 0 ? -1 : 1;
    if (std::abs(all) < bounds_.turn_least * M_PI / 180) return false;
    const double height = run.circle.radius * (1 - std::cos(std::min(std::abs(all), M_PI) / 2));
    const double off = noise(run);
    if (off > share_of_height * height) return false;
    for (int i = run.first; i < run.last; ++i)
      if (!is_chord(run.circle, i, sense)) return false;
    return turns_at_most(run, std::min(turn_of_point, share_of_point * std::abs(all)),
                         stretch_of_noise * off);
  }

  DetectedArc arc_of(const Run& run) const {
    DetectedArc found;
    found.centre = run.circle.centre;
    found.radius = run.circle.radius;
    found.support = run.count();
    for (int i = run.first; i <= run.last; ++i)
      found.deviation = std::max(found.deviation, deviation(run.circle, i));
    const auto on_circle = [&](double around) {
      return found.centre + Point{std::cos(around), std::sin(around), 0} * found.radius;
    };
    const Point out = points_[run.first] - found.centre;
    const double start = std::atan2(out.y, out.x), all = turn(run);
    const bool whole = closed_ && run.count() > sides_;
    const double turned = whole ? (all < 0 ? -2 : 2) * M_PI : all;
    found.arc = {on_circle(start), on_circle(start + turned / 2),
                 whole ? on_circle(start) : on_circle(start + turned)};
    if (closed_ && whole) --found.support;
    return found;
  }

  const ArcBounds& bounds_;
  Line points_;
  bool closed_ = false;
  int sides_ = 0;
  std::vector<bool> taken_;  // by side
  std::vector<Run> found_;
};

}  // namespace

std::vector<DetectedArc> detect_arcs(const Line& line, const ArcBounds& bounds) {
  return ArcSearch(line, bounds).arcs();
}

}  // namespace streetgen
