#include "virtual_city/interchange.hpp"

#include <algorithm>

#include "geometry/polyline.hpp"
#include "virtual_city/portable_math.hpp"

namespace streetgen {

namespace {

constexpr double to_abutment = 8;      // from the outer kerb of the highway
constexpr double kerb_to_ramps = 75;   // from there to where ramps meet the road of the town
constexpr double diverging = 150;      // metres on which a ramp comes clear of the highway
constexpr double beside_highway = 9;   // from kerb to axis, where it is clear
constexpr double square = 50;          // a ramp meets the road of the town at right angles so far
constexpr double ramp_friction = 0.2;  // that the bend of a ramp asks of a car, banked or not
constexpr double arc_chord = 6;
constexpr double ramp_width = 5.5;  // a lane, and room to pass a car that stands

// The arc from a to b about a centre, without its ends.
void add_arc(Line& line, const Point& a, const Point& b, const Point& centre, double radius) {
  if (portable::distance(a, b) <= arc_chord) return;
  const Point middle = centre + portable::unit(a - centre + (b - centre)) * radius;
  add_arc(line, a, middle, centre, radius);
  line.push_back(middle);
  add_arc(line, middle, b, centre, radius);
}

// A line whose bends are arcs of that radius, or of what a piece at an end, or half of another
// piece, has room for.
Line rounded(const Line& corners, double radius) {
  Line line = {corners.front()};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Point before = portable::unit(corners[i] - corners[i - 1]);
    const Point behind = portable::unit(corners[i + 1] - corners[i]);
    const double turn = cross(before, behind), half = std::fabs(turn) / (1 + dot(before, behind));
    if (half == 0) continue;
    const auto room = [&](std::size_t piece) {
      const double length = portable::distance(corners[piece], corners[piece + 1]);
      return piece == 0 || piece + 2 == corners.size() ? length : length / 2;
    };
    const double tangent = std::min({radius * half, room(i - 1), room(i)}), r = tangent / half;
    const Point from = corners[i] - before * tangent, to = corners[i] + behind * tangent;
    line.push_back(from);
    add_arc(line, from, to, from + left_normal(before) * (turn > 0 ? r : -r), r);
    line.push_back(to);
  }
  line.push_back(corners.back());
  return line;
}

}  // namespace

double to_ramps(const Highway& highway) { return highway.outer + kerb_to_ramps; }

std::vector<TownAxis> road_over(const Highway& highway, const HighwayStation& station,
                                const std::vector<double>& vertices, const TownAxis& road) {
  const double abutment = highway.outer + to_abutment;
  TownAxis left = road, bridge = road, right = road;
  for (const double vertex : vertices)
    (vertex > 0 ? left : right).line.push_back(station.at + station.left * vertex);
  bridge.line = {station.at + station.left * abutment, station.at - station.left * abutment};
  bridge.bridge = true;
  left.line.push_back(bridge.line.front());
  right.line.insert(right.line.begin(), bridge.line.back());
  return {left, bridge, right};
}

std::vector<TownAxis> ramps(const Highway& highway, const HighwayStation& station,
                            const TwoTownsOptions& options, const std::string& town) {
  // Off the carriageway that leads along the x axis, right of it.
  const double length = options.ramp_length, terminal = to_ramps(highway);
  const double speed = options.ramp_speed / 3.6;
  const Line off = rounded({{-length, -highway.half, 0},
                            {diverging - length, -highway.outer - beside_highway, 0},
                            {-square, -terminal, 0},
                            {0, -terminal, 0}},
                           speed * speed / (9.81 * ramp_friction));
  std::vector<TownAxis> axes;
  for (const int along : {1, -1})
    for (const bool leaves : {true, false}) {
      TownAxis ramp;
      for (const Point& p : off)
        ramp.line.push_back(station.at + Point{leaves ? p.x : -p.x, p.y, 0} * along);
      if (!leaves) std::reverse(ramp.line.begin(), ramp.line.end());
      ramp.name = town + (leaves ? " Exit " : " Entrance ") + (along > 0 ? "East" : "West");
      ramp.kind = "motorway_link";
      ramp.width = ramp_width;
      ramp.lane_count = 1;
      ramp.importance = 2;
      ramp.speed = options.ramp_speed;
      ramp.direction = CityDirection::direct;
      axes.push_back(ramp);
    }
  return axes;
}

}  // namespace streetgen
