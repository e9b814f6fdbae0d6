#include "pipeline/invariants.hpp"

#ifdef STREETGEN_INVARIANTS

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

void require(bool holds, const char* rule, std::size_t row) {
  if (!holds) throw std::logic_error(std::string(rule) + ", row " + std::to_string(row));
}

bool touches(const Edge& edge, bool at_start, int node) {
  return (at_start ? edge.from_node : edge.to_node) == node;
}

void require_closed_rings(const MultiPolygon& surface, const char* rule, std::size_t row) {
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon) {
      require(ring.size() > 3 && same(ring.front(), ring.back()), rule, row);
      for (const Point& p : ring) require(std::isfinite(p.x) && std::isfinite(p.y), rule, row);
    }
}

bool is_end_of(const Line& line, const Point& p) {
  return distance(line.front(), p) <= same_place || distance(line.back(), p) <= same_place;
}

}  // namespace

void check_network(const Network& network) {
  for (std::size_t e = 0; e < network.edges.size(); ++e) {
    const Edge& edge = network.edges[e];
    require(edge.line.size() > 1, "an edge has two points or more", e);
    require(same(edge.line.front(), network.nodes.at(edge.from_node).point) &&
                same(edge.line.back(), network.nodes.at(edge.to_node).point),
            "an edge starts and ends at its nodes", e);
    require(edge.start_abscissa < edge.end_abscissa, "abscissas grow along an edge", e);
    require(e == 0 || network.edges[e - 1].axis_id != edge.axis_id ||
                network.edges[e - 1].end_abscissa <= edge.start_abscissa,
            "the edges of an axis follow each other", e);
  }
}

void check_corners(const Streets& streets) {
  for (std::size_t c = 0; c < streets.corners.size(); ++c) {
    const Corner& corner = streets.corners[c];
    const auto& edges = streets.network.edges;
    require(touches(edges.at(corner.edge_a), corner.at_start_a, corner.node) &&
                touches(edges.at(corner.edge_b), corner.at_start_b, corner.node),
            "a corner lies between edges of its node", c);
    require(std::isfinite(corner.radius) && corner.radius >= 0, "a radius is no less than 0", c);
    if (!corner.arc) continue;
    require(corner.centre.has_value(), "an arc has a centre", c);
    for (const Point& p : {corner.arc->start, corner.arc->middle, corner.arc->end})
      require(std::abs(distance(*corner.centre, p) - corner.radius) <= coordinate_margin,
              "an arc lies on the circle of its corner", c);
  }
}

void check_limits(const Streets& streets) {
  require(streets.limits.size() == 2 * streets.network.edges.size(), "an edge has two limits",
          streets.limits.size());
  for (std::size_t e = 0; e < streets.network.edges.size(); ++e) {
    const SectionLimit &start = streets.limits[2 * e], &end = streets.limits[2 * e + 1];
    const double size = length(streets.network.edges[e].line);
    require(start.at_start && !end.at_start, "the limits of an edge are its start and its end", e);
    require(start.abscissa >= -coordinate_margin && end.abscissa <= size + coordinate_margin &&
                start.abscissa <= end.abscissa + same_place,
            "the limits of an edge lie on it in their order", e);
  }
}

void check_surfaces(const Streets& streets) {
  for (std::size_t s = 0; s < streets.sections.size(); ++s) {
    require(streets.affected_edges.at(streets.sections[s].edge), "a section is affected", s);
    require_closed_rings(streets.sections[s].surface, "rings of sections are closed", s);
  }
  for (std::size_t i = 0; i < streets.intersections.size(); ++i) {
    require(streets.affected_nodes.at(streets.intersections[i].node), "an intersection is affected",
            i);
    require_closed_rings(streets.intersections[i].surface, "rings of intersections are closed", i);
  }
}

void check_kerbs(const Streets& streets) {
  std::map<std::pair<int, KerbSide>, int> parts;
  for (std::size_t k = 0; k < streets.kerbs.size(); ++k) {
    const Kerb& kerb = streets.kerbs[k];
    require(kerb.line.size() > 1, "a kerb has a line", k);
    require(kerb.part == ++parts[{kerb.edge, kerb.side}], "parts of kerbs follow each other", k);
    require(kerb.node < 0 || touches(streets.network.edges.at(kerb.edge), true, kerb.node) ||
                touches(streets.network.edges.at(kerb.edge), false, kerb.node),
            "the kerb of an intersection names an edge that meets there", k);
  }
}

void check_lanes(const Streets& streets, const Lanes& lanes) {
  std::set<std::pair<int, int>> numbers;
  for (std::size_t l = 0; l < lanes.lanes.size(); ++l) {
    const Lane& lane = lanes.lanes[l];
    require(lane.edge >= 0 && lane.edge < static_cast<int>(streets.network.edges.size()),
            "a lane lies on an edge", l);
    require(lane.line.size() > 1, "a lane has a line", l);
    require(numbers.emplace(lane.edge, lane.ordinality).second, "lanes have a number each", l);
    require(lane.position == 1 || (l > 0 && lanes.lanes[l - 1].edge == lane.edge &&
                                   lanes.lanes[l - 1].position + 1 == lane.position),
            "lanes follow each other from the left", l);
    require_closed_rings(lane.surface, "rings of lanes are closed", l);
  }
}

void check_interconnections(const StreetModel& model) {
  for (std::size_t i = 0; i < model.interconnections.size(); ++i) {
    const Interconnection& path = model.interconnections[i];
    const auto& edges = model.streets.network.edges;
    for (const int lane : {path.lane_in, path.lane_out}) {
      const Edge& edge = edges.at(model.lanes.lanes.at(lane).edge);
      require(edge.from_node == path.node || edge.to_node == path.node,
              "a path joins lanes of its node", i);
    }
    require(path.line.size() > 1 &&
                is_end_of(model.lanes.lanes[path.lane_in].line, path.line.front()) &&
                is_end_of(model.lanes.lanes[path.lane_out].line, path.line.back()),
            "a path goes from the end of a lane to the end of another", i);
  }
}

}  // namespace streetgen

#endif
