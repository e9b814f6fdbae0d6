#include "streetgen/profile.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>

#include "geometry/polyline.hpp"
#include "height/height_line.hpp"
#include "height/least_height.hpp"
#include "rounds.hpp"

namespace streetgen {
namespace profile_test {

constexpr double clearance = 6, grade = 0.06;

ProfileEdge edge(int from, int to, Line line, double radius = 0) {
  return {from, to, std::move(line), grade, radius};
}

double z(const Profile& profile, double at) { return height_at(heights_of(profile.line), at); }

double steepest(const Line& line) {
  const HeightLine heights = heights_of(line);
  double most = 0;
  for (std::size_t i = 1; i < heights.size(); ++i)
    most = std::max(
        most, std::abs(heights[i].z - heights[i - 1].z) / (heights[i].at - heights[i - 1].at));
  return most;
}

// A straight road of 600 m that passes over the middle of another one.
std::vector<ProfileEdge> crossing_roads(double radius = 0) {
  return {edge(0, 1, {{0, 0}, {600, 0}}, radius), edge(2, 3, {{300, -300}, {300, 300}}, radius)};
}

TEST(Profile, LiftsARoadByTheClearanceAndNoFartherThanItsGradeNeeds) {
  const Profiles all = profiles(crossing_roads(), {{0, 300, 1, 300, clearance}}, {});
  EXPECT_NEAR(z(all.edges[0], 300), 6, 1e-9);
  EXPECT_NEAR(z(all.edges[0], 250), 3, 1e-9);
  EXPECT_NEAR(z(all.edges[0], 200), 0, 1e-9);
  EXPECT_NEAR(z(all.edges[0], 100), 0, 1e-9);
  EXPECT_EQ(all.edges[0].method, ProfileMethod::lifted);
  EXPECT_EQ(all.edges[1].method, ProfileMethod::ground);
  EXPECT_FALSE(all.unmet[0]);
}

TEST(Profile, SinksARoadBelowTheGround) {
  const Profiles all = profiles(crossing_roads(), {{0, 300, 1, 300, clearance, true}}, {});
  EXPECT_EQ(all.edges[0].method, ProfileMethod::ground);
  EXPECT_EQ(all.edges[1].method, ProfileMethod::sunk);
  EXPECT_NEAR(z(all.edges[1], 300), -6, 1e-9);
  EXPECT_NEAR(z(all.edges[1], 350), -3, 1e-9);
}

TEST(Profile, KeepsARoadThatHoldsAllByItself) {
  std::vector<ProfileEdge> roads = crossing_roads(400);
  roads[0].line = {{0, 0, 10}, {300, 0, 14}, {600, 0, 10}};
  const Profiles all = profiles(roads, {{0, 300, 1, 300, clearance}}, {});
  EXPECT_EQ(all.edges[0].method, ProfileMethod::ground);
  EXPECT_EQ(all.edges[0].line.size(), 3u);
}

TEST(Profile, GoesOnFromRoadToRoad) {
  const Profiles all = profiles({edge(0, 1, {{0, 0}, {40, 0}}), edge(1, 2, {{40, 0}, {200, 0}}),
                                 edge(3, 4, {{20, -50}, {20, 50}})},
                                {{0, 20, 2, 50, clearance}}, {});
  EXPECT_NEAR(z(all.edges[0], 40), 6 - 20 * grade, 1e-9);
  EXPECT_NEAR(z(all.edges[1], 0), z(all.edges[0], 40), 1e-12);
  EXPECT_NEAR(z(all.edges[1], 160), 0, 1e-9);
}

TEST(Profile, KeepsTheClearanceUnderAnArc) {
  for (const bool sinks : {false, true}) {
    const Profiles all = profiles(crossing_roads(386), {{0, 300, 1, 300, clearance, sinks}}, {});
    EXPECT_GE(z(all.edges[0], 300), z(all.edges[1], 300) + clearance - 1e-6);
    EXPECT_NEAR(z(all.edges[0], 300), z(all.edges[1], 300) + clearance, 1e-6)
        << "no road lies higher than its arc needs";
    const Line& bent = all.edges[sinks ? 1 : 0].line;
    const HeightLine heights = heights_of(bent);
    for (std::size_t i = 2; i < heights.size(); ++i) {
      const double before =
          (heights[i - 1].z - heights[i - 2].z) / (heights[i - 1].at - heights[i - 2].at);
      const double after = (heights[i].z - heights[i - 1].z) / (heights[i].at - heights[i - 1].at);
      EXPECT_LT(std::abs(after - before), 0.02) << "a kink at " << heights[i - 1].at;
    }
    EXPECT_LE(steepest(bent), grade + 1e-9);
  }
}

TEST(Profile, LiesAtLeastAsHighAsByHand) {
  const Profiles all = profiles({edge(0, 1, {{0, 0}, {600, 0}})}, {}, {{0, 300, 3}, {0, 100, -5}});
  EXPECT_NEAR(z(all.edges[0], 300), 3, 1e-9);
  EXPECT_NEAR(z(all.edges[0], 100), 0, 1e-9) << "under the ground it is the ground";
}

// Two roads that pass over each other in turn hold from 2 c / g on: 200 m for 6 m at 6 %.
TEST(Profile, TellsARoadThatCannotBeLifted) {
  for (const auto& [apart, holds] : {std::pair(101.0, true), std::pair(99.0, false)}) {
    const std::vector<ProfileEdge> roads{edge(0, 1, {{0, 0}, {600, 0}}),
                                         edge(2, 3, {{0, 5}, {600, 5}})};
    const Profiles all = profiles(
        roads, {{0, 200, 1, 200, clearance}, {1, 200 + apart, 0, 200 + apart, clearance}}, {});
    EXPECT_EQ(all.unmet[0] || all.unmet[1], !holds) << apart;
    for (const Profile& profile : all.edges)
      for (const Point& point : profile.line) EXPECT_TRUE(std::isfinite(point.z));
  }
}

ProfileEdge bridge(int from, int to, Line line, double rise, bool ends_from = true,
                   bool ends_to = true) {
  ProfileEdge made = edge(from, to, std::move(line), 386);
  made.rise = rise, made.ends_from = ends_from, made.ends_to = ends_to;
  return made;
}

TEST(Profile, LiftsABridgeOffTheGroundAndSinksATunnel) {
  for (const double rise : {0.5, -0.5}) {
    const Profiles all =
        profiles({edge(0, 1, {{0, 0}, {200, 0}}, 386), bridge(1, 2, {{200, 0}, {300, 0}}, rise),
                  edge(2, 3, {{300, 0}, {500, 0}}, 386)},
                 {}, {});
    const double side = rise > 0 ? 1 : -1;
    for (int at = 10; at <= 90; ++at) EXPECT_GE(side * z(all.edges[1], at), 0.5 - 1e-6) << at;
    EXPECT_NEAR(z(all.edges[1], 10), rise, 1e-6) << "no higher than its arc needs";
    EXPECT_NEAR(z(all.edges[0], 0), 0, 1e-9);
    EXPECT_EQ(z(all.edges[0], 200), z(all.edges[1], 0));
    for (const Profile& road : all.edges) EXPECT_LE(steepest(road.line), grade + 1e-9);
    EXPECT_EQ(all.edges[1].method, rise > 0 ? ProfileMethod::lifted : ProfileMethod::sunk);
  }
}

TEST(Profile, LeavesAShortBridgeLevelThatCrossesNoRoad) {
  const std::vector<ProfileEdge> roads{bridge(1, 2, {{0, 0}, {25, 0}}, 0.5),
                                       edge(3, 4, {{12, -200}, {12, 200}})};
  const ProfileRules rules{30, 0};
  EXPECT_EQ(profiles(roads, {}, {}, rules).edges[0].method, ProfileMethod::ground);
  EXPECT_GE(z(profiles(roads, {{0, 12, 1, 200, clearance}}, {}, rules).edges[0], 12), clearance);
}

// Of three pieces over a valley, whose nodes have the height of its floor.
TEST(Profile, LeadsABridgeEvenlyOverAValley) {
  const Profiles all = profiles({bridge(0, 1, {{0, 0, 10}, {50, 0, -20}}, 0.5, true, false),
                                 bridge(1, 2, {{50, 0, -20}, {150, 0, -30}}, 0.5, false, false),
                                 bridge(2, 3, {{150, 0, -30}, {200, 0, 14}}, 0.5, false, true)},
                                {}, {});
  EXPECT_NEAR(z(all.edges[0], 25), 10.5, 1e-9);
  EXPECT_NEAR(z(all.edges[1], 50), 12, 1e-9);
  EXPECT_NEAR(z(all.edges[2], 0), 13, 1e-9);
  for (const Profile& road : all.edges) EXPECT_EQ(road.method, ProfileMethod::lifted);
  EXPECT_TRUE(all.edges[0].tied_to && all.edges[1].tied_from && all.edges[1].tied_to);
  EXPECT_FALSE(all.edges[0].tied_from);
}

TEST(Profile, TakesTheGreatestGradeOnlyInACircle) {
  std::vector<ProfileEdge> roads{edge(0, 1, {{0, 0}, {600, 0}}), edge(2, 3, {{0, 5}, {600, 5}})};
  for (ProfileEdge& road : roads) road.grade = 0.03, road.grade_greatest = 0.06;
  const Profiles one = profiles(roads, {{0, 300, 1, 300, clearance}}, {});
  EXPECT_NEAR(steepest(one.edges[0].line), 0.03, 1e-9);
  const Profiles turn =
      profiles(roads, {{0, 200, 1, 200, clearance}, {1, 301, 0, 301, clearance}}, {});
  EXPECT_FALSE(turn.unmet[0] || turn.unmet[1]);
  EXPECT_EQ(turn.edges[0].grade, 0.06);
}

TEST(Profile, StaysUpBetweenCrossingsThatAreNear) {
  const ProfileRules rules{0, 1};
  const Line low{{0, -500}, {0, 500}};
  for (const auto& [apart, stays] : {std::pair(90.0, true), std::pair(140.0, false)}) {
    const std::vector<ProfileLift> lifts{{0, 400, 1, 500, clearance},
                                         {0, 400 + apart, 2, 500, clearance}};
    const Profiles all = profiles(
        {edge(0, 1, {{0, 0}, {900, 0}}), edge(2, 3, low), edge(4, 5, low)}, lifts, {}, rules);
    const double middle = z(all.edges[0], 400 + apart / 2);
    EXPECT_NEAR(middle, stays ? clearance : clearance - grade * apart / 2, 0.01);
    // A node between them, from which a side street leads away, changes nothing.
    std::vector<ProfileLift> cut = lifts;
    cut[1] = {3, 400 + apart - 420, 2, 500, clearance};
    const Profiles parted =
        profiles({edge(0, 6, {{0, 0}, {420, 0}}), edge(2, 3, low), edge(4, 5, low),
                  edge(6, 1, {{420, 0}, {900, 0}}), edge(6, 7, {{420, 0}, {420, 300}})},
                 cut, {}, rules);
    EXPECT_NEAR(z(parted.edges[3], 400 + apart / 2 - 420), middle, 0.01);
  }
}

// Roads on flat ground that cross at random: not all clearances can be kept.
struct Net {
  std::vector<ProfileEdge> edges;
  std::vector<ProfileLift> lifts;
};

struct NetSize {
  int nodes, edges, lifts;
  unsigned shortest, range;  // metres
};

// A bridge ends where it meets what is none.
void end_bridges(Net* net) {
  const auto ends = [&](std::int64_t node, double rise) {
    return std::any_of(net->edges.begin(), net->edges.end(), [&](const ProfileEdge& other) {
      return (other.from_node == node || other.to_node == node) && other.rise != rise;
    });
  };
  for (ProfileEdge& edge : net->edges) {
    edge.ends_from = ends(edge.from_node, edge.rise);
    edge.ends_to = ends(edge.to_node, edge.rise);
  }
}

Net random_net(std::mt19937_64* random, bool sinks, NetSize size = {8, 10, 4, 10, 300}) {
  Net net;
  const int nodes = size.nodes, count = size.edges;
  for (int e = 0; e < count; ++e) {
    const double length = size.shortest + static_cast<double>((*random)() % size.range);
    const int from = static_cast<int>((*random)() % nodes),
              to = static_cast<int>((*random)() % nodes);
    net.edges.push_back(edge(from, to, {{0, 0}, {length, 0}}, 400));
    net.edges.back().grade_greatest = 0.1;
    if (sinks && (*random)() % 6 == 0) net.edges.back().rise = (*random)() % 2 == 0 ? 0.5 : -0.5;
  }
  end_bridges(&net);
  const auto place = [&](int e) {
    return net.edges[e].line.back().x * static_cast<double>((*random)() % 100) / 100;
  };
  for (int l = 0; l < size.lifts; ++l) {
    const int above = static_cast<int>((*random)() % count), below = (above + 1 + l % 2) % count;
    const double at_above = place(above), at_below = place(below);
    net.lifts.push_back(
        {above, at_above, below, at_below, clearance, sinks && (*random)() % 2 == 0});
  }
  return net;
}

Net together(Net net, const Net& other) {
  const int edges = static_cast<int>(net.edges.size());
  for (ProfileEdge edge : other.edges) {
    edge.from_node += 1000, edge.to_node += 1000;
    net.edges.push_back(edge);
  }
  for (ProfileLift lift : other.lifts) {
    lift.above += edges, lift.below += edges;
    net.lifts.push_back(lift);
  }
  return net;
}

TEST(Profile, IsThatOfEachNetAlone) {
  std::mt19937_64 random(42);
  int unmet = 0;
  for (int round = 0; round < rounds(300); ++round) {
    const Net lifted = random_net(&random, false), sunk = random_net(&random, true);
    const Net both = together(lifted, sunk);
    const Profiles all = profiles(both.edges, both.lifts, {});
    const Profiles first = profiles(lifted.edges, lifted.lifts, {}),
                   second = profiles(sunk.edges, sunk.lifts, {});
    unmet += static_cast<int>(std::count(first.unmet.begin(), first.unmet.end(), true));
    for (std::size_t e = 0; e < all.edges.size(); ++e) {
      const std::size_t other = e - first.edges.size();
      const Line& alone = e < first.edges.size() ? first.edges[e].line : second.edges[other].line;
      const Line& road = all.edges[e].line;
      ASSERT_EQ(road.size(), alone.size()) << "round " << round << " edge " << e;
      for (std::size_t i = 0; i < road.size(); ++i)
        ASSERT_EQ(road[i].z, alone[i].z) << "round " << round << " edge " << e;
    }
  }
  EXPECT_GT(unmet, rounds(100));
}

bool is_same(const Profile& a, const Profile& b) {
  return a.tied_from == b.tied_from && a.tied_to == b.tied_to &&
         std::equal(a.line.begin(), a.line.end(), b.line.begin(), b.line.end(),
                    [](const Point& p, const Point& q) { return p.x == q.x && p.z == q.z; });
}

// Some edges of a net, with the lifts among them; `place` is where each edge went.
Net part_of(const Net& net, const std::vector<bool>& chosen, std::vector<int>* place) {
  Net part;
  place->assign(net.edges.size(), -1);
  for (std::size_t e = 0; e < net.edges.size(); ++e)
    if (chosen[e]) {
      (*place)[e] = static_cast<int>(part.edges.size());
      part.edges.push_back(net.edges[e]);
    }
  for (ProfileLift lift : net.lifts) {
    lift.above = (*place)[lift.above], lift.below = (*place)[lift.below];
    if (lift.above >= 0 && lift.below >= 0) part.lifts.push_back(lift);
  }
  return part;
}

// An edge of a net is drawn anew, with other lifts: then what no lift and no tied node joins to it,
// before or after, stays as it was, and the others are as they are among all.
TEST(Profile, IsThatOfTheEdgesThatLiftsAndTiesJoin) {
  std::mt19937_64 random(43);
  const NetSize size{18, 18, 5, 30, 150};
  const int tries = rounds(1000);
  int unmet = 0, kept = 0, hidden = 0;
  for (int round = 0; round < tries; ++round) {
    const Net before = random_net(&random, true, size), other = random_net(&random, true, size);
    const int edges = static_cast<int>(before.edges.size());
    const int changed = static_cast<int>(random() % static_cast<std::size_t>(edges));
    Net after{before.edges, {}};
    after.edges[changed] = other.edges[changed];
    end_bridges(&after);
    const auto touches = [&](const ProfileLift& l) {
      return l.above == changed || l.below == changed;
    };
    for (const ProfileLift& lift : before.lifts)
      if (!touches(lift)) after.lifts.push_back(lift);
    for (const ProfileLift& lift : other.lifts)
      if (touches(lift)) after.lifts.push_back(lift);
    const ProfileRules rules{60, 1};
    const Profiles were = profiles(before.edges, before.lifts, {}, rules),
                   all = profiles(after.edges, after.lifts, {}, rules);
    unmet += static_cast<int>(std::count(all.unmet.begin(), all.unmet.end(), true));

    std::vector<bool> region(edges);
    region[changed] = true;
    for (int e = 0; e < edges; ++e)
      if (before.edges[e].ends_from != after.edges[e].ends_from ||
          before.edges[e].ends_to != after.edges[e].ends_to)
        region[e] = true;
    std::vector<int> place;
    Profiles some;
    for (bool grew = true; grew;) {
      const Net part = part_of(after, region, &place);
      some = profiles(part.edges, part.lifts, {}, rules);
      std::set<std::int64_t> near, tied;
      for (int e = 0; e < edges; ++e)
        if (region[e]) {
          for (const Net* net : {&before, &std::as_const(after)})
            near.insert({net->edges[e].from_node, net->edges[e].to_node});
          const Profile& now = some.edges[place[e]];
          if (now.tied_from) tied.insert(after.edges[e].from_node);
          if (now.tied_to) tied.insert(after.edges[e].to_node);
        }
      std::vector<bool> grown = region;
      for (const Net* net : {&before, &std::as_const(after)})
        for (const ProfileLift& lift : net->lifts)
          if (region[lift.above] || region[lift.below])
            grown[lift.above] = grown[lift.below] = true;
      for (int e = 0; e < edges; ++e) {
        const ProfileEdge& edge = after.edges[e];
        if (tied.count(edge.from_node) + tied.count(edge.to_node) > 0 ||
            (were.edges[e].tied_from && near.count(before.edges[e].from_node) > 0) ||
            (were.edges[e].tied_to && near.count(before.edges[e].to_node) > 0))
          grown[e] = true;
      }
      grew = grown != region;
      region = grown;
    }
    for (int e = 0; e < edges; ++e) {
      ASSERT_TRUE(is_same(all.edges[e], region[e] ? some.edges[place[e]] : were.edges[e]))
          << "round " << round << " edge " << e;
      kept += region[e] ? 0 : 1;
      hidden += all.edges[e].tied_to && all.edges[e].line.back().z == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(unmet, tries / 10);
  EXPECT_GT(kept, tries);
  EXPECT_GT(hidden, tries / 100) << "nodes that are tied, and on the ground in the end";
}

// Heights of random nets against a plain iteration over all constraints.
TEST(Profile, IsTheLeastOfAllThatHold) {
  std::mt19937_64 random(11);
  int lifted = 0;
  for (int round = 0; round < 200; ++round) {
    const int nodes = 6, count = 9;
    std::vector<GradedRoad> roads;
    std::vector<double> node_ground;
    for (int n = 0; n < nodes; ++n) node_ground.push_back(random() % 300 / 100.0);
    for (int r = 0; r < count; ++r) {
      const int from = static_cast<int>(random() % nodes), to = static_cast<int>(random() % nodes);
      const double length = 50 + random() % 300;
      roads.push_back({from,
                       to,
                       {{0, node_ground[from]},
                        {length / 2, random() % 300 / 100.0},
                        {length, node_ground[to]}},
                       0.04 + random() % 4 / 100.0});
    }
    std::vector<Lift> lifts;
    for (int l = 0; l < 3; ++l) {
      const int below = static_cast<int>(random() % count),
                above = static_cast<int>(random() % count);
      if (below < above)
        lifts.push_back({below, roads[below].ground.back().at * 0.25, above,
                         roads[above].ground.back().at * 0.75, 6});
    }
    const std::vector<HeightLine> solved = least_heights(roads, lifts, {}).roads;
    // Heights at quarters of each road, raised until nothing moves.
    std::vector<std::vector<double>> least;
    for (const GradedRoad& road : roads) {
      least.emplace_back();
      for (int q = 0; q <= 4; ++q)
        least.back().push_back(height_at(road.ground, road.ground.back().at * q / 4));
    }
    bool moved = true;
    for (int sweep = 0; moved && sweep < 400; ++sweep) {
      moved = false;
      const auto raise = [&](double* height, double wanted) {
        if (wanted > *height + 1e-12) *height = wanted, moved = true;
      };
      for (int r = 0; r < count; ++r) {
        const double drop = roads[r].grade * roads[r].ground.back().at / 4;
        for (int q = 0; q < 4; ++q) {
          raise(&least[r][q + 1], least[r][q] - drop);
          raise(&least[r][q], least[r][q + 1] - drop);
        }
        for (int o = 0; o < count; ++o)
          for (const auto& [n, q] :
               {std::pair(roads[r].from_node, 0), std::pair(roads[r].to_node, 4)})
            for (const auto& [m, p] :
                 {std::pair(roads[o].from_node, 0), std::pair(roads[o].to_node, 4)})
              if (n == m) raise(&least[r][q], least[o][p]);
      }
      for (const Lift& lift : lifts) raise(&least[lift.to][3], least[lift.from][1] + lift.rise);
    }
    if (moved) continue;  // the lifts raise each other without end
    for (int r = 0; r < count; ++r)
      for (int q = 0; q <= 4; ++q) {
        const double at = roads[r].ground.back().at * q / 4;
        EXPECT_NEAR(height_at(solved[r], at), least[r][q], 1e-6)
            << "round " << round << " road " << r;
        lifted += least[r][q] > height_at(roads[r].ground, at) + 1;
      }
  }
  EXPECT_GT(lifted, 500);
}

}  // namespace profile_test
}  // namespace streetgen
