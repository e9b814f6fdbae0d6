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
    std::array<std::size_t, 4> passed{};
    for (std::size_t k = 0; k < 4; ++k) {
      const auto here = [&](const BorderPiece& piece) {
        return distance(piece.from, begin_of(k)) <= same_place;
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

  // Whether the side is there from its begin to its end, and nothing shares it.
  bool whole(const BorderLoop& loop, const std::vector<KerbSide>& sides, KerbSide side) const {
    const std::size_t k = std::find(walk.begin(), walk.end(), side) - walk.begin();
    std::size_t i = 0;
    while (i < loop.size() && distance(loop[i].from, begin_of(k)) > same_place) ++i;
    for (std::size_t passed = 0; i < loop.size() && passed < loop.size(); ++passed) {
      const BorderPiece& piece = loop[(i + passed) % loop.size()];
      if (piece.shared || sides[(i + passed) % loop.size()] != side) return false;
      if (distance(piece.to, begin_of((k + 1) % 4)) <= same_place) return true;
    }
    return false;
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
    return beside(nearest, middle, piece.to - piece.from);
  }

 private:
  const Point& begin_of(std::size_t k) const {
    const Line& border = k == 0 || k == 3 ? start_ : end_;
    return k < 2 ? border.front() : border.back();
  }

  KerbSide beside(std::size_t segment, const Point& p, const Point& way) const {
    const Point along = unit(line_[segment] - line_[segment - 1]);
    const Point from_start = p - line_[segment - 1], from_end = p - line_[segment];
    if (segment == 1 && dot(from_start, along) < -same_place) return KerbSide::start;
    if (segment + 1 == line_.size() && dot(from_end, along) > 0) return KerbSide::end;
    // Beyond a vertex both of its segments are as near.
    const Point direction =
        dot(from_end, along) > 0 ? along + unit(line_[segment + 1] - line_[segment]) : along;
    const double offset = cross(unit(direction), from_end);
    // A border along the axis itself has the surface on the right of its way.
    if (std::abs(offset) <= same_place)
      return dot(way, direction) > 0 ? KerbSide::left : KerbSide::right;
    return offset > 0 ? KerbSide::left : KerbSide::right;
  }

  const Line &line_, &start_, &end_;
};

// A line across the edge meets a piece of the border inside of it, and on that side of the edge, at
// this share of its length.
std::optional<double> share_across(const BorderPiece& piece, const LinePosition& place,
                                   bool on_left) {
  const double from = dot(piece.from - place.point, place.direction),
               to = dot(piece.to - place.point, place.direction);
  if (from * to >= 0 || std::min(std::abs(from), std::abs(to)) <= same_place) return std::nullopt;
  const double share = from / (from - to);
  const Point met = piece.from + (piece.to - piece.from) * share;
  const bool left = cross(place.direction, met - place.point) > 0;
  return left == on_left ? std::optional(share) : std::nullopt;
}

// The ground beside a place on the left or the right border of a section.
Beside beside_at(const Layout& layout, int edge, KerbSide side, const Point& place) {
  if (side != KerbSide::left && side != KerbSide::right) return Beside::outer;
  const EdgeEnd end{edge, side == KerbSide::left};
  const BesideEdges& beside = layout.streets.beside;
  const std::vector<double>& medians = beside.medians[slot(end)];
  if (medians.empty()) return beside.sides[slot(end)];
  const double at = nearest_abscissa(place, layout.streets.network.edges[edge].line);
  const auto passed = std::upper_bound(medians.begin(), medians.end(), at) - medians.begin();
  return passed % 2 == 1 ? Beside::median : Beside::outer;
}

}  // namespace

BorderLoop cut_at_medians(const Layout& layout, int edge, const BorderLoop& loop) {
  const BesideEdges& beside = layout.streets.beside;
  if (beside.medians[2 * edge].empty() && beside.medians[2 * edge + 1].empty()) return loop;
  const Line& line = layout.streets.network.edges[edge].line;
  BorderLoop cut;
  for (BorderPiece piece : loop) {
    std::vector<double> shares;
    for (const bool on_left : {true, false})
      for (const double abscissa : beside.medians[slot({edge, on_left})]) {
        const auto share = share_across(piece, position_at(line, abscissa), on_left);
        if (share && !piece.shared) shares.push_back(*share);
      }
    std::sort(shares.begin(), shares.end());
    const Point from = piece.from, along = piece.to - piece.from;
    for (const double share : shares) {
      BorderPiece first = piece;
      first.to = piece.from = from + along * share;
      cut.push_back(first);
    }
    cut.push_back(piece);
  }
  return cut;
}

std::vector<KerbPlace> places_of_section(const Layout& layout, int edge, const BorderLoop& loop) {
  const SectionSides section(layout, edge);
  const auto between = section.between_borders(loop);
  std::vector<KerbSide> sides;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sides.push_back(between ? (*between)[i] : section.by_place(loop[i]));
  std::array<bool, 4> whole{};
  for (const KerbSide side : walk)
    whole[static_cast<std::size_t>(side)] = section.whole(loop, sides, side);
  std::vector<KerbPlace> places;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Method method = loop[i].joins_level                         ? Method::level_change
                          : whole[static_cast<std::size_t>(sides[i])] ? Method::hypothesis
                                                                      : Method::contested;
    const Point middle = (loop[i].from + loop[i].to) * 0.5;
    places.push_back({edge, sides[i], method, -1, beside_at(layout, edge, sides[i], middle)});
  }
  return places;
}

}  // namespace streetgen
