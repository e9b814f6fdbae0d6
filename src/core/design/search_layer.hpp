// One layer of the search of a path: a grid of cells with headings and heights over ground.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "design/curve_room.hpp"
#include "design/section_cost.hpp"
#include "streetgen/road_design.hpp"

namespace streetgen {

// The grid lies along the straight line between both ends: the first is a cell, and so is the last.
struct SearchGrid {
  Point origin, along;  // along: unit vector to the last place
  double cell = 0;      // metres
  int last = 0;         // column of the last place
  int margin_x = 0, margin_y = 0;

  int columns() const { return last + 2 * margin_x + 1; }
  int rows() const { return 2 * margin_y + 1; }
  Point place(int column, int row) const {
    const double u = (column - margin_x) * cell, v = (row - margin_y) * cell;
    return {origin.x + along.x * u - along.y * v, origin.y + along.y * u + along.x * v, 0};
  }
};

// The sides before the first place and behind the last one, so that the turns there fit.
struct SidesAbout {
  struct Side {
    double heading = 0, length = 0;
  };
  std::optional<Side> before, behind;
};

// A bar that is not looked at, to find out what bars a way.
struct Waiver {
  bool zones = false, grade = false;
};

class SearchLayer {
 public:
  // `corridor` holds whether a cell may be used, row by row; empty: all.
  SearchLayer(const DesignSite& site, const SearchGrid& grid, std::vector<bool> corridor,
              Waiver waiver);
  // Places of the path of least cost with their heights; none where there is no way.
  std::optional<Line> search(const SidesAbout& about);

 private:
  struct Move {
    int column, row;
    double length, heading;
  };
  struct Sample {
    double ground, cross_slope;
    const ZoneClass* zone;
  };
  struct Queued {
    float total;  // cost so far and the least that is left
    std::uint32_t state;
    bool operator<(const Queued& other) const { return total > other.total; }
  };
  void make_moves();
  void read_ground();
  std::uint32_t moves_beside(const std::optional<SidesAbout::Side>& side) const;
  void expand(std::uint32_t cell, int level, std::uint32_t moves, double so_far,
              std::uint8_t parent);
  bool sample_side(const Point& from, const Point& to, double length);
  double side_cost(double from, double to, double length) const;
  void reach_state(std::uint32_t cell, int level, int heading, double cost, std::uint8_t parent);
  double bound(std::uint32_t cell) const;
  Line traced(std::uint32_t state) const;
  int cell_at(int column, int row) const;

  const DesignSite& site_;
  SearchGrid grid_;
  Waiver waiver_;
  SectionCost section_;
  double sample_;
  int last_ = -1;  // cell of the last place
  std::vector<Move> moves_;
  std::vector<std::uint32_t> turns_;     // by move: the moves that may follow
  std::vector<std::int32_t> number_;     // of a cell among those that may be used, -1: none
  std::vector<std::uint32_t> position_;  // of a numbered cell on the grid
  std::vector<float> ground_;
  std::vector<float> cost_;           // by state
  std::vector<std::uint8_t> parent_;  // of a state: heading and level it comes from
  std::vector<std::uint32_t> done_;   // by cell and level: moves that were tried
  std::vector<Queued> queue_;
  std::vector<Sample> samples_;  // along the side that is looked at
};

}  // namespace streetgen
