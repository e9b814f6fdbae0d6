// Where the strips behind kerbs that follow each other end.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "strip/kerb_front.hpp"

namespace streetgen {

// Behind each segment a straight line from one width to the other. It goes on to that of the next
// segment, and round about an outer bend; lines that others leave no room for are left out.
class BackLine {
 public:
  // Of the segments that `passed` says.
  BackLine(const std::vector<KerbSegment>& segments, const FrontPassed& passed, bool is_closed);

  struct Place {
    Point point;
    int before = 0;      // the vertex of the back line before it
    int way_before = 0;  // the vertex of the way
  };
  // Where a way from a kerb meets it first; `segment` is beside its start.
  std::optional<Place> meeting(const Line& way, int segment) const;
  // Whether the line goes back along a kerb there: they differ by over 120 degrees.
  bool faces(const Place& place, const Point& along) const;
  // What lies between two places.
  Line between(const Place& from, const Place& to) const;

 private:
  int count() const { return static_cast<int>(line_.size()); }
  // Where a way crosses what follows a vertex.
  Point crossing(const Point& from, const Point& ahead, int vertex) const;

  Line line_;
  std::vector<int> segment_of_;                   // that a vertex lies behind
  std::vector<std::pair<Point, Point>> side_of_;  // the line behind it, as long as the segment;
                                                  // within a bend the vertex twice
  bool is_closed_;
};

// From a kerb to the back line, or to where other kerbs lie behind it; `first` and `last` are its
// segments. Empty: that is no ring. It may cross itself.
Ring ring_behind(const Line& kerb, const KerbGround& ground, const BackLine& back, int first,
                 int last);

}  // namespace streetgen
