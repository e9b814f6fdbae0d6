#include "roadway/round_kink.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

const double least_cosine = std::cos(M_PI / 6 + same_angle);  // of a turn that is no kink
constexpr int quarter = 8;                                    // chords of a quarter circle
constexpr double shortest_side = 1e-3;                        // metres of a side that an arc takes
constexpr double most = 0.9;            // of the way to what an arc must not reach
constexpr double widest = 0.49 * M_PI;  // half of a turn: beyond it a line goes back

bool turns(const Point& before, const Point& at, const Point& after) {
  const Point in = at - before, out = after - at;
  return dot(in, out) < least_cosine * norm(in) * norm(out);
}

// From one side to the other, each left at most `room` metres from the vertex.
void append_round(Line& line, const Point& before, const Point& at, const Point& after, double room,
                  double radius) {
  const Point in = unit(at - before), out = unit(after - at);
  const double sine = cross(in, out), cosine = dot(in, out);
  const double tangent = std::abs(std::atan2(sine, cosine)) / 2;
  const double taken = std::min(radius * std::tan(tangent), room);
  if (taken < shortest_side || tangent > widest) return line.push_back(at);
  const double side = sine > 0 ? 1 : -1;
  const Point from = at - in * taken, to = at + out * taken;
  const Point centre = from + left_normal(in) * (side * taken / std::tan(tangent));
  line.push_back(from);
  append_arc(line, centre, from, to, sine > 0, quarter);
  line.push_back(to);
}

// A line whose vertices may be kinks, each beside its neighbours; of a ring they go round.
class Kinks {
 public:
  Kinks(const Line& line, bool is_ring, const std::vector<Line>& clear_of)
      : line_(line), lines_(clear_of), is_ring_(is_ring), count_(line.size() - (is_ring ? 1 : 0)) {
    for (std::size_t i = 0; i < count_; ++i)
      if (has_both_sides(i) && turns(line_[before(i)], line_[i], line_[after(i)])) {
        kink_.resize(count_);
        kink_[i] = true;
      }
  }

  bool none() const { return kink_.empty(); }

  Line rounded(double radius) const {
    Line out;
    for (std::size_t i = 0; i < count_; ++i) {
      if (kink_[i])
        append_round(out, line_[before(i)], line_[i], line_[after(i)], room(i), radius);
      else
        out.push_back(line_[i]);
    }
    if (is_ring_) out.push_back(out.front());
    return distinct(std::move(out));
  }

 private:
  std::size_t before(std::size_t i) const { return (i + count_ - 1) % count_; }
  std::size_t after(std::size_t i) const { return (i + 1) % count_; }
  bool has_both_sides(std::size_t i) const { return is_ring_ || (i > 0 && i + 1 < count_); }
  double room(std::size_t i) const {
    double least = std::min(room_beside(i, before(i)), room_beside(i, after(i)));
    for (const Line& line : lines_)
      least = std::min(least, distance_to_line(line_[i], line) * most);
    return least;
  }
  double room_beside(std::size_t i, std::size_t other) const {
    return distance(line_[i], line_[other]) * (kink_[other] ? 0.5 : most);
  }

  const Line& line_;
  const std::vector<Line>& lines_;  // that an arc stays clear of
  const bool is_ring_;
  const std::size_t count_;
  std::vector<bool> kink_;  // by vertex; empty where none is one
};

void append_others(const MultiPolygon& surface, const Ring& but, std::vector<Line>& lines) {
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon)
      if (&ring != &but) lines.push_back(ring);
}

}  // namespace

Line with_round_kinks(const Line& line, double radius, const std::vector<Line>& borders) {
  if (line.size() < 3 || radius <= 0) return line;
  const Kinks kinks(line, false, borders);
  return kinks.none() ? line : kinks.rounded(radius);
}

void round_kinks(Geos& geos, MultiPolygon& surface, double radius,
                 const std::vector<Line>& borders) {
  if (radius <= 0) return;
  MultiPolygon rounded;
  for (std::size_t p = 0; p < surface.size(); ++p)
    for (std::size_t r = 0; r < surface[p].size(); ++r) {
      std::vector<Line> limits = borders;
      append_others(surface, surface[p][r], limits);
      const Kinks kinks(surface[p][r], true, limits);
      if (kinks.none()) continue;
      if (rounded.empty()) rounded = surface;
      rounded[p][r] = kinks.rounded(radius);
    }
  if (!rounded.empty() && geos.valid(rounded)) surface = std::move(rounded);
}

}  // namespace streetgen
