#include "town.hpp"

#include <algorithm>
#include <cmath>

namespace streetgen::fuzz {

namespace {

Point beside(Random& random, const Point& p, double reach) {
  const double heading = random.between(0, 2 * M_PI);
  return {p.x + reach * std::cos(heading), p.y + reach * std::sin(heading), 0};
}

Point beyond(const Point& p, double heading, double size) {
  return {p.x + size * std::cos(heading), p.y + size * std::sin(heading), 0};
}

// One kind of trouble after the other, into one list of lines.
class Lines {
 public:
  Lines(Random& random, double tolerance) : random_(random), tolerance_(tolerance) {
    const Point origin = random.of(
        std::vector<Point>{{0, 0, 0}, {650000, 6860000, 0}, {1e9, 1e9, 0}, {-1e9, 5e8, 0}});
    const double extent = random.scaled(20, 600);
    for (int i = 0; i < 3 + random.below(10); ++i)
      places_.push_back(
          {origin.x + random.between(0, extent), origin.y + random.between(0, extent), 0});
  }

  std::vector<Line> draw() {
    for (int count = 1 + random_.below(14); count > 0; --count) switch (random_.below(7)) {
        case 0:
          crooked();
          break;
        case 1:
          star();
          break;
        case 2:
          collinear();
          break;
        case 3:
          twice();
          break;
        case 4:
          loop();
          break;
        default:
          straight();
      }
    return std::move(lines_);
  }

 private:
  void add(Line line) {
    const bool has_length = std::any_of(line.begin(), line.end(), [&](const Point& p) {
      return p.x != line[0].x || p.y != line[0].y;
    });
    if (has_length) lines_.push_back(std::move(line));
  }

  // A place, missed now and then by about the tolerance.
  Point place() {
    const Point& p = random_.of(places_);
    if (!random_.one_in(4)) return p;
    return beside(random_, p,
                  tolerance_ * random_.of(std::vector<double>{1e-9, 0.5, 0.999, 1, 1.001, 2}));
  }

  void straight() { add({place(), place()}); }

  void crooked() {
    Line line = random_line(random_, place());
    if (random_.one_in(2)) line.push_back(place());
    add(std::move(line));
  }

  void star() {
    const Point centre = place();
    double heading = random_.between(0, 2 * M_PI);
    for (int rays = 2 + random_.below(6); rays > 0; --rays) {
      Line ray{centre, beyond(centre, heading, random_.scaled(0.5, 200))};
      if (random_.one_in(2)) std::reverse(ray.begin(), ray.end());
      add(std::move(ray));
      heading += random_.scaled(1e-6, 2);
    }
  }

  // Part of a line there is, or beyond its end, and not always its way.
  void collinear() {
    if (lines_.empty()) return straight();
    const Line& line = random_.of(lines_);
    const Point a = line[0], b = line[1];
    const auto at = [&](double t) {
      return Point{a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, 0};
    };
    add({at(random_.between(-0.5, 0.9)), at(random_.between(0.1, 1.5))});
  }

  void twice() {
    if (lines_.empty()) return straight();
    Line line = random_.of(lines_);
    if (random_.one_in(2)) std::reverse(line.begin(), line.end());
    if (random_.one_in(3))
      for (Point& p : line) p = beside(random_, p, random_.scaled(1e-3, 2) * tolerance_);
    add(std::move(line));
  }

  void loop() {
    const double radius = random_.scaled(0.3, 60);
    const int sides = 1 + random_.below(12);
    const Point start = place();
    const double heading = random_.between(0, 2 * M_PI);
    Line line{start};
    for (int i = 1; i < sides; ++i)
      line.push_back(
          beyond(line.back(), heading + 2 * M_PI * i / sides, radius * 2 * M_PI / sides));
    line.push_back(start);
    add(std::move(line));
  }

  Random& random_;
  double tolerance_;
  std::vector<Point> places_;
  std::vector<Line> lines_;
};

StreetSettings random_settings(Random& random) {
  StreetSettings settings;
  settings.tolerance = random.of(std::vector<double>{0.5, 0.5, 0.01, 2});
  settings.crossing = random.one_in(2) ? Crossing::split : Crossing::over;
  settings.short_axis = random.one_in(3) ? ShortAxis::follow : ShortAxis::reduce;
  if (random.one_in(4)) settings.smoothing = Smoothing{random.between(0.01, 3), 0.01};
  settings.radius_rule = random.of(std::vector<RadiusRule>{RadiusRule::min, RadiusRule::max,
                                                           RadiusRule::mean, RadiusRule::major});
  settings.transition.kind = random.of(std::vector<TransitionKind>{
      TransitionKind::symmetric, TransitionKind::left, TransitionKind::right});
  settings.round_dead_ends = random.one_in(3);
  return settings;
}

}  // namespace

double Random::scaled(double low, double high) {
  return std::exp(between(std::log(low), std::log(high)));
}

Line random_line(Random& random, const Point& from) {
  Line line{from};
  double heading = random.between(0, 2 * M_PI);
  const double sharpest = random.scaled(1e-4, 4), step = random.scaled(0.02, 40);
  for (int points = 1 + random.below(39); points > 0; --points) {
    if (random.one_in(30)) line.push_back(line.back());
    line.push_back(beyond(line.back(), heading, random.between(0.01, 2) * step));
    heading += random.one_in(20) ? M_PI : random.between(-sharpest, sharpest);
  }
  return line;
}

Town random_town(std::uint64_t seed) {
  Random random(seed);
  Town town;
  town.settings = random_settings(random);
  const double widest = random.scaled(4, 60);
  for (Line& line : Lines(random, town.settings.tolerance).draw()) {
    StreetAxis axis;
    axis.axis_id = static_cast<std::int64_t>(town.axes.size()) + 1;
    axis.line = std::move(line);
    axis.width = random.one_in(2) ? widest : random.scaled(0.1, widest);
    axis.width_end = random.one_in(8) ? random.scaled(0.1, widest) : axis.width;
    axis.radius = random.one_in(5) ? 0 : random.scaled(0.1, 15);
    axis.importance = 1 + random.below(5);
    axis.level = random.one_in(6) ? random.below(3) - 1 : 0;
    town.axes.push_back(std::move(axis));
  }
  return town;
}

StreetOverrides random_overrides(Random& random, const Streets& town) {
  StreetOverrides overrides;
  const auto& edges = town.network.edges;
  for (const Edge& edge : edges)
    for (const bool at_start : {true, false})
      if (random.one_in(2))
        overrides.limits.push_back(
            {edge.axis_id, random.between(edge.start_abscissa, edge.end_abscissa), at_start});
  for (const Corner& corner : town.corners)
    if (random.one_in(2))
      overrides.corners.push_back({town.network.nodes[corner.node].point,
                                   edges[corner.edge_a].axis_id, edges[corner.edge_b].axis_id,
                                   random.one_in(4) ? 0 : random.scaled(0.1, 200)});
  return overrides;
}

}  // namespace streetgen::fuzz
