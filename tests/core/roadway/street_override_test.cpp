// What a user decides about limits, corners and lanes holds, and the ground is still tiled.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/geos.hpp"
#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "rounds.hpp"
#include "shared_area.hpp"
#include "streetgen/corner.hpp"
#include "streetgen/interconnection.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace street_override_test {

const int junctions = rounds(60);

struct Random {
  std::mt19937_64 engine;
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine() % 1000000) / 1e6;
  }
  int below(int count) { return static_cast<int>(engine() % static_cast<unsigned>(count)); }
};

// Three to six crooked streets that meet at one place; every second one goes on at its far end.
std::vector<StreetAxis> random_junction(Random& random) {
  const Point node{650000, 6860000, 0};
  std::vector<StreetAxis> axes;
  const int arms = 3 + random.below(4);
  for (int i = 0; i < arms; ++i) {
    const double heading = 2 * M_PI * i / arms + random.between(-0.35, 0.35);
    const auto go = [](const Point& from, double angle, double size) {
      return from + Point{std::cos(angle), std::sin(angle), 0} * size;
    };
    const double size = random.between(20, 90);
    const Point middle = go(node, heading, size / 2);
    const Point end = go(middle, heading + random.between(-0.4, 0.4), size / 2);
    StreetAxis axis;
    axis.axis_id = i + 1;
    axis.line = {node, middle, end};
    if (random.below(2) == 0) axis.line = reversed(axis.line);
    axis.width = axis.width_end = random.between(4, 12);
    axis.radius = random.between(0, 8);
    axis.importance = 1 + random.below(5);
    axes.push_back(axis);
    if (i % 2 == 0)
      for (const double turn : {-1.2, 1.1}) {
        axis.axis_id = 100 + 2 * i + (turn > 0 ? 1 : 0);
        axis.line = {end, go(end, heading + turn, 40)};
        axes.push_back(axis);
      }
  }
  return axes;
}

std::vector<const MultiPolygon*> surfaces_of(const Streets& town) {
  std::vector<const MultiPolygon*> surfaces;
  for (const Section& section : town.sections) surfaces.push_back(&section.surface);
  for (const Intersection& intersection : town.intersections)
    surfaces.push_back(&intersection.surface);
  return surfaces;
}

// Surfaces are valid, lie beside each other, and no axis runs beside them.
void expect_tiled(const Streets& town, const std::string& of) {
  Geos geos;
  const std::vector<const MultiPolygon*> surfaces = surfaces_of(town);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    ASSERT_TRUE(geos.valid(geos.surface(*surfaces[i]).get())) << of;
    for (std::size_t j = i + 1; j < surfaces.size(); ++j)
      EXPECT_LT(shared_area(*surfaces[i], *surfaces[j]), 1e-3) << of;
  }
  for (const Edge& edge : town.network.edges) {
    const double total = length(edge.line);
    for (double at = 0.17; at < total; at += 0.53) {
      const Point p = position_at(edge.line, at).point;
      const bool covered =
          std::any_of(surfaces.begin(), surfaces.end(), [&](const MultiPolygon* surface) {
            return std::any_of(surface->begin(), surface->end(),
                               [&](const Polygon& polygon) { return inside(p, polygon); });
          });
      const bool on_limit = std::any_of(
          town.limits.begin(), town.limits.end(),
          [&](const SectionLimit& limit) { return distance(planar(limit.point), p) < 0.05; });
      EXPECT_TRUE(covered || on_limit) << of << ", axis " << edge.axis_id << " at " << at;
    }
  }
}

// The end of each edge at a node of three and more, with the edge's length.
std::vector<SectionLimitOverride> random_limits(Random& random, const Streets& town) {
  std::vector<SectionLimitOverride> puts;
  for (const Edge& edge : town.network.edges)
    for (const bool at_start : {true, false}) {
      if (random.below(2) == 0) continue;
      puts.push_back(
          {edge.axis_id, random.between(edge.start_abscissa, edge.end_abscissa), at_start});
    }
  return puts;
}

bool ends_dead(const Network& network, int node) {
  return std::count_if(network.edges.begin(), network.edges.end(), [&](const Edge& edge) {
           return edge.from_node == node || edge.to_node == node;
         }) < 2;
}

