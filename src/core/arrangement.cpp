#include "arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "overlap.hpp"
#include "polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

__extension__ using Wide = __int128;
using Cell = GridCell;

struct Segment {
  Cell from, to;  // from < to
};

// Twice the area of a, b, c: positive where c lies left.
Wide turn(const Cell& a, const Cell& b, const Cell& c) {
  return Wide(b.x - a.x) * (c.y - a.y) - Wide(b.y - a.y) * (c.x - a.x);
}

int sign(Wide value) { return (value > 0) - (value < 0); }

// The cell where two segments cross inside of both; at their ends there is a cell already.
bool crossing(const Segment& s, const Segment& t, Cell& cell) {
  const Wide o1 = turn(s.from, s.to, t.from), o2 = turn(s.from, s.to, t.to);
  if (sign(o1) * sign(o2) >= 0) return false;
  const Wide o3 = turn(t.from, t.to, s.from), o4 = turn(t.from, t.to, s.to);
  if (sign(o3) * sign(o4) >= 0) return false;
  const long double share = static_cast<long double>(o3) / static_cast<long double>(o3 - o4);
  cell = {s.from.x + std::llround(share * (s.to.x - s.from.x)),
          s.from.y + std::llround(share * (s.to.y - s.from.y))};
  return true;
}

// Whether the segment comes into the cell: no farther than half a step either way.
bool passes(const Segment& s, const Cell& cell) {
  const auto low_y = std::min(s.from.y, s.to.y), high_y = std::max(s.from.y, s.to.y);
  if (cell.x < s.from.x || cell.x > s.to.x || cell.y < low_y || cell.y > high_y) return false;
  const Wide dx = s.to.x - s.from.x, dy = s.to.y - s.from.y;
  const Wide off = 2 * turn(s.from, s.to, cell);
  const Wide reach = (dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy);
  return off <= reach && -off <= reach;
}

std::vector<Segment> segments_of(const std::vector<std::vector<Cell>>& lines) {
  std::vector<Segment> segments;
  for (const std::vector<Cell>& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Cell &a = line[i - 1], &b = line[i];
      if (!(a == b)) segments.push_back(a < b ? Segment{a, b} : Segment{b, a});
    }
  const auto key = [](const Segment& s) { return std::pair(s.from, s.to); };
  std::sort(segments.begin(), segments.end(),
            [&](const Segment& s, const Segment& t) { return key(s) < key(t); });
  segments.erase(std::unique(segments.begin(), segments.end(),
                             [](const Segment& s, const Segment& t) {
                               return s.from == t.from && s.to == t.to;
                             }),
                 segments.end());
  return segments;
}

std::vector<Cell> crossings(const std::vector<Segment>& segments) {
  std::vector<Cell> cells;
  std::vector<const Segment*> active;
  for (const Segment& s : segments) {
    poll_cancel();
    const auto low = std::min(s.from.y, s.to.y), high = std::max(s.from.y, s.to.y);
    std::size_t kept = 0;
    for (const Segment* t : active) {
      if (t->to.x < s.from.x) continue;
      active[kept++] = t;
      if (std::max(t->from.y, t->to.y) < low || std::min(t->from.y, t->to.y) > high) continue;
      if (Cell cell; crossing(s, *t, cell)) cells.push_back(cell);
    }
    active.resize(kept);
    active.push_back(&s);
  }
  return cells;
}

bool counter_clockwise(const std::vector<Cell>& ring) {
  Wide sum = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) sum += turn(ring[0], ring[i - 1], ring[i]);
  return sum > 0;
}

// A place in half steps, that is on no side of the ring.
bool holds(const std::vector<Cell>& ring, const Cell& place) {
  bool odd = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Cell &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const Cell a{2 * p.x, 2 * p.y}, b{2 * q.x, 2 * q.y};
    if ((a.y > place.y) == (b.y > place.y)) continue;
    odd ^= (turn(a, b, place) > 0) == (b.y > a.y);
  }
  return odd;
}

// A ring that touches itself comes apart into rings that do not.
// `at` holds `nowhere` for each node.
constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();
std::vector<std::vector<int>> apart(const std::vector<int>& ring, std::vector<std::size_t>& at) {
  std::vector<std::vector<int>> rings;
  std::vector<int> open;
  for (const int node : ring) {
    if (const std::size_t start = at[node]; start != nowhere) {
      rings.emplace_back(open.begin() + start, open.end());
      for (std::size_t i = start; i < open.size(); ++i) at[open[i]] = nowhere;
      open.resize(start);
    }
    at[node] = open.size();
    open.push_back(node);
  }
  for (const int node : open) at[node] = nowhere;
  rings.push_back(std::move(open));
  return rings;
}

}  // namespace

