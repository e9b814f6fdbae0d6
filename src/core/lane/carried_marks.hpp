// Turn marks that hold beyond their edge, to the junction that they are about.
#pragma once

#include <optional>
#include <vector>

#include "lane/lane_wishes.hpp"
#include "streetgen/network.hpp"

namespace streetgen {

// An edge as traffic of one direction drives on it.
struct DrivenEdge {
  int edge = 0;
  bool along_axis = true;
};

// Over a node of two edges traffic takes the marks of its lanes along, lane by lane, where the next
// edge has none of its own in that direction.  A mark to merge ends with its lane.  Where lanes
// begin, those beside a lane that turns to their side take the turn, and one that goes on elsewhere
// too leaves it to them; others begin without marks.  A turn that no way answers at a node of more
// edges is meant for the next one: the lane takes it straight on along an edge as short as one
// within a junction.
class CarriedMarks {
 public:
  // All are kept as long as this.
  CarriedMarks(const Network& network, const std::vector<Roadway>& roadways,
               const LaneWishes& wishes, const LaneSettings& settings);

  // Marks lanes of an edge, which are as the wishes have them.
  void carry(int edge, std::vector<LaneWish>& lanes) const;

  // Whether it has lanes, and these no marks of its source.
  bool may_carry(const DrivenEdge& driven) const {
    return open_[number(driven)] && !has_own(driven);
  }
  // Whether its lanes have marks that come from elsewhere.
  bool carries(const DrivenEdge& driven) const;

 private:
  using Marks = std::vector<unsigned>;  // of the lanes of a direction, from left to right

  static std::size_t number(const DrivenEdge& driven) {
    return 2 * static_cast<std::size_t>(driven.edge) + (driven.along_axis ? 0 : 1);
  }
  // From where the lanes of an edge get their marks, and the turns that traffic takes before.
  struct Source {
    DrivenEdge from;
    unsigned answered = 0;
    bool crossing = false;  // over a node of more than two edges
  };
  bool has_own(const DrivenEdge& driven) const { return own_[number(driven)]; }
  std::optional<Source> source(const DrivenEdge& driven) const;
  std::optional<Source> source_across(const DrivenEdge& driven,
                                      const std::vector<EdgeEnd>& ends) const;
  std::optional<EdgeEnd> straight(const EdgeEnd& from, bool onwards,
                                  const std::vector<EdgeEnd>& ends) const;
  double angle(const EdgeEnd& from, const EdgeEnd& to) const;
  const Marks& marks_of(DrivenEdge driven) const;
  Marks carried(const Source& source, const DrivenEdge& to) const;

  const Network& network_;
  const std::vector<Roadway>& roadways_;
  const LaneWishes& wishes_;
  const LaneSettings& settings_;
  bool any_;                                         // whether any edge has marks
  std::vector<bool> own_, open_;                     // by number: it has marks, it has lanes
  std::vector<std::vector<EdgeEnd>> ends_;           // by node
  mutable std::vector<std::optional<Marks>> known_;  // by number
};

}  // namespace streetgen
