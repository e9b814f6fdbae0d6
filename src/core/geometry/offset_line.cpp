#include <algorithm>
#include <cmath>

#include "geometry/box_index.hpp"
#include "geometry/offset.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

// The offset of every segment, joined as they come, and the axis vertex behind each point.
struct Raw {
  Line axis;
  Line line;
  std::vector<int> vertex;
};

Raw raw_offset(Line axis, double offset_start, double offset_end) {
  Raw raw;
  const double total = length(axis);
  double abscissa = 0;
  const auto offset_at = [&](double at) {
    return offset_start + (offset_end - offset_start) * (total > 0 ? at / total : 0);
  };
  for (int i = 1; i < static_cast<int>(axis.size()); ++i) {
    const Point normal = left_normal(unit(axis[i] - axis[i - 1]));
    const double here = offset_at(abscissa);
    const Point start = axis[i - 1] + normal * here;
    if (!raw.line.empty()) {
      const Point last = raw.line.back();
      const double turn = cross(last - axis[i - 1], start - axis[i - 1]);
      if (turn * here < 0) append_arc(raw.line, axis[i - 1], last, start, turn > 0, join_quarter);
    }
    abscissa += distance(axis[i - 1], axis[i]);
    raw.line.push_back(start);
    raw.vertex.resize(raw.line.size(), i - 1);
    raw.line.push_back(axis[i] + normal * offset_at(abscissa));
    raw.vertex.push_back(i);
  }
  raw.axis = std::move(axis);
  return raw;
}

// Whether the loop from the segment that starts at raw point i to the one that ends at j lies
// nearer to the axis than the offset: an inner bend made it, not the axis.
bool turned_over(const Raw& raw, std::size_t i, std::size_t j, double offset) {
  const Point& middle = raw.line[(i + j) / 2];
  const Line part(raw.axis.begin() + raw.vertex[i], raw.axis.begin() + raw.vertex[j] + 1);
  return part.size() > 1 && comes_within(middle, part, offset * (1 - 1e-9));
}

Line without_loops(const Raw& raw, double offset) {
  std::vector<Box> boxes(raw.line.size() - 1);
  for (std::size_t i = 0; i + 1 < raw.line.size(); ++i) {
    boxes[i].add(raw.line[i]);
    boxes[i].add(raw.line[i + 1]);
  }
  const BoxIndex index(boxes);
  Line out{raw.line.front()};
  std::size_t i = 0;
  while (i + 1 < raw.line.size()) {
    poll_cancel();
    const std::vector<int> near = index.near(boxes[i], 0);
    bool cut = false;
    for (auto j = near.rbegin(); !cut && j != near.rend() && *j > static_cast<int>(i) + 1; ++j) {
      const std::size_t k = *j;
      const auto place = crossing(out.back(), raw.line[i + 1], raw.line[k], raw.line[k + 1]);
      if (!place || !turned_over(raw, i, k + 1, offset)) continue;
      out.push_back(*place);
      i = k;
      cut = true;
    }
    if (cut) continue;
    out.push_back(raw.line[i + 1]);
    ++i;
  }
  return distinct(std::move(out));
}

}  // namespace

Line offset_line(const Line& axis, double u, double v, double offset_start, double offset_end) {
  KerbLine kerb = kerb_line(axis, u, v, offset_start, offset_end, +1);
  if (kerb.whole) return std::move(kerb.line);
  const double total = length(axis);
  const auto offset_at = [&](double at) {
    return offset_start + (offset_end - offset_start) * std::clamp(at / total, 0.0, 1.0);
  };
  const Line part = distinct(planar(substring(axis, u, v)));
  return without_loops(raw_offset(part, offset_at(u), offset_at(v)),
                       std::min(std::abs(offset_at(u)), std::abs(offset_at(v))));
}

}  // namespace streetgen
