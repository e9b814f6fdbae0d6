#include <algorithm>
#include <cmath>

#include "simulation/link_course.hpp"
#include "simulation/path_ahead.hpp"
#include "streetgen/traffic.hpp"

namespace streetgen {

int link_of(const TrafficNetwork& network, std::int64_t link_id) {
  const auto found =
      std::lower_bound(network.links.begin(), network.links.end(), link_id,
                       [](const Link& link, std::int64_t id) { return link.link_id < id; });
  return found == network.links.end() || found->link_id != link_id
             ? -1
             : static_cast<int>(found - network.links.begin());
}

namespace {

void set_height(LinkFrame& frame, const RowsOf<LinkHeight>::List& heights, double metres) {
  if (heights.empty()) return;
  const LinkHeight* from = row_at(heights.begin(), heights.end(), metres);
  if (from + 1 == heights.end() && heights.size() > 1) --from;
  frame.height = from->height;
  if (from + 1 == heights.end()) return;
  const double length = static_cast<double>(from[1].metres) - from->metres;
  if (!(length > 0)) return;
  frame.grade = (static_cast<double>(from[1].height) - from->height) / length;
  const double along = std::clamp(metres - from->metres, 0.0, length);
  frame.height += frame.grade * along;
}

}  // namespace

LinkFrame frame(const TrafficNetwork& network, const LinkPlace& place, double wheelbase) {
  require_link(network, place.link);
  LinkFrame frame;
  const double metres = std::clamp(place.metres, 0.0, network.links[place.link].length);
  set_height(frame, network.heights.of(place.link), metres);
  const auto pieces = network.pieces.of(place.link);
  if (pieces.empty()) return frame;
  const double on_course = metres * network.links[place.link].stretch;
  const LinkPiece& piece = *row_at(pieces.begin(), pieces.end(), on_course);
  const CoursePlace at = place_on(piece, on_course - piece.metres);
  frame.x = at.x;
  frame.y = at.y;
  frame.heading = std::remainder(at.heading, 2 * M_PI);
  frame.curvature = at.curvature;
  frame.steering = std::atan(wheelbase * piece.curvature);
  return frame;
}

NeighbourPlace beside(const TrafficNetwork& network, const LinkPlace& place, bool left) {
  require_link(network, place.link);
  const double metres = std::clamp(place.metres, 0.0, network.links[place.link].length);
  for (const LinkBeside& row : network.beside.of(place.link)) {
    if (row.left != left || metres < row.from || metres > row.to) continue;
    const double length = static_cast<double>(row.to) - row.from;
    const double share = length > 0 ? (metres - row.from) / length : 0;
    const double other =
        row.other_from + share * (static_cast<double>(row.other_to) - row.other_from);
    require_link(network, row.link);
    return {{row.link, std::clamp(other, 0.0, network.links[row.link].length)},
            row.may_change,
            row.opposite};
  }
  return {};
}

}  // namespace streetgen
