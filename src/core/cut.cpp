#include "cut.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "overlap.hpp"
#include "polyline.hpp"

namespace streetgen {

namespace {

constexpr double on_it = 1e-7;              // metres
constexpr double adds_up = 5e-5;            // square metres
constexpr std::size_t most_pairs = 250000;  // of segments

enum class Lies { unknown, inside, outside, same, opposite };

// A directed piece of a boundary, the surface on its left.
struct Piece {
  int from = 0, to = 0;
  Lies lies = Lies::unknown;
};

struct Segment {
  int from = 0, to = 0;
  Box box;
  std::vector<std::pair<double, int>> splits{};  // where along it, and the vertex
};

using Loop = std::vector<Segment>;

class Cutter {
 public:
  Cutter(const MultiPolygon& a, const MultiPolygon& b) : surface_{&a, &b} {
    box_[0] = box_of(a);
    box_[1] = box_of(b);
  }

  std::optional<Cut> run() {
    if (!box_[0].meets(box_[1], 0)) return Cut{{}, *surface_[0]};
    name_vertices();
    if (count_[0] * count_[1] > most_pairs) return std::nullopt;
    split();
    for (const int of : {0, 1})
      for (const Loop& loop : loops_[of])
        if (!add_pieces(loop, of)) return std::nullopt;
    for (const int of : {0, 1}) close_slits(of);
    find_common();
    for (const int of : {0, 1})
      if (!place(of)) return std::nullopt;
    std::vector<Piece> shared, rest;
    for (const std::vector<Piece>& ring : pieces_[0])
      for (const Piece& p : ring) {
        if (p.lies == Lies::inside || p.lies == Lies::same) shared.push_back(p);
        if (p.lies == Lies::outside || p.lies == Lies::opposite) rest.push_back(p);
      }
    for (const std::vector<Piece>& ring : pieces_[1])
      for (const Piece& p : ring)
        if (p.lies == Lies::inside) {
          shared.push_back(p);
          rest.push_back({p.to, p.from, p.lies});
        }
    Cut cut;
    if (!link(shared, cut.shared) || !link(rest, cut.rest)) return std::nullopt;
    if (std::abs(area(cut.shared) + area(cut.rest) - area(*surface_[0])) > adds_up)
      return std::nullopt;
    return cut;
  }

 private:
  // About a near origin differences of coordinates are exact.
  Point at(int vertex) const { return vertices_[vertex] - origin_; }

  // Of vertices in one place the first stands for all.
  void name_vertices() {
    origin_ = {box_[0].min_x, box_[0].min_y, 0};
    for (const int of : {0, 1})
      for (const Polygon& polygon : *surface_[of])
        for (const Ring& ring : polygon)
          for (std::size_t i = 0; i + 1 < ring.size(); ++i) vertices_.push_back(planar(ring[i]));
    const int size = static_cast<int>(vertices_.size());
    std::vector<int> order(size), name(size);
    std::iota(order.begin(), order.end(), 0);
    std::iota(name.begin(), name.end(), 0);
    std::sort(order.begin(), order.end(), [&](int i, int j) {
      return vertices_[i].x != vertices_[j].x ? vertices_[i].x < vertices_[j].x : i < j;
    });
    for (int k = 0; k < size; ++k)
      for (int l = k + 1; l < size && vertices_[order[l]].x - vertices_[order[k]].x <= on_it; ++l)
        if (distance(vertices_[order[k]], vertices_[order[l]]) <= on_it) {
          const int first = std::min(name[order[k]], name[order[l]]);
          name[order[k]] = name[order[l]] = first;
        }
    in_.assign(size, 0);
    named_ = size;
    int next = 0;
    for (const int of : {0, 1}) {
      for (const Polygon& polygon : *surface_[of])
        for (const Ring& ring : polygon) {
          Loop loop;
          const int begin = next, points = static_cast<int>(ring.size()) - 1;
          next += points;
          for (int i = 0; i < points; ++i) {
            const int from = name[begin + i], to = name[begin + (i + 1) % points];
            in_[from] |= 1 << of;
            if (from != to)
              loop.push_back({from, to, streetgen::box_of(vertices_[from], vertices_[to])});
          }
          count_[of] += loop.size();
          loops_[of].push_back(std::move(loop));
        }
    }
  }

  void split() {
    std::vector<Segment*> near;
    for (Loop& loop : loops_[1])
      for (Segment& segment : loop)
        if (segment.box.meets(box_[0], on_it)) near.push_back(&segment);
    for (Loop& loop : loops_[0])
      for (Segment& s : loop) {
        if (!s.box.meets(box_[1], on_it)) continue;
        for (Segment* t : near)
          if (s.box.meets(t->box, on_it)) meet(s, *t);
      }
  }

