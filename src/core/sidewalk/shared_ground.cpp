#include "sidewalk/shared_ground.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/border_stretches.hpp"
#include "geometry/crumb.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "sidewalk/kerb_sites.hpp"
#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

constexpr double around = 1;  // metres beyond both strips: as far apart as sites are

// The same order whatever kerbs are given beside the two.
bool before(const Point* a, const Point* b) {
  return std::tie(a[0].x, a[0].y, a[1].x, a[1].y) < std::tie(b[0].x, b[0].y, b[1].x, b[1].y);
}
bool before(const Line& a, const Line& b) { return before(a.data(), b.data()); }

}  // namespace

SharedGround::SharedGround(const std::vector<SidewalkKerb>& kerbs, const KerbChains& chains,
                           const std::vector<Strip>& strips)
    : kerbs_(kerbs), chains_(chains), strips_(strips) {
  std::vector<Box> grounds;
  for (std::size_t i = 0; i < kerbs.size(); ++i) {
    grounds_.emplace_back(strips[i].surface);
    grounds.push_back(grounds_.back().box());
    for (std::size_t s = 1; s < kerbs[i].line.size(); ++s) {
      sides_.push_back({static_cast<int>(i), static_cast<int>(s)});
      boxes_.push_back(box_of(kerbs[i].line[s - 1], kerbs[i].line[s]));
    }
  }
  side_index_ = BoxIndex(boxes_);
  ground_index_ = BoxIndex(grounds);
}

// Whether part of the side lies within the strip, deeper than its ends may.
bool SharedGround::bounds(int kerb, const Side& side) const {
  const Point* ends = ends_of(side);
  const Point along = ends[1] - ends[0];
  const double size = norm(along);
  if (size <= 4 * coordinate_margin) return false;
  const Point inset = along * (coordinate_margin / size);
  const Point from = ends[0] + inset, to = ends[1] - inset;
  if (!grounds_[kerb].comes_near(from, to)) return false;
  std::vector<double> at{0, 1};
  grounds_[kerb].cut(from, to, at);
  std::sort(at.begin(), at.end());
  for (std::size_t k = 1; k < at.size(); ++k)
    if ((at[k] - at[k - 1]) * size > coordinate_margin &&
        grounds_[kerb].holds(from + (to - from) * ((at[k - 1] + at[k]) / 2)))
      return true;
  return false;
}

bool SharedGround::bounds(int kerb, int other) const {
  for (int s = 1; s < static_cast<int>(kerbs_[other].line.size()); ++s)
    if (bounds(kerb, Side{other, s})) return true;
  return false;
}

// Whether the two kerbs follow each other, and the plain strip of the first ends where the front
// parts them. Not where the other kerb comes by once more, about a street that ends beside itself.
bool SharedGround::parted_before(int kerb, int other) const {
  return strips_[kerb].plain && (chains_.next(kerb) == other || chains_.previous(kerb) == other) &&
         !bounds(kerb, other);
}

std::vector<int> SharedGround::rivals(int kerb) const {
  std::vector<int> found;
  const Box& box = grounds_[kerb].box();
  for (const int other : ground_index_.near(box, -sides_touch))
    if (other != kerb && kerbs_[other].level == kerbs_[kerb].level && !parted_before(kerb, other) &&
        overlap(grounds_[kerb], grounds_[other]))
      found.push_back(other);
  side_index_.each_near(box, -sides_touch, [&](int side) {
    const int other = sides_[side].kerb;
    if (other != kerb && kerbs_[other].level == kerbs_[kerb].level &&
        std::find(found.begin(), found.end(), other) == found.end() && bounds(kerb, sides_[side]))
      found.push_back(other);
  });
  std::sort(found.begin(), found.end());
  return found;
}

const VoronoiBorder& SharedGround::border_between(int kerb, int other) {
  if (before(kerbs_[other].line, kerbs_[kerb].line)) std::swap(kerb, other);
  const auto known = borders_.find({kerb, other});
  if (known != borders_.end()) return known->second;
  const Box shared = grounds_[kerb].box().shared_with(grounds_[other].box());
  const double reach = strips_[kerb].reach + strips_[other].reach + around;
  std::vector<Site> sites = kerb_sites(kerbs_[kerb].line, kerbs_[other].line, reach);
  if (sites.empty()) sites.push_back({kerbs_[kerb].line[0], true});
  return borders_.emplace(std::pair(kerb, other), VoronoiBorder(sites, shared)).first->second;
}

