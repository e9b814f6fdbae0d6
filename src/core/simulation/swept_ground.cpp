#include "simulation/swept_ground.hpp"

#include <algorithm>

#include "simulation/link_course.hpp"

namespace streetgen {

namespace {

constexpr double longest_step = 0.3;   // metres
constexpr double room_in_lane = 0.05;  // metres on each side of a car as wide as its lane

// Straight on beyond both ends.
CoursePlace place_along(const ConflictMovement& movement, double metres) {
  const double clamped = std::clamp(metres, 0.0, movement.length);
  const LinkPiece* const first = movement.course.data();
  const LinkPiece& piece = *row_at(first, first + movement.course.size(), clamped);
  CoursePlace at = place_on(piece, clamped - piece.metres);
  at.x += (metres - clamped) * std::cos(at.heading);
  at.y += (metres - clamped) * std::sin(at.heading);
  return at;
}

}  // namespace

Box SweptStep::box() const {
  const double x = half_length * std::abs(cosine) + half_width * std::abs(sine);
  const double y = half_length * std::abs(sine) + half_width * std::abs(cosine);
  return {middle.x - x, middle.y - y, middle.x + x, middle.y + y};
}

// Rectangles are apart where a side of one of them parts them.
bool SweptStep::overlaps(const SweptStep& other) const {
  const double dx = other.middle.x - middle.x, dy = other.middle.y - middle.y;
  const double cross = std::abs(cosine * other.sine - sine * other.cosine);
  const double along = std::abs(cosine * other.cosine + sine * other.sine);
  return std::abs(dx * cosine + dy * sine) <=
             half_length + other.half_length * along + other.half_width * cross &&
         std::abs(dy * cosine - dx * sine) <=
             half_width + other.half_length * cross + other.half_width * along &&
         std::abs(dx * other.cosine + dy * other.sine) <=
             other.half_length + half_length * along + half_width * cross &&
         std::abs(dy * other.cosine - dx * other.sine) <=
             other.half_width + half_length * cross + half_width * along;
}

// The rectangle of a step is that of the car in its middle, with room for how far any point of the
// car lies from there at either end.
SweptGround::SweptGround(const ConflictMovement& movement) {
  const double way = movement.length + usual_car_length;
  const int count = std::max(1, static_cast<int>(std::ceil(way / longest_step)));
  length_of_step_ = way / count;
  const double half_width = std::min(usual_car_width / 2, movement.width / 2 - room_in_lane);
  const double half_step = length_of_step_ / 2;
  std::vector<Box> boxes;
  steps_.reserve(count);
  boxes.reserve(count);
  double heading_before = place_along(movement, -usual_axle_to_front).heading;
  for (int i = 0; i < count; ++i) {
    const double axle = (i + 0.5) * length_of_step_ - usual_axle_to_front;
    const CoursePlace at = place_along(movement, axle);
    const double heading_after = place_along(movement, axle + half_step).heading;
    const double turn = std::max(std::abs(std::remainder(at.heading - heading_before, 2 * M_PI)),
                                 std::abs(std::remainder(heading_after - at.heading, 2 * M_PI)));
    heading_before = heading_after;
    const double forward = (usual_axle_to_front - usual_axle_to_rear) / 2;
    SweptStep step;
    step.cosine = std::cos(at.heading);
    step.sine = std::sin(at.heading);
    step.middle = {at.x + forward * step.cosine, at.y + forward * step.sine, 0};
    const double half_body = std::max(half_width, 0.1);
    step.half_length =
        usual_car_length / 2 + half_step + turn * (half_body + turn * usual_axle_to_front / 2);
    step.half_width = half_body + turn * (half_step + usual_axle_to_front + turn * half_body / 2);
    steps_.push_back(step);
    boxes.push_back(step.box());
    whole_ = whole_.joined_with(boxes.back());
  }
  boxes_ = BoxHierarchy(std::move(boxes));
}

bool SweptGround::meets(std::size_t step, const SweptGround& other) const {
  const Box& box = boxes_[step];
  return box.meets(other.whole_) && other.boxes_.any_near(box, 0, [&](std::size_t i) {
    return steps_[step].overlaps(other.steps_[i]);
  });
}

SweptGround::Stretch SweptGround::within(const SweptGround& other) const {
  std::size_t first = 0, last = steps_.size();
  while (first < last && !meets(first, other)) ++first;
  if (first == last) return {};
  while (!meets(last - 1, other)) --last;
  return {static_cast<double>(first) * length_of_step_,
          static_cast<double>(last) * length_of_step_};
}

}  // namespace streetgen
