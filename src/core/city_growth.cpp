#include "city_growth.hpp"

#include <algorithm>
#include <cmath>

#include "city_ground.hpp"
#include "portable_math.hpp"
#include "random.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

// A road with bends is made of chords of this length.
constexpr double chord = 25;
// It turns off the direction in which it started by no more, so that it never meets itself.
constexpr double most_turned = 50;

class Growth {
 public:
  Growth(const CityExtent& extent, std::uint64_t seed, const CityOptions& options)
      : extent_{0, 0, extent.width, extent.height},
        options_(options),
        key_(seed),
        ground_(
            options.clearance, options.angle_least,
            *std::max_element(options.lanes.begin(), options.lanes.end()) * options.lane_width) {}

  std::vector<CityStreet> run() {
    first_road();
    for (std::size_t i = 0; i < streets_.size(); ++i) {
      poll_cancel();
      outgoing_roads(static_cast<int>(i));
    }
    return std::move(streets_);
  }

 private:
  double longest(int level) const {
    double length = std::max(extent_.width, extent_.height);
    for (int i = 0; i < level; ++i) length *= options_.length_ratio;
    return length;
  }

  // Across the whole map, from one of the shorter borders to the other.
  void first_road() {
    Random random = Random::part(key_, 0);
    const double begin = random.uniform(0.35, 0.65), end = random.uniform(0.35, 0.65);
    const bool wide = extent_.width >= extent_.height;
    const Point from =
        wide ? Point{0, begin * extent_.height, 0} : Point{begin * extent_.width, 0, 0};
    const Point to = wide ? Point{extent_.width, end * extent_.height, 0}
                          : Point{end * extent_.width, extent_.height, 0};
    CityStreet street = street_of(-1, 0, random.next());
    grow(street, portable::to_millimetre(from), portable::unit(to - from),
         2 * (extent_.width + extent_.height), random);
    add(std::move(street), -1);
  }

  void outgoing_roads(int main) {
    const int level = streets_[main].level + 1;
    const double most = longest(level), length = streets_[main].length();
    const double spacing = std::max(options_.spacing_least, options_.spacing_ratio * most);
    const int places = static_cast<int>(length / spacing);
    double last = 0;
    for (int place = 0; place < places; ++place) {
      Random random = Random::part(streets_[main].key, static_cast<std::uint64_t>(place));
      const double abscissa = length * ((place + random.uniform()) / places);
      const bool started = outgoing_road(main, abscissa, last, most, random);
      if (started) last = abscissa;
    }
  }

  bool outgoing_road(int main, double abscissa, double last, double most, Random& random) {
    const CityStreet& from = streets_[main];
    if (abscissa - last < options_.start_gap || from.length() - abscissa < options_.start_gap)
      return false;
    CityStreet street = street_of(main, from.level + 1, random.next());
    std::size_t piece = 1;
    while (from.abscissas[piece] < abscissa) ++piece;
    const Point along = portable::unit(from.line[piece] - from.line[piece - 1]);
    const Point start = portable::to_millimetre(from.line[piece - 1] +
                                                along * (abscissa - from.abscissas[piece - 1]));
    if (city_density(start, extent_, options_) <
        random.uniform(options_.threshold[0], options_.threshold[1]))
      return false;
    street.to_left = random.chance(0.5);
    const double angle = random.chance(options_.right_angles)
                             ? 90
                             : random.uniform(options_.angle_least, 180 - options_.angle_least);
    const double wanted = most * random.uniform(options_.length_drawn, 1);
    if (ground_.occupied(start, street.width, main)) return false;
    grow(street, start, portable::turned(along, street.to_left ? angle : -angle), wanted, random);
    if (street.length() < options_.start_gap) return false;
    add(std::move(street), abscissa);
    return true;
  }

  CityStreet street_of(int main, int level, std::uint64_t key) const {
    CityStreet street;
    street.main = main;
    street.level = level;
    street.width = at_level(options_.lanes, level) * options_.lane_width;
    street.key = key;
    return street;
  }