TEST(ByHand, ALimitLiesWhereItWasPut) {
  int placed = 0;
  for (int seed = 1; seed <= junctions; ++seed) {
    Random random{std::mt19937_64(seed)};
    const std::vector<StreetAxis> axes = random_junction(random);
    const Streets before = streets(axes, {});
    for (int e = 0; e < static_cast<int>(before.network.edges.size()); ++e) {
      const Edge& edge = before.network.edges[e];
      for (const bool at_start : {true, false}) {
        // A snapped edge is a little longer or shorter than its piece of the axis.
        const double total = length(edge.line), put = random.between(0.1, total - 0.1);
        const double of_axis =
            edge.start_abscissa + put * (edge.end_abscissa - edge.start_abscissa) / total;
        const Streets town = streets(axes, {}, {{{edge.axis_id, of_axis, at_start}}, {}});
        const SectionLimit &limit = town.limits[2 * e + !at_start],
                           &other = town.limits[2 * e + at_start];
        if (ends_dead(town.network, at_start ? edge.from_node : edge.to_node)) {
          EXPECT_EQ(limit.method, before.limits[2 * e + !at_start].method);
          EXPECT_EQ(limit.abscissa, before.limits[2 * e + !at_start].abscissa);
          continue;
        }
        ++placed;
        EXPECT_EQ(limit.method, Method::by_hand) << "seed " << seed;
        EXPECT_NEAR(limit.abscissa, put, 1e-6);
        EXPECT_NEAR(distance(limit.point, position_at(edge.line, put).point), 0, 1e-6);
        EXPECT_NEAR(
            distance((limit.border_line[0] + limit.border_line[1]) * 0.5, planar(limit.point)), 0,
            1e-6);
        EXPECT_EQ(limits_crossed(town, e), other.method == Method::crossed_limits);
        if (limits_crossed(town, e)) {
          EXPECT_NEAR(other.abscissa, put, 1e-6);
        } else {
          EXPECT_LT(town.limits[2 * e].abscissa, town.limits[2 * e + 1].abscissa);
        }
      }
    }
  }
  EXPECT_GT(placed, rounds(300));
}

TEST(ByHand, TheGroundIsTiledWhateverIsPut) {
  for (int seed = 1; seed <= junctions; ++seed) {
    Random random{std::mt19937_64(seed)};
    const std::vector<StreetAxis> axes = random_junction(random);
    const Streets before = streets(axes, {});
    StreetOverrides overrides;
    overrides.limits = random_limits(random, before);
    for (const Corner& corner : before.corners)
      if (random.below(2) == 0)
        overrides.corners.push_back(
            {before.network.nodes[corner.node].point, before.network.edges[corner.edge_a].axis_id,
             before.network.edges[corner.edge_b].axis_id, random.between(0, 30)});
    const Streets town = streets(axes, {}, overrides);
    expect_tiled(town, "seed " + std::to_string(seed));
    for (std::size_t e = 0; e < town.network.edges.size(); ++e)
      EXPECT_LE(town.limits[2 * e].abscissa, town.limits[2 * e + 1].abscissa + 1e-9);
  }
}

// West, south, east and north of the origin, 100 m long and 8 m wide.
std::vector<StreetAxis> cross() {
  return {{1, {{-100, 0, 0}, {0, 0, 0}}, 0, 8, 8, 5, 3},
          {2, {{0, -100, 0}, {0, 0, 0}}, 0, 8, 8, 5, 3},
          {3, {{0, 0, 0}, {100, 0, 0}}, 0, 8, 8, 5, 3},
          {4, {{0, 0, 0}, {0, 100, 0}}, 0, 8, 8, 5, 3}};
}

bool equal(const MultiPolygon& a, const MultiPolygon& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Polygon& p, const Polygon& q) {
    return std::equal(p.begin(), p.end(), q.begin(), q.end(), [](const Ring& r, const Ring& s) {
      return std::equal(r.begin(), r.end(), s.begin(), s.end(),
                        [](const Point& u, const Point& v) { return u.x == v.x && u.y == v.y; });
    });
  });
}

