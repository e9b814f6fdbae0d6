#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "geometry/box.hpp"
#include "geometry/box_index.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/footway.hpp"

namespace streetgen {

namespace {

constexpr double step = 2;      // metres along a footway from one look at the sides to the next
constexpr double gap = 6;       // metres along an edge that part two stretches
constexpr double slack = 1e-6;  // metres
// Metres from its ends in which a footway that comes nearer to the kerb leads to a crossing.
constexpr double approach = 10;

// The sides of one edge, beside a place of a footway.
class EdgeBeside {
 public:
  EdgeBeside(const Line& line, const Point& place, const Point& direction, double reach) {
    double along = 0, nearest = reach;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Point foot = nearest_on_segment(place, line[i - 1], line[i]);
      const double away = distance(planar(place), planar(foot));
      if (away < nearest) {
        nearest = away;
        abscissa_ = along + distance(planar(line[i - 1]), planar(foot));
        const Point runs = unit(line[i] - line[i - 1]);
        offset_ = cross(runs, place - foot) >= 0 ? away : -away;
        turn_ = std::abs(cross(runs, direction));
        // Beyond the ends of the edge nothing lies beside it.
        const double onwards = dot(runs, planar(place - foot));
        found_ = !(i == 1 && onwards < -slack) && !(i + 1 == line.size() && onwards > slack);
      }
      along += distance(planar(line[i - 1]), planar(line[i]));
    }
    length_ = along;
  }

  // Nothing where the place is not beside that side, or the footway runs elsewhere.
  std::optional<SidePlace> side(const StreetSide& side, const FootwayMatch& match) const {
    if (!found_ || turn_ > std::sin(match.direction)) return std::nullopt;
    const double at = length_ > 0 ? abscissa_ / length_ : 0;
    const double kerb = side.kerb_at_start + at * (side.kerb_at_end - side.kerb_at_start);
    const double behind = (side.left ? offset_ : -offset_) - kerb;
    const double within = std::min(match.in_roadway, std::max(kerb, 0.0) / 2);
    if (behind > match.distance || behind < -within) return std::nullopt;
    return SidePlace{abscissa_, behind};
  }

 private:
  bool found_ = false;
  double abscissa_ = 0, offset_ = 0, turn_ = 1, length_ = 0;
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// A place of a footway, and what lies beside it.
struct Look {
  SidePlace beside;
  double to_end = 0;  // metres along the footway to its nearer end
};

// The least places between which all others lie within the tolerance, by distance.
void append_course(const std::vector<SidePlace>& places, std::size_t from, std::size_t to,
                   double tolerance, std::vector<SidePlace>& course) {
  const auto& [start, first] = places[from];
  const auto& [end, last] = places[to];
  std::size_t farthest = from;
  double most = tolerance;
  for (std::size_t i = from + 1; i < to; ++i) {
    const double share = end > start ? (places[i].abscissa - start) / (end - start) : 0;
    const double off = std::abs(places[i].distance - (first + (last - first) * share));
    if (off > most) {
      most = off;
      farthest = i;
    }
  }
  if (farthest == from) {
    course.push_back(places[to]);
    return;
  }
  append_course(places, from, farthest, tolerance, course);
  append_course(places, farthest, to, tolerance, course);
}

// The sidewalk of a footway that leads to a crossing at its end stays as wide as before.
void keep_away_at_ends(std::vector<Look>& looks) {
  const double reach =
      std::min(approach, (looks.back().beside.abscissa - looks.front().beside.abscissa) / 2);
  const auto keep = [&](auto from, auto to) {
    if (from->to_end > step) return;
    const double end = from->beside.abscissa;
    const auto away = [&](const Look& look) {
      return std::abs(look.beside.abscissa - end) >= reach;
    };
    const auto kept = std::find_if(from, to, away);
    for (auto look = from; look != kept; ++look)
      look->beside.distance = std::max(look->beside.distance, kept->beside.distance);
  };
  keep(looks.begin(), looks.end());
  keep(looks.rbegin(), looks.rend());
}

std::vector<SidePlace> course_of(std::vector<Look> looks, double distance, double tolerance) {
  keep_away_at_ends(looks);
  std::vector<SidePlace> places;
  for (const Look& look : looks) places.push_back(look.beside);
  std::vector<SidePlace> course{places.front()};
  append_course(places, 0, places.size() - 1, tolerance, course);
  if (std::all_of(course.begin(), course.end(), [&](const SidePlace& place) {
        return std::abs(place.distance - distance) <= tolerance;
      }))
    course.clear();
  return course;
}

class SourceFinder {
 public:
  SourceFinder(const std::vector<LevelLine>& edges, const std::vector<StreetSide>& sides,
               const std::vector<LevelLine>& footways, const FootwayMatch& match)
      : edges_(edges), sides_(sides), footways_(footways), match_(match), sides_of_(edges.size()) {
    std::vector<double> reach(edges.size());
    for (std::size_t s = 0; s < sides.size(); ++s) {
      sides_of_[sides[s].edge].push_back(static_cast<int>(s));
      reach[sides[s].edge] =
          std::max({reach[sides[s].edge], sides[s].kerb_at_start, sides[s].kerb_at_end});
    }
    for (std::size_t e = 0; e < edges.size(); ++e) {
      reach[e] += match.distance;
      Box box;
      for (const Point& p : edges[e].line) box.add(p);
      boxes_.push_back(box.grown(reach[e]));
      if (!sides_of_[e].empty()) index_.add(boxes_.back(), static_cast<int>(e));
    }
    reach_ = std::move(reach);
  }

