#include "geometry/arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "geometry/box.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

using Cell = GridCell;

struct Segment {
  Segment(const std::vector<Cell>& places, int from_place, int to_place)
      : from(places[from_place]),
        to(places[to_place]),
        low(std::min(from.y, to.y)),
        high(std::max(from.y, to.y)),
        first(from_place),
        last(to_place) {}
  Cell from, to;           // from < to, or one cell
  std::int64_t low, high;  // of their y
  int first, last;         // the places that these are
  // In steps either way.
  std::int64_t size() const { return (to.x - from.x) + (high - low); }
  bool in_box(const Cell& cell) const {
    return cell.x >= from.x && cell.x <= to.x && cell.y >= low && cell.y <= high;
  }
  bool ends_at(int place) const { return place == first || place == last; }
};

// Pairs of numbers below `end`, few of which have their first in common.
void sort_distinct(std::vector<std::pair<int, int>>& pairs, std::size_t end) {
  std::vector<int> last(end + 1);  // of each first, in the order
  for (const auto& pair : pairs) ++last[pair.first + 1];
  std::partial_sum(last.begin(), last.end(), last.begin());
  std::vector<std::pair<int, int>> order(pairs.size());
  for (const auto& pair : pairs) order[last[pair.first]++] = pair;
  pairs.clear();
  auto first = order.begin();
  for (std::size_t number = 0; number < end; ++number) {
    const auto next = order.begin() + last[number];
    if (next - first > 1) std::sort(first, next);
    std::unique_copy(first, next, std::back_inserter(pairs));
    first = next;
  }
}

// The cell where two segments without a common end cross inside of both.
bool crossing(const Segment& s, const Segment& t, Cell& cell) {
  if (side(s.from, s.to, t.from) * side(s.from, s.to, t.to) >= 0) return false;
  if (side(t.from, t.to, s.from) * side(t.from, t.to, s.to) >= 0) return false;
  const Wide o3 = twice_area(t.from, t.to, s.from), o4 = twice_area(t.from, t.to, s.to);
  const long double share = static_cast<long double>(o3) / static_cast<long double>(o3 - o4);
  cell = {s.from.x + std::llround(share * (s.to.x - s.from.x)),
          s.from.y + std::llround(share * (s.to.y - s.from.y))};
  return true;
}

// Whether the segment comes into a cell of its box: no farther than half a step either way.
bool passes(const Segment& s, const Cell& cell) {
  const About about = about_twice_area(s.from, s.to, cell);
  if (2 * (std::abs(about.value) - about.error) > static_cast<double>(s.size())) return false;
  const Wide off = 2 * twice_area(s.from, s.to, cell);
  return off <= s.size() && -off <= s.size();
}

// Whether t lies so far on one side of the line of s that they come into no cell of each other.
bool lies_off(const Segment& s, const Segment& t) {
  const double size = static_cast<double>(s.size());
  const About from = about_twice_area(s.from, s.to, t.from),
              to = about_twice_area(s.from, s.to, t.to);
  return 2 * std::min(from.value - from.error, to.value - to.error) > size ||
         2 * std::max(from.value + from.error, to.value + to.error) < -size;
}

// Places where segments end or cross, and which of them others come into.
class Meetings {
 public:
  struct Meeting {
    int segment, place;
  };

  // The ends' cells by place, and the segments by these.
  Meetings(std::vector<Cell>& places, const std::vector<Segment>& segments)
      : places_(places), segments_(segments) {
    struct Active {
      std::int64_t to_x, low, high;
      int segment;
    };
    std::vector<Active> active;
    near_.reserve(4 * segments.size());
    meetings_.reserve(segments.size());
    for (int i = 0; i < static_cast<int>(segments.size()); ++i) {
      poll_cancel();
      const Segment& s = segments[i];
      const Active own{s.to.x, s.low, s.high, i};
      for (std::size_t k = 0; k < active.size();) {
        const Active& other = active[k];
        if (other.to_x < s.from.x) {
          active[k] = active.back();
          active.pop_back();
          continue;
        }
        if (other.high >= own.low && other.low <= own.high) meet(i, other.segment);
        ++k;
      }
      active.push_back(own);
    }
    meet_crossings();
    std::sort(meetings_.begin(), meetings_.end(),
              [](const Meeting& a, const Meeting& b) { return a.segment < b.segment; });
  }

  // By segment, without the segment's own ends; a place may come twice.
  const std::vector<Meeting>& all() const { return meetings_; }

