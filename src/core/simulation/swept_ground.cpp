#include "simulation/swept_ground.hpp"

#include <algorithm>

#include "simulation/link_course.hpp"

namespace streetgen {

namespace {

constexpr double longest_step = 0.3;   // metres
constexpr double room_in_lane = 0.05;  // metres on each side of a car as wide as its lane

const LinkPiece& piece_at(const ConflictMovement& movement, double clamped) {
  const LinkPiece* const first = movement.course.data();
  return *row_at(first, first + movement.course.size(), clamped);
}

// Straight on beyond both ends.
CoursePlace place_along(const ConflictMovement& movement, double metres) {
  const double clamped = std::clamp(metres, 0.0, movement.length);
  const LinkPiece& piece = piece_at(movement, clamped);
  CoursePlace at = place_on(piece, clamped - piece.metres);
  at.x += (metres - clamped) * std::cos(at.heading);
  at.y += (metres - clamped) * std::sin(at.heading);
  return at;
}

double heading_along(const ConflictMovement& movement, double metres) {
  const double clamped = std::clamp(metres, 0.0, movement.length);
  const LinkPiece& piece = piece_at(movement, clamped);
  return piece.heading + piece.curvature * (clamped - piece.metres);
}

// Radians between two headings.
double turn_between(double a, double b) {
  const double turn = std::abs(a - b);
  return turn <= M_PI ? turn : std::abs(std::remainder(turn, 2 * M_PI));
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
  steps_.reserve(count);
  boxes_.reserve(count);
  double heading_before = heading_along(movement, -usual_axle_to_front);
  for (int i = 0; i < count; ++i) {
    const double axle = (i + 0.5) * length_of_step_ - usual_axle_to_front;
    const CoursePlace at = place_along(movement, axle);
    const double heading_after = heading_along(movement, axle + half_step);
    const double turn =
        std::max(turn_between(at.heading, heading_before), turn_between(at.heading, heading_after));
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
    boxes_.push_back(step.box());
    if (i % run == 0) runs_.emplace_back();
    runs_.back() = runs_.back().joined_with(boxes_.back());
    whole_ = whole_.joined_with(boxes_.back());
  }
}

bool SweptGround::meets(std::size_t step, const SweptGround& other,
                        const std::vector<std::size_t>& runs) const {
  for (const std::size_t r : runs) {
    if (!boxes_[step].meets(other.runs_[r])) continue;
    const std::size_t end = std::min(other.steps_.size(), (r + 1) * run);
    for (std::size_t i = r * run; i < end; ++i)
      if (boxes_[step].meets(other.boxes_[i]) && steps_[step].overlaps(other.steps_[i]))
        return true;
  }
  return false;
}

std::size_t SweptGround::outermost(const SweptGround& other, bool first) const {
  std::vector<std::size_t> near;  // runs of the other one that meet a run of this
  for (std::size_t k = 0; k < runs_.size(); ++k) {
    const std::size_t r = first ? k : runs_.size() - 1 - k;
    near.clear();
    if (runs_[r].meets(other.whole_))
      for (std::size_t o = 0; o < other.runs_.size(); ++o)
        if (runs_[r].meets(other.runs_[o])) near.push_back(o);
    if (near.empty()) continue;
    const std::size_t begin = r * run, end = std::min(steps_.size(), begin + run);
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t step = first ? i : begin + end - 1 - i;
      if (meets(step, other, near)) return step;
    }
  }
  return steps_.size();
}

SweptGround::Stretch SweptGround::within(const SweptGround& other) const {
  const std::size_t first = outermost(other, true);
  if (first == steps_.size()) return {};
  const std::size_t last = outermost(other, false);
  return {static_cast<double>(first) * length_of_step_,
          static_cast<double>(last + 1) * length_of_step_};
}

}  // namespace streetgen
