#include "driving/reached_links.hpp"

#include <algorithm>

namespace streetgen {

namespace {

constexpr int most_changes = 2;
constexpr std::size_t most_links = 400;  // of a search; dense nets have more within a long gap

}  // namespace

int ReachedLinks::row_of(int link) const {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i].link == link) return static_cast<int>(i);
  return -1;
}

std::vector<std::int32_t> ReachedLinks::way_to(int row) const {
  std::vector<std::int32_t> way;
  for (int at = row; rows_[at].from >= 0; at = rows_[at].from) way.push_back(rows_[at].link);
  std::reverse(way.begin(), way.end());
  return way;
}

void ReachedLinks::reach(const ReachedLink& row) {
  if (row_of(row.link) < 0) rows_.push_back(row);
}

// From a row on along next links.
void ReachedLinks::go_on(std::size_t from, double metres) {
  for (std::size_t i = from; i < rows_.size() && rows_.size() < most_links; ++i) {
    const ReachedLink row = rows_[i];
    const double end = row.start + network_->links[row.link].length;
    if (end > metres) continue;
    for (const int next : network_->next.of(row.link))
      reach({next, end, static_cast<std::int32_t>(i), row.changes});
  }
}

void ReachedLinks::change(const ReachedLink& row, int index) {
  const auto changes = static_cast<std::uint8_t>(row.changes + 1);
  for (const LinkBeside& beside : network_->beside.of(row.link)) {
    // Another direction is driven along from its end to its start, so no link is reached by it.
    const double start = beside.opposite ? row.start : row.start + beside.from - beside.other_from;
    reach({beside.link, start, index, beside.opposite ? std::uint8_t{most_changes} : changes});
  }
  const int opposite = network_->links[row.link].opposite;
  if (opposite >= 0) reach({opposite, row.start, index, most_changes});
}

void ReachedLinks::look(const LinkPlace& place, double metres) {
  rows_.clear();
  rows_.push_back({place.link, -place.metres, -1, 0});
  go_on(0, metres);
  for (int changes = 0; changes < most_changes; ++changes) {
    const std::size_t first = rows_.size();
    for (std::size_t i = 0; i < first; ++i)
      if (rows_[i].changes == changes) change(ReachedLink(rows_[i]), static_cast<int>(i));
    go_on(first, metres);
  }
}

}  // namespace streetgen
