#include "sidewalk/kerb_chain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

// Metres between the end of a kerb and the start of the next one, of which each may lie a place
// off.
constexpr double meeting = 2 * same_place;

// The cosine of the turn of a street that goes on without a corner.
const double nearly_straight = std::cos(20 * M_PI / 180 + same_angle);

// The turn of the way from a to b and on to c: positive to the left.
double turn(const Point& a, const Point& b, const Point& c) {
  return std::atan2(cross(b - a, c - b), dot(b - a, c - b));
}

double width_at(const std::vector<WidthKnot>& knots, double abscissa) {
  if (abscissa <= knots.front().abscissa) return knots.front().width;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const auto& [from, width_from] = knots[i - 1];
    const auto& [to, width_to] = knots[i];
    if (abscissa < to)
      return width_from + (width_to - width_from) * (abscissa - from) / (to - from);
  }
  return knots.back().width;
}

// Widths from the start of a kerb to its end; a kerb without a course is as wide all along.
std::vector<WidthKnot> knots_of(const SidewalkKerb& kerb, double length) {
  if (kerb.course.empty()) return {{0, *kerb.width}, {length, *kerb.width}};
  std::vector<WidthKnot> course;
  for (const WidthAt& place : kerb.course) course.push_back({place.share * length, place.width});
  std::vector<WidthKnot> knots{{0, width_at(course, 0)}};
  for (const WidthKnot& knot : course)
    if (knot.abscissa > knots.back().abscissa + same_place && knot.abscissa < length - same_place)
      knots.push_back(knot);
  knots.push_back({length, width_at(course, length)});
  return knots;
}

}  // namespace

Point direction_at(const Line& line, bool at_start) {
  return at_start ? unit(line[1] - line[0]) : unit(line.back() - line[line.size() - 2]);
}

KerbChains::KerbChains(const std::vector<SidewalkKerb>& kerbs, double transition)
    : kerbs_(kerbs), next_(kerbs.size(), -1), previous_(kerbs.size(), -1), widths_(kerbs.size()) {
  for (const SidewalkKerb& kerb : kerbs) lengths_.push_back(length(kerb.line));
  link();
  for (std::size_t i = 0; i < kerbs.size(); ++i)
    if (kerbs[i].width && *kerbs[i].width > 0) widths_[i] = knots_of(kerbs[i], lengths_[i]);
  for (std::size_t i = 0; i < kerbs.size(); ++i)
    if (kerbs[i].width || (!kerbs[i].ends && previous_[i] < 0))
      widen(static_cast<int>(i), transition);
}

// The way goes on by the sharpest turn to the left where several begin: about the same ground.
void KerbChains::link() {
  std::vector<Box> starts;
  for (const SidewalkKerb& kerb : kerbs_) starts.push_back(box_of(kerb.line[0], kerb.line[0]));
  const BoxIndex index(starts);
  for (int i = 0; i < static_cast<int>(kerbs_.size()); ++i) {
    poll_cancel();
    const Line& line = kerbs_[i].line;
    if (kerbs_[i].ends) continue;
    double sharpest = 0;
    for (const int j : index.near(box_of(line.back(), line.back()), meeting)) {
      if (kerbs_[j].level != kerbs_[i].level || kerbs_[j].ends || previous_[j] >= 0) continue;
      if (distance(kerbs_[j].line[0], line.back()) > meeting) continue;
      const double angle = turn(line[line.size() - 2], line.back(), kerbs_[j].line[1]);
      if (next_[i] >= 0 && angle <= sharpest) continue;
      next_[i] = j;
      sharpest = angle;
    }
    if (next_[i] >= 0) previous_[next_[i]] = i;
  }
}

