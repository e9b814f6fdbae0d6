#include "ownership/claim_index.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "ownership/hole.hpp"
#include "roadway/near_limits.hpp"
#include "support/disjoint_sets.hpp"

namespace streetgen {

namespace {

constexpr double longest = 10;  // metres of axis in one box
constexpr int nowhere = -1;

void add_stretch(Extent& extent, const Arm& arm, double start, double end) {
  const double reach = arm.reach() + coordinate_margin;
  const Line line = substring(arm.line, start, end);
  extent.add(box_of(line.front(), line.front()).grown(reach));
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point along = line[i] - line[i - 1];
    const double pieces = std::ceil(norm(along) / longest);
    for (double k = 0; k < pieces; ++k)
      extent.add(
          box_of(line[i - 1] + along * (k / pieces), line[i - 1] + along * ((k + 1) / pieces))
              .grown(reach));
  }
}

// Between both axes and the arc.
void add_fillet(Extent& extent, const Arm& a, const Arm& b, const CornerArc& corner) {
  Box box;
  for (const Point& p : substring(a.line, 0, std::max(0.0, corner.abscissa_a))) box.add(p);
  for (const Point& p : substring(b.line, 0, std::max(0.0, corner.abscissa_b))) box.add(p);
  const Point &from = corner.arc.start, &to = corner.arc.end;
  box.add(from);
  box.add(to);
  const double side = cross(to - from, corner.arc.middle - from);
  for (const Point& way : {Point{1, 0}, Point{0, 1}, Point{-1, 0}, Point{0, -1}}) {
    const Point outermost = corner.centre + way * corner.radius;
    if (cross(to - from, outermost - from) * side > 0) box.add(outermost);
  }
  extent.add(box.grown(coordinate_margin));
}

std::vector<Box> boxes_of(const std::vector<Extent>& extents) {
  std::vector<Box> boxes;
  for (const Extent& extent : extents) boxes.push_back(extent.box);
  return boxes;
}

}  // namespace

void Extent::add(const Box& part) {
  parts.push_back(part);
  box.add({part.min_x, part.min_y, 0});
  box.add({part.max_x, part.max_y, 0});
}

bool Extent::meets(const Extent& other, double margin) const {
  if (!box.meets(other.box, margin)) return false;
  return std::any_of(parts.begin(), parts.end(), [&](const Box& part) {
    return part.meets(other.box, margin) &&
           std::any_of(other.parts.begin(), other.parts.end(),
                       [&](const Box& of_other) { return part.meets(of_other, margin); });
  });
}

Extent section_extent(const Arm& arm, double start, double end) {
  Extent extent;
  add_stretch(extent, arm, start, end);
  return extent;
}

Extent section_extent(const Layout& layout, int edge) {
  const auto& limits = layout.streets.limits;
  Extent extent = section_extent(layout.arms[2 * edge], limits[2 * edge].abscissa,
                                 limits[2 * edge + 1].abscissa);
  for (const Parting& parting : partings_of(layout, edge).all()) {
    Box box;
    for (const Point& p : parting.line) box.add(p);
    extent.add(box);
  }
  return extent;
}

Extent intersection_extent(const std::vector<Arm>& arms, const std::vector<Gap>& gaps) {
  Extent extent;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    double reach = arms[i].limit;
    // Limits that crossed lie before what the corners asked for.
    if (!gaps.empty()) {
      const Gap &left = gaps[i], &right = gaps[(i + gaps.size() - 1) % gaps.size()];
      if (left.meets && left.parting.empty()) reach = std::max(reach, left.corner.abscissa_a);
      if (right.meets && right.parting.empty()) reach = std::max(reach, right.corner.abscissa_b);
    }
    add_stretch(extent, arms[i], 0, std::min(reach, length(arms[i].line)));
  }
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (gaps[i].meets && gaps[i].parting.empty())
      add_fillet(extent, arms[i], arms[(i + 1) % arms.size()], gaps[i].corner);
    for (const Ring& ring : gaps[i].beyond) {
      Box box;
      for (const Point& p : ring) box.add(p);
      extent.add(box);
    }
  }
  return extent;
}

Vicinity::Vicinity(std::vector<Extent> extents, const std::vector<Claim>& claims, double slit_width)
    : extents_(std::move(extents)),
      claims_(claims),
      slit_width_(slit_width),
      index_(boxes_of(extents_)),
      touching_(extents_.size()),
      place_(extents_.size(), nowhere) {}

const std::vector<int>& Vicinity::touching(int claim) {
  auto& found = touching_[claim];
  if (!found) {
    found.emplace();
    for (const int other : index_.near(extents_[claim].box, slit_width_))
      if (other != claim && extents_[claim].meets(extents_[other], slit_width_))
        found->push_back(other);
  }
  return *found;
}

std::vector<int> Vicinity::opponents(int claim) {
  const std::vector<int>& all = touching(claim);
  const auto joins_levels = [&](int i) { return claims_[i].joins_levels; };
  if (joins_levels(claim) || std::any_of(all.begin(), all.end(), joins_levels)) return all;
  std::vector<int> opponents;
  for (const int other : all)
    if (tile(claims_[claim], claims_[other])) opponents.push_back(other);
  return opponents;
}

// What meets the others about the claim by way of one of its neighbours alone closes no ring.
std::vector<int> Vicinity::enclosing(int claim, const std::vector<bool>& known) {
  if (!index_.any_near(extents_[claim].box, hole_extent, [&](int other) { return !known[other]; }))
    return {};
  std::vector<int> near;
  for (const int other : index_.near(extents_[claim].box, hole_extent))
    if (other != claim && claims_[other].level == claims_[claim].level &&
        extents_[claim].meets(extents_[other], hole_extent)) {
      place_[other] = static_cast<int>(near.size());
      near.push_back(other);
    }
  Groups joined(static_cast<int>(near.size()));
  for (const int one : near)
    for (const int other : touching(one))
      if (other < one && place_[other] != nowhere) joined.join(place_[one], place_[other]);
  std::vector<int> neighbours(near.size());  // of the claim, by group
  for (const int other : touching(claim))
    if (place_[other] != nowhere) ++neighbours[joined.of(place_[other])];
  std::vector<int> enclosing;
  for (const int other : near)
    if (neighbours[joined.of(place_[other])] > 1) enclosing.push_back(other);
  for (const int other : near) place_[other] = nowhere;
  return enclosing;
}

std::vector<int> Vicinity::near(const Box& box) const {
  std::vector<int> near = index_.near(box, 0);
  near.erase(std::remove_if(near.begin(), near.end(),
                            [&](int i) {
                              return !extents_[i].meets({box, {box}}, 0);
                            }),
             near.end());
  return near;
}

}  // namespace streetgen