  std::vector<SidewalkSource> find() {
    for (std::size_t f = 0; f < footways_.size(); ++f) {
      const Line line = planar(footways_[f].line);
      const double whole = length(line);
      double before = 0;
      for (std::size_t i = 1; i < line.size(); ++i) {
        poll_cancel();
        look_along(static_cast<int>(f), line[i - 1], line[i], before, whole);
        before += distance(line[i - 1], line[i]);
      }
    }
    std::vector<SidewalkSource> sources;
    for (auto& [key, looks] : beside_) add_stretches(key.first, key.second, looks, sources);
    return sources;
  }

 private:
  // Looks from the middles of equal pieces of the segment, where it passes the box of an edge: they
  // are the same whichever edges there are.
  void look_along(int footway, const Point& from, const Point& to, double before, double whole) {
    const double length = distance(from, to);
    if (length == 0) return;
    const double looks = std::ceil(length / step);
    const Point direction = unit(to - from);
    index_.each_near(box_of(from, to), 0, [&](int e) {
      if (edges_[e].level != footways_[footway].level) return;
      const auto [enters, leaves] = passage(from, to, boxes_[e]);
      for (double n = std::max(0.0, std::floor(enters * looks));
           n < looks && (n + 0.5) / looks <= leaves; ++n)
        look(footway, e, from + (to - from) * ((n + 0.5) / looks), direction,
             std::min(before + length * ((n + 0.5) / looks),
                      whole - before - length * ((n + 0.5) / looks)));
    });
  }

  // As shares of the segment; the second is the smaller one where it passes by.
  static std::pair<double, double> passage(const Point& from, const Point& to, const Box& box) {
    double enters = 0, leaves = 1;
    const auto clip = [&](double start, double run, double low, double high) {
      if (run == 0) {
        if (start < low || start > high) leaves = -1;
        return;
      }
      const double one = (low - start) / run, other = (high - start) / run;
      enters = std::max(enters, std::min(one, other));
      leaves = std::min(leaves, std::max(one, other));
    };
    clip(from.x, to.x - from.x, box.min_x, box.max_x);
    clip(from.y, to.y - from.y, box.min_y, box.max_y);
    return {enters, leaves};
  }

  void look(int footway, int e, const Point& place, const Point& direction, double to_end) {
    const EdgeBeside beside(edges_[e].line, place, direction, reach_[e]);
    for (const int s : sides_of_[e])
      if (const std::optional<SidePlace> found = beside.side(sides_[s], match_))
        beside_[{s, footway}].push_back({*found, to_end});
  }

  void add_stretches(int side, int footway, std::vector<Look>& looks,
                     std::vector<SidewalkSource>& sources) const {
    std::sort(looks.begin(), looks.end(), [](const Look& a, const Look& b) {
      return std::pair(a.beside.abscissa, a.beside.distance) <
             std::pair(b.beside.abscissa, b.beside.distance);
    });
    for (std::size_t from = 0, to; from < looks.size(); from = to) {
      std::vector<double> distances{looks[from].beside.distance};
      for (to = from + 1;
           to < looks.size() && looks[to].beside.abscissa - looks[to - 1].beside.abscissa < gap;
           ++to)
        distances.push_back(looks[to].beside.distance);
      const double start = looks[from].beside.abscissa, end = looks[to - 1].beside.abscissa;
      if (end <= start) continue;
      const double middle = median(std::move(distances));
      sources.push_back({side, footway, start, end, middle,
                         course_of({looks.begin() + static_cast<std::ptrdiff_t>(from),
                                    looks.begin() + static_cast<std::ptrdiff_t>(to)},
                                   middle, match_.straight)});
    }
  }

  const std::vector<LevelLine>& edges_;
  const std::vector<StreetSide>& sides_;
  const std::vector<LevelLine>& footways_;
  const FootwayMatch& match_;
  std::vector<std::vector<int>> sides_of_;  // by edge
  std::vector<double> reach_;               // by edge: metres to the farthest footway beside it
  std::vector<Box> boxes_;                  // by edge, with its reach
  BoxIndex index_;                          // of them
  std::map<std::pair<int, int>, std::vector<Look>> beside_;  // by side and footway
};

}  // namespace

std::vector<SidewalkSource> sidewalk_sources(const std::vector<LevelLine>& edges,
                                             const std::vector<StreetSide>& sides,
                                             const std::vector<LevelLine>& footways,
                                             const FootwayMatch& match) {
  return SourceFinder(edges, sides, footways, match).find();
}

}  // namespace streetgen
