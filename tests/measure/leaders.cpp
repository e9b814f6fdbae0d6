// leaders.cpp CARS: what the leaders of cars cost in a town of a grid, beside sorting the cars and
// a binary search among them in the same run.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

#include "streetgen/traffic.hpp"

using namespace streetgen;

namespace {

constexpr int side = 100;  // streets each way
constexpr int repeats = 7;

// Streets of 100 m between crossings, a lane each way, with ways straight on, left and right.
TrafficNetwork grid() {
  TrafficNetwork made;
  // The lane that leaves a crossing towards one of four directions.
  const auto lane = [](int x, int y, int towards) {
    return 4 * ((x + side) % side * side + (y + side) % side) + towards;
  };
  constexpr int step_x[] = {1, 0, -1, 0}, step_y[] = {0, 1, 0, -1};
  const int lanes = 4 * side * side;
  std::vector<std::vector<int>> before(static_cast<std::size_t>(4) * lanes);
  const auto add = [&](double length, bool movement) {
    Link link;
    link.link_id = static_cast<std::int64_t>(made.links.size());
    link.length = length;
    link.speed = 14;
    link.stop = static_cast<float>(length);
    link.movement = movement;
    made.links.push_back(link);
  };
  for (int i = 0; i < lanes; ++i) add(80, false);
  for (int i = 0; i < 3 * lanes; ++i) add(20, true);
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int towards = 0; towards < 4; ++towards) {
        const int from = lane(x, y, towards);
        made.links[from].straight_on = lanes + 3 * from;
        for (int turn = 0; turn < 3; ++turn) {
          const int movement = lanes + 3 * from + turn;
          const int way = (towards + (turn == 2 ? 3 : turn)) % 4;
          const int to = lane(x + step_x[towards], y + step_y[towards], way);
          made.next.add(movement);
          before[movement].push_back(from);
          before[to].push_back(movement);
          made.links[movement].straight_on = to;
        }
        made.next.end_owner();
      }
  for (int i = lanes; i < 4 * lanes; ++i) {
    made.next.add(made.links[i].straight_on);
    made.next.end_owner();
  }
  for (int i = 0; i < 4 * lanes; ++i) {
    for (const int link : before[i]) made.before.add(link);
    made.before.end_owner();
    made.pieces.end_owner();
    made.heights.end_owner();
    made.beside.end_owner();
    made.conflicts.end_owner();
    made.aspects.end_owner();
  }
  return made;
}

// The least of some tries, seconds.
template <class Work>
double seconds_of(Work work) {
  double least = 1e300;
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    least = std::min(least, took.count());
  }
  return least;
}

}  // namespace

int main(int count_of_arguments, char** arguments) {
  const int count = count_of_arguments > 1 ? std::atoi(arguments[1]) : 100000;
  const TrafficNetwork network = grid();
  std::mt19937_64 random(1);
  Traffic traffic(network);
  traffic.reserve(count);
  std::vector<std::pair<int, double>> places;
  for (int i = 0; i < count; ++i) {
    Car car;
    car.car_id = i;
    car.place.link = static_cast<int>(random() % network.size());
    car.place.metres =
        network.links[car.place.link].length * static_cast<double>(random() % 1000) / 1000;
    traffic.add(car);
    places.emplace_back(car.place.link, car.place.metres);
  }
  const LeaderRules rules;
  const double adding = seconds_of([&] {
    Traffic anew(network);
    anew.reserve(count);
    for (int i = 0; i < count; ++i) anew.add(traffic.car(i));
  });
  std::vector<std::pair<int, double>> sorted;
  const double sorting = seconds_of([&] {
    sorted = places;
    std::sort(sorted.begin(), sorted.end());
  });
  double sum = 0;
  const double leading = seconds_of([&] {
    for (const Leader& leader : traffic.leaders(rules)) sum += leader.gap;
  });
  const double searching = seconds_of([&] {
    for (const auto& place : places)
      sum += static_cast<double>(std::lower_bound(sorted.begin(), sorted.end(), place) -
                                 sorted.begin());
  });
  const double one_by_one = seconds_of([&] {
    for (int i = 0; i < count; ++i) sum += traffic.leader(i, rules).gap;
  });
  const double moving = seconds_of([&] {
    for (int i = 0; i < count; ++i) {
      LinkPlace place = traffic.car(i).place;
      place.metres += 0.5;
      if (place.metres > network.links[place.link].length)
        place = {network.links[place.link].straight_on, 0};
      traffic.move(i, place);
    }
  });
  const auto row = [&](const char* what, double seconds, double beside) {
    std::printf("%s\t%.1f ns\t%.2f\n", what, 1e9 * seconds / count, seconds / beside);
  };
  std::printf("%d cars on %d links\ta car\tratio\n", count, network.size());
  row("sorting them", sorting, sorting);
  row("leaders of all, to sorting", leading, sorting);
  row("a binary search", searching, searching);
  row("the leader of one, to a search", one_by_one, searching);
  row("adding, to sorting", adding, sorting);
  row("moving by half a metre, to sorting", moving, sorting);
  return sum > 0 ? 0 : 1;
}
