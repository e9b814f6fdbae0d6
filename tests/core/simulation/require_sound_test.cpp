#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "streetgen/error.hpp"
#include "streetgen/traffic.hpp"

namespace streetgen {
namespace {

// A lane that leads to another one.
TrafficNetwork sound() {
  TrafficNetwork network;
  for (const int key : {1, 2, 5}) {
    Link link;
    link.link_id = key;
    link.length = 10;
    link.speed = 10;
    link.movement = key == 2;
    network.links.push_back(link);
  }
  const auto list = [](RowsOf<std::int32_t>& lists, std::initializer_list<int> rows) {
    for (const int row : rows) {
      if (row >= 0) lists.add(row);
      lists.end_owner();
    }
  };
  list(network.next, {1, 2, -1});
  list(network.before, {-1, 0, 1});
  return network;
}

TEST(RequireSound, NetworkThatIsSoundPasses) {
  EXPECT_NO_THROW(require_sound(sound()));
  EXPECT_NO_THROW(require_sound(TrafficNetwork()));
}

TEST(RequireSound, EachFaultIsRefused) {
  const std::function<void(TrafficNetwork&)> faults[] = {
      [](auto& n) { n.links[0].length = 0; },
      [](auto& n) { n.links[0].length = std::numeric_limits<double>::quiet_NaN(); },
      [](auto& n) { n.links[0].link_id = 2; },
      [](auto& n) { n.links[1].plan = 0; },
      [](auto& n) { n.links[1].straight_on = 3; },
      [](auto& n) { n.links[1].opposite = -2; },
      [](auto& n) { n.next.starts.push_back(0); },
      [](auto& n) { n.next.starts[1] = 7; },
      [](auto& n) { n.next.rows[0] = 2; },
      [](auto& n) { n.next.rows[0] = 9; },
      [](auto& n) { n.before.rows[1] = -1; },
      [](auto& n) { n.before.rows.push_back(0), ++n.before.starts.back(); },
      [](auto& n) { n.plans.push_back({}); },
      [](auto& n) {
        n.conflicts.add({3, Precedence::by_signal, 0, 1, 0, 1});
        n.conflicts.end_owner(), n.conflicts.end_owner(), n.conflicts.end_owner();
      },
      [](auto& n) {
        n.beside.add({-1, false, false, false, 0, 1, 0, 1});
        n.beside.end_owner(), n.beside.end_owner(), n.beside.end_owner();
      },
      [](auto& n) {
        n.aspects.add({0, static_cast<Aspect>(9)});
        n.aspects.end_owner(), n.aspects.end_owner(), n.aspects.end_owner();
      }};
  int number = 0;
  for (const auto& fault : faults) {
    TrafficNetwork network = sound();
    fault(network);
    EXPECT_THROW(require_sound(network), Error) << number;
    ++number;
  }
}

}  // namespace
}  // namespace streetgen
