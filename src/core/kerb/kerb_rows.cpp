#include "kerb/kerb_rows.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

// The arc of the corner, from the first point of the line to its last. A kerb goes
// counter-clockwise about the centre, and vertices say nothing of its middle: crumbs are among
// them.
Arc curve_of(const Corner& corner, const Line& line) {
  const Point& centre = *corner.centre;
  const Point start = unit(line.front() - centre), end = unit(line.back() - centre);
  double sweep = std::atan2(cross(start, end), dot(start, end));
  if (sweep < -M_PI_2) sweep += 2 * M_PI;
  const Point middle = start * std::cos(sweep / 2) + left_normal(start) * std::sin(sweep / 2);
  return {line.front(), centre + middle * corner.radius, line.back()};
}

}  // namespace

KerbRows::KerbRows(const Layout& layout, int edge, int node, int level, std::vector<Kerb>& kerbs)
    : layout_(layout),
      node_(node),
      level_(level),
      first_place_(node < 0 ? layout.streets.limits[2 * edge].border_line.front()
                            : layout.arm(layout.junctions[node].ends[0]).border.front()),
      kerbs_(kerbs),
      before_(kerbs.size()) {}

// The place where one begins: the first from the place on that all parts are counted from.
std::size_t KerbRows::begin_of(const BorderLoop& loop, const std::vector<KerbPlace>& places) const {
  const auto nearer = [&](const BorderPiece& a, const BorderPiece& b) {
    return distance(a.from, first_place_) < distance(b.from, first_place_);
  };
  const std::size_t first = std::min_element(loop.begin(), loop.end(), nearer) - loop.begin();
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const std::size_t i = (first + k) % loop.size(), before = (i + loop.size() - 1) % loop.size();
    if (loop[i].shared != loop[before].shared || !(places[i] == places[before])) return i;
  }
  return first;
}

void KerbRows::append(const BorderLoop& loop, const std::vector<KerbPlace>& places) {
  const std::size_t begin = begin_of(loop, places);
  Line line;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const std::size_t i = (begin + k) % loop.size(), next = (i + 1) % loop.size();
    if (loop[i].shared) continue;
    if (line.empty()) line.push_back(loop[i].from);
    line.push_back(loop[i].to);
    if (k + 1 < loop.size() && !loop[next].shared && places[next] == places[i]) continue;
    append_row(places[i], std::move(line));
    line.clear();
  }
}

void KerbRows::append_row(const KerbPlace& place, Line line) {
  Kerb kerb;
  kerb.edge = place.edge;
  kerb.node = node_;
  kerb.level = level_;
  kerb.side = place.side;
  for (std::size_t k = before_; k < kerbs_.size(); ++k)
    if (kerbs_[k].edge == place.edge && kerbs_[k].side == place.side)
      kerb.part = kerbs_[k].part + 1;
  if (place.corner >= 0) kerb.curve = curve_of(layout_.streets.corners[place.corner], line);
  kerb.line = std::move(line);
  kerb.method = place.method;
  kerb.stone_width = layout_.settings.kerb_stone_width;
  kerb.beside = place.beside;
  kerbs_.push_back(std::move(kerb));
}

const char* kerb_side_name(KerbSide side) noexcept {
  switch (side) {
    case KerbSide::left:
      return "left";
    case KerbSide::right:
      return "right";
    case KerbSide::start:
      return "start";
    case KerbSide::end:
      return "end";
    case KerbSide::corner_at_start:
      return "corner_at_start";
    case KerbSide::corner_at_end:
      return "corner_at_end";
    case KerbSide::across_start:
      return "across_start";
    case KerbSide::across_end:
      return "across_end";
  }
  return "";
}

}  // namespace streetgen
