#include <cmath>
#include <cstring>
#include <string>

#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "streetgen/traffic.hpp"

namespace streetgen {

namespace {

[[noreturn]] void refuse_network(const std::string& what) {
  throw Error(ErrorKind::invalid_input, "a network of links has " + what);
}

// A value of one byte as it lies there: a network may come from bytes.
template <class Value>
unsigned byte_of(const Value& value) {
  static_assert(sizeof value == 1);
  unsigned char byte;
  std::memcpy(&byte, &value, 1);
  return byte;
}

template <class Row>
void require_lists(const RowsOf<Row>& lists, std::size_t owners, const char* name) {
  const auto& starts = lists.starts;
  const bool whole = starts.size() == owners + 1 || (starts.size() == 1 && lists.rows.empty());
  if (!whole || starts.front() != 0 || starts.back() != static_cast<int>(lists.rows.size()))
    refuse_network(std::string("lists of ") + name + " that do not fit its links");
  for (std::size_t i = 1; i < starts.size(); ++i)
    if (starts[i] < starts[i - 1])
      refuse_network(std::string("lists of ") + name + " that lie over each other");
}

void require_index(std::int64_t index, std::int64_t low, std::size_t count, const char* name) {
  if (index < low || index >= static_cast<std::int64_t>(count))
    refuse_network(std::string("a ") + name + " " + std::to_string(index) + " that is none");
}

void require_finite(const char* name, std::initializer_list<double> numbers) {
  for (const double number : numbers)
    if (!std::isfinite(number)) refuse_network(std::string("a ") + name + " that is no number");
}

void require_links(const TrafficNetwork& network) {
  const std::size_t count = network.links.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Link& link = network.links[i];
    require_finite("link", {link.length, link.stretch, link.speed, link.width, link.stop});
    if (!(link.length > 0) || !(link.stretch > 0) || link.speed < 0 || link.width < 0)
      refuse_network("a link without length");
    if (i > 0 && network.links[i - 1].link_id >= link.link_id)
      refuse_network("links that are not in the order of their keys");
    require_index(link.from_node, -1, network.nodes.size(), "node");
    require_index(link.to_node, -1, network.nodes.size(), "node");
    require_index(link.junction, -1, network.junctions.size(), "junction");
    require_index(link.plan, -1, network.plans.size(), "plan");
    require_index(link.straight_on, -1, count, "link");
    require_index(link.opposite, -1, count, "link");
    if (byte_of(link.movement) > 1 || link.traffic > traffic::all)
      refuse_network("a link of no kind");
  }
}

// Lanes lead to movements, and each movement from one lane to one lane.
void require_ways(const TrafficNetwork& network) {
  const std::size_t count = network.links.size();
  std::size_t ways = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto next = network.next.of(static_cast<int>(i));
    for (const std::int32_t to : next) {
      require_index(to, 0, count, "link");
      bool back = false;
      for (const std::int32_t from : network.before.of(to))
        back = back || from == static_cast<std::int32_t>(i);
      if (!back) refuse_network("a way that leads on and not back");
    }
    for (const std::int32_t from : network.before.of(static_cast<int>(i)))
      require_index(from, 0, count, "link");
    ways += next.size();
  }
  if (ways != network.before.rows.size()) refuse_network("a way that leads back and not on");
}

void require_rows(const TrafficNetwork& network) {
  const std::size_t count = network.links.size();
  for (const LinkPiece& piece : network.pieces.rows)
    require_finite("course", {piece.metres, piece.x, piece.y, piece.heading, piece.curvature});
  for (const LinkHeight& height : network.heights.rows)
    require_finite("height", {height.metres, height.height});
  for (const LinkBeside& row : network.beside.rows) {
    require_index(row.link, 0, count, "link");
    require_finite("stretch", {row.from, row.to, row.other_from, row.other_to});
    if (byte_of(row.left) > 1 || byte_of(row.may_change) > 1 || byte_of(row.opposite) > 1)
      refuse_network("a stretch on no side");
  }
  for (const LinkConflict& row : network.conflicts.rows) {
    require_index(row.link, 0, count, "link");
    require_finite("conflict", {row.from, row.to, row.other_from, row.other_to});
    if (byte_of(row.precedence) > byte_of(Precedence::by_signal))
      refuse_network("a conflict without precedence");
  }
  for (const SignalAspect& row : network.aspects.rows) {
    require_finite("signal", {row.since});
    if (byte_of(row.aspect) > byte_of(Aspect::protected_green))
      refuse_network("a signal of no aspect");
  }
  for (const SignalPlan& plan : network.plans) {
    require_finite("plan", {plan.cycle, plan.start_offset});
    if (!(plan.cycle > 0)) refuse_network("a plan without a cycle");
  }
}

}  // namespace

void require_sound(const TrafficNetwork& network) {
  const std::size_t count = network.links.size();
  require_lists(network.next, count, "ways");
  require_lists(network.before, count, "ways");
  require_lists(network.pieces, count, "courses");
  require_lists(network.heights, count, "heights");
  require_lists(network.beside, count, "stretches");
  require_lists(network.conflicts, count, "conflicts");
  require_lists(network.aspects, count, "signals");
  poll_cancel();
  require_links(network);
  require_ways(network);
  require_rows(network);
}

}  // namespace streetgen
