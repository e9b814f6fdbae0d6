#include "kerb/free_border.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "geometry/polyline.hpp"
#include "geometry/tolerance.hpp"

namespace streetgen {

namespace {

// The part of a to b that c to d lies on, as shares of its length and as points.
struct Common {
  double first, last;
  Point from, to;
};
std::optional<Common> common(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point along = b - a;
  const double square = dot(along, along);
  if (square == 0) return std::nullopt;
  double t = dot(c - a, along) / square, u = dot(d - a, along) / square;
  Point at_t = c, at_u = d;
  if (t > u) {
    std::swap(t, u);
    std::swap(at_t, at_u);
  }
  const double first = std::max(t, 0.0), last = std::min(u, 1.0);
  const double size = (last - first) * std::sqrt(square);
  if (size <= same_place) return std::nullopt;
  const double apart = size > coordinate_margin ? crack : same_place;
  const auto on_other = [&](double share) {
    return at_t + (at_u - at_t) * ((share - t) / (u - t));
  };
  const Point from = on_other(first), to = on_other(last);
  if (distance(from, a + along * first) > apart || distance(to, a + along * last) > apart)
    return std::nullopt;
  return Common{first, last, from, to};
}

// Shorter pieces where sharing begins and ends are noise of borders computed in two ways.
void join_crumbs(BorderLoop& loop) {
  const auto shared =
      std::find_if(loop.begin(), loop.end(), [](const BorderPiece& piece) { return piece.shared; });
  if (shared == loop.end()) return;
  std::rotate(loop.begin(), shared, loop.end());
  const auto is_crumb = [](const BorderPiece& piece) {
    return !piece.shared && distance(piece.from, piece.to) <= 2 * same_place;
  };
  // The end of a crack.
  for (std::size_t i = 1; i < loop.size(); ++i)
    if (const BorderPiece& next = loop[(i + 1) % loop.size()];
        loop[i - 1].shared && next.shared && distance(loop[i].from, loop[i].to) <= crack)
      loop[i].shared = true;
  for (std::size_t i = 1; i < loop.size(); ++i)
    if (is_crumb(loop[i])) {
      loop[i].shared = loop[i - 1].shared;
      loop[i].joins_level = loop[i - 1].joins_level;
    }
  for (std::size_t i = loop.size(); i-- > 0;)
    if (loop[(i + 1) % loop.size()].shared && is_crumb(loop[i])) loop[i].shared = true;
}

// A border that goes to and fro within a millimetre shares itself there, and takes nothing from
// the kerb, which goes on at the place where it left.
void drop_spikes(BorderLoop& loop) {
  const auto free = std::find_if(loop.begin(), loop.end(),
                                 [](const BorderPiece& piece) { return !piece.shared; });
  if (free == loop.end()) return;
  std::rotate(loop.begin(), free, loop.end());
  BorderLoop kept;
  for (std::size_t i = 0; i < loop.size();) {
    std::size_t next = i;
    double length = 0;
    for (; next < loop.size() && loop[next].shared; ++next)
      length += distance(loop[next].from, loop[next].to);
    const bool is_spike =
        next > i && length <= 2 * coordinate_margin && same(loop[i].from, loop[next - 1].to);
    if (is_spike)
      i = next;
    else
      kept.push_back(loop[i++]);
  }
  loop = std::move(kept);
}

}  // namespace

bool lie_along(const Point& a, const Point& b, const Point& c, const Point& d) {
  return common(a, b, c, d).has_value();
}

FreeBorder::FreeBorder(const MultiPolygon& surface) : box_(box_of(surface)) {
  std::vector<Box> boxes;
  for (const Polygon& polygon : surface)
    for (const Ring& ring : polygon) {
      for (std::size_t i = ring.size(); i-- > 1;) {
        sides_.push_back(&ring[i]);
        boxes.push_back(box_of(ring[i - 1], ring[i]));
      }
      ring_ends_.push_back(sides_.size());
    }
  boxes_ = BoxHierarchy(std::move(boxes));
}

bool FreeBorder::lies_along(const Point& from, const Point& to) const {
  return boxes_.any_near(box_of(from, to), crack, [&](std::size_t i) {
    return lie_along(side(i).first, side(i).second, from, to);
  });
}

void FreeBorder::share_with(const MultiPolygon& neighbour, bool other_level) {
  std::vector<std::size_t> near;
  for (const Polygon& polygon : neighbour)
    for (const Ring& ring : polygon)
      for (std::size_t k = 1; k < ring.size(); ++k) {
        const Point &from = ring[k - 1], &to = ring[k];
        const Box box = box_of(from, to);
        if (!box_.meets(box, crack)) continue;
        near.clear();
        // A side that is there twice lies on no other one, also at the tip of a needle.
        const bool is_twice = boxes_.any_near(box, crack, [&](std::size_t i) {
          near.push_back(i);
          return same(side(i).first, from) && same(side(i).second, to);
        });
        if (is_twice) near.erase(near.begin(), near.end() - 1);
        const std::size_t before = stretches_.size();
        for (const std::size_t i : near) add_shared(i, from, to, other_level);
        if (stretches_.size() > before + 1) keep_longest(before, to - from);
      }
}

void FreeBorder::share_with_itself() {
  // Once only: a needle of ground between two sides has a border where a neighbour shares one of
  // them, and where the ring goes to and fro over some micrometres one of the three sides is it.
  for (std::size_t k = 0; k < sides_.size(); ++k)
    boxes_.any_near(boxes_[k], crack, [&](std::size_t i) {
      if (i <= k) return false;
      const std::size_t before = stretches_.size();
      add_shared(i, side(k).second, side(k).first, false);
      add_shared(k, side(i).second, side(i).first, false);
      const auto fresh = stretches_.begin() + before;
      if (stretches_.end() - fresh < 2 ||
          std::any_of(fresh, stretches_.end(),
                      [&](const Stretch& stretch) { return is_shared(stretch, before); }))
        stretches_.erase(fresh, stretches_.end());
      return false;
    });
}

// The stretches from the first on lie on one side of a neighbour. Where two of them lie on each
// other, another side of the neighbour lies between, and that side is left the shorter one.
void FreeBorder::keep_longest(std::size_t first, const Point& along) {
  const auto begin = stretches_.begin() + first;
  const auto span = [&](const Stretch& stretch) { return dot(stretch.to - stretch.from, along); };
  std::sort(begin, stretches_.end(),
            [&](const Stretch& a, const Stretch& b) { return span(a) > span(b); });
  auto kept = begin;
  for (auto next = begin; next != stretches_.end(); ++next) {
    const Point middle = (next->from + next->to) * 0.5;
    if (std::none_of(begin, kept, [&](const Stretch& longer) {
          return dot(middle - longer.from, along) > 0 && dot(longer.to - middle, along) > 0;
        }))
      *kept++ = *next;
  }
  stretches_.erase(kept, stretches_.end());
}

// Whether one of the first stretches covers the middle of another one.
bool FreeBorder::is_shared(const Stretch& stretch, std::size_t first) const {
  const double middle = (stretch.first + stretch.last) / 2;
  return std::any_of(stretches_.begin(), stretches_.begin() + first, [&](const Stretch& other) {
    return other.side == stretch.side && !other.other_level && other.first <= middle &&
           middle <= other.last;
  });
}

void FreeBorder::add_shared(std::size_t i, const Point& from, const Point& to, bool other_level) {
  const auto [own_from, own_to] = side(i);
  // Sides with ground on one and the same hand are two borders of a strip thinner than a place.
  if (dot(own_to - own_from, to - from) <= 0) return;
  if (const auto found = common(own_from, own_to, from, to))
    stretches_.push_back({i, found->first, found->last, found->from, found->to, other_level});
}

void FreeBorder::share_with_claim(const MultiPolygon& neighbour) {
  share_with(neighbour, false);
  const PreparedSurface claim(neighbour);
  std::vector<double> at;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    if (!claim.box().meets(boxes_[i], crack)) continue;
    const auto [from, to] = side(i);
    const Point along = to - from, beyond = left_normal(unit(along)) * crack;
    at = {0, 1};
    claim.cut(from, to, at);
    std::sort(at.begin(), at.end());
    for (std::size_t k = 1; k < at.size(); ++k)
      if (claim.holds(from + along * ((at[k - 1] + at[k]) / 2) + beyond))
        stretches_.push_back(
            {i, at[k - 1], at[k], from + along * at[k - 1], from + along * at[k], false});
  }
}

