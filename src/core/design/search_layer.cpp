#include "design/search_layer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {
namespace {

constexpr int reach = 3;  // cells that a move spans at most, along either axis
constexpr int headings = 32;
constexpr int levels = 5;
constexpr int ground_level = 2;
// Heights over ground, in shares of what the greatest grade climbs over a cell.
constexpr double level_share[levels] = {-1.1, -0.4, 0, 0.4, 1.1};
constexpr std::uint8_t no_parent = 255;
constexpr float unreached = std::numeric_limits<float>::infinity();

std::uint32_t state_of(std::uint32_t cell, int level, int heading) {
  return (cell * levels + level) * headings + heading;
}

}  // namespace

SearchLayer::SearchLayer(const DesignSite& site, const SearchGrid& grid, std::vector<bool> corridor,
                         Waiver waiver)
    : site_(site), grid_(grid), waiver_(waiver), section_(site.rules) {
  sample_ = std::max(grid.cell / 3, std::min(grid.cell, site.terrain.cell() / 2));
  make_moves();
  number_.assign(static_cast<std::size_t>(grid.columns()) * grid.rows(), -1);
  for (std::size_t i = 0; i < number_.size(); ++i)
    if (corridor.empty() || corridor[i]) {
      number_[i] = static_cast<std::int32_t>(position_.size());
      position_.push_back(static_cast<std::uint32_t>(i));
    }
  read_ground();
  cost_.assign(position_.size() * levels * headings, unreached);
  parent_.assign(cost_.size(), no_parent);
  done_.assign(position_.size() * levels, 0);
}

void SearchLayer::make_moves() {
  for (int row = -reach; row <= reach; ++row)
    for (int column = -reach; column <= reach; ++column)
      if (std::gcd(column, row) == 1)
        moves_.push_back({column, row, grid_.cell * std::hypot(column, row),
                          std::atan2(grid_.along.y, grid_.along.x) + std::atan2(row, column)});
  const CurveRoom room(site_.rules);
  for (const Move& in : moves_) {
    std::uint32_t fitting = 0;
    for (int i = 0; i < headings; ++i) {
      const double turn = std::remainder(moves_[i].heading - in.heading, 2 * M_PI);
      if (room.tangent(turn) <= std::min(in.length, moves_[i].length) / 2) fitting |= 1u << i;
    }
    turns_.push_back(fitting);
  }
}

void SearchLayer::read_ground() {
  ground_.resize(position_.size());
  for (std::size_t i = 0; i < position_.size(); ++i) {
    const Point p = grid_.place(position_[i] % grid_.columns(), position_[i] / grid_.columns());
    ground_[i] = static_cast<float>(site_.terrain.ground(p.x, p.y).height);
  }
}

// The moves whose turn to or from a side fits; without a side, all.
std::uint32_t SearchLayer::moves_beside(const std::optional<SidesAbout::Side>& side) const {
  if (!side) return ~0u;
  const CurveRoom room(site_.rules);
  std::uint32_t fitting = 0;
  for (int i = 0; i < headings; ++i)
    if (room.tangent(std::remainder(moves_[i].heading - side->heading, 2 * M_PI)) <=
        std::min(side->length, moves_[i].length) / 2)
      fitting |= 1u << i;
  return fitting;
}

int SearchLayer::cell_at(int column, int row) const {
  if (column < 0 || row < 0 || column >= grid_.columns() || row >= grid_.rows()) return -1;
  return number_[static_cast<std::size_t>(row) * grid_.columns() + column];
}

double SearchLayer::bound(std::uint32_t cell) const {
  const int column = position_[cell] % grid_.columns(), row = position_[cell] / grid_.columns();
  return section_.least() * grid_.cell *
         std::hypot(column - grid_.margin_x - grid_.last, row - grid_.margin_y);
}

// Ground in the middle of equal parts of a side; false where there is none, or a zone forbids it.
bool SearchLayer::sample_side(const Point& from, const Point& to, double length) {
  const int parts = std::max(1, static_cast<int>(length / sample_ + 0.5));
  const double nx = -(to.y - from.y) / length, ny = (to.x - from.x) / length;
  if (!waiver_.zones && site_.zones.bars(from, to)) return false;
  samples_.clear();
  for (int i = 0; i < parts; ++i) {
    const double t = (i + 0.5) / parts;
    const double x = from.x + t * (to.x - from.x), y = from.y + t * (to.y - from.y);
    const Terrain::Ground g = site_.terrain.ground(x, y);
    if (std::isnan(g.height)) return false;
    samples_.push_back({g.height, g.slope_x * nx + g.slope_y * ny,
                        waiver_.zones ? nullptr : site_.zones.at(x, y)});
  }
  return true;
}