Arrangement::Arrangement(const std::vector<Line>& lines) {
  node(lines);
  connect();
  walk();
  place_walks();
}

Point Arrangement::position(int node) const {
  return {nodes_[node].cell.x * step_, nodes_[node].cell.y * step_, 0};
}

Point Arrangement::on_grid(const GridCell& cell) const {
  return {origin_.x + cell.x * step_, origin_.y + cell.y * step_, 0};
}

void Arrangement::node(const std::vector<Line>& lines) {
  Box box;
  for (const Line& line : lines)
    for (const Point& p : line) box.add(p);
  const double farthest = std::max(
      {std::abs(box.min_x), std::abs(box.max_x), std::abs(box.min_y), std::abs(box.max_y), 1.0});
  // A power of two that doubles of this size hold, so that cells are places of their own.
  step_ = std::ldexp(1, std::max(-24, std::ilogb(farthest) - 51));
  origin_ = {std::floor(box.min_x), std::floor(box.min_y), 0};
  // Of several in one cell the first holds.
  std::vector<std::pair<Cell, Point>> places;
  std::vector<std::vector<Cell>> rounded;
  for (const Line& line : lines) {
    rounded.emplace_back();
    for (const Point& p : line) {
      rounded.back().push_back(
          {std::llround((p.x - origin_.x) / step_), std::llround((p.y - origin_.y) / step_)});
      places.emplace_back(rounded.back().back(), planar(p));
    }
  }
  const std::vector<Segment> segments = segments_of(rounded);
  for (const Cell& cell : crossings(segments)) places.emplace_back(cell, on_grid(cell));
  std::stable_sort(places.begin(), places.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [cell, point] : places)
    if (nodes_.empty() || !(nodes_.back().cell == cell)) nodes_.push_back({cell, point});
  std::vector<std::pair<int, int>> edges;
  std::vector<std::pair<Wide, int>> along;
  for (const Segment& s : segments) {
    poll_cancel();
    along.clear();
    const Wide dx = s.to.x - s.from.x, dy = s.to.y - s.from.y;
    const auto first =
        std::lower_bound(nodes_.begin(), nodes_.end(), s.from.x,
                         [](const Node& node, std::int64_t x) { return node.cell.x < x; });
    for (auto node = first; node != nodes_.end() && node->cell.x <= s.to.x; ++node)
      if (passes(s, node->cell))
        along.emplace_back(dx * (node->cell.x - s.from.x) + dy * (node->cell.y - s.from.y),
                           static_cast<int>(node - nodes_.begin()));
    std::sort(along.begin(), along.end());
    for (std::size_t i = 1; i < along.size(); ++i)
      edges.push_back(std::minmax(along[i - 1].second, along[i].second));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& [a, b] : edges) {
    halves_.push_back({a, b});
    halves_.push_back({b, a});
  }
}

void Arrangement::connect() {
  std::vector<int> order(halves_.size());
  for (std::size_t h = 0; h < order.size(); ++h) order[h] = static_cast<int>(h);
  const auto ahead = [&](int h) {
    const Cell &from = nodes_[halves_[h].from].cell, &to = nodes_[halves_[h].to].cell;
    return Cell{to.x - from.x, to.y - from.y};
  };
  const auto lower = [](const Cell& d) { return d.y < 0 || (d.y == 0 && d.x < 0); };
  // By node, counter-clockwise.
  std::sort(order.begin(), order.end(), [&](int g, int h) {
    if (halves_[g].from != halves_[h].from) return halves_[g].from < halves_[h].from;
    const Cell a = ahead(g), b = ahead(h);
    if (lower(a) != lower(b)) return lower(b);
    return Wide(a.x) * b.y - Wide(a.y) * b.x > 0;
  });
  around_.resize(halves_.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first;
    while (last < order.size() && halves_[order[last]].from == halves_[order[first]].from) ++last;
    for (std::size_t i = first; i < last; ++i)
      around_[order[i]] = order[i == first ? last - 1 : i - 1];
    first = last;
  }
  for (std::size_t h = 0; h < halves_.size(); ++h) halves_[h].next = around_[h ^ 1];
}

void Arrangement::walk() {
  for (std::size_t start = 0; start < halves_.size(); ++start) {
    if (halves_[start].walk >= 0) continue;
    std::vector<int> walk;
    for (int h = static_cast<int>(start); halves_[h].walk < 0; h = halves_[h].next) {
      halves_[h].walk = static_cast<int>(walks_.size());
      walk.push_back(h);
    }
    walks_.push_back(std::move(walk));
  }
}

