// The ground that each sidewalk gets of what several kerbs want.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "geometry/arrangement.hpp"
#include "geometry/box_index.hpp"
#include "geometry/geos.hpp"
#include "geometry/prepared_surface.hpp"
#include "geometry/voronoi_border.hpp"
#include "sidewalk/strip.hpp"

namespace streetgen {

// The kerbs must outlive it unchanged.
class SharedGround {
 public:
  SharedGround(const std::vector<SidewalkKerb>& kerbs, const KerbChains& chains,
               const std::vector<Strip>& strips);

  // The kerbs that want part of the ground of one, or bound it, ascending.
  std::vector<int> rivals(int kerb) const;
  // The part of its strip that no roadway holds and no other kerb that wants it is nearer to.
  MultiPolygon ground_of(int kerb, const std::vector<int>& rivals);

 private:
  struct Side {
    int kerb;
    int segment;
  };
  bool bounds(int kerb, const Side& side) const;
  bool bounds(int kerb, int other) const;
  bool parted_before(int kerb, int other) const;
  bool on_roadway(const Point& place, int kerb) const;
  const Point* ends_of(const Side& side) const { return &kerbs_[side.kerb].line[side.segment - 1]; }
  bool left_of(const Point& place, const Side& side) const;
  std::vector<int> in_order_of_place(std::vector<int> kerbs) const;
  void append_kerbs(int kerb, std::vector<LineView>& lines) const;
  const VoronoiBorder& border_between(int kerb, int other);

  const std::vector<SidewalkKerb>& kerbs_;
  const KerbChains& chains_;
  const std::vector<Strip>& strips_;
  std::vector<PreparedSurface> grounds_;
  std::vector<Side> sides_;
  std::vector<Box> boxes_;  // of sides
  BoxIndex side_index_, ground_index_;
  std::map<std::pair<int, int>, VoronoiBorder> borders_;
  Geos geos_;
};

}  // namespace streetgen