void FreeBorder::append_pieces(std::size_t i, const Stretch* first, const Stretch* last,
                               BorderLoop& loop) const {
  const auto [from, to] = side(i);
  if (first == last) {
    if (!same(from, to)) loop.push_back({from, to});
    return;
  }
  struct Cut {
    double at;
    Point point;
  };
  std::vector<Cut> cuts;
  for (const Stretch* s = first; s != last; ++s) {
    cuts.push_back({s->first, s->from});
    cuts.push_back({s->last, s->to});
  }
  std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.at < b.at; });
  const double size = distance(from, to);
  Cut before{0, from};
  const auto cut_at = [&](const Cut& cut) {
    const double middle = (before.at + cut.at) / 2;
    BorderPiece piece{before.point, cut.point};
    for (const Stretch* s = first; s != last; ++s)
      if (s->first <= middle && middle <= s->last)
        (s->other_level ? piece.joins_level : piece.shared) = true;
    loop.push_back(piece);
    before = cut;
  };
  for (const Cut& cut : cuts)
    if ((cut.at - before.at) * size > same_place && (1 - cut.at) * size > same_place) cut_at(cut);
  cut_at({1, to});
}

std::vector<BorderLoop> FreeBorder::loops() const {
  std::vector<Stretch> stretches = stretches_;
  std::sort(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) {
    return std::tie(a.side, a.first, a.last) < std::tie(b.side, b.first, b.last);
  });
  std::vector<BorderLoop> loops;
  const Stretch* next = stretches.data();
  const Stretch* const end = next + stretches.size();
  for (std::size_t i = 0, ring = 0; ring < ring_ends_.size(); ++ring) {
    BorderLoop loop;
    for (; i < ring_ends_[ring]; ++i) {
      const Stretch* const first = next;
      while (next != end && next->side == i) ++next;
      append_pieces(i, first, next, loop);
    }
    join_crumbs(loop);
    drop_spikes(loop);
    if (!loop.empty()) loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace streetgen
