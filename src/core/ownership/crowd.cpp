#include "ownership/crowd.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/arrangement.hpp"
#include "geometry/border_stretches.hpp"
#include "geometry/crumb.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/progress.hpp"

namespace streetgen {

namespace {

constexpr double side_of_square = 10;    // metres
constexpr std::int64_t looked_into = 8;  // squares a side, from which on boxes alone do not tell

GridCell cell_at(double x, double y) {
  return {std::llround(std::floor(x / side_of_square)),
          std::llround(std::floor(y / side_of_square))};
}

// Squares side by side, the last ones not included.
struct Block {
  GridCell first, end;

  Box box() const {
    return {first.x * side_of_square, first.y * side_of_square, end.x * side_of_square,
            end.y * side_of_square};
  }
  std::int64_t side() const { return std::max(end.x - first.x, end.y - first.y); }
  std::pair<Block, Block> halves() const {
    Block low = *this, high = *this;
    if (end.x - first.x > end.y - first.y)
      low.end.x = high.first.x = first.x + (end.x - first.x) / 2;
    else
      low.end.y = high.first.y = first.y + (end.y - first.y) / 2;
    return {low, high};
  }
};

class Search {
 public:
  Search(const std::vector<Box>& boxes, std::size_t most,
         const std::function<bool(int, const Box&)>& comes_into)
      : boxes_(boxes), most_(most), comes_into_(comes_into) {}

  std::vector<Crowd> all() {
    std::vector<int> members;
    Box whole;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (boxes_[i].min_x > boxes_[i].max_x) continue;
      members.push_back(static_cast<int>(i));
      whole = whole.joined_with(boxes_[i]);
    }
    if (members.size() > most_) {
      const GridCell last = cell_at(whole.max_x, whole.max_y);
      look({cell_at(whole.min_x, whole.min_y), {last.x + 1, last.y + 1}}, std::move(members));
    }
    return std::move(found_);
  }

 private:
  void look(const Block& block, std::vector<int> members) {
    poll_cancel();
    const Box box = block.box();
    const bool near = block.side() <= looked_into;
    members.erase(std::remove_if(members.begin(), members.end(),
                                 [&](int i) {
                                   return !boxes_[i].meets(box) || (near && !comes_into_(i, box));
                                 }),
                  members.end());
    if (members.size() <= most_) return;
    if (block.side() == 1) {
      found_.push_back({box, std::move(members)});
      return;
    }
    const auto [low, high] = block.halves();
    look(low, members);
    look(high, std::move(members));
  }

  const std::vector<Box>& boxes_;
  const std::size_t most_;
  const std::function<bool(int, const Box&)>& comes_into_;
  std::vector<Crowd> found_;
};

MultiPolygon square_of(const Box& box) {
  return {{{{box.min_x, box.min_y},
            {box.max_x, box.min_y},
            {box.max_x, box.max_y},
            {box.min_x, box.max_y},
            {box.min_x, box.min_y}}}};
}

// What of the ground the surface claims, and the rest, with common vertices.
struct Parts {
  MultiPolygon claimed, rest;
};
Parts parted(MultiPolygon ground, const MultiPolygon& surface, const PreparedSurface& claim) {
  const PreparedSurface whole(ground);
  if (!claim.box().meets(whole.box())) return {{}, std::move(ground)};
  std::vector<LineView> lines;
  append_rings(ground, lines);
  const auto near = [&](const Point& from, const Point& to) {
    return box_of(from, to).meets(whole.box());
  };
  append_stretches(surface, near, lines);
  const Arrangement faces(lines);
  std::vector<bool> claimed, rest;
  for (const Point& place : faces.places()) {
    const bool held = whole.holds(place), taken = held && claim.holds(place);
    claimed.push_back(taken);
    rest.push_back(held && !taken);
  }
  constexpr auto on_grid = Arrangement::Vertices::on_grid;
  Parts parts{without_crumbs(faces.joined(claimed, on_grid)), {}};
  parts.rest =
      parts.claimed.empty() ? std::move(ground) : without_crumbs(faces.joined(rest, on_grid));
  return parts;
}

// Who gets what of the squares.
class Shares {
 public:
  explicit Shares(const std::vector<Claim>& claims) : claims_(claims) {
    grounds_.reserve(claims.size());
    for (const Claim& claim : claims) grounds_.emplace_back(*claim.surface);
  }