 private:
  void come(int segment, const Segment& s, int place, const Cell& cell) {
    if (s.in_box(cell) && !s.ends_at(place) && passes(s, cell))
      meetings_.push_back({segment, place});
  }

  void meet(int i, int j) {
    const Segment &s = segments_[i], &t = segments_[j];
    near_.emplace_back(i, j);
    const bool joined = t.ends_at(s.first) || t.ends_at(s.last);
    if (!joined && (lies_off(s, t) || lies_off(t, s))) return;
    come(i, s, t.first, t.from);
    come(i, s, t.last, t.to);
    come(j, t, s.first, s.from);
    come(j, t, s.last, s.to);
    Cell cell;
    if (joined || !crossing(s, t, cell)) return;
    const int place = static_cast<int>(places_.size());
    places_.push_back(cell);
    crossed_.push_back({i, place});
    crossed_.push_back({j, place});
  }

  // A cell where two cross lies in the boxes of both, so in that of each that comes into it.
  void meet_crossings() {
    if (crossed_.empty()) return;
    std::sort(crossed_.begin(), crossed_.end(),
              [](const Meeting& a, const Meeting& b) { return a.segment < b.segment; });
    std::vector<int> first(segments_.size() + 1);  // of each segment's in these
    for (const Meeting& own : crossed_) {
      ++first[own.segment + 1];
      come(own.segment, segments_[own.segment], own.place, places_[own.place]);
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    const auto come_of = [&, first = first.data()](int other, int segment) {
      for (int k = first[other], end = first[other + 1]; k < end; ++k) {
        const int place = crossed_[k].place;
        come(segment, segments_[segment], place, places_[place]);
      }
    };
    int last = -1;
    for (const auto& [i, j] : near_) {
      if (i != last) poll_cancel();
      last = i;
      come_of(i, j);
      come_of(j, i);
    }
  }

  std::vector<Cell>& places_;
  const std::vector<Segment>& segments_;
  std::vector<std::pair<int, int>> near_;  // their boxes meet
  std::vector<Meeting> crossed_, meetings_;
};

bool counter_clockwise(const std::vector<Cell>& ring) {
  Wide sum = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) sum += twice_area(ring[0], ring[i - 1], ring[i]);
  return sum > 0;
}

// A place in half steps, that is on no side of the ring.
bool holds(const std::vector<Cell>& ring, const Cell& place) {
  bool odd = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Cell &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const Cell a{2 * p.x, 2 * p.y}, b{2 * q.x, 2 * q.y};
    if ((a.y > place.y) == (b.y > place.y)) continue;
    odd ^= (twice_area(a, b, place) > 0) == (b.y > a.y);
  }
  return odd;
}

// The nodes that each segment passes, from its first place to its last.
class PassedNodes {
 public:
  void begin_segment(int node) {
    firsts_.push_back(nodes_.size());
    nodes_.push_back(node);
  }
  void go_on(int node) { nodes_.push_back(node); }

  template <class Use>
  void each_step(std::size_t segment, bool backwards, Use use) const {
    const std::size_t first = firsts_[segment],
                      end = segment + 1 < firsts_.size() ? firsts_[segment + 1] : nodes_.size();
    for (std::size_t i = first + 1; i < end; ++i) {
      const std::size_t k = backwards ? end + first - i : i;
      backwards ? use(nodes_[k], nodes_[k - 1]) : use(nodes_[k - 1], nodes_[k]);
    }
  }

 private:
  std::vector<std::size_t> firsts_;
  std::vector<int> nodes_;
};

