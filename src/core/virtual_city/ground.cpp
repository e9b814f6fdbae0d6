#include "virtual_city/ground.hpp"

#include <algorithm>
#include <cmath>

#include "support/infinite.hpp"
#include "virtual_city/portable_math.hpp"

namespace streetgen {

namespace {

constexpr double never = infinite;
// Points on a whole millimetre lie off the line between others by less.
constexpr double on_line = 0.002;
// Boxes of longer pieces would hold much that is far from them.
constexpr double longest_box = 400;

// Metres along the ray to the place where it crosses the segment, ends included.
double crossing(const Point& from, const Point& direction, const CityPiece& piece) {
  const Point along = piece.b - piece.a;
  const double across = cross(direction, along);
  if (across == 0) return never;
  const double place = cross(piece.a - from, direction) / across;
  const double slack = on_line / portable::norm(along);
  if (place < -slack || place > 1 + slack) return never;
  const double t = cross(piece.a - from, along) / across;
  return t >= 0 ? t : never;
}

double entry_into_circle(const Point& from, const Point& direction, const Point& centre,
                         double radius) {
  const Point to = centre - from;
  const double along = dot(to, direction), off = cross(direction, to);
  if (std::fabs(off) >= radius) return never;
  const double t = along - std::sqrt(radius * radius - off * off);
  return t >= 0 ? t : never;
}

// Metres along the ray to the first place nearer to the segment than `radius`.
double entry(const Point& from, const Point& direction, const CityPiece& piece, double radius) {
  if (portable::distance_to_segment(from, piece.a, piece.b) < radius) return 0;
  double first = std::min(entry_into_circle(from, direction, piece.a, radius),
                          entry_into_circle(from, direction, piece.b, radius));
  const Point along = portable::unit(piece.b - piece.a);
  const double off = cross(along, from - piece.a), closing = cross(along, direction);
  if (closing != 0) {
    const double t = ((off > 0 ? radius : -radius) - off) / closing;
    const double place = dot(from + direction * t - piece.a, along);
    if (t >= 0 && place >= 0 && place <= portable::distance(piece.a, piece.b))
      first = std::min(first, t);
  }
  return first;
}

}  // namespace

CityGround::CityGround(double clearance, double angle_least, double widest)
    : clearance_(clearance), widest_(widest) {
  const Point arm = portable::turned({1, 0, 0}, angle_least);
  cosine_ = arm.x;
  nearing_ = 1 / arm.y;
}

void CityGround::add(int index, const CityStreet& street) {
  for (std::size_t i = 1; i < street.line.size(); ++i) {
    const Point a = street.line[i - 1], b = street.line[i];
    const int number = static_cast<int>(pieces_.size());
    pieces_.push_back({index, a, b, street.abscissas[i - 1], street.width});
    const int boxes = static_cast<int>(std::ceil(portable::distance(a, b) / longest_box));
    for (int k = 0; k < boxes; ++k)
      index_.add(box_of(a + (b - a) * (k / double(boxes)), a + (b - a) * ((k + 1) / double(boxes))),
                 number);
  }
}

std::vector<int> CityGround::near(const Point& a, const Point& b, double margin) const {
  std::vector<int> found = index_.near(box_of(a, b), margin);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool CityGround::occupied(const Point& p, double width, int main) const {
  return index_.any_near(box_of(p, p), (width + widest_) / 2 + clearance_, [&](int i) {
    const CityPiece& other = piece(i);
    return other.street != main &&
           portable::distance_to_segment(p, other.a, other.b) < apart(width, other);
  });
}

CityWay CityGround::way(const Point& from, const Point& to, double width, int main) const {
  const double length = portable::distance(from, to);
  const Point direction = portable::unit(to - from);
  const double reach = (width + widest_) / 2 + clearance_;
  double free = never, meets = never, blocked = never;
  int met = -1;
  const int steps = static_cast<int>(std::ceil(length / longest_box));
  struct Beside {
    double entry, apart;
  };
  std::vector<Beside> beside;
  for (int step = 0; step < steps; ++step) {
    const double begin = length * step / steps, end = length * (step + 1) / steps;
    for (const int i : near(from + direction * begin, from + direction * end, reach)) {
      const CityPiece& other = piece(i);
      const double across = crossing(from, direction, other);
      if (across < meets && across <= length && (other.street != main || across > on_line)) {
        meets = across;
        met = i;
      }
      if (other.street == main) continue;
      const double entered = entry(from, direction, other, apart(width, other));
      if (entered >= length) continue;
      beside.push_back({entered, apart(width, other)});
      free = std::min(free, entered);
    }
    if (meets <= end || free < end - nearing_ * reach) break;
  }
  if (met >= 0 && piece(met).street == main)
    free = std::min(free, std::max(0.0, meets - nearing_ * apart(width, piece(met))));
  for (const Beside& b : beside)
    if (meets == never || b.entry < meets - nearing_ * b.apart)
      blocked = std::min(blocked, b.entry);
  CityWay way;
  way.free = free;
  if (blocked == never && meets != never) {
    way.meets = meets;
    way.piece = met;
  }
  return way;
}

bool CityGround::may_join(const Point& from, const Point& at, double width, int main) const {
  const double length = portable::distance(from, at);
  const Point direction = portable::unit(at - from);
  for (const int i : near(from, at, (width + widest_) / 2 + clearance_)) {
    const CityPiece& other = piece(i);
    if (portable::distance_to_segment(at, other.a, other.b) < on_line) {
      for (const Point& end : {other.a, other.b})
        if (portable::distance(end, at) > on_line &&
            dot(portable::unit(end - at), direction) < -cosine_)
          return false;
      continue;
    }
    const double across = crossing(from, direction, other);
    if (across <= length && (other.street != main || across > on_line)) return false;
    if (other.street != main && entry(from, direction, other, apart(width, other)) <
                                    length - nearing_ * apart(width, other))
      return false;
  }
  return true;
}

}  // namespace streetgen
