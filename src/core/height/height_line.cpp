#include "height/height_line.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

constexpr double sagitta = 0.01;  // metres by which chords leave a parabola
constexpr double same_grade = 1e-9;

double grade(const HeightPoint& from, const HeightPoint& to) {
  return (to.z - from.z) / (to.at - from.at);
}

bool holds(const std::vector<double>& places, double at) {
  return std::any_of(places.begin(), places.end(),
                     [&](double place) { return std::abs(place - at) <= same_place; });
}

class Rounding {
 public:
  Rounding(const HeightLine& heights, const KinkBounds& bounds)
      : heights_(heights), bounds_(bounds) {}

  HeightLine run() const {
    HeightLine round{heights_.front()};
    for (std::size_t i = 1; i + 1 < heights_.size(); ++i) append(i, &round);
    if (heights_.size() > 1) round.push_back(heights_.back());
    return round;
  }

 private:
  double change(std::size_t i) const {
    return grade(heights_[i], heights_[i + 1]) - grade(heights_[i - 1], heights_[i]);
  }

  bool on_ground(std::size_t i) const {
    return std::abs(heights_[i].z - height_at(bounds_.ground, heights_[i].at)) <= same_place;
  }

  bool below_ground(std::size_t i) const {
    return heights_[i].z < height_at(bounds_.ground, heights_[i].at) - same_place;
  }

  bool is_kink(std::size_t i) const {
    return i > 0 && i + 1 < heights_.size() && std::abs(change(i)) > same_grade &&
           !(on_ground(i - 1) && on_ground(i) && on_ground(i + 1));
  }

  // The height that a parabola may take there since the road was lifted or sunk by it; none: it was
  // not.
  std::optional<double> loss(std::size_t i) const {
    std::optional<double> least;
    for (const KinkLoss& loss : change(i) < 0 ? bounds_.lowered : bounds_.raised)
      if (std::abs(loss.at - heights_[i].at) <= same_place)
        least = std::min(loss.most, least.value_or(loss.most));
    return least;
  }

  // Whether a parabola at the kink keeps what must hold there.
  bool may_leave(std::size_t i) const {
    const double at = heights_[i].at;
    const bool crest = change(i) < 0;
    if (loss(i)) return true;
    return !holds(bounds_.fixed, at) &&
           !(crest && on_ground(i) && !below_ground(i - 1) && !below_ground(i + 1));
  }

  // Metres from the kink to where its parabola begins.
  double tangent(std::size_t i) const {
    if (bounds_.radius <= 0 || !is_kink(i) || !may_leave(i)) return 0;
    double length = bounds_.radius * std::abs(change(i)) / 2;
    if (const auto most = loss(i)) length = std::min(length, 4 * *most / std::abs(change(i)));
    for (const std::size_t next : {i - 1, i + 1}) {
      const double apart = std::abs(heights_[next].at - heights_[i].at);
      length = std::min(length, is_kink(next) ? apart / 2 : apart);
    }
    for (const double place : bounds_.fixed)
      if (std::abs(place - heights_[i].at) > same_place)
        length = std::min(length, std::abs(place - heights_[i].at));
    return length;
  }

  void append(std::size_t i, HeightLine* round) const {
    const HeightPoint& kink = heights_[i];
    const double length = tangent(i);
    if (length <= same_place) {
      round->push_back(kink);
      return;
    }
    const double bend = change(i), before = grade(heights_[i - 1], kink);
    const double begin = kink.at - length, begin_z = kink.z - before * length;
    const double step = std::sqrt(8 * sagitta * 2 * length / std::abs(bend));
    // The middle is a point: there the clearance is measured.
    const int chords = std::max(1, static_cast<int>(std::ceil(length / step)));
    for (int k = 0; k <= 2 * chords; ++k) {
      const double along = length * k / chords;
      const double z = begin_z + before * along + bend * along * along / (4 * length);
      if (begin + along > round->back().at + same_place) round->push_back({begin + along, z});
    }
  }

  const HeightLine& heights_;
  const KinkBounds& bounds_;
};

// The higher of two lines at each place; both begin and end at the same abscissas.
HeightLine higher_of(const HeightLine& a, const HeightLine& b) {
  std::vector<double> places;
  for (const HeightLine* line : {&a, &b})
    for (const HeightPoint& point : *line) places.push_back(point.at);
  std::sort(places.begin(), places.end());
  HeightLine higher;
  double before = 0;  // of a over b at the last place
  for (const double at : places) {
    if (!higher.empty() && at <= higher.back().at + same_place) continue;
    const double z_a = height_at(a, at), z_b = height_at(b, at), over = z_a - z_b;
    if (!higher.empty() && over * before < 0) {
      const double from = higher.back().at;
      const double meet = from + (at - from) * (before / (before - over));
      if (meet > from + same_place && meet < at - same_place)
        higher.push_back({meet, height_at(a, meet)});
    }
    higher.push_back({at, std::max(z_a, z_b)});
    before = over;
  }
  return higher;
}

}  // namespace

HeightLine heights_of(const Line& line) {
  HeightLine heights;
  double at = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) at += distance(line[i - 1], line[i]);
    heights.push_back({at, line[i].z});
  }
  return heights;
}

double height_at(const HeightLine& heights, double at) {
  if (at <= heights.front().at) return heights.front().z;
  if (at >= heights.back().at) return heights.back().z;
  const auto after = std::upper_bound(heights.begin(), heights.end(), at,
                                      [](double a, const HeightPoint& p) { return a < p.at; });
  const HeightPoint &from = *(after - 1), &to = *after;
  return from.z + (to.z - from.z) * ((at - from.at) / (to.at - from.at));
}

HeightLine raised_to(const HeightLine& heights, const HeightLine& bound, double grade) {
  const HeightPoint first = bound.front(), last = bound.back();
  const double begin = heights.front().at, end = heights.back().at;
  HeightLine whole;
  if (first.at > begin + same_place) whole.push_back({begin, first.z - grade * (first.at - begin)});
  whole.insert(whole.end(), bound.begin(), bound.end());
  if (last.at < end - same_place) whole.push_back({end, last.z - grade * (end - last.at)});
  return higher_of(heights, whole);
}

HeightLine kinks_of(const HeightLine& heights) {
  HeightLine kinks{heights.front()};
  for (std::size_t i = 1; i < heights.size(); ++i) {
    const bool is_last = i + 1 == heights.size();
    if (is_last ||
        std::abs(grade(kinks.back(), heights[i]) - grade(heights[i], heights[i + 1])) > same_grade)
      kinks.push_back(heights[i]);
  }
  return kinks;
}

HeightLine upside_down(HeightLine heights) {
  for (HeightPoint& point : heights) point.z = -point.z;
  return heights;
}

Line with_heights(const Line& line, const HeightLine& heights) {
  Line out;
  auto next = heights.begin();
  double at = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) {
      const double size = distance(line[i - 1], line[i]);
      for (; next != heights.end() && next->at < at + size - same_place; ++next)
        if (next->at > at + same_place) {
          Point point = line[i - 1] + (line[i] - line[i - 1]) * ((next->at - at) / size);
          point.z = next->z;
          out.push_back(point);
        }
      at += size;
    }
    out.push_back({line[i].x, line[i].y, height_at(heights, at)});
  }
  return out;
}

HeightLine without_kinks(const HeightLine& heights, const KinkBounds& bounds) {
  return Rounding(heights, bounds).run();
}

}  // namespace streetgen