// A ring that touches itself comes apart into rings that do not.
// `at` holds `nowhere` for each node.
constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();
std::vector<std::vector<int>> apart(const std::vector<int>& ring, std::vector<std::size_t>& at) {
  std::vector<std::vector<int>> rings;
  std::vector<int> open;
  open.reserve(ring.size());
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

Arrangement::Arrangement(const std::vector<LineView>& lines, Asked asked) {
  node(lines, asked);
  connect();
  walk();
  if (asked == Asked::places) place_walks();
}

Point Arrangement::on_grid(const GridCell& cell) const {
  return {origin_.x + cell.x * step_, origin_.y + cell.y * step_, 0};
}

void Arrangement::node(const std::vector<LineView>& lines, Asked asked) {
  Box box;
  for (const LineView& line : lines)
    for (const Point& p : line) box.add(p);
  const double farthest = std::max(
      {std::abs(box.min_x), std::abs(box.max_x), std::abs(box.min_y), std::abs(box.max_y), 1.0});
  // A power of two that doubles of this size hold, so that cells are places of their own.
  step_ = std::ldexp(1, std::max(-24, std::ilogb(farthest) - 51));
  origin_ = {std::floor(box.min_x), std::floor(box.min_y), 0};
  std::size_t count = 0;
  for (const LineView& line : lines) count += line.size();
  struct Vertex {
    Cell cell;
    int number;  // line by line
    const Point* point;
    bool operator<(const Vertex& o) const {
      return cell == o.cell ? number < o.number : cell < o.cell;
    }
  };
  std::vector<Vertex> vertices;
  vertices.reserve(count);
  for (const LineView& line : lines)
    for (const Point& p : line)
      vertices.push_back(
          {{std::llround((p.x - origin_.x) / step_), std::llround((p.y - origin_.y) / step_)},
           static_cast<int>(vertices.size()),
           &p});
  std::sort(vertices.begin(), vertices.end());
  std::vector<int> place_of(count);  // of each vertex; of several in one cell the first holds
  std::vector<Cell> places;
  std::vector<const Point*> points;
  places.reserve(count);
  points.reserve(count);
  for (const Vertex& vertex : vertices) {
    if (places.empty() || !(places.back() == vertex.cell)) {
      places.push_back(vertex.cell);
      points.push_back(vertex.point);
    }
    place_of[vertex.number] = static_cast<int>(places.size()) - 1;
  }
  std::vector<std::pair<int, int>> ends;
  ends.reserve(count);
  auto place = place_of.begin();
  for (const LineView& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i, ++place)
      if (i > 0) ends.push_back(std::minmax(place[-1], place[0]));
  sort_distinct(ends, places.size());
  std::vector<Segment> segments;
  segments.reserve(ends.size());
  for (const auto& [first, last] : ends) segments.emplace_back(places, first, last);
  const Meetings meetings(places, segments);
  const std::vector<int> node_of = number(places, points);
  std::vector<std::pair<int, int>> edges;
  std::vector<std::pair<Wide, int>> along;
  PassedNodes passed;
  edges.reserve(segments.size() + meetings.all().size());
  auto meeting = meetings.all().begin();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    int last = node_of[s.first];
    if (asked == Asked::ways) passed.begin_segment(last);
    if (meeting == meetings.all().end() || meeting->segment != static_cast<int>(i)) {
      if (s.first != s.last) edges.emplace_back(last, node_of[s.last]);
      if (s.first != s.last && asked == Asked::ways) passed.go_on(node_of[s.last]);
      continue;
    }
    const auto go_on = [&](int node) {
      if (node != last) edges.push_back(std::minmax(last, node));
      if (node != last && asked == Asked::ways) passed.go_on(node);
      last = node;
    };
    along.clear();
    for (; meeting != meetings.all().end() && meeting->segment == static_cast<int>(i); ++meeting) {
      const Cell& cell = places[meeting->place];
      along.emplace_back(Wide(s.to.x - s.from.x) * (cell.x - s.from.x) +
                             Wide(s.to.y - s.from.y) * (cell.y - s.from.y),
                         node_of[meeting->place]);
    }
    std::sort(along.begin(), along.end());
    for (const auto& [where, node] : along) go_on(node);
    go_on(node_of[s.last]);
  }
  sort_distinct(edges, nodes_.size());
  halves_.reserve(2 * edges.size());
  for (const auto& [a, b] : edges) {
    halves_.push_back({a, b});
    halves_.push_back({b, a});
  }
  if (asked == Asked::places) return;
  const auto append = [&](int from, int to) {
    const std::pair<int, int> pair = std::minmax(from, to);
    const auto edge = std::lower_bound(edges.begin(), edges.end(), pair) - edges.begin();
    way_sides_.push_back(2 * static_cast<int>(edge) + (from > to));
  };
  place = place_of.begin();
  for (const LineView& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i, ++place) {
      if (i == 0) continue;
      const std::pair<int, int> pair = std::minmax(place[-1], place[0]);
      const auto segment = std::lower_bound(ends.begin(), ends.end(), pair) - ends.begin();
      passed.each_step(segment, place[-1] > place[0], append);
    }
    ways_.push_back(static_cast<int>(way_sides_.size()));
  }
}

