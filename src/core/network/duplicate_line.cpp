#include "streetgen/duplicate_line.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "geometry/box.hpp"
#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double most_turned = 0.17;  // sine of ten degrees

struct Segment {
  Point from, along;  // unit
  double size, before;
  int line;
};

struct Span {
  int other;
  double from, to;
};

// Narrows [from, to] to where start + t * step lies within [low, high].
void narrow(double start, double step, double low, double high, double& from, double& to) {
  if (step == 0) {
    if (start < low || start > high) to = from;
    return;
  }
  const double a = (low - start) / step, b = (high - start) / step;
  from = std::max(from, std::min(a, b));
  to = std::min(to, std::max(a, b));
}

// Abscissas of the line of s beside t.
Span shared(const Segment& s, const Segment& t, double near) {
  double from = 0, to = s.size;
  const Point away = s.from - t.from;
  narrow(dot(t.along, away), dot(t.along, s.along), 0, t.size, from, to);
  narrow(cross(t.along, away), cross(t.along, s.along), -near, near, from, to);
  return {t.line, s.before + from, s.before + to};
}

// The length of each other's spans together, of the one with most.
double most(std::vector<Span>& spans) {
  std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) {
    return std::tie(a.other, a.from) < std::tie(b.other, b.from);
  });
  double longest = 0, sum = 0, reached = 0;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    if (i == 0 || spans[i].other != spans[i - 1].other) sum = reached = 0;
    sum += std::max(0.0, spans[i].to - std::max(reached, spans[i].from));
    reached = std::max(reached, spans[i].to);
    longest = std::max(longest, sum);
  }
  return longest;
}

}  // namespace

std::vector<double> doubled(const std::vector<Line>& lines, const std::vector<int>& levels,
                            double near) {
  std::vector<Segment> segments;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    double before = 0;
    for (std::size_t j = 1; j < lines[i].size(); ++j) {
      const double size = distance(lines[i][j - 1], lines[i][j]);
      if (size == 0) continue;
      segments.push_back({lines[i][j - 1], unit(lines[i][j] - lines[i][j - 1]), size, before,
                          static_cast<int>(i)});
      boxes.push_back(box_of(lines[i][j - 1], lines[i][j]));
      before += size;
    }
  }
  const BoxIndex index(boxes);
  std::vector<double> metres(lines.size());
  std::vector<Span> spans;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    poll_cancel();
    const Segment& s = segments[i];
    for (const int other : index.near(boxes[i], near)) {
      const Segment& t = segments[other];
      if (t.line == s.line || levels[t.line] != levels[s.line] ||
          std::abs(cross(s.along, t.along)) >= most_turned)
        continue;
      const Span span = shared(s, t, near);
      if (span.from < span.to) spans.push_back(span);
    }
    if (i + 1 == segments.size() || segments[i + 1].line != s.line) {
      metres[s.line] = most(spans);
      spans.clear();
    }
  }
  return metres;
}

}  // namespace streetgen
