// Where control points lead: to the next junction on their road, or to a place in mid-block.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "streetgen/control_point.hpp"
#include "streetgen/network.hpp"

namespace streetgen {

// Whether traffic runs along an edge, and against it.
struct EdgeWays {
  bool along = true, against = true;
  bool on_ring = false;  // of a roundabout
};

// What a control point speaks to.
struct ControlledEnds {
  // Ends of edges by which that traffic comes, 2 * edge + at end; of signals in mid-block those at
  // which they speak where they have no node of their own.
  std::vector<int> slots{};
  std::optional<int> junction{};  // the node of three and more edges on which the point lies
  bool mid_block = false;         // signals that are no junction's
};

// Signals of one axis that are one place in mid-block.
struct MidBlockSignals {
  std::int64_t axis_id = 0;
  double abscissa = 0;        // metres along the axis
  std::vector<int> points{};  // by their order
};

constexpr double on_node = 1.5;  // metres from a node within which a point lies on the node

// A signal, stop or yield sign belongs to the next node of three and more edges ahead of it, over
// nodes of two, as far as `farthest`.  Signals without one belong to the junction that their
// traffic left, as far behind as a queue before them would reach; else they stand in mid-block.
// So do signals of a crossing that is none of the junction's arms, where traffic would stop behind
// it, and signals beside a roundabout: they are the ring's at its very entry alone.
// Other points belong to the node of two edges on which they lie.  A point beyond its axis, or on
// an axis without an edge there, speaks to nobody.
class ControlReach {
 public:
  // `points`: all that stand on the edges.
  ControlReach(const Network& network, std::vector<EdgeWays> ways,
               const std::vector<ControlPoint>& points, const ControlRules& rules);

  ControlledEnds ends_of(const ControlPoint& point) const;

  // The nodes of two edges about a point within `farthest`, and the junctions behind them.
  std::vector<int> nodes_near(const ControlPoint& point) const;

  // Signals in mid-block as near to each other as a queue is long are one place: that of the
  // crossing for people on foot in their midst, else their middle.
  std::vector<MidBlockSignals> mid_block_signals(const std::vector<ControlPoint>& points) const;

  const std::vector<int>& slots_at(int node) const { return slots_[node]; }
  int node_of(int slot) const {
    const Edge& edge = edges_[slot / 2];
    return slot % 2 == 0 ? edge.from_node : edge.to_node;
  }
  const std::vector<int>& edges_of(std::int64_t axis_id) const;

  bool is_junction(int node) const { return slots_[node].size() > 2; }

  // The end by which one comes to the next junction who goes along an edge or against it, with so
  // many metres before him on that edge.
  struct Ahead {
    int slot = 0;
    double metres = 0;
  };
  std::optional<Ahead> junction_ahead(int edge, bool along, double metres, double farthest) const;

 private:
  struct Place {
    int edge = 0;
    double to_start = 0, to_end = 0;  // metres
  };
  std::vector<Place> places_of(const ControlPoint& point) const;
  bool has_end_near(const Place& place) const;
  void add_ends(const ControlPoint& point, const Place& place, ControlledEnds& found) const;
  void add_on_junction(const ControlPoint& point, int slot, ControlledEnds& found) const;
  void add_on_road(const ControlPoint& point, const Place& place, ControlledEnds& found) const;
  std::vector<bool> ways_spoken_to(const ControlPoint& point, const Place& place) const;
  std::optional<double> crossing_of(const ControlPoint& point) const;
  bool is_of_junction(const ControlPoint& point, const Place& place, bool along, const Ahead& node,
                      bool comes) const;

  const std::vector<Edge>& edges_;
  std::vector<EdgeWays> ways_;
  ControlRules rules_;
  std::vector<std::vector<int>> slots_;  // by node
  std::unordered_map<std::int64_t, std::vector<int>> of_axis_;
  std::unordered_map<std::int64_t, std::vector<double>> crossings_;  // by axis, metres along it
};

}  // namespace streetgen