TEST(ByHand, ALimitMovesGroundFromSectionToIntersection) {
  const Streets before = streets(cross(), {});
  for (const double put : {95.0, 90.0, 40.0}) {
    const Streets town = streets(cross(), {}, {{{1, put, false}}, {}});
    ASSERT_EQ(town.limits[1].abscissa, put);
    EXPECT_NEAR(area(town.sections[0].surface), 8 * put, 1e-6);
    // The corners' limit was at 91; their fillets stay with the intersection.
    EXPECT_NEAR(area(town.intersections[0].surface),
                area(before.intersections[0].surface) + 8 * (91 - put), 1e-6);
    for (const int e : {1, 2, 3}) {
      EXPECT_TRUE(equal(town.sections[e].surface, before.sections[e].surface));
      EXPECT_EQ(town.limits[2 * e].abscissa, before.limits[2 * e].abscissa);
    }
    expect_tiled(town, "put at " + std::to_string(put));
  }
}

TEST(ByHand, LimitsOfAnEdgeMeetWhereTheyWouldPass) {
  // A street of 40 m between two crossings: the corners want its limits at 9 m and 31 m.
  const std::vector<StreetAxis> axes = {{1, {{0, 0, 0}, {40, 0, 0}}, 0, 8, 8, 5, 3},
                                        {2, {{0, -80, 0}, {0, 80, 0}}, 0, 8, 8, 5, 3},
                                        {3, {{40, -80, 0}, {40, 80, 0}}, 0, 8, 8, 5, 3}};
  // The vertices that axes 2 and 3 share with axis 1.
  std::vector<StreetAxis> town = axes;
  for (const int i : {1, 2}) town[i].line.insert(town[i].line.begin() + 1, axes[0].line[i - 1]);
  const auto limits = [&](const std::vector<SectionLimitOverride>& puts) {
    const Streets made = streets(town, {}, {puts, {}});
    expect_tiled(made, "meeting");
    return std::vector<SectionLimit>(made.limits.begin(), made.limits.begin() + 2);
  };
  const auto one = limits({{1, 35, true}});
  EXPECT_EQ(one[0].method, Method::by_hand);
  EXPECT_EQ(one[1].method, Method::crossed_limits);
  EXPECT_EQ(one[0].abscissa, 35);
  EXPECT_NEAR(one[1].abscissa, 35, 1e-12);
  const auto both = limits({{1, 30, true}, {1, 20, false}});
  EXPECT_EQ(both[0].method, Method::crossed_limits);
  EXPECT_EQ(both[1].method, Method::crossed_limits);
  EXPECT_GE(both[0].abscissa, 20);
  EXPECT_LE(both[0].abscissa, 30);
  // Clear of the nodes.
  EXPECT_EQ(limits({{1, 0, true}})[0].abscissa, 0.1);
  EXPECT_NEAR(limits({{1, 40, false}})[1].abscissa, 39.9, 1e-12);
}

TEST(ByHand, OfTwoTheLaterHoldsAndOneWithoutAPlaceChangesNothing) {
  const Streets town = streets(cross(), {}, {{{1, 80, false}, {1, 70, false}}, {}});
  EXPECT_EQ(town.limits[1].abscissa, 70);
  const Streets before = streets(cross(), {});
  const Streets same =
      streets(cross(), {},
              {{{1, 50, true}, {1, 101, false}, {9, 50, false}},
               {{{1, 1, 0}, 1, 4, 3}, {{0, 1.6, 0}, 1, 2, 3}, {{0, 0, 0}, 1, 9, 3}}});
  for (std::size_t i = 0; i < before.limits.size(); ++i)
    EXPECT_EQ(same.limits[i].abscissa, before.limits[i].abscissa);
  for (std::size_t i = 0; i < before.corners.size(); ++i)
    EXPECT_EQ(same.corners[i].radius, before.corners[i].radius);
}

// The line of an edge as it leaves its node.
Line leaving(const Streets& town, int edge, bool at_start) {
  const Line line = planar(town.network.edges[edge].line);
  return at_start ? line : reversed(line);
}