  bool comes_into(int claim, const Box& box) const {
    const MultiPolygon square = square_of(box);
    return overlap(grounds_[claim], PreparedSurface(square));
  }
  std::vector<Box> boxes() const {
    std::vector<Box> boxes;
    for (const PreparedSurface& ground : grounds_) boxes.push_back(ground.box());
    return boxes;
  }

  void share_out(const Crowd& crowd) {
    std::vector<int> ranked = crowd.members;
    std::sort(ranked.begin(), ranked.end(),
              [&](int i, int j) { return before(claims_[i], claims_[j]); });
    std::map<int, MultiPolygon> left;  // by level
    std::vector<std::pair<int, MultiPolygon>> given;
    for (const int i : ranked) {
      poll_cancel();
      const Claim& claim = claims_[i];
      MultiPolygon& free = left.try_emplace(claim.level, square_of(crowd.square)).first->second;
      auto& share = shares_[i][cell_at((crowd.square.min_x + crowd.square.max_x) / 2,
                                       (crowd.square.min_y + crowd.square.max_y) / 2)];
      if (free.empty()) continue;
      Parts parts = parted(std::move(free), *claim.surface, grounds_[i]);
      // Of another level, but tiling with it.
      bool lost = false;
      MultiPolygon own = parts.claimed;
      for (const auto& [other, ground] : given) {
        if (claims_[other].level == claim.level || !tile(claims_[other], claim)) continue;
        own = parted(std::move(own), ground, PreparedSurface(ground)).rest;
        lost = true;
      }
      if (lost) {
        MultiPolygon all = std::move(parts.rest);
        all.insert(all.end(), parts.claimed.begin(), parts.claimed.end());
        parts.rest =
            own.empty() ? std::move(all) : parted(std::move(all), own, PreparedSurface(own)).rest;
      }
      free = std::move(parts.rest);
      if (own.empty()) continue;
      share = own;
      given.emplace_back(i, std::move(own));
    }
  }

  std::map<int, MultiPolygon> left(Geos& geos) const {
    std::map<int, MultiPolygon> left;
    for (const auto& [claim, shares] : shares_) {
      poll_cancel();
      tell_progress("crowds", left.size(), shares_.size());
      left.emplace(claim, left_of(geos, claim, shares));
    }
    return left;
  }

 private:
  using BySquare = std::map<GridCell, MultiPolygon>;

  MultiPolygon left_of(Geos& geos, int claim, const BySquare& shares) const {
    std::vector<MultiPolygon> squares;
    std::map<GridCell, PreparedSurface> held;
    std::vector<LineView> lines;
    append_rings(*claims_[claim].surface, lines);
    squares.reserve(shares.size());
    for (const auto& [cell, share] : shares) {
      squares.push_back(square_of(Block{cell, {cell.x + 1, cell.y + 1}}.box()));
      append_rings(squares.back(), lines);
      append_rings(share, lines);
      held.emplace(cell, share);
    }
    const Arrangement faces(lines);
    std::vector<bool> kept;
    for (const Point& place : faces.places()) {
      const auto found = held.find(cell_at(place.x, place.y));
      kept.push_back(found == held.end() ? grounds_[claim].holds(place)
                                         : found->second.holds(place));
    }
    MultiPolygon rest = without_crumbs(faces.joined(kept));
    if (geos.valid(rest)) return rest;
    return without_crumbs(faces.joined(kept, Arrangement::Vertices::on_grid));
  }

  const std::vector<Claim>& claims_;
  std::vector<PreparedSurface> grounds_;
  std::map<int, BySquare> shares_;  // by claim; an empty one where others took all
};

}  // namespace

std::vector<Crowd> crowds(const std::vector<Box>& boxes, std::size_t most,
                          const std::function<bool(int, const Box&)>& comes_into) {
  return Search(boxes, most, comes_into).all();
}

std::map<int, MultiPolygon> left_by_crowds(Geos& geos, const std::vector<Claim>& claims,
                                           std::size_t most) {
  if (claims.size() <= most) return {};
  Shares shares(claims);
  for (const Crowd& crowd : crowds(shares.boxes(), most, [&](int claim, const Box&box) {
         return shares.comes_into(claim, box);
       }))
    shares.share_out(crowd);
  return shares.left(geos);
}

}  // namespace streetgen
