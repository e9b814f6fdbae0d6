// through.cpp NETWORK SECONDS < DEMAND: how many cars get through a network.  DEMAND has lines
// "entry LINK FLOW" (cars an hour) and "turn LINK NEXT SHARE"; NETWORK is a file of network bytes.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

#include "simulation/network_bytes.hpp"
#include "streetgen/car_following.hpp"

using namespace streetgen;

int main(int count, char** arguments) {
  if (count != 3) return 2;
  std::ifstream file(arguments[1], std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const TrafficNetwork network = pg::read_network(bytes);
  std::vector<TrafficEntry> entries;
  std::vector<TurnShare> turns;
  for (std::string kind; std::cin >> kind;) {
    std::int64_t link = 0, next = 0;
    double number = 0;
    if (kind == "entry") {
      std::cin >> link >> number;
      TrafficEntry entry;
      entry.link = link_of(network, link);
      entry.flow = number / 3600;
      entries.push_back(entry);
    } else {
      std::cin >> link >> next >> number;
      turns.push_back({link_of(network, link), link_of(network, next), number});
    }
  }
  CarFollowing run(network, {});
  run.set_turns(turns);
  run.set_entries(entries);
  const int seconds = std::atoi(arguments[2]);
  std::vector<double> stands;  // by car, seconds
  const auto began = std::chrono::steady_clock::now();
  std::printf("%8s %8s %8s %8s %8s %10s %12s\n", "s", "entered", "left", "there", "waiting", "km/h",
              "stood > 2min");
  for (int t = 1; t <= seconds; ++t) {
    for (int i = 0; i < 10; ++i) run.step(0.1);
    const Traffic& cars = run.traffic();
    stands.resize(cars.size());
    double speeds = 0;
    int long_stand = 0;
    for (int i = 0; i < cars.size(); ++i) {
      if (!cars.holds(i)) {
        stands[i] = 0;
        continue;
      }
      const double speed = cars.car(i).speed;
      speeds += speed;
      stands[i] = speed < 0.5 ? stands[i] + 1 : 0;
      long_stand += stands[i] > 120;
    }
    if (t % 60 == 0 || t == seconds)
      std::printf("%8d %8lld %8lld %8d %8lld %10.1f %12d\n", t,
                  static_cast<long long>(run.entered()), static_cast<long long>(run.left()),
                  cars.count(), static_cast<long long>(run.waiting()),
                  cars.count() > 0 ? speeds / cars.count() * 3.6 : 0, long_stand);
  }
  std::printf("%.1f s of one core\n",
              std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
}
