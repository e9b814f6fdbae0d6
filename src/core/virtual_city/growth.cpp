#include "virtual_city/growth.hpp"

#include <algorithm>
#include <cmath>

#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "virtual_city/ground.hpp"
#include "virtual_city/portable_math.hpp"
#include "support/random.hpp"

namespace streetgen {

namespace {

// A road with bends is made of chords of this length.
constexpr double chord = 25;
// A road turns off the direction in which it started by no more, so that it never meets itself.
constexpr double most_turned = 50;

// The share of roads that leave to the same side as the one before.
constexpr double same_side = 0.15;
// More would not fit into the memory of most machines.
constexpr std::size_t most_streets = 6000000, most_pieces = 20000000;

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
    const double across = 2 * (extent_.width + extent_.height);
    grow(street, portable::to_millimetre(from), portable::unit(to - from), across, across, random);
    add(std::move(street), -1);
  }

  void outgoing_roads(int main) {
    const int level = streets_[main].level + 1;
    const double most = longest(level), length = streets_[main].length();
    const double spacing = std::max(options_.spacing_least, options_.spacing_ratio * most);
    const int places = static_cast<int>(length / spacing);
    double last = 0;  // start
    // To the left and to the right in turn, now and then twice to one side.
    bool to_left = Random(streets_[main].key).chance(0.5);
    for (int place = 0; place < places; ++place) {
      Random random = Random::part(streets_[main].key, static_cast<std::uint64_t>(place));
      const double in_place = 0.5 + options_.scatter * random.uniform(-0.5, 0.5);
      const double abscissa = length * ((place + in_place) / places);
      if (abscissa - last >= options_.start_gap && length - abscissa >= options_.start_gap &&
          outgoing_road(main, abscissa, most, to_left, random))
        last = abscissa;
      to_left = to_left == random.chance(same_side);
    }
  }

  // To one side, or to the other where that is built up.
  bool outgoing_road(int main, double abscissa, double most, bool to_left, Random& random) {
    const CityStreet& from = streets_[main];
    CityStreet street = street_of(main, from.level + 1, random.next());
    const auto piece = static_cast<std::size_t>(
        std::lower_bound(from.abscissas.begin() + 1, from.abscissas.end(), abscissa) -
        from.abscissas.begin());
    const Point along = portable::unit(from.line[piece] - from.line[piece - 1]);
    const Point start = portable::to_millimetre(from.line[piece - 1] +
                                                along * (abscissa - from.abscissas[piece - 1]));
    const double threshold = random.uniform(options_.threshold[0], options_.threshold[1]);
    street.to_left = to_left;
    const double angle = random.chance(options_.right_angles)
                             ? 90
                             : random.uniform(options_.angle_least, 180 - options_.angle_least);
    const double wanted = most * random.uniform(options_.length_drawn, 1);
    if (city_density(start, extent_, options_) < threshold ||
        ground_.occupied(start, street.width, main))
      return false;
    for (int side = 0; side < 2; ++side, street.to_left = !street.to_left) {
      const Point direction = portable::turned(along, street.to_left ? angle : -angle);
      const bool leaves =
          leaving_ < options_.transit && wanted > to_border(start, direction) && random.chance(0.4);
      grow(street, start, direction,
           leaves ? wanted : inside_city(start, direction, wanted, options_.fade * threshold), most,
           random);
      if (street.length() < options_.start_gap) continue;
      add(std::move(street), abscissa);
      return true;
    }
    return false;
  }

  // Metres of a road until the density falls below `least`.
  double inside_city(const Point& start, const Point& direction, double wanted,
                     double least) const {
    const double step = std::max(options_.start_gap, 1e-3 * longest(0));
    double at = 0;
    while (at < wanted && city_density(start + direction * at, extent_, options_) >= least)
      at += step;
    return std::min(at, wanted);
  }

  CityStreet street_of(int main, int level, std::uint64_t key) const {
    CityStreet street;
    street.main = main;
    street.level = level;
    street.width = at_level(options_.lanes, level) * options_.lane_width;
    street.key = key;
    return street;
  }

  // Draws a street until it meets a road, leaves the extent or is as long as wanted.
  void grow(CityStreet& street, const Point& start, Point direction, double wanted, double most,
            Random& random) {
    street.line = {start};
    street.abscissas = {0};
    street.end = CityEnd::blind_alley;
    const double piece = options_.bend > 0 ? chord : wanted;
    double turned = 0, turn = 0;
    for (double left = wanted; left > on_spot; left = wanted - street.length()) {
      const double step = std::min(left, piece);
      const double further = std::min(ground_.ahead(), most - street.length() - step);
      if (!advance(street, direction, step, std::max(further, 0.0), step == left)) break;
      const double before = turned;
      turn = 0.8 * turn + random.uniform(-1, 1) * options_.bend * (chord / 100) - 0.02 * turned;
      turned = std::min(std::max(turned + turn, -most_turned), most_turned);
      if (options_.bend > 0) direction = portable::turned(direction, turned - before);
    }
  }

  // One straight piece, the last one even further if there is a road.  False where the street ends.
  bool advance(CityStreet& street, const Point& direction, double step, double further, bool last) {
    const Point from = street.line.back();
    const double border = to_border(from, direction);
    const CityWay way = ground_.way(from, from + direction * std::min(border, step + further),
                                    street.width, street.main);
    if (way.meets && (last || way.free < step || *way.meets < step) &&
        join(street, from, from + direction * *way.meets, way.piece))
      return false;
    const double free = std::min(way.free, step);
    if (border <= free) {
      leave(street, from, direction, border);
      return false;
    }
    if (free > on_spot) append(street, from + direction * free);
    return free == step;
  }

  // Ends the street on the border, or before where enough roads leave already.
  void leave(CityStreet& street, const Point& from, const Point& direction, double border) {
    if (street.length() + border < options_.start_gap) return;
    if (street.main < 0 || leaving_ < options_.transit) {
      append(street, from + direction * border);
      street.end = CityEnd::border;
      ++leaving_;
    } else if (border > 2 * options_.start_gap) {
      append(street, from + direction * (border * 0.7));
    }
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
        street.length() + portable::distance(from, at) < options_.start_gap ||
        !ground_.may_join(from, at, street.width, street.main))
      return false;
    if (nearest == nullptr) road.nodes.insert(after, {abscissa, at});
    append(street, at);
    street.end = CityEnd::road;
    street.ends_on = across.street;
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
    if (streets_.size() == most_streets || ground_.pieces() > most_pieces)
      throw Error(ErrorKind::invalid_input,
                  "the city has more than " + std::to_string(most_streets) + " streets or " +
                      std::to_string(most_pieces) + " bends",
                  "Make its extent smaller, or spacing_least and clearance greater.");
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
  double leaving_ = 1;  // ends on the border; the first road's start is one
};

}  // namespace

std::vector<CityStreet> grown_streets(const CityExtent& extent, std::uint64_t seed,
                                      const CityOptions& options) {
  return Growth(extent, seed, options).run();
}

}  // namespace streetgen