  void meet(Segment& s, Segment& t) {
    const Point p = at(s.from), q = at(s.to), r = at(t.from), e = at(t.to);
    const Point u = q - p, v = e - r;
    const double nu = norm(u), nv = norm(v);
    const double of_r = cross(u, r - p) / nu, of_e = cross(u, e - p) / nu;
    const double of_p = cross(v, p - r) / nv, of_q = cross(v, q - r) / nv;
    const auto touches = [](Segment& on, const Point& start, const Point& along, double size,
                            double aside, const Point& place, int vertex) {
      if (std::abs(aside) > on_it || vertex == on.from || vertex == on.to) return false;
      const double share = dot(along, place - start) / (size * size);
      if (share <= 0 || share >= 1) return false;
      on.splits.emplace_back(share, vertex);
      return true;
    };
    bool touched = touches(s, p, u, nu, of_r, r, t.from);
    touched |= touches(s, p, u, nu, of_e, e, t.to);
    touched |= touches(t, r, v, nv, of_p, p, s.from);
    touched |= touches(t, r, v, nv, of_q, q, s.to);
    if (touched ||
        std::min({std::abs(of_r), std::abs(of_e), std::abs(of_p), std::abs(of_q)}) <= on_it ||
        of_r * of_e > 0 || of_p * of_q > 0)
      return;
    const double share = of_p / (of_p - of_q);
    const int vertex = crossing(origin_ + p + u * share);
    s.splits.emplace_back(share, vertex);
    t.splits.emplace_back(of_r / (of_r - of_e), vertex);
  }

  // Crossings in one place are one.
  int crossing(const Point& place) {
    const auto found =
        std::find_if(vertices_.begin() + named_, vertices_.end(), [&](const Point& p) {
          return std::abs(p.x - place.x) <= on_it && distance(p, place) <= on_it;
        });
    if (found == vertices_.end()) {
      vertices_.push_back(place);
      in_.push_back(3);
      return static_cast<int>(vertices_.size()) - 1;
    }
    return static_cast<int>(found - vertices_.begin());
  }

  bool add_pieces(const Loop& loop, int of) {
    std::vector<Piece> ring;
    for (const Segment& segment : loop) {
      std::vector<std::pair<double, int>> splits = segment.splits;
      std::sort(splits.begin(), splits.end());
      int from = segment.from;
      const auto go = [&](int to) {
        if (to == from) return true;
        if (distance(vertices_[from], vertices_[to]) <= on_it) return false;
        ring.push_back({from, to});
        from = to;
        return true;
      };
      for (const auto& [share, vertex] : splits) {
        in_[vertex] = 3;
        if (!go(vertex)) return false;
      }
      if (!go(segment.to)) return false;
    }
    pieces_[of].push_back(std::move(ring));
    return true;
  }

  // Parts that lie nearer to each other than can be told are one: what runs there and back goes.
  void close_slits(int of) {
    std::vector<Piece*> all;
    for (std::vector<Piece>& ring : pieces_[of])
      for (Piece& piece : ring) all.push_back(&piece);
    const auto ends = [](const Piece* p) {
      return std::pair(std::min(p->from, p->to), std::max(p->from, p->to));
    };
    std::stable_sort(all.begin(), all.end(),
                     [&](const Piece* p, const Piece* q) { return ends(p) < ends(q); });
    bool closed = false;
    for (std::size_t k = 1; k < all.size(); ++k) {
      Piece &p = *all[k - 1], &q = *all[k];
      if (p.from != q.to || p.to != q.from) continue;
      in_[p.from] = in_[p.to] = 3;
      p.to = p.from;
      q.to = q.from;
      closed = true;
    }
    if (!closed) return;
    for (std::vector<Piece>& ring : pieces_[of])
      ring.erase(
          std::remove_if(ring.begin(), ring.end(), [](const Piece& p) { return p.from == p.to; }),
          ring.end());
  }

  // Pieces of both boundaries, in one direction or against each other.
  void find_common() {
    const auto both = [&](const Piece& p) { return in_[p.from] == 3 && in_[p.to] == 3; };
    std::vector<Piece*> candidates;
    for (std::vector<Piece>& ring : pieces_[1])
      for (Piece& p : ring)
        if (both(p)) candidates.push_back(&p);
    for (std::vector<Piece>& ring : pieces_[0])
      for (Piece& p : ring) {
        if (!both(p)) continue;
        for (Piece* other : candidates) {
          if (other->from == p.from && other->to == p.to) p.lies = other->lies = Lies::same;
          if (other->from == p.to && other->to == p.from) p.lies = other->lies = Lies::opposite;
        }
      }
  }