// A place is left of its nearest side. Beyond a vertex that the way turns at, the outside of the
// turn decides.
bool SharedGround::left_of(const Point& place, const Side& side) const {
  const Line& line = kerbs_[side.kerb].line;
  const Point& from = line[side.segment - 1];
  const Point& to = line[side.segment];
  const Point along = to - from;
  const double share = dot(place - from, along) / dot(along, along);
  const bool left = cross(along, place - from) > 0;
  Point before = along, after = along;
  if (share <= 0) {
    const int previous = chains_.previous(side.kerb);
    if (side.segment > 1)
      before = from - line[side.segment - 2];
    else if (previous >= 0)
      before = kerbs_[previous].line.back() - *(kerbs_[previous].line.end() - 2);
    else
      return left;
  } else if (share >= 1) {
    const int next = chains_.next(side.kerb);
    if (side.segment + 1 < static_cast<int>(line.size()))
      after = line[side.segment + 1] - to;
    else if (next >= 0)
      after = kerbs_[next].line[1] - kerbs_[next].line[0];
    else
      return left;
  }
  const double turn = cross(before, after);
  return std::abs(turn) <= straight_sine * norm(before) * norm(after) ? left : turn < 0;
}

// The same of two sides that meet in the nearest place tells, whatever kerbs are given.
bool SharedGround::on_roadway(const Point& place, int kerb) const {
  const Side* nearest = nullptr;
  double least = infinite;
  side_index_.each_near(box_of(place, place), strips_[kerb].widest + same_width, [&](int i) {
    const Side& side = sides_[i];
    const Line& line = kerbs_[side.kerb].line;
    if (kerbs_[side.kerb].level != kerbs_[kerb].level) return;
    const double away = distance_to_segment(place, line[side.segment - 1], line[side.segment]);
    if (away > least || distance(line[side.segment - 1], line[side.segment]) == 0) return;
    if (away == least && !before(ends_of(side), ends_of(*nearest))) return;
    least = away;
    nearest = &side;
  });
  return nearest != nullptr && !left_of(place, *nearest);
}

// The same faces come out whatever numbers the kerbs have.
std::vector<int> SharedGround::in_order_of_place(std::vector<int> kerbs) const {
  std::sort(kerbs.begin(), kerbs.end(),
            [&](int i, int j) { return before(kerbs_[i].line, kerbs_[j].line); });
  return kerbs;
}

// The parts of kerbs of the level that come near the strip.
void SharedGround::append_kerbs(int kerb, std::vector<LineView>& lines) const {
  std::vector<const Point*> sides;
  side_index_.each_near(grounds_[kerb].box(), 0, [&](int i) {
    const Point* from = ends_of(sides_[i]);
    if (kerbs_[sides_[i].kerb].level == kerbs_[kerb].level &&
        grounds_[kerb].comes_near(from[0], from[1]))
      sides.push_back(from);
  });
  std::sort(sides.begin(), sides.end(),
            [](const Point* a, const Point* b) { return before(a, b); });
  for (const Point* side : sides) lines.emplace_back(side, 2);
}

MultiPolygon SharedGround::ground_of(int kerb, const std::vector<int>& rivals) {
  poll_cancel();
  const PreparedSurface& ground = grounds_[kerb];
  const auto near = [&](const Point& from, const Point& to) { return ground.comes_near(from, to); };
  std::vector<LineView> lines;
  std::vector<Line> held;
  append_rings(strips_[kerb].surface, lines);
  const std::vector<int> ordered = in_order_of_place(rivals);
  for (const int other : ordered) append_stretches(strips_[other].surface, near, lines);
  append_kerbs(kerb, lines);
  std::vector<bool> parted;
  for (const int other : ordered) {
    parted.push_back(parted_before(other, kerb));
    if (!strips_[other].surface.empty() && !parted.back())
      for (const auto& [from, to] : border_between(kerb, other).border())
        if (near(from, to)) held.push_back({from, to});
  }
  lines.insert(lines.end(), held.begin(), held.end());
  const Arrangement faces(lines);
  std::vector<bool> kept;
  for (const Point& place : faces.places()) {
    poll_cancel();
    bool owned = ground.holds(place) && !on_roadway(place, kerb);
    for (std::size_t i = 0; owned && i < ordered.size(); ++i) {
      const int other = ordered[i];
      if (!grounds_[other].holds(place)) continue;
      const bool first = before(kerbs_[kerb].line, kerbs_[other].line);
      owned = !parted[i] && border_between(kerb, other).first_owns(place) == first;
    }
    kept.push_back(owned);
  }
  MultiPolygon rest = without_crumbs(faces.joined(kept));
  if (!geos_.valid(rest)) rest = without_crumbs(faces.joined(kept, Arrangement::Vertices::on_grid));
  // A part that another sidewalk cuts off from the kerb is no sidewalk of this one.
  rest.erase(std::remove_if(rest.begin(), rest.end(),
                            [&](const Polygon& part) {
                              return std::none_of(
                                  part[0].begin(), part[0].end(), [&](const Point& p) {
                                    return comes_within(p, kerbs_[kerb].line, coordinate_margin);
                                  });
                            }),
             rest.end());
  return rest;
}

}  // namespace streetgen
