#include "streetgen/two_towns.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/polyline.hpp"
#include "support/random.hpp"
#include "virtual_city/highway.hpp"
#include "virtual_city/interchange.hpp"
#include "virtual_city/placement.hpp"
#include "virtual_city/portable_math.hpp"

namespace streetgen {

namespace {

// From the middle line of the highway to the country roads, and to where a town begins.
constexpr double to_country_road = 350, to_town = 500;
constexpr double most_aside = 60, aside_share = 0.04;  // how far a country road strays, by its way
constexpr double country_width = 6.5, country_speed = 80, crossing_speed = 70, overpass_speed = 60;

const char* const town_names[] = {"Weston", "Easton"};

// The class of a town's street by its level, and its importance.
struct StreetClass {
  const char* kind;
  int importance;
};
constexpr StreetClass street_classes[] = {{"primary", 2}, {"tertiary", 4}, {"residential", 5}};

TownAxis country_road(const std::string& name, const char* kind, int importance, double speed) {
  TownAxis axis;
  axis.name = name;
  axis.kind = kind;
  axis.importance = importance;
  axis.width = country_width;
  axis.lane_count = 2;
  axis.speed = speed;
  return axis;
}

class Country {
 public:
  Country(std::uint64_t key, bool keeps_left, const TwoTownsOptions& options)
      : key_(key),
        keeps_left_(keeps_left),
        options_(options),
        random_(Random::part(key, 0)),
        highway_(highway_between(options, random_)) {}

  std::vector<TownAxis> run() {
    carriageways();
    for (const int left : {1, -1}) country_road_along(left);
    for (std::size_t i = 1; i + 1 < highway_.crossings.size(); ++i)
      add(road_over(
          highway_, crossing(i), {to_country_road, -to_country_road},
          country_road("Overpass Road " + std::to_string(i), "tertiary", 4, overpass_speed)));
    town(0, crossing(0));
    town(1, crossing(highway_.crossings.size() - 1));
    return std::move(axes_);
  }

 private:
  void add(std::vector<TownAxis> more) {
    std::move(more.begin(), more.end(), std::back_inserter(axes_));
  }
  const HighwayStation& crossing(std::size_t i) const {
    return highway_.stations[highway_.crossings[i]];
  }

  void carriageways() {
    for (const int along : {1, -1}) {
      TownAxis axis;
      for (const HighwayStation& station : highway_.stations)
        if (station.carriageways)
          axis.line.push_back(station.at - station.left * (along * highway_.half));
      if (along < 0) std::reverse(axis.line.begin(), axis.line.end());
      axis.name = along > 0 ? "Highway East" : "Highway West";
      axis.kind = "motorway";
      axis.width = highway_.carriageway_width;
      axis.lane_count = static_cast<int>(options_.highway_lanes);
      axis.importance = 1;
      axis.speed = options_.highway_speed;
      axis.direction = CityDirection::direct;
      axes_.push_back(axis);
    }
  }

  // Between two crossings it strays from the highway's course, and comes back to it.
  void country_road_along(int left) {
    TownAxis road = country_road((left > 0) != keeps_left_ ? "North Road" : "South Road",
                                 "secondary", 3, country_speed);
    std::size_t next = 0;  // crossing
    double aside = 0;      // metres at most
    for (std::size_t i = 0; i < highway_.stations.size(); ++i) {
      const HighwayStation& station = highway_.stations[i];
      if (!station.country_roads) continue;
      double offset = to_country_road;
      if (next > 0 && next < highway_.crossings.size()) {
        const double from = crossing(next - 1).abscissa, way = crossing(next).abscissa - from;
        const double at = (station.abscissa - from) / way, rise = 4 * at * (1 - at);
        offset += aside * rise * rise;
      }
      road.line.push_back(station.at + station.left * (left * offset));
      if (next == highway_.crossings.size() || i != highway_.crossings[next]) continue;
      if (++next == highway_.crossings.size()) continue;
      const double way = crossing(next).abscissa - station.abscissa;
      aside = std::min(most_aside, aside_share * way) * random_.uniform(-1, 1);
    }
    axes_.push_back(road);
  }

  // The streets of a town, its road to the highway and the ramps there.
  void town(int which, const HighwayStation& at) {
    const int side = random_.chance(0.5) ? 1 : -1;
    const double size = options_.town_size;
    const std::vector<CityAxis> streets = virtual_city(
        {0, 0, size, size},
        static_cast<std::int64_t>(Random::part(key_, static_cast<std::uint64_t>(1 + which)).next()),
        options_);
    // The main road begins on the left border, which is turned towards the highway.
    const Point start = streets.front().line.front();
    const Point away = at.left * side, aside = left_normal(away);
    for (const CityAxis& drawn : streets) {
      TownAxis axis;
      static_cast<CityAxis&>(axis) = drawn;
      for (Point& p : axis.line) p = at.at + away * (to_town + p.x) + aside * (p.y - start.y);
      const StreetClass& of = street_classes[std::min(axis.level, 2)];
      axis.kind = of.kind;
      axis.importance = of.importance;
      axis.name = town_names[which] + (" " + axis.name);
      axis.built_up = true;
      axes_.push_back(axis);
    }
    TownAxis road = country_road(town_names[which] + std::string(" Road"), street_classes[0].kind,
                                 street_classes[0].importance, crossing_speed);
    road.width = streets.front().width;
    road.lane_count = streets.front().lane_count;
    const double ramps_at = to_ramps(highway_);
    std::vector<double> vertices = {to_country_road, ramps_at, -ramps_at, -to_country_road};
    vertices.insert(side > 0 ? vertices.begin() : vertices.end(), side * to_town);
    add(road_over(highway_, at, vertices, road));
    add(ramps(highway_, at, options_, town_names[which]));
  }

  std::uint64_t key_;
  bool keeps_left_;
  const TwoTownsOptions& options_;
  Random random_;
  Highway highway_;
  std::vector<TownAxis> axes_;
};

}  // namespace

std::vector<TownAxis> two_towns(double x, double y, std::int64_t seed, bool keeps_left,
                                const TwoTownsOptions& options) {
  check_corner(x, y);
  std::vector<TownAxis> axes = Country(static_cast<std::uint64_t>(seed), keeps_left, options).run();
  Point low{1e300, 1e300, 0};
  for (TownAxis& axis : axes)
    for (Point& p : axis.line) {
      if (keeps_left) p.y = -p.y;
      p = portable::to_millimetre(p);
      low = {std::min(low.x, p.x), std::min(low.y, p.y), 0};
    }
  move_axes(axes, low, {x, y, 0});
  return axes;
}

}  // namespace streetgen
