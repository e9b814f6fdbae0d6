#include "streetgen/virtual_city.hpp"

#include <algorithm>
#include <cmath>

#include "city_growth.hpp"
#include "portable_math.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

double at_level(const std::vector<double>& list, int level) {
  return list[std::min<std::size_t>(static_cast<std::size_t>(level), list.size() - 1)];
}

double city_density(const Point& at, const CityExtent& extent, const CityOptions& options) {
  const double sx = options.deviation * extent.width, sy = options.deviation * extent.height;
  double density = 0;
  for (std::size_t i = 0; i + 1 < options.centres.size(); i += 2) {
    const double dx = (at.x - extent.x - options.centres[i] * extent.width) / sx;
    const double dy = (at.y - extent.y - options.centres[i + 1] * extent.height) / sy;
    density = std::max(density, portable::decay(dx * dx / 2 + dy * dy / 2));
  }
  return density;
}

namespace {

// The line of a street with a vertex at each of its nodes.
Line noded_line(const CityStreet& street) {
  Line line;
  std::size_t bend = 0;
  for (const CityNode& node : street.nodes) {
    for (; bend < street.line.size() && street.abscissas[bend] < node.abscissa; ++bend)
      line.push_back(street.line[bend]);
    if (bend < street.line.size() && street.abscissas[bend] == node.abscissa) ++bend;
    line.push_back(node.point);
  }
  return line;
}

std::string name_of(const CityStreet& street, std::size_t number) {
  static const char* const kinds[] = {"Main Road", "Avenue", "Street", "Lane"};
  return std::string(kinds[std::min(street.level, 3)]) + " " + std::to_string(number + 1);
}

CityAxis axis_of(const CityStreet& street, std::size_t number, const CityOptions& options) {
  CityAxis axis;
  axis.line = noded_line(street);
  axis.level = street.level;
  axis.width = street.width;
  axis.lane_count = static_cast<int>(at_level(options.lanes, street.level));
  axis.importance = std::min(street.level + 1, 5);
  axis.speed = at_level(options.speed, street.level);
  axis.name = name_of(street, number);
  return axis;
}

void check(const CityExtent& extent, const CityOptions& options) {
  const double widest =
      options.lane_width * *std::max_element(options.lanes.begin(), options.lanes.end());
  for (const auto& [name, size] : {std::pair<const char*, double>{"width", extent.width},
                                   std::pair<const char*, double>{"height", extent.height}}) {
    const double least = 2 * (widest + options.clearance);
    if (!(size >= least && size <= 1e6))
      throw Error(ErrorKind::invalid_input,
                  "the " + std::string(name) + " of the extent is " + text_of(size) +
                      " m, expected " + text_of(least) + " to 1000000 m",
                  "The least is twice the widest road and its clearance.");
  }
  if (!(std::fabs(extent.x) <= 1e9 && std::fabs(extent.y) <= 1e9))
    throw Error(ErrorKind::invalid_input,
                "the lower left corner is " + text_of(extent.x) + ", " + text_of(extent.y) +
                    ", expected metres up to 1e9",
                "Give the corner in the coordinates of the SRID.");
  if (options.threshold[0] > options.threshold[1])
    throw Error(ErrorKind::invalid_input,
                "option \"threshold\" goes from " + text_of(options.threshold[0]) + " to " +
                    text_of(options.threshold[1]),
                "Give the smaller number first.");
  if (options.centres.size() % 2 != 0)
    throw Error(ErrorKind::invalid_input,
                "option \"centres\" has " + std::to_string(options.centres.size()) + " numbers",
                "Give two numbers for each centre, [[x, y], ...].");
}

}  // namespace

std::vector<CityAxis> virtual_city(const CityExtent& extent, std::int64_t seed,
                                   const CityOptions& options) {
  check(extent, options);
  std::vector<CityAxis> axes;
  const std::vector<CityStreet> streets =
      grown_streets(extent, static_cast<std::uint64_t>(seed), options);
  for (std::size_t i = 0; i < streets.size(); ++i) axes.push_back(axis_of(streets[i], i, options));
  const Point corner = portable::to_millimetre({extent.x, extent.y, 0});
  for (CityAxis& axis : axes)
    for (Point& p : axis.line) p = portable::to_millimetre(p + corner);
  return axes;
}

}  // namespace streetgen