TEST(ByHand, ARadiusIsWhatWasTypedWhereItFits) {
  int typed = 0, reduced = 0;
  for (int seed = 1; seed <= junctions; ++seed) {
    Random random{std::mt19937_64(seed)};
    const std::vector<StreetAxis> axes = random_junction(random);
    const Streets before = streets(axes, {});
    for (std::size_t c = 0; c < before.corners.size(); ++c) {
      const Corner& corner = before.corners[c];
      const Edge &a = before.network.edges[corner.edge_a], &b = before.network.edges[corner.edge_b];
      const double radius = random.below(8) == 0 ? 0 : random.between(0.5, 40);
      const Point node = before.network.nodes[corner.node].point;
      const Streets town = streets(axes, {}, {{}, {{node, a.axis_id, b.axis_id, radius}}});
      const Corner& made = town.corners[c];
      EXPECT_EQ(made.radius_wanted, radius);
      for (std::size_t other = 0; other < before.corners.size(); ++other)
        // The ground that it closes may lie behind the arc of another one.
        if (other != c && town.corners[other].method != before.corners[other].method) {
          EXPECT_TRUE(town.corners[other].method == Method::covered ||
                      before.corners[other].method == Method::covered)
              << "seed " << seed;
        } else if (other != c) {
          EXPECT_EQ(town.corners[other].radius, before.corners[other].radius) << "seed " << seed;
        }
      const auto arc = corner_arc(leaving(before, corner.edge_a, corner.at_start_a),
                                  leaving(before, corner.edge_b, corner.at_start_b),
                                  before.roadways[corner.edge_a].width,
                                  before.roadways[corner.edge_b].width, radius);
      if (made.method == Method::by_hand) {
        ++typed;
        EXPECT_EQ(made.radius, radius);
        EXPECT_EQ(made.arc.has_value(), radius > 0);
      } else if (made.method == Method::radius_reduced) {
        ++reduced;
        EXPECT_GT(made.radius, 0.001);
        EXPECT_LT(made.radius, radius);
        EXPECT_TRUE(!arc || distance(arc->centre, node) > 60) << "seed " << seed;
        // A little more fits no longer.
        const auto more = corner_arc(leaving(before, corner.edge_a, corner.at_start_a),
                                     leaving(before, corner.edge_b, corner.at_start_b),
                                     before.roadways[corner.edge_a].width,
                                     before.roadways[corner.edge_b].width, made.radius + 1e-3);
        EXPECT_TRUE(!more || distance(more->centre, node) > 60 - 1e-2) << "seed " << seed;
      } else {
        EXPECT_TRUE(made.method == Method::no_arc || made.method == Method::followed ||
                    made.method == Method::covered)
            << "seed " << seed << " " << method_name(made.method);
        EXPECT_EQ(made.arc.has_value(), made.method == Method::followed);
      }
    }
  }
  EXPECT_GT(typed, rounds(200));
  EXPECT_GT(reduced, rounds(20));
}

TEST(ByHand, ACentreTooFarGivesTheLargestRadiusThatIsNear) {
  // At a right angle the centre is sqrt(2) (4 + r) from the node.
  StreetSettings settings;
  settings.max_arc_distance = 20;
  const Streets town = streets(cross(), settings, {{}, {{{0, 0, 0}, 3, 4, 50}}});
  for (const Corner& corner : town.corners) {
    const bool meant = town.network.edges[corner.edge_a].axis_id == 3;
    EXPECT_EQ(corner.method, meant ? Method::radius_reduced : Method::hypothesis);
    EXPECT_NEAR(corner.radius, meant ? 20 / std::sqrt(2) - 4 : 5, 1e-6);
  }
}

