#include "streetgen/drive_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "simulation/made_network.hpp"
#include "rounds.hpp"
#include "streetgen/error.hpp"

namespace streetgen {
namespace driving_test {

using simulation_test::NetworkMaker;

// A fork: lane 0 goes east, movements 2 and 4 lead from its end to lanes 1 (on) and 3 (to the
// left); lane 5 comes towards lane 0, to its left.
struct Fork {
  NetworkMaker maker;
  int in, on, straight, left, turn, towards;
  TrafficNetwork network;
};

Fork made_fork() {
  Fork f;
  f.in = f.maker.lane(100);
  f.on = f.maker.lane(100);
  f.straight = f.maker.movement(f.in, f.on, 20, 14);
  f.left = f.maker.lane(100, 8);
  const double radius = 20 / (M_PI / 2);
  f.turn = f.maker.movement(f.in, f.left, 20, 8);
  f.towards = f.maker.lane(100);
  f.maker.piece(f.in, {0, 0, 0, 0, 0});
  f.maker.piece(f.straight, {0, 100, 0, 0, 0});
  f.maker.piece(f.on, {0, 120, 0, 0, 0});
  f.maker.piece(f.turn, {0, 100, 0, 0, 1 / radius});
  f.maker.piece(f.left, {0, 100 + radius, radius, M_PI / 2, 0});
  f.maker.piece(f.towards, {0, 100, 3.5, M_PI, 0});
  LinkBeside row{f.towards, true, false, true, 0, 100, 100, 0};
  f.maker.beside(f.in, row);
  f.network = f.maker.network();
  return f;
}

// The sample of an actor metres along some links.
DriveSample sample_at(const TrafficNetwork& network, const std::vector<int>& way, double metres,
                      double time, int actor = 0) {
  std::size_t i = 0;
  while (i + 1 < way.size() && metres > network.links[way[i]].length)
    metres -= network.links[way[i++]].length;
  const LinkFrame at = frame(network, {way[i], metres});
  DriveSample sample;
  sample.actor = actor;
  sample.time = time;
  sample.x = at.x;
  sample.y = at.y;
  return sample;
}

int link_at(const TrafficNetwork& network, const std::vector<int>& way, double metres) {
  std::size_t i = 0;
  while (i + 1 < way.size() && metres > network.links[way[i]].length)
    metres -= network.links[way[i++]].length;
  return way[i];
}

// Where paths part, what comes after tells the movement.
TEST(DriveReport, FollowsAnActorAcrossAJunction) {
  const Fork f = made_fork();
  for (const auto& way :
       {std::vector<int>{f.in, f.straight, f.on}, std::vector<int>{f.in, f.turn, f.left}})
    for (const double each : {0.31, 4.1, 17.3}) {
      std::vector<DriveSample> samples;
      for (double m = 1; m < 219; m += each)
        samples.push_back(sample_at(f.network, way, m, m / 10));
      const auto driven = drive_report(f.network, samples);
      for (std::size_t i = 0; i < samples.size(); ++i) {
        EXPECT_EQ(driven[i].located.place.link, link_at(f.network, way, 1 + each * i)) << i;
        EXPECT_NEAR(driven[i].located.offset, 0, 1e-9);
        EXPECT_EQ(driven[i].finding, DriveFinding::none);
      }
      EXPECT_NEAR(driven[1].speed, 10, 1e-9) << "by the places";
      EXPECT_NEAR(driven[1].over_limit, -4, 1e-9);
      EXPECT_NEAR(driven.back().over_limit, way[1] == f.turn ? 2 : -4, 1e-9);
    }
}

TEST(DriveReport, TakesTheLaneOnWhichAnActorMostlyIs) {
  const Fork f = made_fork();
  std::vector<DriveSample> samples;
  for (int i = 0; i < 20; ++i) {
    DriveSample s;
    s.time = i;
    s.x = 4 * i;
    s.y = i < 10 ? 1.2 : 3.3;  // it overtakes on the lane of those that come towards
    samples.push_back(s);
  }
  const auto driven = drive_report(f.network, samples);
  EXPECT_EQ(driven[5].located.place.link, f.in);
  EXPECT_NEAR(driven[5].located.offset, 1.2, 1e-9);
  EXPECT_FALSE(driven[5].against);
  EXPECT_EQ(driven[15].located.place.link, f.towards);
  EXPECT_TRUE(driven[15].against);
}

TEST(DriveReport, GivesGapsToWhoIsNextOnTheWay) {
  const Fork f = made_fork();
  const std::vector<int> on{f.in, f.straight, f.on}, turn{f.in, f.turn, f.left};
  std::vector<DriveSample> samples;
  for (int i = 0; i < 10; ++i) {
    samples.push_back(sample_at(f.network, turn, 80 + 4 * i, i, 0));
    samples.push_back(sample_at(f.network, on, 130 + 2 * i, i, 1));
    samples.push_back(sample_at(f.network, turn, 150 + 3 * i, i, 2));
    samples.back().length = 12;
  }
  const auto driven = drive_report(f.network, samples);
  for (int i = 0; i < 10; ++i) {
    const DrivenSample& first = driven[3 * i];
    EXPECT_EQ(first.leader, 2) << "who turns follows who turned";
    EXPECT_NEAR(first.gap, 70 - i - 12, 1e-6);
    EXPECT_NEAR(first.time_to_collision, first.gap / (first.speed - driven[3 * i + 2].speed), 1e-9);
    EXPECT_EQ(driven[3 * i + 1].leader, -1);
    EXPECT_TRUE(std::isnan(driven[3 * i + 1].gap));
  }
}

// One overtakes on the lane of who comes: both see each other, front to front.
TEST(DriveReport, TellsWhenTwoMeetHeadOn) {
  const Fork f = made_fork();
  std::vector<DriveSample> samples;
  for (int i = 0; i < 8; ++i) {
    samples.push_back(sample_at(f.network, {f.in}, 5 + 5 * i, 0.5 * i, 0));
    samples.push_back(sample_at(f.network, {f.in}, 98 - 4 * i, 0.5 * i + 0.1, 1));
    samples.back().y = -0.5;
    samples.back().length = 12;
  }
  const auto driven = drive_report(f.network, samples);
  for (int i = 0; i < 8; ++i) {
    const DrivenSample &with = driven[2 * i], &against = driven[2 * i + 1];
    ASSERT_TRUE(against.against) << i;
    EXPECT_EQ(against.leader, 0) << i;
    EXPECT_NEAR(against.gap, 93 - 9 * i - 10 * 0.1, 1e-4) << i;
    EXPECT_NEAR(against.time_to_collision, against.gap / 18, 1e-6) << i;
    if (i == 0) continue;
    EXPECT_EQ(with.leader, 1) << i;
    EXPECT_NEAR(with.gap, 93 - 9 * i + 4 - 8 * 0.4, 1e-4) << i;
    EXPECT_NEAR(with.time_to_collision, with.gap / 18, 1e-6) << i;
  }
}

// Actors are logged at different times: who was seen in the second before counts, moved on.
TEST(DriveReport, MovesALeaderOnSinceItsSample) {
  const Fork f = made_fork();
  std::vector<DriveSample> samples;
  for (int i = 0; i < 40; ++i) samples.push_back(sample_at(f.network, {f.in}, i, i * 0.1, 0));
  for (int i = 0; i < 4; ++i)
    samples.push_back(sample_at(f.network, {f.in}, 50 + 5 * i, i * 0.5 + 0.03, 1));
  const auto driven = drive_report(f.network, samples);
  EXPECT_EQ(driven[0].leader, -1) << "nobody was seen yet";
  for (int i = 1; i <= 25; ++i) {
    EXPECT_EQ(driven[i].leader, 1) << i;
    EXPECT_NEAR(driven[i].gap, 50 + 10 * (i * 0.1 - 0.03) - 5 - i, 1e-6) << i;
  }
  EXPECT_EQ(driven[26].leader, -1) << "it was seen over a second before";
}

TEST(DriveReport, TellsWhatItCannotPlace) {
  const Fork f = made_fork();
  std::vector<DriveSample> samples;
  for (int i = 0; i < 6; ++i) samples.push_back(sample_at(f.network, {f.in}, 10 + 5 * i, i, 0));
  samples[1].x = std::numeric_limits<double>::quiet_NaN();
  samples[2].time = std::numeric_limits<double>::infinity();
  samples[3].y = -40;
  samples.push_back(samples[5]);
  const auto driven = drive_report(f.network, samples);
  const DriveFinding found[] = {DriveFinding::none,     DriveFinding::no_place,
                                DriveFinding::no_time,  DriveFinding::off_road,
                                DriveFinding::none,     DriveFinding::none,
                                DriveFinding::twice};
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(driven[i].finding, found[i]) << i;
    EXPECT_EQ(driven[i].located.place.link, found[i] == DriveFinding::none ? f.in : -1) << i;
  }
  EXPECT_TRUE(drive_report(f.network, {}).empty());
  for (const int actor : {-1, 7, std::numeric_limits<int>::max()}) {
    samples[0].actor = actor;
    EXPECT_THROW(drive_report(f.network, samples), Error) << actor;
  }
  samples[0].actor = 0;
  samples[0].length = 0;
  EXPECT_THROW(drive_report(f.network, samples), Error);
}

TEST(DriveReport, DoesNotDependOnTheOrderOfSamples) {
  const Fork f = made_fork();
  std::mt19937_64 random(3);
  std::vector<DriveSample> samples;
  for (int actor = 0; actor < 8; ++actor)
    for (int i = 0; i < 30; ++i)
      samples.push_back(sample_at(f.network,
                                  actor % 2 ? std::vector<int>{f.in, f.straight, f.on}
                                            : std::vector<int>{f.in, f.turn, f.left},
                                  10 * actor + 4 * i, i, actor));
  const auto driven = drive_report(f.network, samples);
  std::vector<int> order(samples.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  for (int round = 0; round < rounds(5); ++round) {
    std::shuffle(order.begin(), order.end(), random);
    std::vector<DriveSample> mixed;
    for (const int i : order) mixed.push_back(samples[i]);
    const auto again = drive_report(f.network, mixed);
    for (std::size_t i = 0; i < order.size(); ++i) {
      EXPECT_EQ(again[i].located.place.link, driven[order[i]].located.place.link);
      EXPECT_EQ(again[i].leader, driven[order[i]].leader);
      EXPECT_TRUE(again[i].leader < 0 || again[i].gap == driven[order[i]].gap);
    }
  }
}

}  // namespace driving_test
}  // namespace streetgen
