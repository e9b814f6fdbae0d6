#include "simulation/network_bytes.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "streetgen/error.hpp"

namespace streetgen::pg {
namespace {

// "network1", and how rows lie: a build with others refuses them.
constexpr std::uint64_t mark = 0x316b726f7774656eULL + sizeof(Link) + (sizeof(LinkPiece) << 8) +
                               (sizeof(LinkBeside) << 16) + (sizeof(LinkConflict) << 24);

// FNV-1a, eight bytes at a time.
std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t sum = 14695981039346656037ULL;
  for (std::size_t at = 0; at < bytes.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min<std::size_t>(8, bytes.size() - at));
    sum = (sum ^ word) * 1099511628211ULL;
  }
  return sum;
}

// Gives each array of a network to work, in their order.
template <class Network, class Work>
void each_array(Network& network, Work work) {
  work(network.links);
  const auto lists = [&](auto& rows) { work(rows.starts), work(rows.rows); };
  lists(network.next);
  lists(network.before);
  lists(network.pieces);
  lists(network.heights);
  lists(network.beside);
  lists(network.conflicts);
  lists(network.aspects);
  work(network.plans);
  work(network.nodes);
  work(network.junctions);
}

[[noreturn]] void refuse() {
  throw Error(ErrorKind::invalid_input, "bytes that are no network of links");
}

}  // namespace

std::string network_bytes(const TrafficNetwork& network) {
  std::string bytes;
  const auto append = [&](const void* from, std::size_t size) {
    bytes.append(static_cast<const char*>(from), size);
  };
  each_array(network, [&](const auto& array) {
    static_assert(std::is_trivially_copyable_v<std::decay_t<decltype(array[0])>>);
    const std::uint64_t size = array.size();
    append(&size, sizeof size);
    append(array.data(), size * sizeof array[0]);
  });
  bytes += static_cast<char>(network.left_hand);
  const std::uint64_t head[] = {mark, checksum(bytes)};
  return std::string(reinterpret_cast<const char*>(head), sizeof head) + bytes;
}

TrafficNetwork read_network(std::string_view bytes) {
  std::uint64_t head[2];
  if (bytes.size() < sizeof head) refuse();
  std::memcpy(head, bytes.data(), sizeof head);
  bytes.remove_prefix(sizeof head);
  if (head[0] != mark || head[1] != checksum(bytes)) refuse();
  TrafficNetwork network;
  each_array(network, [&](auto& array) {
    std::uint64_t size = 0;
    if (bytes.size() < sizeof size) refuse();
    std::memcpy(&size, bytes.data(), sizeof size);
    bytes.remove_prefix(sizeof size);
    using Row = std::decay_t<decltype(array[0])>;
    if (size > bytes.size() / sizeof(Row)) refuse();
    array.resize(size);
    std::memcpy(static_cast<void*>(array.data()), bytes.data(), size * sizeof(Row));
    bytes.remove_prefix(size * sizeof(Row));
  });
  if (bytes.size() != 1) refuse();
  network.left_hand = bytes[0] != 0;
  require_sound(network);
  return network;
}

}  // namespace streetgen::pg