// The nodes in the order of their cells, and which one each place is. The first places are in that
// order and have points; the others lie where segments cross.
std::vector<int> Arrangement::number(const std::vector<Cell>& places,
                                     const std::vector<const Point*>& points) {
  std::vector<int> crossings(places.size() - points.size());
  std::iota(crossings.begin(), crossings.end(), static_cast<int>(points.size()));
  std::sort(crossings.begin(), crossings.end(),
            [&](int i, int j) { return places[i] < places[j]; });
  std::vector<int> node_of(places.size());
  nodes_.reserve(places.size());
  auto crossing = crossings.begin();
  for (std::size_t own = 0; own < points.size() || crossing != crossings.end();) {
    const bool next =
        crossing == crossings.end() || (own < points.size() && !(places[*crossing] < places[own]));
    const int place = next ? static_cast<int>(own++) : *crossing++;
    const Cell& cell = places[place];
    if (nodes_.empty() || !(nodes_.back().cell == cell))
      nodes_.push_back({cell, next ? planar(*points[place]) : on_grid(cell)});
    node_of[place] = static_cast<int>(nodes_.size()) - 1;
  }
  return node_of;
}

void Arrangement::connect() {
  const auto ahead = [&](int h) {
    const Cell &from = nodes_[halves_[h].from].cell, &to = nodes_[halves_[h].to].cell;
    return Cell{to.x - from.x, to.y - from.y};
  };
  const auto lower = [](const Cell& d) { return d.y < 0 || (d.y == 0 && d.x < 0); };
  std::vector<int> order(halves_.size());  // by node
  std::vector<int> last(nodes_.size() + 1);
  for (const Half& half : halves_) ++last[half.from + 1];
  std::partial_sum(last.begin(), last.end(), last.begin());
  for (std::size_t h = 0; h < halves_.size(); ++h)
    order[last[halves_[h].from]++] = static_cast<int>(h);
  around_.resize(halves_.size());
  for (std::size_t node = 0, first = 0; node < nodes_.size(); ++node) {
    const std::size_t end = last[node];
    // Counter-clockwise; two need no order.
    if (end - first > 2)
      std::sort(order.begin() + first, order.begin() + end, [&](int g, int h) {
        const Cell a = ahead(g), b = ahead(h);
        if (lower(a) != lower(b)) return lower(b);
        return side({0, 0}, a, b) > 0;
      });
    for (std::size_t i = first; i < end; ++i)
      around_[order[i]] = order[i == first ? end - 1 : i - 1];
    first = end;
  }
  for (std::size_t h = 0; h < halves_.size(); ++h) halves_[h].next = around_[h ^ 1];
}

void Arrangement::walk() {
  walked_.reserve(halves_.size());
  for (std::size_t start = 0; start < halves_.size(); ++start) {
    if (halves_[start].walk >= 0) continue;
    for (int h = static_cast<int>(start); halves_[h].walk < 0; h = halves_[h].next) {
      halves_[h].walk = static_cast<int>(walks_.size());
      walked_.push_back(h);
    }
    walks_.push_back(static_cast<int>(walked_.size()));
  }
}

Ring Arrangement::border(int walk) const {
  Ring ring;
  for (int i = walk > 0 ? walks_[walk - 1] : 0; i < walks_[walk]; ++i)
    ring.push_back(nodes_[halves_[walked_[i]].from].point);
  ring.push_back(ring.front());
  return ring;
}

MultiPolygon Arrangement::joined(const std::vector<bool>& kept, Vertices vertices) const {
  std::vector<char> borders(halves_.size()), used(halves_.size());  // by half
  for (std::size_t h = 0; h < halves_.size(); ++h)
    borders[h] = kept[halves_[h].walk] && !kept[halves_[h ^ 1].walk];
  std::vector<std::size_t> at(nodes_.size(), nowhere);
  std::vector<std::vector<Cell>> shells;
  std::vector<std::pair<Cell, Ring>> holes;  // with a place on the border, in half steps
  std::vector<int> ring;
  MultiPolygon out;
  for (int start = 0; start < static_cast<int>(halves_.size()); ++start) {
    if (used[start] || !borders[start]) continue;
    ring.clear();
    for (int h = start; !used[h];) {
      used[h] = true;
      ring.push_back(halves_[h].from);
      int next = halves_[h].next;
      while (!borders[next]) next = around_[next];
      h = next;
    }
    for (const std::vector<int>& part : apart(ring, at)) {
      if (part.size() < 3) continue;
      std::vector<Cell> cells;
      Ring points;
      cells.reserve(part.size());
      points.reserve(part.size() + 1);
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
    poll_cancel();
    const auto shell = std::find_if(by_size.begin(), by_size.end(),
                                    [&](std::size_t i) { return holds(shells[i], place); });
    if (shell != by_size.end()) out[*shell].push_back(std::move(hole));
  }
  MultiPolygon sorted;
  for (const std::size_t i : by_size) sorted.push_back(std::move(out[i]));
  return sorted;
}

}  // namespace streetgen