// Half way from the middle of a long part of the walk to what lies across the face, where that is
// not too near to tell one side of it from the other.
void Arrangement::place_walks() {
  constexpr double clear = 1e-3;  // metres
  constexpr std::size_t most_tries = 64;
  std::vector<bool> bounds(walks_.size());  // the outside of a face, not an island in it
  std::vector<int> outer, all(halves_.size());
  for (std::size_t h = 0; h < all.size(); ++h) all[h] = static_cast<int>(h);
  for (std::size_t w = 0; w < walks_.size(); ++w) {
    double sum = 0;
    const Point start = position(halves_[walks_[w].front()].from);
    for (const int h : walks_[w])
      sum += cross(position(halves_[h].from) - start, position(halves_[h].to) - start);
    bounds[w] = sum > 0;
    if (!bounds[w]) outer.insert(outer.end(), walks_[w].begin(), walks_[w].end());
  }
  std::vector<double> sizes;  // of halves
  for (const Half& half : halves_)
    sizes.push_back(distance(position(half.from), position(half.to)));
  const auto shorter = [&](int g, int h) { return sizes[g] < sizes[h]; };
  for (std::size_t w = 0; w < walks_.size(); ++w) {
    poll_cancel();
    std::vector<int> parts = walks_[w];
    Point place;
    double widest = 0;
    for (std::size_t tries = 0; tries < most_tries && !parts.empty(); ++tries) {
      const auto longest = std::max_element(parts.begin(), parts.end(), shorter);
      const int part = *longest;
      parts.erase(longest);
      const Point from = position(halves_[part].from), to = position(halves_[part].to);
      const Point middle = (from + to) * 0.5, across = left_normal(unit(to - from));
      double reach = 1;  // metres, where nothing lies across
      const auto meet = [&](int h) {
        if ((h | 1) == (part | 1)) return;
        const Point a = position(halves_[h].from) - middle, b = position(halves_[h].to) - middle;
        const double of_a = cross(across, a), of_b = cross(across, b);
        if ((of_a > 0) == (of_b > 0)) return;
        const double t = of_a / (of_a - of_b);
        const double off = dot(a, across) * (1 - t) + dot(b, across) * t;
        if (off > 0) reach = std::min(reach, off);
      };
      if (bounds[w]) {
        std::for_each(walks_[w].begin(), walks_[w].end(), meet);
        std::for_each(outer.begin(), outer.end(), meet);
      } else {
        std::for_each(all.begin(), all.end(), meet);
      }
      if (reach <= widest) continue;
      widest = reach;
      place = middle + across * (reach / 2);
      if (widest >= clear) break;
    }
    places_.push_back(origin_ + place);
  }
}

MultiPolygon Arrangement::joined(const std::vector<bool>& kept, Vertices vertices) const {
  const auto borders = [&](int h) { return kept[halves_[h].walk] && !kept[halves_[h ^ 1].walk]; };
  std::vector<bool> used(halves_.size());
  std::vector<std::size_t> at(nodes_.size(), nowhere);
  std::vector<std::vector<Cell>> shells;
  std::vector<std::pair<Cell, Ring>> holes;  // with a place on the border, in half steps
  MultiPolygon out;
  for (int start = 0; start < static_cast<int>(halves_.size()); ++start) {
    if (used[start] || !borders(start)) continue;
    std::vector<int> ring;
    for (int h = start; !used[h];) {
      used[h] = true;
      ring.push_back(halves_[h].from);
      int next = halves_[h].next;
      while (!borders(next)) next = around_[next];
      h = next;
    }
    for (const std::vector<int>& part : apart(ring, at)) {
      if (part.size() < 3) continue;
      std::vector<Cell> cells;
      Ring points;
      for (const int node : part) {
        cells.push_back(nodes_[node].cell);
        points.push_back(vertices == Vertices::own ? nodes_[node].point
                                                   : on_grid(nodes_[node].cell));
      }
      points.push_back(points.front());
      if (counter_clockwise(cells)) {
        shells.push_back(std::move(cells));
        out.push_back({std::move(points)});
      } else {
        holes.push_back({{cells[0].x + cells[1].x, cells[0].y + cells[1].y}, std::move(points)});
      }
    }
  }
  std::vector<std::size_t> by_size(out.size());
  std::iota(by_size.begin(), by_size.end(), 0);
  std::sort(by_size.begin(), by_size.end(), [&](std::size_t i, std::size_t j) {
    return signed_area(out[i].front()) < signed_area(out[j].front());
  });
  for (auto& [place, hole] : holes) {
    const auto shell = std::find_if(by_size.begin(), by_size.end(),
                                    [&](std::size_t i) { return holds(shells[i], place); });
    if (shell != by_size.end()) out[*shell].push_back(std::move(hole));
  }
  MultiPolygon sorted;
  for (const std::size_t i : by_size) sorted.push_back(std::move(out[i]));
  return sorted;
}

}  // namespace streetgen
