#include <algorithm>
#include <cmath>
#include <random>

#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "streetgen/road_network.hpp"

namespace streetgen {
namespace {

constexpr int most_tries = 3000;

bool within(const MultiPolygon& area, const Point& p) {
  bool inside = false;
  for (const Polygon& polygon : area)
    for (const Ring& ring : polygon)
      for (std::size_t i = 1; i < ring.size(); ++i) {
        const Point &a = ring[i - 1], &b = ring[i];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
          inside = !inside;
      }
  return inside;
}

class TownPlacer {
 public:
  TownPlacer(const MultiPolygon& surface, const Terrain& terrain, const ZoneGrid& zones,
             const TownWish& wish)
      : area_(surface), terrain_(terrain), zones_(zones), wish_(wish), random_(wish.seed) {
    for (const Polygon& polygon : surface)
      for (const Point& p : polygon.front()) {
        low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), 0};
        high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), 0};
      }
    size_ = area(surface);
  }

  // A place for a town of a kind, and whether there is one.
  bool place(Town& town, const std::vector<Town>& there, int of_its_kind) {
    const double spread = std::sqrt(size_ / std::max(1, of_its_kind)) * wish_.spacing;
    for (int i = 0; i < most_tries; ++i) {
      poll_cancel();
      town.point = {low_.x + share() * (high_.x - low_.x), low_.y + share() * (high_.y - low_.y),
                    0};
      // A crowded area gets its last towns nearer to each other.
      if (fit(town, there, spread * (1 - static_cast<double>(i) / most_tries))) return true;
    }
    return false;
  }

 private:
  double share() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

  bool fit(const Town& town, const std::vector<Town>& there, double spread) const {
    if (!within(area_, town.point)) return false;
    const Terrain::Ground g = terrain_.ground(town.point.x, town.point.y);
    if (std::isnan(g.height) || std::hypot(g.slope_x, g.slope_y) > wish_.steepest) return false;
    if (zones_.at(town.point.x, town.point.y) != nullptr) return false;
    for (const Town& other : there)
      if (distance(planar(other.point), town.point) < (other.kind <= town.kind ? spread : 1))
        return false;
    return true;
  }

  const MultiPolygon& area_;
  const Terrain& terrain_;
  const ZoneGrid& zones_;
  const TownWish& wish_;
  std::mt19937_64 random_;
  Point low_{1e300, 1e300, 0}, high_{-1e300, -1e300, 0};
  double size_ = 0;
};

}  // namespace

std::vector<Town> rank_size_towns(const MultiPolygon& surface, const Terrain& terrain,
                                  const ZoneGrid& zones, const TownWish& wish,
                                  const std::vector<Town>& there) {
  std::vector<Town> all = there, made;
  if (surface.empty()) throw Error(ErrorKind::invalid_input, "the area of the nodes is empty");
  TownPlacer placer(surface, terrain, zones, wish);
  for (int rank = 1; rank <= wish.count; ++rank) {
    Town town;
    town.kind = rank <= wish.cities                ? TownKind::city
                : rank <= wish.cities + wish.towns ? TownKind::town
                                                   : TownKind::village;
    town.importance = std::round(wish.largest / std::pow(rank, wish.exponent));
    const int so_many = town.kind == TownKind::city   ? wish.cities
                        : town.kind == TownKind::town ? wish.cities + wish.towns
                                                      : wish.count;
    if (!placer.place(town, all, so_many)) continue;
    all.push_back(town);
    made.push_back(town);
  }
  return made;
}

}  // namespace streetgen
