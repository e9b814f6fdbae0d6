// A change asks for all that it can move, and for nothing that stays.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "geometry/polyline.hpp"
#include "random_town.hpp"
#include "rounds.hpp"
#include "streetgen/streets.hpp"

namespace streetgen {
namespace find_affected_test {

FormerLimit former_of(const SectionLimit& limit) {
  return {limit.wanted_abscissa, limit.abscissa, limit.border_line};
}

Former former_of(const Streets& before) {
  Former former;
  for (const Section& section : before.sections)
    former.edges.push_back(
        {before.network.edges[section.edge].axis_id,
         before.network.edges[section.edge].start_abscissa,
         before.network.edges[section.edge].end_abscissa,
         before.network.edges[section.edge].line,
         former_of(before.limits[2 * section.edge]),
         former_of(before.limits[2 * section.edge + 1]),
         {section.surface, section.contested_area > 0, before.network.edges[section.edge].level},
         section.borders});
  for (const Intersection& intersection : before.intersections)
    former.nodes.push_back(
        {before.network.nodes[intersection.node].point,
         {intersection.surface, intersection.contested_area > 0, intersection.level}});
  return former;
}

// Areas of surfaces, by edge and by node.
struct Areas {
  explicit Areas(const Streets& town)
      : sections(town.network.edges.size()), intersections(town.network.nodes.size()) {
    for (const Section& section : town.sections) sections[section.edge] = area(section.surface);
    for (const Intersection& crossing : town.intersections)
      intersections[crossing.node] = area(crossing.surface);
  }
  std::vector<double> sections, intersections;
};

// Surfaces about one axis, built from what may matter to them, against those of the whole town.
TEST(Streets, ComeOutTheSameFromTheirVicinityAlone) {
  for (int seed = 1; seed <= rounds(3); ++seed) {
    std::vector<StreetAxis> axes = random_town(seed, 24);
    const Streets whole = streets(axes, {});
    const Areas areas(whole);
    std::size_t compared = 0;
    for (std::int64_t edited = 1; edited <= 6; ++edited) {
      for (StreetAxis& axis : axes) axis.changed = axis.axis_id == edited;
      const Streets part = streets(axes, {}, {}, former_of(whole));
      for (const Section& section : part.sections) {
        EXPECT_EQ(area(section.surface), areas.sections[section.edge])
            << "seed " << seed << ", axis " << edited << ", edge " << section.edge;
        ++compared;
      }
      for (const Intersection& intersection : part.intersections) {
        EXPECT_EQ(area(intersection.surface), areas.intersections[intersection.node])
            << "seed " << seed << ", axis " << edited << ", node " << intersection.node;
        ++compared;
      }
    }
    EXPECT_GE(compared, 12u);
  }
}

// A wider axis takes ground: what is asked comes out as in the whole town, and nothing else is
// another there.
TEST(Streets, AWiderAxisAsksForAllThatItChanges) {
  std::size_t asked = 0, left = 0;
  StreetSettings settings;
  settings.crossing = Crossing::split;
  for (int seed = 1; seed <= rounds(3); ++seed) {
    std::vector<StreetAxis> axes = random_town(seed, 40);
    for (StreetAxis& axis : axes) axis.width = axis.width_end = axis.width / 3;
    const Streets before = streets(axes, settings);
    const Areas was(before);
    for (std::int64_t edited = 1; edited <= rounds(12); ++edited) {
      std::vector<StreetAxis> wider = axes;
      for (StreetAxis& axis : wider) {
        axis.changed = axis.axis_id == edited;
        if (axis.changed) axis.width = axis.width_end = 1.1 * axis.width;
      }
      const Areas is(streets(wider, settings));
      const Streets part = streets(wider, settings, {}, former_of(before));
      const Areas told(part);
      const auto compare = [&](const std::vector<bool>& out, const std::vector<double>& of_part,
                               const std::vector<double>& old, const std::vector<double>& now,
                               const char* what) {
        for (std::size_t i = 0; i < out.size(); ++i) {
          EXPECT_EQ(out[i] ? of_part[i] : old[i], now[i])
              << what << ' ' << i << (out[i] ? ", asked" : "") << ", seed " << seed << ", axis "
              << edited;
          ++(out[i] ? asked : left);
        }
      };
      compare(part.affected_edges, told.sections, was.sections, is.sections, "edge");
      compare(part.affected_nodes, told.intersections, was.intersections, is.intersections, "node");
    }
  }
  EXPECT_GT(asked, 500u * rounds(3) * rounds(12) / 36);
  EXPECT_GT(left, asked);
}

// The wide street lay on the ground about a node of two others, and goes.
TEST(Streets, AnIntersectionThatLostGroundGetsItBack) {
  std::vector<StreetAxis> axes = {
      {8, {{122, 100, 0}, {190, 102, 0}}, 0, 5.5, 5.5, 4, 5},
      {14, {{190, 102, 0}, {191, 150, 0}}, 0, 5, 5, 4, 6},
      {15, {{147.71, 110.08, 0}, {196.63, 101.82, 0}}, 0, 15.68, 15.68, 4, 3}};
  const auto at_bend = [](const Streets& town) -> const Intersection& {
    return *std::find_if(
        town.intersections.begin(), town.intersections.end(),
        [&](const Intersection& i) { return town.network.nodes[i.node].point.x == 190; });
  };
  const Streets before = streets(axes, {});
  EXPECT_GT(at_bend(before).contested_area, 5);
  axes[2].line = {{147.71, 110.08, 0}, {248.08, 151.78, 0}};
  axes[0].changed = axes[1].changed = false;
  EXPECT_NEAR(area(at_bend(streets(axes, {}, {}, former_of(before))).surface),
              area(at_bend(before).surface) + at_bend(before).contested_area, 1e-6);
}

// Two streets leave a hole between them, which goes to one of them until a street of another level
// that ends on a third one covers it.
TEST(Streets, AHoleThatIsCoveredGoesBack) {
  std::vector<StreetAxis> axes = {
      {237,
       {{55.7933130867, 88.698831765, 0},
        {62.5851039334, 90.413623994, 0},
        {70.2127205366, 97.681852341, 0}},
       0,
       6,
       6,
       3,
       5},
      {427,
       {{66.3257846195, 102.493926154, 0},
        {63.5836806569, 99.880003191, 0},
        {59.1934797047, 95.711095422, 0},
        {55.7933130867, 88.698831765, 0}},
       0,
       6,
       6,
       3,
       5},
      {442,
       {{70.2127205366, 97.681852341, 0}, {66.3257846195, 102.493926154, 0}},
       0,
       9,
       9,
       6.25,
       2}};
  StreetSettings settings;
  settings.island_area_minimal = 0;
  const Streets before = streets(axes, settings);
  for (StreetAxis& axis : axes) axis.changed = false;
  axes.push_back({543,
                  {{60.8727205367, 93.851852341, 0},
                   {108.3257846195, 133.723926155, 0},
                   {66.2157846196, 102.273926155, 0}},
                  1,
                  14.6,
                  14.6,
                  3,
                  4});
  const Areas was(before), told(streets(axes, settings, {}, former_of(before))),
      is(streets(axes, settings));
  EXPECT_NE(was.sections[1], is.sections[1]);
  EXPECT_EQ(told.sections[1], is.sections[1]);
}

// A limit by hand leaves a street no section: another gets ground back that this kept from it,
// though what it was left lies more than two metres off.
TEST(Streets, GroundComesBackToASurfaceThatWasLeftNoneBesideIt) {
  std::vector<StreetAxis> axes = {
      {4, {{-4.6519, 33.832, 0}, {54.5541, 41.4442, 0}}, -1, 5.96, 5.96, 6.25, 2},
      {5, {{-4.6519, 33.832, 0}, {33.4091, 94.3067, 0}}, 0, 10.48, 10.48, 6.25, 2},
      {7, {{54.5541, 41.4442, 0}, {33.4091, 94.3067, 0}}, 0, 19.19, 19.19, 3, 5},
      {8, {{-4.6519, 33.832, 0}, {73.5846, 90.5006, 0}}, 0, 6, 6, 14.53, 5},
      {9,
       {{50.748, 1.2687, 0}, {49.02685, 84.11365, 0}, {73.5846, 90.5006, 0}},
       0,
       10.68,
       10.68,
       3,
       5}};
  StreetOverrides by_hand;
  by_hand.limits.push_back({7, 51.37, true});
  const Streets before = streets(axes, {});
  const Areas was(before), is(streets(axes, {}, by_hand));
  for (StreetAxis& axis : axes) axis.changed = axis.axis_id == 7;
  const Areas told(streets(axes, {}, by_hand, former_of(before)));
  EXPECT_GT(is.sections[3], was.sections[3] + 30);
  EXPECT_EQ(told.sections[3], is.sections[3]);
}

// An axis that is said to have changed, and did not: of its neighbours, whose surfaces stay what
// they were, none comes out.
TEST(Streets, LeaveOutWhatStaysWhatItWas) {
  std::size_t out = 0, met = 0;
  for (int seed = 1; seed <= rounds(3); ++seed) {
    std::vector<StreetAxis> axes = random_town(seed, 40);
    const Streets whole = streets(axes, {});
    const auto& edges = whole.network.edges;
    for (std::int64_t edited = 1; edited <= 10; ++edited) {
      for (StreetAxis& axis : axes) axis.changed = axis.axis_id == edited;
      const Streets part = streets(axes, {}, {}, former_of(whole));
      std::vector<bool> at(whole.network.nodes.size());
      for (const Edge& edge : edges)
        if (edge.axis_id == edited) at[edge.from_node] = at[edge.to_node] = true;
      for (std::size_t e = 0; e < edges.size(); ++e) {
        EXPECT_EQ(part.affected_edges[e], edges[e].axis_id == edited)
            << "seed " << seed << ", axis " << edited << ", edge " << e;
        out += part.affected_edges[e];
        met += at[edges[e].from_node] || at[edges[e].to_node];
      }
    }
  }
  EXPECT_GT(met, out);
}

// Streets cross on two levels at one place: an edit at the far end of one on either level leaves
// the kerbs where they part from both crossings.
TEST(Streets, LeaveEachOfTwoCrossingsAtOnePlaceItsGround) {
  std::vector<StreetAxis> axes = {{1, {{-80, 0, 0}, {0, 0, 0}, {80, 0, 0}}, 0, 8, 8, 4, 5},
                                  {2, {{0, -80, 0}, {0, 0, 0}, {0, 80, 0}}, 0, 8, 8, 4, 5},
                                  {3, {{-80, -80, 0}, {0, 0, 0}, {80, 80, 0}}, -1, 6, 6, 4, 5},
                                  {4, {{80, -80, 0}, {0, 0, 0}, {-80, 80, 0}}, -1, 6, 6, 4, 5},
                                  {5, {{80, 0, 0}, {300, 20, 0}}, 0, 8, 8, 4, 5},
                                  {6, {{80, 80, 0}, {300, 80, 0}}, -1, 6, 6, 4, 5}};
  const Streets whole = streets(axes, {}, {}, {}, true);
  std::set<int> levels;
  for (const Intersection& crossing : whole.intersections)
    if (distance(whole.network.nodes[crossing.node].point, {0, 0}) == 0)
      levels.insert(crossing.level);
  EXPECT_EQ(levels, (std::set<int>{-1, 0}));
  for (const std::int64_t edited : {5, 6}) {
    for (StreetAxis& axis : axes) axis.changed = axis.axis_id == edited;
    const Streets part = streets(axes, {}, {}, former_of(whole), true);
    std::size_t beside = 0;
    for (const Kerb& kerb : part.kerbs) {
      const auto same_kerb = [&](const Kerb& other) {
        return other.edge == kerb.edge && other.node == kerb.node && other.side == kerb.side &&
               other.part == kerb.part && same(other.line, kerb.line);
      };
      EXPECT_TRUE(std::any_of(whole.kerbs.begin(), whole.kerbs.end(), same_kerb))
          << "axis " << edited << ", edge " << kerb.edge << ", node " << kerb.node;
      beside += part.network.edges[kerb.edge].axis_id != edited;
    }
    EXPECT_GE(beside, 2u);
  }
}

// The end of a street moves, and with it the next one, which ends where one meets it that is not
// written.
TEST(Streets, TellAlongWhichAxesAChangeLeadsOn) {
  std::vector<StreetAxis> axes = {{7, {{0, 0, 0}, {100, 0, 0}}, 0, 6, 6, 4, 5},
                                  {8, {{100, 0, 0}, {200, 0, 0}}, 0, 6, 6, 4, 5},
                                  {9, {{200, 0, 0}, {300, 50, 0}}, 0, 6, 6, 4, 5}};
  Former former = former_of(streets(axes, {}));
  former.edges.pop_back();
  axes[0].line.back().y = 0.3;
  axes[1].changed = axes[2].changed = false;
  axes[2].outer = true;
  EXPECT_EQ(streets(axes, {}, {}, former).spreads_to, (std::vector<bool>{false, true, false}));
  former.may_spread = false;
  try {
    streets(axes, {}, {}, former);
    FAIL();
  } catch (const ChangeSpreads& spreads) {
    EXPECT_EQ(spreads.axes(), std::vector<std::int64_t>{8});
  }
}

}  // namespace find_affected_test
}  // namespace streetgen
