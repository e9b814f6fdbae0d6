#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "box_index.hpp"
#include "city_axes.hpp"
#include "portable_math.hpp"
#include "random.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

// The ring has a vertex each so many degrees, apart from those where its arms begin.
constexpr double step = 15;
// Of the ring, km/h.
constexpr double ring_speed = 30;
// Kerbs of neighbouring arms are so far apart where they meet the ring.
constexpr double between_arms = 4;

std::uint64_t place_key(const Point& p) {
  const auto x = static_cast<std::int64_t>(std::round(p.x * 1000));
  const auto y = static_cast<std::int64_t>(std::round(p.y * 1000));
  return static_cast<std::uint64_t>(x) << 32 ^ static_cast<std::uint64_t>(y);
}

struct Vertex {
  int axis;
  std::size_t index;
};

struct Arm {
  Point direction;  // unit, away from the crossing
  double width;
};

bool upper(const Point& d) { return d.y > 0 || (d.y == 0 && d.x > 0); }
// By angle from the x axis, counter-clockwise.
bool turns_before(const Point& a, const Point& b) {
  return upper(a) != upper(b) ? upper(a) : cross(a, b) > 0;
}

class Roundabouts {
 public:
  Roundabouts(std::vector<CityAxis>& axes, std::uint64_t key, const CityOptions& options)
      : axes_(axes), key_(key), options_(options), cut_(axes.size()) {
    for (std::size_t i = 0; i < axes_.size(); ++i)
      for (std::size_t k = 0; k < axes_[i].line.size(); ++k) {
        const auto [place, first] = vertices_.try_emplace(place_key(axes_[i].line[k]));
        if (first) places_.push_back(place->first);
        place->second.push_back({static_cast<int>(i), k});
      }
    for (std::size_t i = 0; i < axes_.size(); ++i)
      for (std::size_t k = 1; k < axes_[i].line.size(); ++k) {
        segments_.push_back({static_cast<int>(i), k});
        index_.add(box_of(axes_[i].line[k - 1], axes_[i].line[k]),
                   static_cast<int>(segments_.size()) - 1);
      }
  }

  void make() {
    std::vector<CityAxis> rings;
    for (const std::uint64_t place : places_) {
      poll_cancel();
      if (!Random::part(key_, place).chance(options_.roundabouts)) continue;
      const std::vector<Vertex>& vertices = vertices_.at(place);
      if (std::optional<CityAxis> ring = ring_at(vertices)) {
        ring->name = "Roundabout " + std::to_string(rings.size() + 1);
        rings.push_back(std::move(*ring));
        for (const Vertex& v : vertices) cut_[static_cast<std::size_t>(v.axis)].push_back(v.index);
      }
    }
    cut_axes();
    axes_.insert(axes_.end(), rings.begin(), rings.end());
  }

 private:
  const Line& line(const Vertex& v) const { return axes_[static_cast<std::size_t>(v.axis)].line; }

  std::optional<CityAxis> ring_at(const std::vector<Vertex>& vertices) const {
    const double radius = options_.roundabout_radius;
    const Point centre = line(vertices.front())[vertices.front().index];
    std::vector<Arm> arms;
    CityAxis ring;
    ring.importance = 99;
    for (const Vertex& v : vertices) {
      const CityAxis& axis = axes_[static_cast<std::size_t>(v.axis)];
      ring.level = std::max(ring.level, axis.level);
      ring.importance = std::min(ring.importance, axis.importance);
      ring.lane_count = std::max(ring.lane_count, axis.lane_count >= 4 ? 2 : 1);
      for (const std::size_t next : {v.index - 1, v.index + 1}) {
        if (next >= axis.line.size()) continue;
        // Room for a ring at the other end too.
        if (portable::distance(centre, axis.line[next]) < 2 * radius + options_.node_gap) return {};
        arms.push_back({portable::unit(axis.line[next] - centre), axis.width});
      }
    }
    ring.width = (ring.lane_count + 1) * options_.lane_width;
    if (arms.size() < 3 || built_up(centre, radius + ring.width / 2 + options_.clearance))
      return {};
    std::sort(arms.begin(), arms.end(),
              [](const Arm& a, const Arm& b) { return turns_before(a.direction, b.direction); });
    for (std::size_t i = 0; i < arms.size(); ++i) {
      const Arm &a = arms[i], &b = arms[(i + 1) % arms.size()];
      if (radius * portable::distance(a.direction, b.direction) <
          (a.width + b.width) / 2 + between_arms)
        return {};
    }
    ring.line = ring_line(centre, arms);
    ring.speed = ring_speed;
    ring.direction = CityDirection::direct;
    return ring;
  }

