#include "streetgen/virtual_city.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "streetgen/error.hpp"
#include "virtual_city/axes.hpp"
#include "virtual_city/growth.hpp"
#include "virtual_city/placement.hpp"
#include "virtual_city/portable_math.hpp"
#include "support/random.hpp"

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

constexpr double longest_side = 1e6;

// The least length of a side of the extent, metres.
double shortest_side(const CityOptions& options) {
  const double widest =
      options.lane_width * *std::max_element(options.lanes.begin(), options.lanes.end());
  return 2 * (widest + options.clearance);
}

void check_side(const char* name, double size, double least) {
  if (!(size >= least && size <= longest_side))
    throw Error(ErrorKind::invalid_input,
                "the " + std::string(name) + " of the extent is " + text_of(size) +
                    " m, expected " + text_of(least) + " to " + text_of(longest_side) + " m",
                "The least is twice the widest road and its clearance.");
}

void check(const CityExtent& extent, const CityOptions& options) {
  // Scaling needs its shape alone.
  const double least = options.axes > 0 ? 1e-3 : shortest_side(options);
  check_side("width", extent.width, least);
  check_side("height", extent.height, least);
  check_corner(extent.x, extent.y);
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

std::vector<CityAxis> drawn(const CityExtent& extent, std::uint64_t seed,
                            const CityOptions& options) {
  std::vector<CityAxis> axes = street_axes(grown_streets(extent, seed, options), options);
  make_roundabouts(axes, seed, options);
  return axes;
}

// Scales the extent until it holds the wanted number of axes.
class Fit {
  using Found = std::optional<std::vector<CityAxis>>;

 public:
  Fit(const CityExtent& extent, std::uint64_t seed, const CityOptions& options)
      : extent_(extent), key_(seed), options_(options) {}

  std::vector<CityAxis> run() {
    // Two levels fewer give a like city, from which the area for each axis is learnt soon.
    int levels = 0;
    while (options_.axes * shrunk(levels + 1) > few) ++levels;
    for (; levels > 0; --levels) draw(shrunk(levels) * options_.axes * area_each_);
    for (; most_drawn() > drawn_; key_ = Random(key_).next())
      if (Found axes = near_expected()) return *axes;
    throw Error(
        ErrorKind::invalid_input,
        "no scale of the extent draws " + text_of(options_.axes) + " axes",
        "The nearest found is " + text_of(nearest_) + "; ask for it, or take another seed.");
  }

 private:
  static constexpr double few = 1000;
  double most_drawn() const { return 10 * options_.axes + 100000; }

  // Share of the area that a city of so many times two levels fewer has.
  double shrunk(int times) const {
    double share = 1;
    for (int i = 0; i < 4 * times; ++i) share *= options_.length_ratio;
    return share;
  }

  Found near_expected() {
    for (int attempt = 0; attempt < 4; ++attempt)
      if (Found axes = draw(options_.axes * area_each_)) return axes;
    // The number of a small city leaps as the extent grows: ever farther from the nearest so far.
    const double area = best_area_;
    for (double away = 1.01; away < 1.5 && drawn_ < most_drawn(); away *= 1.01)
      for (const double beside : {area * away, area / away})
        if (Found axes = draw(beside)) return axes;
    return std::nullopt;
  }

  // The city of that area, if it has the wanted number of axes.
  Found draw(double area) {
    const double smaller = std::min(extent_.width, extent_.height);
    const double scale = std::max(std::sqrt(area / (extent_.width * extent_.height)),
                                  shortest_side(options_) / smaller);
    if (scale * std::max(extent_.width, extent_.height) > longest_side)
      throw Error(ErrorKind::invalid_input,
                  text_of(options_.axes) + " axes need an extent longer than " +
                      text_of(longest_side) + " m",
                  "Ask for fewer, or for an extent nearer to a square.");
    CityExtent scaled = extent_;
    scaled.width = std::round(extent_.width * scale * 1000) / 1000;
    scaled.height = std::round(extent_.height * scale * 1000) / 1000;
    std::vector<CityAxis> axes = drawn(scaled, key_, options_);
    const double count = static_cast<double>(axes.size());
    drawn_ += count + 1;
    area_each_ = scaled.width * scaled.height / count;
    if (std::fabs(count - options_.axes) < std::fabs(nearest_ - options_.axes)) {
      nearest_ = count;
      best_area_ = scaled.width * scaled.height;
    }
    if (std::fabs(count - options_.axes) > 0.05 * options_.axes) return std::nullopt;
    return axes;
  }

  CityExtent extent_;
  std::uint64_t key_;
  const CityOptions& options_;
  double area_each_ = 1.45e5;  // m2 for each axis, as far as is known
  double best_area_ = 0;       // of the nearest number so far
  double nearest_ = 0;
  double drawn_ = 0;
};

}  // namespace

std::vector<CityAxis> virtual_city(const CityExtent& extent, std::int64_t seed,
                                   const CityOptions& options) {
  check(extent, options);
  const auto key = static_cast<std::uint64_t>(seed);
  std::vector<CityAxis> axes =
      options.axes > 0 ? Fit(extent, key, options).run() : drawn(extent, key, options);
  move_axes(axes, {}, {extent.x, extent.y, 0});
  return axes;
}

}  // namespace streetgen
