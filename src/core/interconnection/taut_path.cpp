#include "interconnection/taut_path.hpp"

#include <algorithm>

#include "geometry/polyline.hpp"
#include "interconnection/guided_path.hpp"
#include "interconnection/path_choice.hpp"
#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

// Metres.
constexpr double leads[] = {8, 4, 2, 1};         // that a path keeps straight on at its ends
constexpr double widths[] = {40, 20, 10, 6, 3};  // of its arcs
constexpr double sample = 3, beside = 8;         // along a piece; from it to an edge inside
constexpr double lengthwise = 0.7;               // cosine of headings that are of one direction
constexpr double detour = 5;                     // metres for one against traffic
constexpr std::size_t most_places = 400;  // beyond it, a search costs more than a path is worth

class Search {
 public:
  Search(const JunctionPlace& place, const Kerbs& kerbs, int from, int to, double clearance)
      : place_(place),
        kerbs_(kerbs),
        from_(from),
        to_(to),
        // Pieces between places along a round kerb come a little nearer to it.
        clearance_(0.8 * clearance),
        bulges_(kerbs.bulges(clearance)) {}

  // The shortest way of straight pieces.
  std::optional<Line> between(const Point& start, const Point& goal) const {
    if (bulges_.size() > most_places) return std::nullopt;
    std::vector<Point> places{start, goal};
    places.insert(places.end(), bulges_.begin(), bulges_.end());
    constexpr double far = infinite;
    std::vector<double> way(places.size(), far);
    std::vector<std::size_t> before(places.size(), 0);
    std::vector<bool> done(places.size(), false);
    way[0] = 0;
    while (true) {
      std::size_t at = 0;
      double least = far;
      for (std::size_t i = 0; i < places.size(); ++i) {
        const double whole = way[i] + distance(places[i], goal);
        if (!done[i] && whole < least) least = whole, at = i;
      }
      if (least == far) return std::nullopt;
      if (at == 1) break;
      done[at] = true;
      poll_cancel();
      for (std::size_t i = 1; i < places.size(); ++i) {
        if (done[i] || way[at] + distance(places[at], places[i]) >= way[i] ||
            !sees(places[at], places[i]))
          continue;
        const double longer = way[at] + cost(places[at], places[i]);
        if (longer >= way[i]) continue;
        way[i] = longer;
        before[i] = at;
      }
    }
    Line line{goal};
    for (std::size_t i = 1; i != 0;) {
      i = before[i];
      line.push_back(places[i]);
    }
    return reversed(std::move(line));
  }

 private:
  bool sees(const Point& a, const Point& b) const {
    return !kerbs_.stop({a, b}, from_, to_, clearance_);
  }

  // A metre against the traffic of the nearest edge inside counts for several.
  double cost(const Point& a, const Point& b) const {
    const double size = distance(a, b);
    const int parts = std::max(1, static_cast<int>(size / sample));
    double spent = 0;
    for (int i = 0; i < parts; ++i)
      spent += size / parts * (against(a + (b - a) * ((i + 0.5) / parts), b - a) ? detour : 1);
    return spent;
  }

  bool against(const Point& at, const Point& heading) const {
    double nearest = beside;
    bool found = false;
    for (const InnerEdge& edge : place_.inner)
      for (std::size_t i = 1; i < edge.line.size(); ++i) {
        const Point start = planar(edge.line[i - 1]), end = planar(edge.line[i]);
        const double off = distance_to_segment(at, start, end);
        if (off >= nearest) continue;
        nearest = off;
        const double along = dot(unit(end - start), unit(heading));
        found = (along > lengthwise && edge.along.none()) ||
                (along < -lengthwise && edge.against.none());
      }
    return found;
  }

  const JunctionPlace& place_;
  const Kerbs& kerbs_;
  int from_, to_;
  double clearance_;
  std::vector<Point> bulges_;
};

}  // namespace

std::optional<Line> taut_path(const JunctionPlace& place, const Kerbs& kerbs, int from, int to,
                              const LaneEnd& in, const LaneEnd& out, double tolerance) {
  for (const double clearance : {half_car, half_car / 3}) {
    const Search search(place, kerbs, from, to, clearance);
    for (const double lead : leads) {
      const std::optional<Line> way =
          search.between(in.place + in.direction * lead, out.place - out.direction * lead);
      if (!way) continue;
      Line guide{in.place};
      guide.insert(guide.end(), way->begin(), way->end());
      guide.push_back(out.place);
      for (const double widest : widths) {
        Line path = rounded(guide, widest, tolerance);
        if (!kerbs.stop(path, from, to) && drivable(path)) return path;
      }
    }
  }
  return std::nullopt;
}

}  // namespace streetgen