  // Whether a road that does not come to the crossing is that near.
  bool built_up(const Point& centre, double reach) const {
    return index_.any_near(box_of(centre, centre), reach, [&](int i) {
      const Vertex& end = segments_[static_cast<std::size_t>(i)];
      const Point a = line(end)[end.index - 1], b = line(end)[end.index];
      const bool comes = portable::distance(a, centre) == 0 || portable::distance(b, centre) == 0;
      return !comes && portable::distance_to_segment(centre, a, b) < reach;
    });
  }

  Point on_ring(const Point& centre, const Point& direction) const {
    return portable::to_millimetre(centre + direction * options_.roundabout_radius);
  }

  // Counter-clockwise, closed, from its first arm.
  Line ring_line(const Point& centre, const std::vector<Arm>& arms) const {
    std::vector<Point> directions;
    for (const Arm& arm : arms) directions.push_back(arm.direction);
    for (double angle = -180; angle < 180; angle += step) {
      const Point direction = portable::turned({1, 0, 0}, angle);
      if (std::all_of(arms.begin(), arms.end(), [&](const Arm& arm) {
            return portable::distance(arm.direction, direction) > 0.1;
          }))
        directions.push_back(direction);
    }
    std::sort(directions.begin(), directions.end(), turns_before);
    std::rotate(directions.begin(),
                std::find_if(directions.begin(), directions.end(),
                             [&](const Point& d) {
                               return portable::distance(d, arms.front().direction) == 0;
                             }),
                directions.end());
    Line ring;
    for (const Point& direction : directions) ring.push_back(on_ring(centre, direction));
    ring.push_back(ring.front());
    return ring;
  }

  // Each axis ends at the rings in its way and goes on behind them.
  void cut_axes() {
    std::vector<CityAxis> pieces;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      CityAxis& axis = axes_[i];
      std::sort(cut_[i].begin(), cut_[i].end());
      const Line whole = axis.line;
      std::vector<std::size_t> ends = cut_[i];
      if (ends.empty() || ends.front() != 0) ends.insert(ends.begin(), 0);
      if (ends.back() != whole.size() - 1) ends.push_back(whole.size() - 1);
      for (std::size_t k = 1; k < ends.size(); ++k) {
        const std::size_t from = ends[k - 1], to = ends[k];
        axis.line.assign(whole.begin() + static_cast<std::ptrdiff_t>(from),
                         whole.begin() + static_cast<std::ptrdiff_t>(to) + 1);
        const auto is_cut = [&](std::size_t at) {
          return std::binary_search(cut_[i].begin(), cut_[i].end(), at);
        };
        if (is_cut(from))
          axis.line.front() = on_ring(whole[from], portable::unit(whole[from + 1] - whole[from]));
        if (is_cut(to))
          axis.line.back() = on_ring(whole[to], portable::unit(whole[to - 1] - whole[to]));
        pieces.push_back(axis);
      }
    }
    axes_ = std::move(pieces);
  }

  std::vector<CityAxis>& axes_;
  std::uint64_t key_;
  const CityOptions& options_;
  std::unordered_map<std::uint64_t, std::vector<Vertex>> vertices_;
  std::vector<std::uint64_t> places_;  // in the order of the axes
  std::vector<std::vector<std::size_t>> cut_;
  std::vector<Vertex> segments_;  // by their second vertex
  BoxIndex index_;
};

}  // namespace

void make_roundabouts(std::vector<CityAxis>& axes, std::uint64_t key, const CityOptions& options) {
  if (options.roundabouts > 0) Roundabouts(axes, key, options).make();
}

}  // namespace streetgen
