// Roads that stay up between crossings which follow each other.
#pragma once

#include <array>
#include <vector>

#include "height/height_line.hpp"
#include "streetgen/profile.hpp"

namespace streetgen {

struct LiftedPlace {
  int edge = 0;
  double at = 0;  // metres along it
};

// A part of an edge that lies at least so high.
struct Plateau {
  int edge = 0;
  HeightLine bound;
};

// Roads of edges that lead straight on through their nodes.
class ThroughRoads {
 public:
  explicit ThroughRoads(const std::vector<ProfileEdge>& edges);

  // Even lines between places that follow each other on a road nearer than `factor` times the way
  // on which it comes down from the lower one.
  std::vector<Plateau> plateaus(const std::vector<LiftedPlace>& places,
                                const std::vector<HeightLine>& heights,
                                const std::vector<HeightLine>& ground, double factor) const;

 private:
  struct End {
    int edge = -1;  // none
    bool at_start = true;
  };
  struct Piece {
    int edge;
    bool forward;
    double begin, end;  // metres along the road
  };

  void find_next();
  void follow(int edge);
  double on_road(const LiftedPlace& place) const;

  const std::vector<ProfileEdge>& edges_;
  std::vector<std::array<End, 2>> next_;  // what the start and the end of an edge lead on to
  std::vector<std::vector<Piece>> roads_;
  std::vector<int> road_;   // of each edge
  std::vector<int> piece_;  // of its road
};

}  // namespace streetgen
