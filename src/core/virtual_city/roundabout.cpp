#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "geometry/box_index.hpp"
#include "streetgen/cancel.hpp"
#include "virtual_city/axes.hpp"
#include "virtual_city/portable_math.hpp"
#include "support/random.hpp"

namespace streetgen {

namespace {

// The ring has a vertex each so many degrees, apart from those where its arms begin.
constexpr double step = 15;
// But none so near to an arm, m.
constexpr double beside_arm = 2;
// The speed on the ring, km/h.
constexpr double ring_speed = 30;
// A ring is wider than its lanes, m.
constexpr double wider = 2;
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
  Point at;         // where it meets the ring
  Point direction;  // unit, from the crossing to there
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
        const Point& centre = line(vertices.front())[vertices.front().index];
        centres_.add(box_of(centre, centre), static_cast<int>(rings.size()) - 1);
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
      for (const int way : {-1, 1}) {
        if (v.index + static_cast<std::size_t>(way) >= axis.line.size()) continue;
        // Room for a ring at the other end too.
        if (!free_of_nodes(v, way, 2 * radius + options_.node_gap)) return {};
        const Point at = leaves_ring(v, way).point;
        arms.push_back({at, portable::unit(at - centre), axis.width});
      }
    }
    ring.width = ring.lane_count * options_.lane_width + wider;
    const double to_next = 2 * radius + ring.width + options_.clearance;
    if (arms.size() < 3 || !centres_.near(box_of(centre, centre), to_next).empty() ||
        built_up(vertices, centre, radius + ring.width / 2 + options_.clearance))
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

  // Whether the axis has no node and does not end within `reach` of its vertex v.
  bool free_of_nodes(const Vertex& v, int way, double reach) const {
    const Point centre = line(v)[v.index];
    std::size_t k = v.index;
    do {
      k += static_cast<std::size_t>(way);
      if (k >= line(v).size()) return false;
      if (portable::distance(centre, line(v)[k]) >= reach) return true;
    } while (vertices_.at(place_key(line(v)[k])).size() == 1);
    return false;
  }

  struct Exit {
    Point point;
    std::size_t outside;  // the first vertex beyond it
  };
  // The exit where an axis leaves the ring about its vertex v.
  Exit leaves_ring(const Vertex& v, int way) const {
    const Point centre = line(v)[v.index];
    std::size_t k = v.index;
    do k += static_cast<std::size_t>(way);
    while (portable::distance(centre, line(v)[k]) < options_.roundabout_radius);
    const Point inside = line(v)[k - static_cast<std::size_t>(way)];
    const Point direction = portable::unit(line(v)[k] - inside), off = inside - centre;
    const double radius = options_.roundabout_radius, along = dot(off, direction);
    const double t = std::sqrt(along * along - dot(off, off) + radius * radius) - along;
    return {portable::to_millimetre(inside + direction * t), k};
  }

  // Whether a road that does not come to the crossing is that near.
  bool built_up(const std::vector<Vertex>& vertices, const Point& centre, double reach) const {
    return index_.any_near(box_of(centre, centre), reach, [&](int i) {
      const Vertex& end = segments_[static_cast<std::size_t>(i)];
      const bool comes = std::any_of(vertices.begin(), vertices.end(),
                                     [&](const Vertex& v) { return v.axis == end.axis; });
      return !comes && portable::distance_to_segment(centre, line(end)[end.index - 1],
                                                     line(end)[end.index]) < reach;
    });
  }

  // Counter-clockwise, closed, from its first arm.
  Line ring_line(const Point& centre, const std::vector<Arm>& arms) const {
    Line ring;
    for (const Arm& arm : arms) ring.push_back(arm.at);
    for (double degrees = -180; degrees < 180; degrees += step) {
      const Point at = portable::to_millimetre(centre + portable::turned({1, 0, 0}, degrees) *
                                                            options_.roundabout_radius);
      if (std::all_of(arms.begin(), arms.end(),
                      [&](const Arm& arm) { return portable::distance(arm.at, at) > beside_arm; }))
        ring.push_back(at);
    }
    const Point first = arms.front().at;
    std::sort(ring.begin(), ring.end(),
              [&](const Point& a, const Point& b) { return turns_before(a - centre, b - centre); });
    std::rotate(ring.begin(),
                std::find_if(ring.begin(), ring.end(),
                             [&](const Point& p) { return portable::distance(p, first) == 0; }),
                ring.end());
    ring.push_back(first);
    return ring;
  }

  // Each axis ends at the rings in its way and goes on behind them.
  void cut_axes() {
    std::vector<CityAxis> pieces;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      std::vector<std::size_t>& cuts = cut_[i];
      std::sort(cuts.begin(), cuts.end());
      CityAxis piece = axes_[i];
      const std::size_t last = axes_[i].line.size() - 1;
      std::size_t from = 0;
      piece.line.clear();
      for (const std::size_t cut : cuts) {
        const Vertex v{static_cast<int>(i), cut};
        if (cut > 0) {
          const Exit entry = leaves_ring(v, -1);
          for (; from <= entry.outside; ++from) piece.line.push_back(axes_[i].line[from]);
          piece.line.push_back(entry.point);
          pieces.push_back(piece);
        }
        if (cut == last) {
          from = last + 1;
          break;
        }
        const Exit exit = leaves_ring(v, 1);
        piece.line = {exit.point};
        from = exit.outside;
      }
      if (from > last) continue;
      for (; from <= last; ++from) piece.line.push_back(axes_[i].line[from]);
      pieces.push_back(piece);
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
  BoxIndex centres_;  // of the rings
};

}  // namespace

void make_roundabouts(std::vector<CityAxis>& axes, std::uint64_t key, const CityOptions& options) {
  if (options.roundabouts > 0) Roundabouts(axes, key, options).make();
}

}  // namespace streetgen
