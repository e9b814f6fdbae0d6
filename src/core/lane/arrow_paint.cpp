#include "lane/arrow_paint.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

// Metres.
constexpr double arrow_length = 4, arrow_shaft = 0.15, arrow_head = 1.2, arrow_head_half = 0.4;
constexpr double arrow_lane = 2.5;  // the lane width that an arrow of full size asks for

double size_on(const Lane& lane) { return std::min(1.0, lane.width / arrow_lane); }

// As wide as the shaft.
Polygon bar(const Point& from, const Point& to, const Point& leftwards) {
  const Point across = leftwards * (arrow_shaft / 2);
  return {{from - across, to - across, to + across, from + across, from - across}};
}

MultiPolygon straight_arrow() {
  const double neck = arrow_length - arrow_head, s = arrow_shaft / 2, h = arrow_head_half;
  return {{{{0, -s},
            {neck, -s},
            {neck, -h},
            {arrow_length, 0},
            {neck, h},
            {neck, s},
            {0, s},
            {0, -s}}}};
}

constexpr double degree = M_PI / 180;

// A branch from the bend of the arrow, turned by `angle` to the left.
void append_branch(double angle, std::vector<MultiPolygon>& parts) {
  const double bend = angle == 0 ? arrow_length - arrow_head : 1.8;
  const Point from{bend, 0};
  if (angle == 0) {
    parts.push_back(straight_arrow());
    return;
  }
  const Point direction{std::cos(angle), std::sin(angle)}, side = left_normal(direction);
  const Point neck = from + direction * (std::abs(angle) > M_PI_2 + same_angle ? 1.0 : 0.6);
  parts.push_back({bar({0, 0}, from, {0, 1})});
  // Into the head, so that both are one however the arrow is turned.
  const Point within_head = neck + direction * (arrow_head / 4);
  parts.push_back({bar(from - direction * (arrow_shaft / 2), within_head, side)});
  const Point tip = neck + direction * (arrow_head * 0.7);
  parts.push_back({{{neck - side * arrow_head_half, tip, neck + side * arrow_head_half,
                     neck - side * arrow_head_half}}});
}

}  // namespace

double ArrowPaint::length_on(const Lane& lane) { return size_on(lane) * arrow_length; }

const MultiPolygon& ArrowPaint::shape_of(unsigned turns) {
  constexpr std::pair<unsigned, double> branches[] = {
      {turn::reverse, 165 * degree},     {turn::sharp_left, 135 * degree},
      {turn::left, 90 * degree},         {turn::slight_left, 45 * degree},
      {turn::merge_left, 30 * degree},   {turn::through, 0},
      {turn::merge_right, -30 * degree}, {turn::slight_right, -45 * degree},
      {turn::right, -90 * degree},       {turn::sharp_right, -135 * degree}};
  const auto [found, is_new] = shapes_.emplace(turns, MultiPolygon{});
  if (!is_new) return found->second;
  std::vector<MultiPolygon> parts;
  for (const auto& [bit, angle] : branches)
    if (turns & bit) append_branch(angle, parts);
  if (parts.empty()) parts.push_back(straight_arrow());
  found->second =
      parts.size() == 1 ? std::move(parts.front()) : geos_.polygons(geos_.unite(parts).get());
  return found->second;
}

MultiPolygon ArrowPaint::on(const Lane& lane, unsigned turns, const Line& line) {
  const Point foot = line.front(), along = unit(line.back() - foot) * size_on(lane);
  const Point side = left_normal(along);
  MultiPolygon paint = shape_of(turns);
  for (Polygon& polygon : paint)
    for (Ring& ring : polygon)
      for (Point& p : ring) p = foot + along * p.x + side * p.y;
  // Where many branches cross, turning may fold a corner.
  if (std::bitset<32>(turns).count() > 3 && !geos_.valid(paint))
    return geos_.polygons(geos_.unite({paint}).get());
  return paint;
}

}  // namespace streetgen
