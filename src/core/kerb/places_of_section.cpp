#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "kerb/kerb_place.hpp"

namespace streetgen {

namespace {

// In the order of the walk: where each begins.
constexpr std::array<KerbSide, 4> walk{KerbSide::left, KerbSide::end, KerbSide::right,
                                       KerbSide::start};

bool on_segment(const Point& p, const Line& segment) {
  return distance_to_segment(p, segment.front(), segment.back()) <= same_place;
}

class SectionSides {
 public:
  SectionSides(const Layout& layout, int edge)
      : line_(layout.streets.network.edges[edge].line),
        start_(layout.streets.limits[2 * edge].border_line),
        end_(layout.streets.limits[2 * edge + 1].border_line) {}

  // By the ends of both border lines, where the border passes each once and in their order.
  std::optional<std::vector<KerbSide>> between_borders(const BorderLoop& loop) const {
    const std::array<Point, 4> places{start_.front(), end_.front(), end_.back(), start_.back()};
    std::array<std::size_t, 4> passed{};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto here = [&](const BorderPiece& piece) {
        return distance(piece.from, places[k]) <= same_place;
      };
      const auto found = std::find_if(loop.begin(), loop.end(), here);
      if (found == loop.end() || std::find_if(found + 1, loop.end(), here) != loop.end())
        return std::nullopt;
      passed[k] = found - loop.begin();
    }
    for (std::size_t& at : passed)
      if (&at != &passed[0]) at = (at + loop.size() - passed[0]) % loop.size();
    if (!(0 < passed[1] && passed[1] < passed[2] && passed[2] < passed[3])) return std::nullopt;
    std::vector<KerbSide> sides(loop.size());
    for (std::size_t i = 0, k = 0; i < loop.size(); ++i) {
      if (k < 3 && i == passed[k + 1]) ++k;
      sides[(passed[0] + i) % loop.size()] = walk[k];
    }
    return sides;
  }

  KerbSide by_place(const BorderPiece& piece) const {
    if (on_segment(piece.from, start_) && on_segment(piece.to, start_)) return KerbSide::start;
    if (on_segment(piece.from, end_) && on_segment(piece.to, end_)) return KerbSide::end;
    const Point middle = (piece.from + piece.to) * 0.5;
    std::size_t nearest = 1;
    double least = distance_to_segment(middle, line_[0], line_[1]);
    for (std::size_t i = 2; i < line_.size(); ++i) {
      const double away = distance_to_segment(middle, line_[i - 1], line_[i]);
      if (away < least) {
        least = away;
        nearest = i;
      }
    }
    return beside(nearest, middle);
  }

 private:
  KerbSide beside(std::size_t segment, const Point& p) const {
    const Point along = unit(line_[segment] - line_[segment - 1]);
    const Point from_start = p - line_[segment - 1], from_end = p - line_[segment];
    if (segment == 1 && dot(from_start, along) < -same_place) return KerbSide::start;
    if (segment + 1 == line_.size() && dot(from_end, along) > 0) return KerbSide::end;
    // Beyond a vertex both of its segments are as near.
    const Point direction = dot(from_end, along) > 0
                                ? along + unit(line_[segment + 1] - line_[segment])
                                : along;
    return cross(direction, from_end) > 0 ? KerbSide::left : KerbSide::right;
  }

  const Line &line_, &start_, &end_;
};

bool all_free(const BorderLoop& loop, const std::vector<KerbSide>& sides, KerbSide side) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (sides[i] == side && loop[i].shared) return false;
  return true;
}

}  // namespace

std::vector<KerbPlace> places_of_section(const Layout& layout, int edge, const BorderLoop& loop) {
  const SectionSides section(layout, edge);
  const auto sides = section.between_borders(loop);
  const bool whole_left = sides && all_free(loop, *sides, KerbSide::left),
             whole_right = sides && all_free(loop, *sides, KerbSide::right);
  std::vector<KerbPlace> places;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    KerbPlace place{edge, sides ? (*sides)[i] : section.by_place(loop[i])};
    const bool along = place.side == KerbSide::left || place.side == KerbSide::right;
    if (loop[i].joins_level)
      place.method = Method::level_change;
    else if (along && !(place.side == KerbSide::left ? whole_left : whole_right))
      place.method = Method::contested;
    places.push_back(place);
  }
  return places;
}

}  // namespace streetgen
