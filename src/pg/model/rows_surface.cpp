// The rows of subject surface.
#include <utility>

#include "model/row_value.hpp"
#include "model/streets_give.hpp"

namespace streetgen::pg {

namespace {

using Computed = const ComputedStreets&;

bool fill_section_limit(const ComputedStreets& computed, const Named& named, std::size_t i,
                        Row& row) {
  const SectionLimit& limit = computed.streets.limits[i];
  const std::int64_t edge = named.edges[limit.edge];
  return edge > 0 && put(row, edge, computed.streets.network.edges[limit.edge].axis_id,
                         end_name(limit.at_start), limit.wanted_abscissa, limit.abscissa,
                         Geometry{stored_point(limit.point, with_z(computed))},
                         Geometry{stored_line(limit.border_line, flat(computed))},
                         name(method_name(limit.method)));
}

bool fill_section(const ComputedStreets& computed, const Named& named, std::size_t i, Row& row) {
  const Section& section = computed.streets.sections[i];
  const std::int64_t edge = named.edges[section.edge];
  return edge > 0 && put(row, edge, computed.streets.network.edges[section.edge].level,
                         Geometry{stored_surface(section.surface, flat(computed))},
                         name(method_name(section.method)), section.contested_area,
                         borders_value(section.borders));
}

bool fill_corner(const ComputedStreets& computed, const Named& named, std::size_t i, Row& row) {
  const Corner& corner = computed.streets.corners[i];
  const std::int64_t node = named.nodes[corner.node];
  const std::int64_t edge_a = named.edges[corner.edge_a], edge_b = named.edges[corner.edge_b];
  if (node == 0 || edge_a == 0 || edge_b == 0 || !computed.streets.affected_nodes[corner.node])
    return false;
  Value centre, arc;
  if (corner.centre) centre = Geometry{stored_point(*corner.centre, flat(computed))};
  if (corner.arc) arc = Ewkb{write_arc(*corner.arc, flat(computed))};
  return put(row, node, edge_a, end_name(corner.at_start_a), edge_b, end_name(corner.at_start_b),
             std::move(centre), corner.radius_wanted, corner.radius, std::move(arc),
             name(method_name(corner.method)));
}

bool fill_intersection(const ComputedStreets& computed, const Named& named, std::size_t i,
                       Row& row) {
  const Intersection& intersection = computed.streets.intersections[i];
  const std::int64_t node = named.nodes[intersection.node];
  return node > 0 && put(row, node, intersection.level,
                         Geometry{stored_surface(intersection.surface, flat(computed))},
                         name(method_name(intersection.method)), intersection.contested_area);
}

const Table section_limit_table{[](Computed c) { return c.streets.limits.size(); },
                                fill_section_limit,
                                [](ComputedStreets& c) { release(c.streets.limits); }};
const Table section_table{[](Computed c) { return c.streets.sections.size(); }, fill_section,
                          [](ComputedStreets& c) { release(c.streets.sections); }};
const Table corner_table{[](Computed c) { return c.streets.corners.size(); }, fill_corner,
                         [](ComputedStreets& c) { release(c.streets.corners); }};
const Table intersection_table{[](Computed c) { return c.streets.intersections.size(); },
                               fill_intersection,
                               [](ComputedStreets& c) { release(c.streets.intersections); }};

}  // namespace

STREETGEN_TABLE(section_limit, &Named::edges)
STREETGEN_TABLE(section, &Named::edges)
STREETGEN_TABLE(corner, &Named::nodes, &Named::edges)
STREETGEN_TABLE(intersection, &Named::nodes)

}  // namespace streetgen::pg
