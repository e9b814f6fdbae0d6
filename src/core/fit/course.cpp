#include "fit/course.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "geometry/polyline.hpp"

namespace streetgen {

int Unknowns::add(double value, double lower, double upper) {
  origin.push_back(value);
  least.push_back(std::min(lower, value));
  greatest.push_back(std::max(upper, value));
  return count() - 1;
}

Point FittedCourse::vertex(std::size_t i) const {
  const CourseVertex& vertex = course_.vertices[i];
  if (vertex.x == not_free) return vertex.origin;
  return {vertex.origin.x + values_[vertex.x], vertex.origin.y + values_[vertex.x + 1],
          vertex.origin.z};
}

double FittedCourse::width_end() const {
  if (course_.width_end == course_.width_start && course_.width_start != not_free)
    return values_[course_.width_start] + axis_.width_end - axis_.width_start;
  return of(course_.width_end, axis_.width_end);
}

namespace {

constexpr double one_vertex = 0.01;  // metres: a node so near to a vertex lies there

// The abscissas of the vertices of an axis.
std::vector<double> abscissas_of(const Line& line) {
  std::vector<double> abscissas{0};
  for (std::size_t i = 1; i < line.size(); ++i)
    abscissas.push_back(abscissas.back() + distance(line[i - 1], line[i]));
  return abscissas;
}

// Abscissas of nodes, and of cuts between neighbours farther apart than a piece.
std::vector<double> places_between(std::vector<double> there, const FitAxis& axis, double piece) {
  const auto add_new = [&](double abscissa) {
    const auto next = std::lower_bound(there.begin(), there.end(), abscissa);
    if (next != there.end() && *next - abscissa < one_vertex) return;
    if (next != there.begin() && abscissa - *(next - 1) < one_vertex) return;
    there.insert(next, abscissa);
  };
  for (const FitStretch& stretch : axis.stretches) {
    add_new(stretch.start);
    add_new(stretch.end);
  }
  std::vector<double> places;
  for (std::size_t i = 0; i < there.size(); ++i) {
    if (i > 0) {
      const double gap = there[i] - there[i - 1];
      const int pieces = static_cast<int>(std::ceil(gap / piece));
      for (int k = 1; k < pieces; ++k) places.push_back(there[i - 1] + gap * k / pieces);
    }
    places.push_back(there[i]);
  }
  return places;
}

// The node at an abscissa of an axis; none: 0 and false.
std::pair<std::int64_t, bool> node_at(const FitAxis& axis, double abscissa) {
  for (const FitStretch& stretch : axis.stretches) {
    if (std::abs(stretch.start - abscissa) < one_vertex) return {stretch.start_node, true};
    if (std::abs(stretch.end - abscissa) < one_vertex) return {stretch.end_node, true};
  }
  return {0, false};
}

}  // namespace

Unknowns vertices_of(const std::vector<FitAxis>& axes, const FitRules& rules) {
  Unknowns unknowns;
  std::set<std::int64_t> held{0};
  if (rules.axes_move)
    for (const FitAxis& axis : axes)
      if (!axis.moves)
        for (const FitStretch& stretch : axis.stretches)
          held.insert({stretch.start_node, stretch.end_node});
  std::map<std::int64_t, int> unknown_of_node;
  for (const FitAxis& axis : axes) {
    Course course;
    const Line line = distinct(axis.line);
    const std::vector<double> abscissas = abscissas_of(line);
    course.total = abscissas.back();
    if (!rules.axes_move || !axis.moves) {
      for (std::size_t i = 0; i < line.size(); ++i)
        course.vertices.push_back({line[i], abscissas[i], not_free});
    } else {
      for (double place : places_between(abscissas, axis, rules.piece)) {
        const auto own = std::lower_bound(abscissas.begin(), abscissas.end(), place);
        CourseVertex vertex{own != abscissas.end() && *own == place
                                ? line[own - abscissas.begin()]
                                : position_at(line, place).point,
                            place, not_free};
        const auto [node, is_node] = node_at(axis, place);
        if (is_node && held.count(node) > 0) {
          course.vertices.push_back(vertex);
          continue;
        }
        const auto known = is_node ? unknown_of_node.find(node) : unknown_of_node.end();
        if (known != unknown_of_node.end()) {
          vertex.x = known->second;
        } else {
          vertex.x = unknowns.add(0, -rules.move, rules.move);
          unknowns.add(0, -rules.move, rules.move);
          if (is_node) unknown_of_node.emplace(node, vertex.x);
        }
        course.vertices.push_back(vertex);
      }
    }
    unknowns.courses.push_back(std::move(course));
  }
  return unknowns;
}

void add_widths(const std::vector<FitAxis>& axes, const std::vector<bool>& taken,
                const std::vector<bool>& tapers, const FitRules& rules, Unknowns& unknowns) {
  const auto add_width = [&](double width) {
    return unknowns.add(width, std::max(rules.width_least, width - rules.width_change),
                        std::min(rules.width_greatest, width + rules.width_change));
  };
  for (std::size_t a = 0; a < axes.size(); ++a) {
    if (!taken[a] || !axes[a].moves) continue;
    Course& course = unknowns.courses[a];
    course.width_start = add_width(axes[a].width_start);
    course.width_end = tapers[a] ? add_width(axes[a].width_end) : course.width_start;
    if (!rules.axes_move)
      course.offset = unknowns.add(axes[a].roadway_offset, axes[a].roadway_offset - rules.move,
                                   axes[a].roadway_offset + rules.move);
  }
}

}  // namespace streetgen
