// ArcRoad::fit: of a polyline the road with the greatest radii.
#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/space.hpp"
#include "geometry/tolerance.hpp"
#include "road/fit_radii.hpp"
#include "road/road_body.hpp"
#include "road/road_vertex.hpp"
#include "streetgen/arc_road.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"

namespace streetgen {

namespace {

constexpr double fits = 1e-9;  // share by which tangents may exceed their segment

void refuse_unless_length(double value, const std::string& name) {
  if (!std::isfinite(value) || value < 0)
    throw Error(ErrorKind::invalid_input,
                name + " is " + text_of(value) + ", expected a finite number of 0 or more");
}

std::string radius_name(std::size_t vertex) {
  return "the radius of vertex " + std::to_string(vertex + 1);
}

void refuse_limits(const Line& line, const ArcRoadFit& fit) {
  refuse_unless_length(fit.cap, "cap");
  if (fit.shift) refuse_unless_length(*fit.shift, "shift");
  if (!fit.radii.empty() && fit.radii.size() != line.size())
    throw Error(ErrorKind::invalid_input, "radii has " + std::to_string(fit.radii.size()) +
                                              " elements, expected one for each of the " +
                                              std::to_string(line.size()) + " points of the line");
  for (std::size_t i = 0; i < fit.radii.size(); ++i)
    if (fit.radii[i]) refuse_unless_length(*fit.radii[i], radius_name(i));
}

class Fitting {
 public:
  Fitting(const Line& line, const ArcRoadFit& fit)
      : line_(line), fit_(fit), vertices_(road_vertices(line)), near_(resolution(line)) {
    const Line& points = vertices_.points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      lengths_.push_back(space::distance(points[i], points[i + 1]));
      directions_.push_back(space::unit(points[i + 1] - points[i]));
    }
    for (std::size_t i = 1; i + 1 < points.size(); ++i) bends_.push_back(bend_at(i));
    refuse_misfit();
    radii_ = fit_radii(lengths_, bends_);
  }

  ArcRoad road() {
    const Line& points = vertices_.points;
    RoadBuilder road(near_);
    std::vector<RoadArc> arcs;
    arcs.reserve(bends_.size());
    double taken = 0;  // of the segment, by the bend before it
    for (std::size_t i = 0; i < lengths_.size(); ++i) {
      poll_cancel();
      const double next = i < bends_.size() ? radii_[i] * bends_[i].tangent : 0;
      RoadPiece straight;
      straight.origin = points[i] + directions_[i] * taken;
      straight.forward = directions_[i];
      straight.length = lengths_[i] - taken - next;
      road.add(straight);
      if (i < bends_.size()) arcs.push_back(add_arc(road, i, next));
      taken = next;
    }
    return road.built(points.back(), std::move(arcs));
  }

 private:
  Bend bend_at(std::size_t vertex) const {
    const Point &in = directions_[vertex - 1], &out = directions_[vertex];
    const double sine = space::norm(space::cross(in, out)), cosine = space::dot(in, out);
    Bend bend;
    if (dot(in, out) < 0 && std::abs(cross(in, out)) <= straight_sine * norm(in) * norm(out)) {
      bend.fixed = 0;  // there and back
      if (const auto wanted = fixed_at(vertex); wanted && *wanted > 0)
        refuse_radius(vertex, *wanted, 0);
      return bend;
    }
    if (cosine > 0 && sine <= straight_sine) {
      bend.fixed = 0;
      return bend;
    }
    bend.tangent = half_turn_tangent(sine, cosine);
    bend.bound = fit_.cap;
    if (fit_.shift) bend.bound = std::min(bend.bound, radius_of_shift(bend.tangent, *fit_.shift));
    bend.fixed = fixed_at(vertex);
    return bend;
  }

  // Said of the point or of one that repeats it.
  std::optional<double> fixed_at(std::size_t vertex) const {
    if (fit_.radii.empty()) return {};
    const std::size_t number = vertices_.numbers[vertex];
    for (std::size_t i = number;
         i < line_.size() && space::distance(line_[i], line_[number]) <= near_; ++i)
      if (fit_.radii[i]) return fit_.radii[i];
    return {};
  }

  [[noreturn]] void refuse_radius(std::size_t vertex, double radius, double greatest) const {
    throw Error(ErrorKind::invalid_input, radius_name(vertices_.numbers[vertex]) + " is " +
                                              text_of(radius) + ", but the bend has room for " +
                                              text_of(greatest) + " at most");
  }

  void refuse_misfit() const {
    const auto taken = [&](std::size_t bend) {
      return bend < bends_.size() && bends_[bend].fixed ? *bends_[bend].fixed * bends_[bend].tangent
                                                        : 0;
    };
    for (std::size_t i = 0; i < lengths_.size(); ++i) {
      const double before = i > 0 ? taken(i - 1) : 0, after = taken(i);
      if (before + after <= lengths_[i] * (1 + fits)) continue;
      // The one before has found room in its other segment and goes first.
      const bool alone = before > lengths_[i] * (1 + fits) || after == 0;
      const std::size_t bend = alone ? i - 1 : i;
      const double room = alone ? lengths_[i] : lengths_[i] - before;
      refuse_radius(bend + 1, *bends_[bend].fixed, std::max(room, 0.0) / bends_[bend].tangent);
    }
  }

  RoadArc add_arc(RoadBuilder& road, std::size_t bend, double tangent) const {
    const Point &in = directions_[bend], &out = directions_[bend + 1];
    const Point& corner = vertices_.points[bend + 1];
    RoadPiece piece;
    piece.origin = corner - in * tangent;
    piece.forward = in;
    piece.radius = radii_[bend];
    const bool turns = bends_[bend].tangent > 0;
    const double angle = turns ? 2 * std::atan(bends_[bend].tangent) : dot(in, out) < 0 ? M_PI : 0;
    piece.length = piece.radius * angle;
    const Point axis = turns ? space::unit(space::cross(in, out)) : Point{0, 0, 1};
    piece.inward = space::cross(axis, in);
    RoadArc arc;
    arc.vertex = vertices_.numbers[bend + 1];
    arc.centre = piece.centre();
    arc.radius = piece.radius;
    arc.angle = angle;
    arc.start_abscissa = road.add(piece);
    arc.end_abscissa = road.length();
    arc.start_direction = piece.inward * -1;
    arc.orientation = axis;
    return arc;
  }

  const Line& line_;
  const ArcRoadFit& fit_;
  RoadVertices vertices_;
  double near_;
  std::vector<double> lengths_;
  std::vector<Point> directions_;
  std::vector<Bend> bends_;
  std::vector<double> radii_;
};

}  // namespace

ArcRoad ArcRoad::fit(const Line& line, const ArcRoadFit& fit) {
  refuse_limits(line, fit);
  return Fitting(line, fit).road();
}

}  // namespace streetgen
