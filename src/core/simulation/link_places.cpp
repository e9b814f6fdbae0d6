#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "geometry/box_index.hpp"
#include "simulation/link_course.hpp"
#include "simulation/other_storeys.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "streetgen/traffic.hpp"
#include "support/infinite.hpp"

namespace streetgen {

namespace {

constexpr double longest_part = 50;  // metres of a course that have a box of their own
constexpr double first_reach = 8;    // metres, within which a link is looked for first
constexpr double same_place = 1e-6;  // metres

// The box of a part of a piece, all of which lies within half its length of its middle.
Box box_of(const LinkPiece& piece, double from, double to) {
  const double half = (to - from) / 2;
  const CoursePlace at = place_on(piece, from + half);
  Box box;
  if (piece.curvature == 0) {
    for (const double end : {from, to}) {
      const CoursePlace p = place_on(piece, end);
      box.add({p.x, p.y, 0});
    }
    return box;
  }
  return {at.x - half, at.y - half, at.x + half, at.y + half};
}

// Metres after the piece begins to the place of a part that is nearest to a point.
double nearest_on(const LinkPiece& piece, double from, double to, double x, double y) {
  const double dx = x - piece.x, dy = y - piece.y;
  const double c = std::cos(piece.heading), s = std::sin(piece.heading);
  const double ahead = dx * c + dy * s, left = dy * c - dx * s;
  if (piece.curvature == 0) return std::clamp(ahead, from, to);
  const double k = std::abs(piece.curvature);
  const double aside = piece.curvature > 0 ? left : -left;
  const double round = 2 * M_PI / k;
  double along = std::atan2(k * ahead, 1 - k * aside) / k;
  // The place on the circle that is nearest to the middle of the part.
  const double middle = (from + to) / 2;
  along += round * std::round((middle - along) / round);
  return std::clamp(along, from, to);
}

}  // namespace

struct LinkPlaces::Index {
  // A part of a piece of a link.
  struct CoursePart {
    std::int32_t link, piece;
    double from, to;  // metres after the piece begins
  };

  const TrafficNetwork* network;
  std::vector<CoursePart> parts;
  BoxIndex boxes;

  const LinkPiece& piece_of(const CoursePart& part) const {
    return network->pieces.of(part.link)[part.piece];
  }
  std::vector<NearPlace> near(double x, double y, double reach) const;
  bool holds(const NearPlace& near) const {
    return near.distance <= network->links[near.located.place.link].width / 2;
  }
};

LinkPlaces::LinkPlaces(const TrafficNetwork& network) {
  auto index = std::make_unique<Index>();
  index->network = &network;
  std::vector<Box> boxes;
  for (int link = 0; link < network.size(); ++link) {
    if (link % 1024 == 0) poll_cancel();
    const auto pieces = network.pieces.of(link);
    for (int i = 0; i < pieces.size(); ++i) {
      const double end = i + 1 < pieces.size() ? pieces[i + 1].metres : course_length(network.links[link]);
      const double length = end - pieces[i].metres;
      if (!std::isfinite(length) || length < 0) continue;
      const int count = std::max(1, static_cast<int>(std::ceil(length / longest_part)));
      for (int k = 0; k < count; ++k) {
        index->parts.push_back({link, i, length * k / count, length * (k + 1) / count});
        boxes.push_back(box_of(pieces[i], index->parts.back().from, index->parts.back().to));
      }
    }
  }
  index->boxes = BoxIndex(boxes);
  index_ = std::move(index);
}

LinkPlaces::~LinkPlaces() = default;
LinkPlaces::LinkPlaces(LinkPlaces&&) noexcept = default;
LinkPlaces& LinkPlaces::operator=(LinkPlaces&&) noexcept = default;

// Each link within reach once, by index.
std::vector<NearPlace> LinkPlaces::Index::near(double x, double y, double reach) const {
  std::vector<NearPlace> found;
  for (const int i : boxes.near({x, y, x, y}, reach)) {
    const CoursePart& part = parts[i];
    const LinkPiece& piece = piece_of(part);
    const double along = nearest_on(piece, part.from, part.to, x, y);
    const CoursePlace at = place_on(piece, along);
    const double distance = std::hypot(x - at.x, y - at.y);
    if (distance > reach) continue;
    const double offset = (y - at.y) * std::cos(at.heading) - (x - at.x) * std::sin(at.heading);
    const double metres = (piece.metres + along) / network->links[part.link].stretch;
    const NearPlace near{{{part.link, metres}, offset}, distance, at.heading};
    if (found.empty() || found.back().located.place.link != part.link)
      found.push_back(near);
    else if (distance < found.back().distance)
      found.back() = near;
  }
  return found;
}

namespace {

void require_locating(std::initializer_list<double> numbers, double reach) {
  for (const double number : numbers)
    if (!std::isfinite(number))
      throw Error(ErrorKind::invalid_input, text_of(number) + " locates no place");
  if (reach < 0)
    throw Error(ErrorKind::invalid_input, "a reach of " + text_of(reach) + " metres is below 0");
}

}  // namespace

std::vector<NearPlace> LinkPlaces::near(double x, double y, double reach) const {
  require_locating({x, y, reach}, reach);
  return index_->near(x, y, reach);
}

LocatedPlace LinkPlaces::locate(double x, double y, double reach, std::optional<double> heading,
                                std::optional<double> height) const {
  require_locating({x, y, reach, heading.value_or(0), height.value_or(0)}, reach);
  std::vector<NearPlace> near;
  for (double within = std::min(first_reach, reach);; within = std::min(2 * within, reach)) {
    poll_cancel();
    near = index_->near(x, y, within);
    if (!near.empty() || within == reach) break;
  }
  if (std::any_of(near.begin(), near.end(), [&](const NearPlace& n) { return index_->holds(n); })) {
    near.erase(std::remove_if(near.begin(), near.end(),
                              [&](const NearPlace& n) { return !index_->holds(n); }),
               near.end());
    if (height) drop_other_storeys(*index_->network, *height, near);
    if (heading)
      for (NearPlace& n : near)
        n.distance += metres_a_radian * std::abs(std::remainder(n.heading - *heading, 2 * M_PI));
  }
  const NearPlace* best = nullptr;
  for (const NearPlace& n : near)
    if (!best || n.distance < best->distance - same_place) best = &n;
  return best ? best->located : LocatedPlace{};
}

}  // namespace streetgen