// The kerbs between `from` and the next one of known width, and the change of width on the way.
void KerbChains::widen(int from, double transition) {
  std::vector<int> between;
  if (!kerbs_[from].width) between.push_back(from);
  double size = kerbs_[from].width ? 0 : lengths_[from];
  int to = next_[from];
  for (; to >= 0 && to != from && !kerbs_[to].width; to = next_[to]) {
    between.push_back(to);
    size += lengths_[to];
  }
  const bool known_from = kerbs_[from].width.has_value(), known_to = to >= 0 && kerbs_[to].width;
  if (!known_from && !known_to) return;
  const auto width_beside = [&](int kerb, bool at_end) {
    const std::vector<WidthKnot> knots = knots_of(kerbs_[kerb], lengths_[kerb]);
    return at_end ? knots.back().width : knots.front().width;
  };
  const double start = known_from ? width_beside(from, true) : width_beside(to, false);
  const double end = known_to ? width_beside(to, false) : start;
  const bool across =
      std::any_of(between.begin(), between.end(), [&](int kerb) { return kerbs_[kerb].across; });
  if (std::min(start, end) <= 0) {
    if (across || between.empty() || start == end) return;
    if (start <= 0) std::reverse(between.begin(), between.end());
    lead_on(start > 0 ? SidewalkEnd{from, true, start, between, to}
                      : SidewalkEnd{to, false, end, between, from});
    return;
  }
  const double beyond = std::max(0.0, (transition - size) / 2);
  const double before = known_from ? std::min(beyond, lengths_[from] / 2) : 0;
  const double after = known_to ? std::min(beyond, lengths_[to] / 2) : 0;
  const double inset = std::max(0.0, (size - transition) / 2);
  const std::vector<WidthKnot> change{{inset - before, start}, {size - inset + after, end}};
  double at = 0;
  for (const int kerb : between) {
    put(kerb, at, at + lengths_[kerb], change);
    at += lengths_[kerb];
  }
  if (start == end || change[0].abscissa >= change[1].abscissa) return;
  if (before > 0) put(from, -lengths_[from], 0, change);
  if (after > 0) put(to, size, size + lengths_[to], change);
}

// Kerbs that go on as the street does come before the corner where its sidewalk ends. Straight
// pieces before the arc are such, and kerbs beside a section without ground.
void KerbChains::lead_on(SidewalkEnd end) {
  const Point along = direction_at(kerbs_[end.beside].line, !end.ahead);
  const auto goes_on = [&](int kerb) {
    const Line& line = kerbs_[kerb].line;
    return std::min(dot(along, direction_at(line, true)), dot(along, direction_at(line, false))) >
           nearly_straight;
  };
  std::size_t passed = 0;
  while (passed + 1 < end.on.size() && goes_on(end.on[passed])) {
    end.beside = end.on[passed++];
    widths_[end.beside] = {{0, end.width}, {lengths_[end.beside], end.width}};
  }
  end.on.erase(end.on.begin(), end.on.begin() + static_cast<std::ptrdiff_t>(passed));
  ends_.push_back(std::move(end));
}

// The kerb lies from `start` to `end` along the way on which the width changes. What is known of it
// beside the change stays, whichever change is put first: those of both ends may meet in the
// middle.
void KerbChains::put(int kerb, double start, double end, const std::vector<WidthKnot>& change) {
  std::vector<WidthKnot>& widths = widths_[kerb];
  std::vector<WidthKnot> knots;
  const auto add = [&](const WidthKnot& knot) {
    if (knots.empty() || knot.abscissa - knots.back().abscissa > same_place) knots.push_back(knot);
  };
  const bool keeps_start = kerbs_[kerb].width && change.front().abscissa > start;
  const bool keeps_end = kerbs_[kerb].width && !keeps_start;
  const double from = change.front().abscissa - start, to = change.back().abscissa - start;
  if (keeps_start) {
    for (const WidthKnot& knot : widths)
      if (knot.abscissa < from - same_place) add(knot);
    add({from, width_at(widths, from)});
  } else {
    knots.push_back({0, width_at(change, start)});
  }
  for (const WidthKnot& knot : change)
    if (knot.abscissa > start && knot.abscissa < end && !(keeps_end && &knot == &change.back()))
      add({knot.abscissa - start, knot.width});
  if (keeps_end) {
    add({to, width_at(widths, to)});
    for (const WidthKnot& knot : widths)
      if (knot.abscissa > to) add(knot);
  } else {
    knots.push_back({end - start, width_at(change, end)});
  }
  if (keeps_end && knots.back().abscissa < end - start)
    knots.push_back({end - start, widths.back().width});
  widths = std::move(knots);
}

}  // namespace streetgen
