#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/polyline.hpp"
#include "geometry/prepared_surface.hpp"
#include "streetgen/lane.hpp"
#include "surfaces.hpp"
#include "truths.hpp"

namespace streetgen::fuzz {

namespace {

std::vector<LaneWish> random_wishes(Random& random) {
  std::vector<LaneWish> wishes(random.below(6));
  for (LaneWish& wish : wishes) {
    wish.kind = random.of(std::vector<LaneKind>{LaneKind::general, LaneKind::general, LaneKind::bus,
                                                LaneKind::cycle, LaneKind::parking});
    wish.width = random.one_in(3) ? random.scaled(0.1, 20) : 0;
    wish.yields = wish.width > 0 && random.one_in(3);
    wish.turns = random.one_in(3) ? random.below(1024) : 0;
  }
  return wishes;
}

struct LanesAsked {
  std::vector<LanesOfAxis> axes;
  std::vector<LaneOverride> overrides;
  LaneSettings settings;
};

LanesAsked random_lanes(Random& random, const Town& town) {
  using Direction = LaneOverride::Direction;
  LanesAsked asked;
  for (const StreetAxis& axis : town.axes) {
    if (!random.one_in(10))
      asked.axes.push_back({axis.axis_id,
                            {random_wishes(random), random_wishes(random),
                             random.one_in(3) ? random_wishes(random) : std::vector<LaneWish>{}}});
    if (random.one_in(3))
      asked.overrides.push_back(
          {axis.axis_id, random.between(0, 50), 1 + random.below(5),
           random.of(std::vector<Direction>{Direction::as_is, Direction::along, Direction::against,
                                            Direction::both}),
           random.one_in(2) ? random.scaled(0.1, 20) : 0});
  }
  if (random.one_in(3)) asked.settings.order = LaneOrder::right_first;
  if (random.one_in(3)) asked.settings.driving_side = DrivingSide::left;
  asked.settings.edge_lines = random.one_in(3);
  return asked;
}

bool finite(const Line& line) {
  return line.size() >= 2 && std::all_of(line.begin(), line.end(), [](const Point& p) {
           return std::isfinite(p.x) && std::isfinite(p.y);
         });
}

std::string of_edge(int edge) { return " of edge " + std::to_string(edge); }

void find_unsound(const Lanes& lanes, Faults& faults) {
  for (const Lane& lane : lanes.lanes) {
    if (!finite(lane.line)) faults.push_back("a lane is not finite" + of_edge(lane.edge));
    if (!sound(lane.surface)) faults.push_back("a lane is not valid" + of_edge(lane.edge));
    if (!(lane.width > 0)) faults.push_back("a lane has no width" + of_edge(lane.edge));
  }
  for (const LaneSeparator& separator : lanes.separators)
    if (!finite(separator.line) || !sound(paint_of(separator)))
      faults.push_back("a separator is not sound" + of_edge(separator.edge));
  for (const Marking& marking : lanes.markings)
    if (!finite(marking.line) || marking.surface.empty() || !sound(marking.surface))
      faults.push_back("a marking is not sound" + of_edge(marking.edge));
}

// The width that the axis gives its roadway at the start limit, without a taper.
double width_at_start(const Streets& town, int e) {
  const Roadway& roadway = town.roadways[e];
  const double total = length(planar(town.network.edges[e].line));
  return roadway.width + (roadway.width_end - roadway.width) * town.limits[2 * e].abscissa / total;
}

// Axes on which the widths of all lanes may be stated, which then need not fill the roadway.
std::set<std::int64_t> stated_axes(const LanesAsked& asked) {
  const auto stated = [](const std::vector<LaneWish>& wishes) {
    return std::all_of(wishes.begin(), wishes.end(),
                       [](const LaneWish& wish) { return wish.width > 0; });
  };
  std::set<std::int64_t> axes;
  for (const LanesOfAxis& axis : asked.axes)
    if (stated(axis.lanes.forward) && stated(axis.lanes.backward) && stated(axis.lanes.both_ways))
      axes.insert(axis.axis_id);
  for (const LaneOverride& by_hand : asked.overrides)
    if (by_hand.width > 0) axes.insert(by_hand.axis_id);
  return axes;
}

// Numbers, widths and places of the lanes of each edge.
void find_misplaced(const Streets& town, const LanesAsked& asked, const Lanes& lanes,
                    Faults& faults) {
  const std::set<std::int64_t> stated = stated_axes(asked);
  auto lane = lanes.lanes.begin();
  for (int e = 0; e < static_cast<int>(town.network.edges.size()); ++e) {
    std::vector<int> ordinalities;
    double sum = 0;
    const double roadway = width_at_start(town, e);
    const bool crossed = town.limits[2 * e].method == Method::crossed_limits;
    for (int position = 1; lane != lanes.lanes.end() && lane->edge == e; ++lane, ++position) {
      if (lane->position != position) faults.push_back("positions are not in order" + of_edge(e));
      ordinalities.push_back(lane->ordinality);
      sum += lane->width;
    }
    std::sort(ordinalities.begin(), ordinalities.end());
    for (std::size_t i = 0; i < ordinalities.size(); ++i)
      if (ordinalities[i] != static_cast<int>(i) + 1)
        faults.push_back("ordinalities are not 1 to n" + of_edge(e));
    if (ordinalities.empty()) faults.push_back("no lane" + of_edge(e));
    const bool short_of = stated.count(town.network.edges[e].axis_id) > 0 && sum < roadway;
    if (!crossed && !short_of && std::abs(sum - roadway) > 1e-5)
      faults.push_back("widths sum to " + std::to_string(sum) + " on " + std::to_string(roadway) +
                       " m" + of_edge(e));
  }
}

// Centre lines in their sections but for half a percent of their length, where nothing was taken.
void find_astray(const Streets& town, const Lanes& lanes, Faults& faults) {
  constexpr int steps = 32;
  constexpr double rim = 0.1;  // metres
  double whole = 0, astray = 0, farthest = 0;
  int worst = 0;
  for (const Lane& lane : lanes.lanes) {
    const Section& section = town.sections[lane.edge];
    if (section.contested_area > 0 || section.surface.empty()) continue;
    const double total = length(lane.line);
    whole += total;
    for (int i = 0; i < steps; ++i) {
      const Point p = position_at(lane.line, total * (i + 0.5) / steps).point;
      double off = 1e300;
      for (const Polygon& part : section.surface) {
        if (inside(p, part)) off = 0;
        for (const Ring& ring : part) off = std::min(off, distance_to_line(p, ring));
      }
      if (off <= rim) continue;
      astray += total / steps;
      if (off > farthest) farthest = off, worst = lane.edge;
    }
  }
  if (astray > 5e-3 * whole)
    faults.push_back(std::to_string(astray) + " m of " + std::to_string(whole) +
                     " m of lanes leave their sections, by " + std::to_string(farthest) + " m" +
                     of_edge(worst));
}

bool same(const Lanes& a, const Lanes& b) {
  const auto same_line = [](const Line& a, const Line& b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](auto& p, auto& q) {
             return p.x == q.x && p.y == q.y;
           });
  };
  return a.lanes.size() == b.lanes.size() && a.markings.size() == b.markings.size() &&
         a.separators.size() == b.separators.size() &&
         std::equal(a.lanes.begin(), a.lanes.end(), b.lanes.begin(),
                    [&](const Lane& p, const Lane& q) {
                      return p.edge == q.edge && p.ordinality == q.ordinality &&
                             p.along_axis == q.along_axis && p.width == q.width &&
                             same_line(p.line, q.line);
                    });
}

}  // namespace

Faults lane_faults(const Made& made) {
  Random random(made.seed);
  LanesAsked asked = random_lanes(random, made.town);
  const Lanes first = lanes(made.streets, asked.axes, asked.overrides, asked.settings);
  Faults faults;
  find_unsound(first, faults);
  find_misplaced(made.streets, asked, first, faults);
  if (!faults.empty()) return faults;
  find_astray(made.streets, first, faults);
  std::mt19937_64 shuffled(made.seed);
  std::shuffle(asked.axes.begin(), asked.axes.end(), shuffled);
  std::shuffle(asked.overrides.begin(), asked.overrides.end(), shuffled);
  if (!same(first, lanes(made.streets, asked.axes, asked.overrides, asked.settings)))
    faults.push_back("not the same with the wishes in another order");
  return faults;
}

}  // namespace streetgen::fuzz
