#include "streetgen/clean.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/box.hpp"
#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

constexpr double collinear_within = 1e-3;

struct LineVertex {
  Point point;
  bool fixed;
};

double angle(const Point& from, const Point& to) {
  return std::atan2(cross(from, to), dot(from, to));
}

// The filters: each is told of the points kept, and asked of the ones between.
class Coincident {
 public:
  explicit Coincident(double epsilon) : epsilon_(epsilon) {}
  void keep(const Point& point) { last_ = point; }
  bool drops(const Point& at, const Point&) const { return distance(last_, at) < epsilon_; }

 private:
  double epsilon_;
  Point last_;
};

// A chord may replace the points dropped since the last kept one when it lies in the cone of
// directions that pass them all closely, and is as long as the farthest of them is away.
class Collinear {
 public:
  void keep(const Point& point) {
    *this = Collinear();
    last_ = point;
  }
  bool drops(const Point& at, const Point& after) {
    pass(at - last_);
    const Point chord = after - last_;
    const double turn = angle(axis_, chord);
    return norm(chord) >= reach_ && low_ <= turn && turn <= high_;
  }

 private:
  void pass(const Point& away) {
    const double far = norm(away);
    reach_ = std::max(reach_, far);
    if (far <= collinear_within) return;
    if (norm(axis_) == 0) axis_ = away;
    const double turn = angle(axis_, away), half = std::asin(collinear_within / far);
    low_ = std::max(low_, turn - half);
    high_ = std::min(high_, turn + half);
  }

  Point last_, axis_;  // turns are counted from axis_
  double reach_ = 0;
  double low_ = -infinite;
  double high_ = infinite;
};

class TightTurn {
 public:
  explicit TightTurn(double r_min) : r_min_(r_min) {}
  void keep(const Point& point) { last_ = point; }
  bool drops(const Point& at, const Point& after) const {
    const Point chord = after - last_;
    const double size = norm(chord);
    if (size == 0) return false;
    // A fold would lose its end, and the street with it.
    const double along = dot(at - last_, chord) / size;
    if (along < -r_min_ || along > size + r_min_) return false;
    const double offset = r_min_ * std::tan(std::abs(angle(at - last_, after - at)) / 2);
    return offset > distance(last_, at) / 2 || offset > distance(at, after) / 2;
  }

 private:
  double r_min_;
  Point last_;
};

bool is_flat_loop(const std::vector<LineVertex>& line) {
  return line.size() < 4 && distance(line.front().point, line.back().point) == 0;
}

template <class Filter>
void apply(Filter filter, std::vector<LineVertex>& line) {
  std::vector<LineVertex> out;
  for (std::size_t i = 0; i < line.size(); ++i) {
    poll_cancel();
    const bool inner = i > 0 && i + 1 < line.size();
    if (inner && !line[i].fixed && filter.drops(line[i].point, line[i + 1].point)) continue;
    out.push_back(line[i]);
    filter.keep(line[i].point);
  }
  if (!is_flat_loop(out)) line = std::move(out);
}

struct Inner {
  std::size_t line, vertex;
};

}  // namespace

Line clean(const Line& line, const std::vector<bool>& keep, double epsilon, double r_min) {
  if (!keep.empty() && keep.size() != line.size())
    throw Error(ErrorKind::invalid_input, "the line has " + std::to_string(line.size()) +
                                              " points but keep has " +
                                              std::to_string(keep.size()) + " elements");
  std::vector<LineVertex> vertices;
  for (std::size_t i = 0; i < line.size(); ++i)
    vertices.push_back({line[i], !keep.empty() && keep[i]});
  apply(Coincident(epsilon), vertices);
  apply(Collinear(), vertices);
  apply(TightTurn(r_min), vertices);
  Line out;
  for (const LineVertex& vertex : vertices) out.push_back(vertex.point);
  return out;
}

std::vector<Line> clean(const std::vector<Line>& lines, const std::vector<Line>& beside,
                        double tolerance, double epsilon, double r_min) {
  std::vector<Line> out;
  std::vector<std::vector<bool>> keep(lines.size());
  std::vector<Inner> places;
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Line& line = lines[i];
    out.push_back(clean(line, {}, epsilon, r_min));
    // What loses no point where none is kept loses none, unless a filter was passed over.
    const bool closed = distance(line.front(), line.back()) == 0;
    if (out[i].size() == line.size() && !closed) continue;
    keep[i].resize(line.size());
    for (std::size_t j = 1; j + 1 < line.size(); ++j) {
      places.push_back({i, j});
      boxes.push_back(box_of(line[j], line[j]));
    }
  }
  const BoxIndex index(boxes);
  const auto meet = [&](const Line& line, std::size_t of) {
    poll_cancel();
    for (const Point& p : line)
      for (const int at : index.near(box_of(p, p), tolerance)) {
        const Inner& place = places[at];
        if (place.line != of && distance(lines[place.line][place.vertex], p) <= tolerance)
          keep[place.line][place.vertex] = true;
      }
  };
  for (std::size_t i = 0; i < lines.size(); ++i) meet(lines[i], i);
  for (const Line& line : beside) meet(line, lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (!keep[i].empty()) out[i] = clean(lines[i], keep[i], epsilon, r_min);
  return out;
}

}  // namespace streetgen
