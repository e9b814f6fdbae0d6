#include "ownership/slit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/arrangement.hpp"
#include "geometry/border_stretches.hpp"
#include "geometry/box_index.hpp"
#include "geometry/hairline.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/tolerance.hpp"
#include "ownership/notch.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

const double nearly_parallel = std::cos(M_PI / 18 + same_angle);
constexpr double least_slit = 0.01;  // square metres
constexpr int nose_chords = 8;
constexpr double around_cuts = 1.5;  // metres: small ground this near that they close

struct Segment {
  Point from, to;  // the surface on its left
};

std::vector<Segment> sides_within(const MultiPolygon& surface, const Box& box) {
  std::vector<Segment> sides;
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon)
      for (std::size_t i = 1; i < ring.size(); ++i)
        if (box_of(ring[i - 1], ring[i]).meets(box)) sides.push_back({ring[i - 1], ring[i]});
  return sides;
}

// Across the slit between two sides that face each other: a line where it begins, one where it
// ends. Where the slit grows wider than `width` the ground beyond gets a round nose.
std::optional<std::pair<Line, Line>> ends_of_slit(const Segment& a, const Segment& b,
                                                  double width) {
  const double size = distance(a.from, a.to);
  const Point along = unit(a.to - a.from), outwards = left_normal(along) * -1;
  if (dot(along, unit(b.to - b.from)) > -nearly_parallel) return std::nullopt;
  // Where b begins and ends, seen along a and away from it.
  const double s_from = dot(b.from - a.from, along), s_to = dot(b.to - a.from, along);
  const double h_from = dot(b.from - a.from, outwards), h_to = dot(b.to - a.from, outwards);
  const auto away = [&](double s) {
    return h_from + (h_to - h_from) * (s - s_from) / (s_to - s_from);
  };
  double first = std::max(0.0, s_to), last = std::min(size, s_from);
  bool opens_first = false, opens_last = false;
  // As far as b lies beyond a, but no more than the width.
  for (const double level : {0.0, width}) {
    const auto beyond = [&](double s) { return level > 0 ? away(s) > level : away(s) < level; };
    if (first >= last || (beyond(first) && beyond(last))) return std::nullopt;
    if (!beyond(first) && !beyond(last)) continue;
    const double at = s_from + (level - h_from) / (h_to - h_from) * (s_to - s_from);
    const bool at_first = beyond(first);
    (at_first ? first : last) = std::clamp(at, first, last);
    if (level > 0) (at_first ? opens_first : opens_last) = true;
  }
  if (last - first < coordinate_margin || std::max(away(first), away(last)) < same_place)
    return std::nullopt;
  const auto across = [&](double s, double nose) {
    const Point foot = a.from + along * s, there = foot + outwards * away(s);
    Line line{foot - outwards * coordinate_margin};
    for (int i = 0; nose != 0 && i <= nose_chords; ++i) {
      const double angle = M_PI * i / nose_chords;
      line.push_back((foot + there) * 0.5 - outwards * (std::cos(angle) * away(s) / 2) +
                     along * (std::sin(angle) * nose * away(s) / 2));
    }
    line.push_back(there + outwards * coordinate_margin);
    return line;
  };
  return std::pair(across(first, opens_first ? 1 : 0), across(last, opens_last ? -1 : 0));
}

class Slits {
 public:
  Slits(const std::vector<Claim>& claims, double width, double radius, double least_island)
      : claims_(claims),
        width_(width),
        radius_(radius),
        least_island_(least_island),
        boxes_(boxes_of(claims)),
        index_(boxes_) {}

  std::vector<Hole> found() const {
    std::vector<Hole> slits;
    for (int i = 0; i < static_cast<int>(claims_.size()); ++i) {
      if (claims_[i].surface->empty()) continue;
      poll_cancel();
      index_.each_near(boxes_[i], width_, [&](int j) {
        if (may_part(i, j) && before(claims_[i], claims_[j])) append_between(i, j, slits);
      });
    }
    return slits;
  }

 private:
  static std::vector<Box> boxes_of(const std::vector<Claim>& claims) {
    std::vector<Box> boxes;
    for (const Claim& claim : claims) boxes.push_back(box_of(*claim.surface));
    return boxes;
  }

  bool may_part(int i, int j) const {
    const Claim &a = claims_[i], &b = claims_[j];
    return (a.wanted || b.wanted) && a.level == b.level;
  }

  bool share_edge(int i, int j) const {
    const auto &a = claims_[i].edges, &b = claims_[j].edges;
    return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
  }

  std::vector<Line> cuts_between(int i, int j) const {
    std::vector<Line> cuts;
    if (radius_ > 0 && claims_[i].node && claims_[j].node && share_edge(i, j))
      cuts = across_notches(*claims_[i].surface, *claims_[j].surface, radius_,
                            [&](const Point& p) { return is_free(p, i, j); });
    if (width_ <= 0 || share_edge(i, j)) return cuts;
    const Box shared = boxes_[i].grown(width_).shared_with(boxes_[j].grown(width_));
    const std::vector<Segment> of_j = sides_within(*claims_[j].surface, shared);
    if (of_j.empty()) return cuts;
    std::vector<Box> boxes;
    for (const Segment& b : of_j) boxes.push_back(box_of(b.from, b.to));
    const BoxIndex sides(boxes);
    for (const Segment& a : sides_within(*claims_[i].surface, shared)) {
      poll_cancel();
      for (const int k : sides.near(box_of(a.from, a.to), width_)) {
        auto ends = ends_of_slit(a, of_j[k], width_);
        if (ends && is_free(*ends, i, j)) {
          cuts.push_back(std::move(ends->first));
          cuts.push_back(std::move(ends->second));
        }
      }
    }
    return cuts;
  }

