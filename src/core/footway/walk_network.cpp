#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "footway/walk_nodes.hpp"
#include "geometry/box.hpp"
#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/walk_network.hpp"

namespace streetgen {

namespace {

constexpr double near_end = 0.5;  // metres; a crossing that is nearer to an end of a line is there

std::uint64_t mixed(std::uint64_t hash) {
  hash += 0x9e3779b97f4a7c15;
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111eb;
  return hash ^ (hash >> 31);
}

std::uint64_t mixed(std::uint64_t hash, const Point& p) {
  for (const double value : {p.x, p.y}) {
    std::uint64_t bits;
    const double plain = value + 0.0;  // no negative zero
    std::memcpy(&bits, &plain, sizeof bits);
    hash = mixed(hash ^ bits);
  }
  return hash;
}

std::int64_t positive(std::uint64_t hash) { return static_cast<std::int64_t>(hash >> 1); }

// A place of a line at which it is cut: on a segment, so far along it.
struct Cut {
  std::size_t segment;
  double along;
  Point place;
};

struct Foot {
  int line;
  Cut cut;
  double away;
};

class Network {
 public:
  explicit Network(const std::vector<WalkLine>& given) : given_(given), cuts_(given.size()) {
    for (const WalkLine& line : given) lines_.push_back(distinct(planar(line.line)));
    for (std::size_t l = 0; l < lines_.size(); ++l) {
      if (lines_[l].size() < 2) lines_[l].clear();
      for (std::size_t i = 1; i < lines_[l].size(); ++i) {
        index_.add(box_of(lines_[l][i - 1], lines_[l][i]), static_cast<int>(segments_.size()));
        segments_.push_back({static_cast<int>(l), i - 1});
      }
      for (const Point& p : lines_[l]) ++uses_[place_of(p)];
    }
  }

  std::vector<WalkLink> links() {
    cut_crossings();
    each_loose_end([&](int l, bool at_end) { cut_off(l, at_end); });
    each_loose_end([&](int l, bool at_end) { lead_on(l, at_end); });
    std::vector<WalkPiece> pieces;
    for (std::size_t l = 0; l < lines_.size(); ++l)
      if (!lines_[l].empty()) add_pieces(static_cast<int>(l), pieces);
    join_near_ends(pieces);
    return links_of(pieces);
  }

 private:
  using Segment = std::pair<int, std::size_t>;  // line, number

  void cut_crossings() {
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      poll_cancel();
      const auto [line, i] = segments_[s];
      if (given_[line].mapped) continue;
      index_.each_near(box_of(lines_[line][i], lines_[line][i + 1]), one_place, [&](int other) {
        const auto [beside, j] = segments_[other];
        // Two that are not mapped find each other twice.
        if (beside == line || given_[beside].level != given_[line].level ||
            (!given_[beside].mapped && static_cast<std::size_t>(other) < s))
          return;
        cut_where_both_meet(line, i, beside, j);
      });
    }
  }

  void cut_where_both_meet(int line, std::size_t i, int other, std::size_t j) {
    const Point &a = lines_[line][i], &b = lines_[line][i + 1];
    const Point &c = lines_[other][j], &d = lines_[other][j + 1];
    std::optional<Point> place = crossing(a, b, c, d);
    if (!place) place = touch(line, i, other, j);
    if (!place) return;
    const Point met = settled(*place, {&a, &b, &c, &d}, line, other);
    cut(line, i, met);
    cut(other, j, met);
  }

  // The end of one line on a segment of the other.
  std::optional<Point> touch(int line, std::size_t i, int other, std::size_t j) const {
    const auto end_beside = [&](const Line& ending, std::size_t segment, const Point& a,
                                const Point& b) -> std::optional<Point> {
      if (segment == 0 && distance_to_segment(ending.front(), a, b) < one_place)
        return ending.front();
      if (segment + 2 == ending.size() && distance_to_segment(ending.back(), a, b) < one_place)
        return ending.back();
      return std::nullopt;
    };
    const Line &first = lines_[line], &second = lines_[other];
    if (const auto end = end_beside(first, i, second[j], second[j + 1])) return end;
    return end_beside(second, j, first[i], first[i + 1]);
  }