  // Draws a street until it meets a road, leaves the extent or is long enough.
  void grow(CityStreet& street, const Point& start, Point direction, double wanted,
            Random& random) {
    street.line = {start};
    street.abscissas = {0};
    double turned = 0, turn = 0;
    while (street.end == CityEnd::blind_alley && street.length() + on_spot < wanted) {
      const double left = wanted - street.length();
      const double step = options_.bend > 0 ? std::min(left, chord) : left;
      const bool last = step == left;
      if (!advance(street, direction, step, last ? options_.start_gap : 0)) break;
      if (options_.bend > 0) {
        const double before = turned;
        turn = 0.8 * turn + random.uniform(-1, 1) * options_.bend * (chord / 100) - 0.02 * turned;
        turned = std::min(std::max(turned + turn, -most_turned), most_turned);
        direction = portable::turned(direction, turned - before);
      }
    }
  }

  // One straight piece; a road that is met up to `further` metres beyond its end is still
  // reached.  False where the street ends.
  bool advance(CityStreet& street, const Point& direction, double step, double further) {
    const Point from = street.line.back();
    const double border = to_border(from, direction);
    const Point to = from + direction * std::min(border, step + further);
    const CityWay way = ground_.way(from, to, street.width, street.main);
    if (way.meets && join(street, from, from + direction * *way.meets, way.piece)) return false;
    const double free = way.meets || way.free < step ? std::min(way.free, step) : step;
    if (border <= free) {
      if (street.main < 0 || leaving_ < options_.transit) {
        append(street, from + direction * border);
        street.end = CityEnd::border;
        ++leaving_;
      } else if (border > 2 * options_.start_gap) {
        append(street, from + direction * (border * 0.7));
      }
      return false;
    }
    if (free > on_spot) append(street, from + direction * free);
    return free == step;
  }

  // Ends the street on the road it meets, in a node of that road if one is near.
  bool join(CityStreet& street, const Point& from, const Point& met, int piece) {
    const CityPiece& across = ground_.piece(piece);
    CityStreet& road = streets_[across.street];
    Point at = portable::to_millimetre(met);
    double abscissa = across.abscissa + portable::distance(across.a, at);
    const auto after =
        std::lower_bound(road.nodes.begin(), road.nodes.end(), abscissa,
                         [](const CityNode& node, double value) { return node.abscissa < value; });
    const CityNode* nearest = nullptr;
    for (auto node = after - (after != road.nodes.begin());
         node != road.nodes.end() && node <= after; ++node)
      if (std::fabs(node->abscissa - abscissa) < options_.node_gap &&
          (nearest == nullptr ||
           std::fabs(node->abscissa - abscissa) < std::fabs(nearest->abscissa - abscissa)))
        nearest = &*node;
    if (nearest != nullptr) at = nearest->point;
    if (portable::distance(from, at) < on_spot ||
        !ground_.may_join(from, at, street.width, street.main))
      return false;
    if (nearest == nullptr) road.nodes.insert(after, {abscissa, at});
    append(street, at);
    street.end = CityEnd::road;
    return true;
  }

  void append(CityStreet& street, const Point& to) const {
    const Point end = portable::to_millimetre(to);
    street.abscissas.push_back(street.length() + portable::distance(street.line.back(), end));
    street.line.push_back(end);
  }

  double to_border(const Point& from, const Point& direction) const {
    const auto until = [](double at, double step, double size) {
      return step > 0 ? (size - at) / step : step < 0 ? -at / step : 1e300;
    };
    return std::min(until(from.x, direction.x, extent_.width),
                    until(from.y, direction.y, extent_.height));
  }

  void add(CityStreet street, double abscissa_of_start) {
    street.nodes = {{0, street.line.front()}, {street.length(), street.line.back()}};
    if (street.main >= 0) {
      auto& nodes = streets_[street.main].nodes;
      const auto after = std::lower_bound(
          nodes.begin(), nodes.end(), abscissa_of_start,
          [](const CityNode& node, double value) { return node.abscissa < value; });
      nodes.insert(after, {abscissa_of_start, street.line.front()});
    }
    ground_.add(static_cast<int>(streets_.size()), street);
    streets_.push_back(std::move(street));
  }

  // Shorter pieces are not drawn.
  static constexpr double on_spot = 1;

  CityExtent extent_;
  const CityOptions& options_;
  std::uint64_t key_;
  CityGround ground_;
  std::vector<CityStreet> streets_;
  double leaving_ = 0;
};

}  // namespace

std::vector<CityStreet> grown_streets(const CityExtent& extent, std::uint64_t seed,
                                      const CityOptions& options) {
  return Growth(extent, seed, options).run();
}

}  // namespace streetgen