TEST(ByHand, OfTwoCornersOfThroughStreetsThePlaceTells) {
  const std::vector<StreetAxis> axes = {{1, {{-100, 0, 0}, {0, 0, 0}, {100, 0, 0}}, 0, 8, 8, 5, 3},
                                        {2, {{0, -100, 0}, {0, 0, 0}, {0, 100, 0}}, 0, 8, 8, 5, 3}};
  const auto radius = [&](const Point& place, double x, double y) {
    const Streets town = streets(axes, {}, {{}, {{place, 1, 2, 3}}});
    for (const Corner& corner : town.corners)
      if (corner.centre->x * x > 0 && corner.centre->y * y > 0) return corner.radius;
    return -1.0;
  };
  // From axis 1 to axis 2 counter-clockwise: north-east and south-west.
  EXPECT_EQ(radius({0.4, 0.3, 0}, 1, 1), 3);
  EXPECT_EQ(radius({0.4, 0.3, 0}, -1, -1), 5);
  EXPECT_EQ(radius({-0.4, -0.3, 0}, 1, 1), 5);
  EXPECT_EQ(radius({-0.4, -0.3, 0}, -1, -1), 3);
  for (const double side : {1.0, -1.0}) {
    EXPECT_EQ(radius({0, 0, 0}, side, side), 3);
    EXPECT_EQ(radius({0, 0, 0}, side, -side), 5);
  }
}

// Two lanes on each street.
std::vector<LanesOfAxis> two_lanes() {
  std::vector<LanesOfAxis> lanes;
  for (std::int64_t axis_id = 1; axis_id <= 4; ++axis_id)
    lanes.push_back({axis_id, {{LaneWish{}}, {LaneWish{}}}});
  return lanes;
}

TEST(ByHand, ALaneRunsAlongItsLineAndTrajectoriesMeetIt) {
  const std::vector<StreetAxis> axes = cross();
  const Streets town = streets(axes, {});
  const Lanes before = lanes(town, two_lanes(), {}, {});
  const Line drawn = {{-88, -1, 0}, {-50, -3, 0}, {-12, -1.5, 0}};
  for (const bool turned : {false, true}) {
    // The right lane of axis 1, along it.
    LaneOverride put{1, 50, 2};
    put.line = turned ? reversed(drawn) : drawn;
    const Lanes made = lanes(town, two_lanes(), {put}, {});
    ASSERT_EQ(made.lanes.size(), before.lanes.size());
    for (std::size_t i = 0; i < made.lanes.size(); ++i) {
      const Lane &lane = made.lanes[i], &was = before.lanes[i];
      if (town.network.edges[lane.edge].axis_id != 1 || lane.ordinality != 2) {
        EXPECT_TRUE(equal(lane.surface, was.surface));
        EXPECT_EQ(lane.method, was.method);
        continue;
      }
      EXPECT_EQ(lane.method, Method::by_hand);
      EXPECT_EQ(lane.width, was.width);
      EXPECT_EQ(lane.along_axis, was.along_axis);
      ASSERT_EQ(lane.line.size(), drawn.size());
      for (std::size_t k = 0; k < drawn.size(); ++k) EXPECT_EQ(distance(lane.line[k], drawn[k]), 0);
      EXPECT_NEAR(lane.axis_offset, -1, 1e-9);
      // Two straight bands of 4 m that meet in a slight bend.
      EXPECT_NEAR(area(lane.surface), lane.width * length(drawn), 0.5);
    }
    int met = 0;
    for (const Interconnection& way : interconnections(town, axes, made.lanes, {}, {})) {
      const Lane &in = made.lanes[way.lane_in], &out = made.lanes[way.lane_out];
      EXPECT_EQ(distance(way.line.front(), in.along_axis ? in.line.back() : in.line.front()), 0);
      EXPECT_EQ(distance(way.line.back(), out.along_axis ? out.line.front() : out.line.back()), 0);
      met += in.method == Method::by_hand;
    }
    EXPECT_EQ(met, 3);
  }
}

TEST(ByHand, OfALaneTheLaterHoldsInWhatItSays) {
  const Streets town = streets(cross(), {});
  LaneOverride narrow{1, 50, 2}, turned{1, 20, 2}, wide{1, 70, 2};
  narrow.width = 3;
  turned.direction = LaneOverride::Direction::against;
  wide.width = 5;
  for (const Lane& lane : lanes(town, two_lanes(), {wide, turned, narrow}, {}).lanes)
    if (lane.edge == 0 && lane.ordinality == 2) {
      EXPECT_EQ(lane.width, 3);
      EXPECT_FALSE(lane.along_axis);
    }
}

}  // namespace street_override_test
}  // namespace streetgen