  // The place itself, or an end or a vertex beside it.
  Point settled(const Point& place, std::array<const Point*, 4> vertices, int line,
                int other) const {
    const Point* nearest = nullptr;
    for (const int l : {line, other})
      for (const Point* end : {&lines_[l].front(), &lines_[l].back()})
        if (!nearest || distance(place, *end) < distance(place, *nearest)) nearest = end;
    if (distance(place, *nearest) < near_end) return *nearest;
    for (const Point* vertex : vertices)
      if (distance(place, *vertex) < one_place) return *vertex;
    return place;
  }

  void cut(int line, std::size_t segment, const Point& place) {
    cut_places_[place_of(place)] = true;
    if (same(place, lines_[line].front()) || same(place, lines_[line].back())) return;
    cuts_[line].push_back({segment, distance(lines_[line][segment], place), place});
  }

  bool is_node(const Point& p) const {
    const auto uses = uses_.find(place_of(p));
    return (uses != uses_.end() && uses->second > 1) || cut_places_.count(place_of(p)) > 0;
  }

  template <class Settle>
  void each_loose_end(Settle settle) {
    for (std::size_t l = 0; l < lines_.size(); ++l) {
      if (lines_[l].empty()) continue;
      if (!is_node(lines_[l].front())) settle(static_cast<int>(l), false);
      if (!is_node(lines_[l].back())) settle(static_cast<int>(l), true);
    }
  }

  void lead_on(int l, bool at_end) {
    const double reach = at_end ? given_[l].reach_end : given_[l].reach_start;
    if (reach <= 0 || ends_before_.count({l, at_end}) > 0) return;
    std::optional<Foot> foot = onwards_from(l, at_end, reach, true);
    // Steps and bridges of a source lead from level to level.
    if (!foot && given_[l].mapped) foot = onwards_from(l, at_end, reach, false);
    if (foot) {
      cut(foot->line, foot->cut.segment, foot->cut.place);
      led_on_[{l, at_end}] = foot->cut.place;
    }
  }

  // The nearest place on another line to which the line can be led on without turning back.
  std::optional<Foot> onwards_from(int l, bool at_end, double reach, bool on_its_level) const {
    const Line& line = lines_[l];
    const Point end = at_end ? line.back() : line.front();
    const Point runs = unit(end - (at_end ? line[line.size() - 2] : line[1]));
    std::optional<Foot> nearest;
    for (const int s : index_.near(box_of(end, end), reach)) {
      const auto [other, j] = segments_[s];
      if (other == l || (on_its_level && given_[other].level != given_[l].level)) continue;
      const Point &a = lines_[other][j], &b = lines_[other][j + 1];
      Point foot = nearest_on_segment(end, a, b);
      if (distance(foot, a) < one_place) foot = a;
      if (distance(foot, b) < one_place) foot = b;
      const double away = distance(end, foot);
      if (away > reach || (nearest && away >= nearest->away)) continue;
      if (away > one_place && dot(unit(foot - end), runs) < -0.5) continue;
      if (is_cut_off(other, {j, distance(a, foot), foot})) continue;
      nearest = Foot{other, {j, distance(a, foot), foot}, away};
    }
    return nearest;
  }

  // The piece beyond the last node before a loose end goes, where it is short.
  void cut_off(int l, bool at_end) {
    const double excess = at_end ? given_[l].excess_end : given_[l].excess_start;
    if (excess <= 0) return;
    const std::vector<Cut> nodes = nodes_along(l);
    if (nodes.size() < 3) return;
    const Cut& last = at_end ? nodes[nodes.size() - 2] : nodes[1];
    const double whole = length(lines_[l]), at = abscissa_of(l, last);
    if ((at_end ? whole - at : at) <= excess) ends_before_[{l, at_end}] = at;
  }

  bool is_cut_off(int l, const Cut& cut) const {
    const auto before = ends_before_.find({l, false}), after = ends_before_.find({l, true});
    return (before != ends_before_.end() && abscissa_of(l, cut) < before->second) ||
           (after != ends_before_.end() && abscissa_of(l, cut) > after->second);
  }

  double abscissa_of(int l, const Cut& cut) const {
    double along = cut.along;
    for (std::size_t i = 1; i <= cut.segment; ++i)
      along += distance(lines_[l][i - 1], lines_[l][i]);
    return along;
  }