  // A chain between two places where the boundaries meet lies on one side: that of its longest
  // piece.
  bool place(int of) {
    for (std::vector<Piece>& ring : pieces_[of]) {
      const std::size_t size = ring.size();
      std::size_t start = 0;
      while (start < size && in_[ring[start].from] != 3) ++start;
      if (start == size) start = 0;
      for (std::size_t done = 0; done < size;) {
        Piece& first = ring[(start + done) % size];
        if (first.lies != Lies::unknown) {
          ++done;
          continue;
        }
        std::size_t last = done + 1;
        while (last < size && in_[ring[(start + last) % size].from] != 3) ++last;
        const Piece* longest = &first;
        for (std::size_t i = done; i < last; ++i) {
          const Piece& piece = ring[(start + i) % size];
          if (size_of(piece) > size_of(*longest)) longest = &piece;
        }
        const Lies lies = side(*longest, 1 - of);
        if (lies == Lies::unknown) return false;
        for (; done < last; ++done) ring[(start + done) % size].lies = lies;
      }
    }
    return true;
  }

  double size_of(const Piece& piece) const {
    return distance(vertices_[piece.from], vertices_[piece.to]);
  }

  Lies side(const Piece& piece, int of) const {
    const Point middle = (vertices_[piece.from] + vertices_[piece.to]) * 0.5;
    if (!box_[of].holds(middle, 0)) return Lies::outside;
    bool odd = false;
    for (const Polygon& polygon : *surface_[of]) {
      for (const Ring& ring : polygon)
        for (std::size_t i = 1; i < ring.size(); ++i)
          if (streetgen::box_of(ring[i - 1], ring[i]).holds(middle, on_it) &&
              distance_to_segment(middle, ring[i - 1], ring[i]) <= on_it)
            return Lies::unknown;
      odd ^= inside(middle, polygon);
    }
    return odd ? Lies::inside : Lies::outside;
  }

  // Rings of the pieces: where several go on, the one next to the ground on the left.
  bool link(const std::vector<Piece>& pieces, MultiPolygon& out) const {
    std::vector<std::vector<int>> leaving(vertices_.size());
    std::vector<int> balance(vertices_.size(), 0);
    for (int i = 0; i < static_cast<int>(pieces.size()); ++i) {
      leaving[pieces[i].from].push_back(i);
      ++balance[pieces[i].from];
      --balance[pieces[i].to];
    }
    if (std::any_of(balance.begin(), balance.end(), [](int b) { return b != 0; })) return false;
    std::vector<bool> used(pieces.size(), false);
    std::vector<Ring> holes;
    for (int first = 0; first < static_cast<int>(pieces.size()); ++first) {
      if (used[first]) continue;
      std::vector<int> walked;  // vertices
      int piece = first;
      do {
        if (used[piece]) return false;
        used[piece] = true;
        const auto before = std::find(walked.begin(), walked.end(), pieces[piece].from);
        if (before != walked.end()) {
          add_ring({before, walked.end()}, out, holes);
          walked.erase(before, walked.end());
        }
        walked.push_back(pieces[piece].from);
        piece = next(pieces, leaving[pieces[piece].to], piece);
      } while (piece != first);
      add_ring(walked, out, holes);
    }
    return place_holes(std::move(holes), out);
  }

  int next(const std::vector<Piece>& pieces, const std::vector<int>& leaving, int piece) const {
    if (leaving.size() == 1) return leaving.front();
    const Point back = at(pieces[piece].from) - at(pieces[piece].to);
    int best = leaving.front();
    double least = 10;
    for (const int other : leaving) {
      const Point on = at(pieces[other].to) - at(pieces[other].from);
      // Clockwise from the way back.
      double turn = std::atan2(cross(on, back), dot(on, back));
      if (turn <= 0) turn += 2 * M_PI;
      if (turn >= least) continue;
      least = turn;
      best = other;
    }
    return best;
  }

  void add_ring(const std::vector<int>& walked, MultiPolygon& out, std::vector<Ring>& holes) const {
    Ring ring;
    for (const int vertex : walked) ring.push_back(vertices_[vertex]);
    ring.push_back(ring.front());
    const double size = signed_area(ring);
    if (size > 0) out.push_back({std::move(ring)});
    if (size < 0) holes.push_back(std::move(ring));
  }

  static bool place_holes(std::vector<Ring> holes, MultiPolygon& out) {
    const std::size_t shells = out.size();
    for (Ring& hole : holes) {
      std::size_t i = 0;
      const Point inner = (hole[0] + hole[1]) * 0.5;
      if (shells > 1)
        while (i < shells && !inside(inner, {out[i].front()})) ++i;
      if (i >= shells) return false;
      out[i].push_back(std::move(hole));
    }
    return true;
  }

  const MultiPolygon* surface_[2];
  Box box_[2];
  Point origin_;
  std::vector<Point> vertices_;
  int named_ = 0;  // of them; crossings come after
  std::vector<int>
      in_;  // by vertex: bit 0 on the boundary of the first surface, bit 1 of the second
  std::size_t count_[2] = {0, 0};
  std::vector<Loop> loops_[2];
  std::vector<std::vector<Piece>> pieces_[2];
};

}  // namespace

std::optional<Cut> cut(const MultiPolygon& surface, const MultiPolygon& by) {
  return Cutter(surface, by).run();
}

}  // namespace streetgen
