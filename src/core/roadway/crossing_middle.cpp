#include "roadway/crossing_middle.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/closed_ring.hpp"
#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

constexpr double straight_on = 45 * M_PI / 180;
constexpr double most_bent = 60 * M_PI / 180;
constexpr double times_apart = 1.5;  // the length of a carriageway beyond the crossing

class DualCrossing {
 public:
  DualCrossing(Layout& layout, const StreetFace& face) : layout_(layout), face_(face) {}

  bool has_middle() {
    if (face_.size() != 4) return false;
    const bool along = runs_along(face_.front().end);
    for (const FaceSide& side : face_) {
      const bool one_way = runs_along(side.end) != runs_along(back(side.end));
      if (!one_way || runs_along(side.end) != along || layout_.axis_of(side.end.edge).on_ring)
        return false;
    }
    if (!opposite(0, 2) || !opposite(1, 3) || bends() > most_bent) return false;
    const int first = ends_of(0), second = ends_of(1);
    return first + second >= 3;
  }

 private:
  static EdgeEnd back(const EdgeEnd& end) { return {end.edge, !end.at_start}; }

  bool runs_along(const EdgeEnd& end) const {
    const StreetAxis& axis = layout_.axis_of(end.edge);
    return end.at_start ? axis.leads_forward : axis.leads_backward;
  }

  bool one_way_as(const EdgeEnd& end, const EdgeEnd& other) const {
    return runs_along(end) == runs_along(other) && runs_along(back(end)) == runs_along(back(other));
  }

  double length_of(std::size_t side) const { return length(layout_.arm(face_[side].end).line); }

  bool opposite(std::size_t i, std::size_t j) const {
    const Line &a = layout_.arm(face_[i].end).line, &b = layout_.arm(face_[j].end).line;
    const Point on_a = a.back() - a.front(), on_b = b.front() - b.back();
    return std::abs(std::atan2(cross(on_a, on_b), dot(on_a, on_b))) < straight_on;
  }

  // Radians by which the sides turn between their ends, all together: those of a ring nearly 2 pi.
  double bends() const {
    double within = -2 * M_PI;  // a face of straight sides has four corners of 2 pi together
    for (std::size_t i = 0; i < face_.size(); ++i) {
      const Line& side = layout_.arm(face_[i].end).line;
      const Line& before = layout_.arm(face_[(i + face_.size() - 1) % face_.size()].end).line;
      within += angle_of(side[1] - side[0], before[before.size() - 2] - before.back());
    }
    return within;
  }

  // Counter-clockwise, 0 to 2 pi.
  static double angle_of(const Point& from, const Point& to) {
    const double angle = std::atan2(cross(from, to), dot(from, to));
    return angle < 0 ? angle + 2 * M_PI : angle;
  }

  // At how many of its two ends the street of a side and the opposite one goes on as a pair.
  int ends_of(std::size_t side) {
    const EdgeEnd &one = face_[side].end, &other = face_[side + 2].end;
    const double apart = std::max(length_of(side + 1), length_of((side + 3) % 4));
    const double wanted = std::min(times_apart * apart, layout_.settings.reach);
    const bool ahead = goes_on(one, wanted) && goes_on(back(other), wanted);
    const bool behind = goes_on(back(one), wanted) && goes_on(other, wanted);
    return int(ahead) + int(behind);
  }

  // Whether the carriageway goes on beyond the far end of an edge for so many metres, before it
  // crosses another street.
  bool goes_on(EdgeEnd last, double wanted) {
    for (double run = 0; run < wanted;) {
      const int node = far_node(layout_, last);
      for (const FaceSide& side : face_)
        layout_.junctions[side.corner.node].followed.push_back(node);
      if (run > 0 && layout_.junctions[node].ends.size() > 3) return false;
      const std::optional<EdgeEnd> next = straight_ahead(last, node);
      if (!next) return false;
      run += length(layout_.arm(*next).line);
      last = *next;
    }
    return true;
  }

  // The one-way edge of the same level and direction that turns least.
  std::optional<EdgeEnd> straight_ahead(const EdgeEnd& last, int node) const {
    const auto& edges = layout_.streets.network.edges;
    const Line& own = layout_.arm(last).line;
    const Point direction = own.back() - own[own.size() - 2];
    std::optional<EdgeEnd> next;
    double least = straight_on;
    for (const EdgeEnd& end : layout_.junctions[node].ends) {
      if (end.edge == last.edge || edges[end.edge].level != edges[last.edge].level ||
          !one_way_as(end, last))
        continue;
      const Line& on = layout_.arm(end).line;
      const double turn =
          std::abs(std::atan2(cross(direction, on[1] - on[0]), dot(direction, on[1] - on[0])));
      if (turn >= least) continue;
      least = turn;
      next = end;
    }
    return next;
  }

  Layout& layout_;
  const StreetFace& face_;
};

}  // namespace

bool is_middle_of_crossing(Layout& layout, const StreetFace& face) {
  return DualCrossing(layout, face).has_middle();
}

std::vector<MiddlePart> parts_of_middle(const Layout& layout, const StreetFace& face) {
  const std::vector<KerbStretch> stretches =
      kerbs_about(layout, face, kerb_crossings(layout, face));
  std::vector<Line> first, second;  // the halves of the kerb of each side
  Ring all;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const auto& [from, until] = stretches[i];
    const Course course = course_of(layout.arm(face[i].end), +1);
    first.push_back(kerb_line(course, from, (from + until) / 2, +1).line);
    second.push_back(kerb_line(course, (from + until) / 2, until, +1).line);
    second.back().front() = first.back().back();
    all.insert(all.end(), first.back().begin(), first.back().end());
    all.insert(all.end(), second.back().begin(), second.back().end());
  }
  all = closed(std::move(all));
  if (all.empty() || signed_area(all) <= 0) return {};
  Point middle;
  for (const Line& half : first) middle = middle + half.back() * (1.0 / first.size());
  std::vector<MiddlePart> parts;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const std::size_t before = (i + first.size() - 1) % first.size();
    Ring ring = second[before];
    ring.insert(ring.end(), first[i].begin(), first[i].end());
    ring.push_back(middle);
    const double end = length(layout.arm(face[before].end).line);
    parts.push_back({{closed(std::move(ring))},
                     (stretches[i].from + stretches[i].until) / 2,
                     end - (stretches[before].from + stretches[before].until) / 2});
  }
  return parts;
}

}  // namespace streetgen