// Cost of the sampled side where it climbs evenly between two heights.
double SearchLayer::side_cost(double from, double to, double length) const {
  double sum = 0, at = from + (to - from) / (2 * samples_.size());
  const double climb = (to - from) / samples_.size();
  for (const Sample& s : samples_) {
    sum += section_.cost(at - s.ground, s.cross_slope, s.zone);
    at += climb;
  }
  return sum * length / samples_.size() + site_.rules.climb_cost * std::abs(to - from);
}

void SearchLayer::expand(std::uint32_t cell, int level, std::uint32_t moves, double so_far,
                         std::uint8_t parent) {
  std::uint32_t& done = done_[cell * levels + level];
  moves &= ~done;
  done |= moves;
  const double step = site_.rules.grade * grid_.cell;
  const int column = position_[cell] % grid_.columns(), row = position_[cell] / grid_.columns();
  const Point from = grid_.place(column, row);
  const double height = ground_[cell] + level_share[level] * step;
  for (int i = 0; i < headings; ++i) {
    if (!(moves >> i & 1)) continue;
    const Move& move = moves_[i];
    const int next = cell_at(column + move.column, row + move.row);
    if (next < 0 || std::isnan(ground_[next])) continue;
    const double climb = waiver_.grade ? infinite : site_.rules.grade * move.length;
    const double least = so_far + section_.least() * move.length;
    bool sampled = false;
    for (int l = 0; l < levels; ++l) {
      const double to = ground_[next] + level_share[l] * step;
      const std::uint32_t state = state_of(next, l, i);
      if (std::abs(to - height) > climb || !(least < cost_[state])) continue;
      if (!sampled &&
          !sample_side(from, grid_.place(column + move.column, row + move.row), move.length))
        break;
      sampled = true;
      reach_state(next, l, i, so_far + side_cost(height, to, move.length), parent);
    }
  }
}

void SearchLayer::reach_state(std::uint32_t cell, int level, int heading, double cost,
                              std::uint8_t parent) {
  const std::uint32_t state = state_of(cell, level, heading);
  if (!(cost < cost_[state])) return;
  cost_[state] = static_cast<float>(cost);
  parent_[state] = parent;
  // All that may follow was tried from there at less cost.
  const bool spent = (turns_[heading] & ~done_[cell * levels + level]) == 0;
  if (spent && static_cast<int>(cell) != last_) return;
  queue_.push_back({static_cast<float>(cost + bound(cell)), state});
  std::push_heap(queue_.begin(), queue_.end());
}

std::optional<Line> SearchLayer::search(const SidesAbout& about) {
  const int first = cell_at(grid_.margin_x, grid_.margin_y);
  last_ = cell_at(grid_.margin_x + grid_.last, grid_.margin_y);
  if (first < 0 || last_ < 0 || std::isnan(ground_[first]) || std::isnan(ground_[last_])) return {};
  const std::uint32_t arriving = moves_beside(about.behind);
  expand(first, ground_level, moves_beside(about.before), 0, no_parent);
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end());
    const Queued next = queue_.back();
    queue_.pop_back();
    const std::uint32_t cell = next.state / (levels * headings);
    const int level = next.state / headings % levels, heading = next.state % headings;
    // The first to come to a cell, height and move is the cheapest: a turn costs nothing.
    if (next.total > cost_[next.state] + bound(cell) * (1 + 1e-6) + 1) continue;
    if (static_cast<int>(cell) == last_ && level == ground_level && (arriving >> heading & 1))
      return traced(next.state);
    poll_cancel();
    expand(cell, level, turns_[heading], cost_[next.state],
           static_cast<std::uint8_t>(heading * levels + level));
  }
  return {};
}

Line SearchLayer::traced(std::uint32_t state) const {
  Line line;
  const double step = site_.rules.grade * grid_.cell;
  for (;;) {
    const std::uint32_t cell = state / (levels * headings);
    const int column = position_[cell] % grid_.columns(), row = position_[cell] / grid_.columns();
    Point p = grid_.place(column, row);
    p.z = ground_[cell] + level_share[state / headings % levels] * step;
    line.push_back(p);
    const Move& move = moves_[state % headings];
    const int before = cell_at(column - move.column, row - move.row);
    const std::uint8_t parent = parent_[state];
    if (parent == no_parent) {
      Point start = grid_.place(column - move.column, row - move.row);
      start.z = ground_[before];
      line.push_back(start);
      break;
    }
    state = state_of(before, parent % levels, parent / levels);
  }
  std::reverse(line.begin(), line.end());
  return line;
}

}  // namespace streetgen