  // Whether another surface leaves some of the middle between both ends.
  bool is_free(const std::pair<Line, Line>& ends, int i, int j) const {
    const Point first = (ends.first.front() + ends.first.back()) * 0.5,
                last = (ends.second.front() + ends.second.back()) * 0.5;
    const double shares[] = {0.1, 0.5, 0.9};
    return std::any_of(std::begin(shares), std::end(shares),
                       [&](double share) { return is_free(first + (last - first) * share, i, j); });
  }

  bool is_free(const Point& p, int i, int j) const {
    return !index_.any_near(box_of(p, p), 0, [&](int k) {
      return k != i && k != j && claims_[k].level == claims_[i].level &&
             inside(p, *claims_[k].surface);
    });
  }

  // Those that no surface of the slit's own level may overlap, nor one that tiles with it.
  std::vector<int> members_near(int i, int j, const Box& place) const {
    std::vector<int> members;
    for (const int k : index_.near(place, 0))
      if (tile(claims_[k], claims_[i]) || tile(claims_[k], claims_[j])) members.push_back(k);
    return members;
  }

  bool narrow(const Ring& ring, int i, int j) const {
    const auto beside = [&](const Point& p, int k) {
      poll_cancel();
      for (const Polygon& polygon : *claims_[k].surface)
        for (const Ring& border : polygon)
          if (comes_within(p, border, width_ + same_place)) return true;
      return false;
    };
    return std::all_of(ring.begin(), ring.end(),
                       [&](const Point& p) { return beside(p, i) && beside(p, j); });
  }

  void append_between(int i, int j, std::vector<Hole>& slits) const {
    const std::vector<Line> cuts = cuts_between(i, j);
    if (cuts.empty()) return;
    Box place;
    for (const Line& cut : cuts)
      for (const Point& p : cut) place.add(p);
    place = place.grown(std::max(width_, around_cuts));
    const std::vector<int> members = members_near(i, j, place);
    std::vector<LineView> lines(cuts.begin(), cuts.end());
    for (const int k : members)
      append_stretches(
          *claims_[k].surface,
          [&](const Point& from, const Point& to) { return box_of(from, to).meets(place); }, lines);
    const Arrangement faces(lines);
    std::vector<bool> open;
    for (int walk = 0; walk < faces.walk_count(); ++walk) {
      const Ring ring = faces.border(walk);
      const Point& within = faces.places()[walk];
      const double size = signed_area(ring);
      // A filled slit may close what lies between its end and another kerb.
      open.push_back(size > 0 && (size < least_island_ || narrow(ring, i, j)) &&
                     std::none_of(members.begin(), members.end(),
                                  [&](int k) { return inside(within, *claims_[k].surface); }));
    }
    for (Polygon& slit : faces.joined(open)) {
      Ring ring = without_hairlines(slit.front());
      if (signed_area(ring) >= least_slit) slits.push_back({std::move(ring), {i, j}});
    }
  }

  const std::vector<Claim>& claims_;
  const double width_, radius_, least_island_;
  const std::vector<Box> boxes_;
  const BoxIndex index_;
};

// Ground that is to be filled, and where.
class Filled {
 public:
  Filled(const std::vector<Claim>& claims, const std::vector<Hole>& holes) : claims_(claims) {
    for (const Hole& hole : holes) add(hole);
  }

  void add(const Hole& hole) {
    index_.add(box_of({{hole.ring}}), static_cast<int>(all_.size()));
    all_.push_back(hole);
  }

  // What of the slit others of its level do not fill.
  std::vector<Hole> left_of(const Hole& slit) const {
    const MultiPolygon whole{{slit.ring}};
    const PreparedSurface ground(whole);
    std::vector<LineView> lines;
    std::vector<Polygon> others;
    for (const int k : index_.near(ground.box(), 0)) {
      const Hole& other = all_[k];
      if (claims_[other.around[0]].level != claims_[slit.around[0]].level) continue;
      const MultiPolygon taken{{other.ring}};
      if (!overlap(ground, PreparedSurface(taken))) continue;
      others.push_back({other.ring});
      lines.push_back(other.ring);
    }
    if (others.empty()) return {slit};
    lines.push_back(slit.ring);
    const Arrangement faces(lines);
    std::vector<bool> open;
    for (const Point& place : faces.places())
      open.push_back(inside(place, whole) && !inside(place, others));
    std::vector<Hole> left;
    for (Polygon& part : faces.joined(open)) {
      Ring ring = without_hairlines(part.front());
      if (signed_area(ring) >= least_slit) left.push_back({std::move(ring), slit.around});
    }
    return left;
  }

 private:
  const std::vector<Claim>& claims_;
  std::vector<Hole> all_;
  BoxIndex index_;
};

}  // namespace

std::vector<Hole> slits_between(const std::vector<Claim>& claims, const std::vector<Hole>& holes,
                                double width, double radius, double least_island) {
  if (width <= 0 && radius <= 0) return {};
  std::vector<Hole> slits = Slits(claims, width, radius, least_island).found();
  std::stable_sort(slits.begin(), slits.end(), [&](const Hole& a, const Hole& b) {
    const int k = a.around[0] != b.around[0] ? 0 : 1;
    return before(claims[a.around[k]], claims[b.around[k]]);
  });
  Filled filled(claims, holes);
  std::vector<Hole> left;
  for (const Hole& slit : slits)
    for (Hole& rest : filled.left_of(slit)) {
      filled.add(rest);
      left.push_back(std::move(rest));
    }
  return left;
}

}  // namespace streetgen
