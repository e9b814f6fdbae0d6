#include "nearest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double noise = 1e-6;      // metres
constexpr double beyond = 1;        // metres
constexpr double chord_off = 1e-3;  // metres: from its parabola
constexpr double infinite = std::numeric_limits<double>::infinity();

using Segments = std::vector<std::pair<Point, Point>>;

// Ends of segments that meet come out of each a little different.
void join_ends(Segments& segments) {
  std::vector<Point*> ends;
  for (auto& [from, to] : segments) ends.insert(ends.end(), {&from, &to});
  std::sort(ends.begin(), ends.end(), [](const Point* p, const Point* q) { return p->x < q->x; });
  for (std::size_t k = 0; k < ends.size(); ++k)
    for (std::size_t l = k; l-- > 0 && ends[k]->x - ends[l]->x <= 2 * noise;)
      if (std::abs(ends[k]->y - ends[l]->y) <= 2 * noise) *ends[k] = *ends[l];
  segments.erase(
      std::remove_if(segments.begin(), segments.end(),
                     [](const auto& segment) { return same(segment.first, segment.second); }),
      segments.end());
}

// A place as near to both owners lies no farther than the corner farthest from any of their axes.
double reach_within(const Box& box, const std::vector<Straight>& first,
                    const std::vector<Straight>& second, double reach) {
  double square = reach * reach;
  for (const auto* pieces : {&first, &second})
    for (const Straight& piece : *pieces)
      square = std::min(square, box.farthest_square(piece.start));
  return std::sqrt(square) + beyond;
}

std::vector<Straight> near(const std::vector<Straight>& pieces, const Box& box, double reach) {
  std::vector<Straight> out;
  for (const Straight& piece : pieces)
    if (piece.box().meets(box, reach)) out.push_back(piece);
  return out;
}

}  // namespace

NearestOwner::Axes::Axes(std::vector<Straight> all) : pieces(std::move(all)) {
  std::vector<Box> boxes;
  boxes.reserve(2 * pieces.size());
  for (const Straight& piece : pieces) boxes.push_back(piece.box());
  index = BoxRuns(std::move(boxes));
}

double NearestOwner::Axes::square_from(const Point& p) const {
  const int nearest = index.nearest(p, [&](int i) { return pieces[i].square_from(p); });
  return nearest < 0 ? infinite : pieces[nearest].square_from(p);
}

NearestOwner::NearestOwner(const std::vector<Straight>& of_leader,
                           const std::vector<Straight>& of_other, const Point& origin,
                           const Box& within, double reach)
    : origin_(origin),
      within_{within.min_x - origin.x, within.min_y - origin.y, within.max_x - origin.x,
              within.max_y - origin.y},
      reach_(reach_within(within_, of_leader, of_other, reach)),
      leader_(near(of_leader, within_, reach_)),
      other_(apart(near(of_other, within_, reach_), leader_.pieces, leader_.index)) {}

bool NearestOwner::leader_owns(const Point& place) const {
  const Point p = planar(place - origin_);
  return leader_.square_from(p) <= other_.square_from(p);
}

void NearestOwner::append_border(Front& front, const Box& base, Segments& border) const {
  other_.index.any_near(base, 2 * reach_, [&](std::size_t i) {
    front.meet(other_.pieces[i], true);
    return false;
  });
  const double farthest = front.farthest();
  if (farthest == 0) return;
  leader_.index.any_near(base, 2 * farthest, [&](std::size_t i) {
    front.meet(leader_.pieces[i], false);
    return false;
  });
  front.append_met(chord_off, within_.grown(beyond), border);
}

// Outwards from all that is the leader's.
Segments NearestOwner::border() const {
  Segments border;
  if (other_.pieces.empty()) return border;
  struct End {
    Point point, direction;
  };
  std::vector<End> ends;
  for (const Straight& piece : leader_.pieces) {
    poll_cancel();
    for (const bool left : {true, false}) {
      Front front = Front::beside(piece, left, reach_);
      append_border(front, piece.box(), border);
    }
    ends.push_back({piece.start, piece.along});
    ends.push_back({piece.end, piece.along * -1});
  }
  std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    return std::pair(a.point.x, a.point.y) < std::pair(b.point.x, b.point.y);
  });
  std::vector<Point> directions;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    directions.push_back(ends[i].direction);
    if (i + 1 < ends.size() && same(ends[i].point, ends[i + 1].point)) continue;
    poll_cancel();
    if (auto front = Front::beyond(ends[i].point, directions, reach_))
      append_border(*front, box_of(ends[i].point, ends[i].point), border);
    directions.clear();
  }
  join_ends(border);
  for (auto& [from, to] : border) {
    from = origin_ + from;
    to = origin_ + to;
  }
  return border;
}

}  // namespace streetgen