  // Cuts and vertices that are nodes, with both ends, along the line.
  std::vector<Cut> nodes_along(int l) const {
    const Line& line = lines_[l];
    std::vector<Cut> nodes = cuts_[l];
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
      if (is_node(line[i])) nodes.push_back({i, 0, line[i]});
    nodes.push_back({0, 0, line.front()});
    nodes.push_back({line.size() - 2, distance(line[line.size() - 2], line.back()), line.back()});
    std::sort(nodes.begin(), nodes.end(), [](const Cut& a, const Cut& b) {
      return std::pair(a.segment, a.along) < std::pair(b.segment, b.along);
    });
    const auto same_node = [](const Cut& a, const Cut& b) { return same(a.place, b.place); };
    nodes.erase(std::unique(nodes.begin(), nodes.end(), same_node), nodes.end());
    return nodes;
  }

  void add_pieces(int l, std::vector<WalkPiece>& pieces) const {
    std::vector<Cut> nodes = nodes_along(l);
    if (const auto cut = ends_before_.find({l, false}); cut != ends_before_.end())
      while (nodes.size() > 1 && abscissa_of(l, nodes.front()) < cut->second)
        nodes.erase(nodes.begin());
    if (const auto cut = ends_before_.find({l, true}); cut != ends_before_.end())
      while (nodes.size() > 1 && abscissa_of(l, nodes.back()) > cut->second) nodes.pop_back();
    std::vector<Line> lines;
    for (std::size_t n = 1; n < nodes.size(); ++n)
      lines.push_back(between(lines_[l], nodes[n - 1], nodes[n]));
    for (const bool at_end : {false, true}) add_way_on(l, at_end, lines);
    for (Line& line : lines) {
      line = distinct(std::move(line));
      if (line.size() > 1) pieces.push_back({l, given_[l].level, std::move(line)});
    }
  }

  // A piece that two lines share is the first one's.
  static std::vector<WalkLink> links_of(std::vector<WalkPiece>& pieces) {
    std::vector<WalkLink> links;
    std::set<std::int64_t> known;
    std::map<int, int> parts;  // by line
    for (WalkPiece& piece : pieces) {
      WalkLink link;
      link.line = piece.line;
      link.geometry = std::move(piece.geometry);
      name(link);
      if (!known.insert(link.id).second) continue;
      link.part = ++parts[link.line];
      links.push_back(std::move(link));
    }
    for (WalkLink& link : links) link.parts = parts[link.line];
    return links;
  }

  // A piece of its own where others were led on to the end as well.
  void add_way_on(int l, bool at_end, std::vector<Line>& pieces) const {
    const auto place = led_on_.find({l, at_end});
    if (place == led_on_.end() || pieces.empty()) return;
    Line& line = at_end ? pieces.back() : pieces.front();
    const Point end = at_end ? line.back() : line.front();
    if (is_node(end))
      pieces.insert(at_end ? pieces.end() : pieces.begin(),
                    at_end ? Line{end, place->second} : Line{place->second, end});
    else
      line.insert(at_end ? line.end() : line.begin(), place->second);
  }

  static Line between(const Line& line, const Cut& from, const Cut& to) {
    Line piece{from.place};
    for (std::size_t i = from.segment + 1; i <= to.segment; ++i)
      if (!same(line[i], piece.back())) piece.push_back(line[i]);
    piece.push_back(to.place);
    return piece;
  }

  static void name(WalkLink& link) {
    link.from_node = positive(mixed(0, link.geometry.front()));
    link.to_node = positive(mixed(0, link.geometry.back()));
    std::uint64_t hash = 1;
    for (const Point& p : link.geometry) hash = mixed(hash, p);
    link.id = positive(hash);
  }

  const std::vector<WalkLine>& given_;
  std::vector<Line> lines_;
  std::vector<Segment> segments_;
  BoxIndex index_;  // of segments
  std::map<Place, int> uses_;
  std::map<Place, bool> cut_places_;
  std::vector<std::vector<Cut>> cuts_;                  // by line
  std::map<std::pair<int, bool>, Point> led_on_;        // by line and end
  std::map<std::pair<int, bool>, double> ends_before_;  // the same, metres along the line
};

}  // namespace

std::vector<WalkLink> walk_network(const std::vector<WalkLine>& lines) {
  return Network(lines).links();
}

}  // namespace streetgen
