#include "interconnection/kerb_clear_path.hpp"

#include <algorithm>
#include <utility>

#include "geometry/offset.hpp"
#include "geometry/polyline.hpp"

namespace streetgen {

namespace {

constexpr double sharpest = 64;  // the least tangents are this part of the longest

// Both end where they first cross.
void end_at_crossing(Line& in, Line& out) {
  for (std::size_t i = 1; i < in.size(); ++i)
    for (std::size_t o = 1; o < out.size(); ++o)
      if (const auto place = crossing(in[i - 1], in[i], out[o - 1], out[o])) {
        in.resize(i);
        in.push_back(*place);
        out.resize(o);
        out.push_back(*place);
        return;
      }
}

// The place where the path parts from the lane, `reach` before the lane's end; it looks to the
// node.
LaneEnd parting(const LaneToNode& lane, double reach) {
  const double abscissa = length(lane.line) - reach;
  if (abscissa <= 0) return lane.end;
  LaneEnd end = lane.end;
  const LinePosition place = position_at(lane.line, abscissa);
  end.place = place.point;
  end.direction = place.direction;
  return end;
}

Trajectory turn_at(const LaneToNode& in, const LaneToNode& out, double reach, TrajectoryRule rule,
                   double tolerance) {
  const LaneEnd start = parting(in, reach), end = parting(out, reach);
  Trajectory path = tangent_trajectory({start.place - start.direction, start.place},
                                       {end.place, end.place - end.direction}, rule, tolerance);
  const auto kept = [&](const Line& line) {
    return substring(line, 0, std::max(0.0, length(line) - reach));
  };
  Line whole = kept(in.line);
  whole.insert(whole.end(), path.line.begin(), path.line.end());
  const Line rest = reversed(kept(out.line));
  whole.insert(whole.end(), rest.begin(), rest.end());
  path.line = distinct(std::move(whole));
  if (path.line.size() < 2) path.line.push_back(out.end.place);
  return path;
}

}  // namespace

Line lane_to_node(const Line& axis, const Roadway& roadway, double abscissa, const Point& place,
                  bool to_start) {
  const double total = length(axis);
  const double half_start = roadway.width / 2, half_end = roadway.width_end / 2;
  const Point foot = position_at(axis, abscissa).point;
  const double half = half_start + (half_end - half_start) * (abscissa / total);
  const Point left = left_normal(local_direction(axis, abscissa));
  const double share = (dot(place - foot, left) - roadway.roadway_offset) / half;
  const double start = share * half_start + roadway.roadway_offset,
               end = share * half_end + roadway.roadway_offset;
  Line line = to_start ? offset_line(axis, 0, abscissa, start, end)
                       : offset_line(axis, abscissa, total, start, end);
  if (to_start) line = reversed(std::move(line));
  line.front() = place;
  if (line.size() < 2) line.push_back(place);
  return line;
}

std::optional<Trajectory> late_turn(LaneToNode in, LaneToNode out, TrajectoryRule rule,
                                    double tolerance, const Kerbs& kerbs) {
  end_at_crossing(in.line, out.line);
  const auto clear = [&](const Trajectory& path, double clearance) {
    return !kerbs.stop(path.line, in.border, out.border, clearance);
  };
  const double most = std::max(length(in.line), length(out.line));
  double fits = most / sharpest, fails = most;
  Trajectory widest = turn_at(in, out, fits, rule, tolerance);
  while (!clear(widest, 0)) {
    if (fits >= most) return std::nullopt;
    fits *= 4;
    widest = turn_at(in, out, fits, rule, tolerance);
  }
  const double clearance = clear(widest, half_car) ? half_car : 0;
  for (double reach = most; fails - fits > fits / 8; reach = (fits + fails) / 2) {
    Trajectory path = turn_at(in, out, reach, rule, tolerance);
    if (clear(path, clearance)) {
      widest = std::move(path);
      fits = reach;
    } else {
      fails = reach;
    }
  }
  return widest;
}

}  // namespace streetgen
