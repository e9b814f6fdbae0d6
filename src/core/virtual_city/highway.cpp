#include "virtual_city/highway.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "virtual_city/portable_math.hpp"

namespace streetgen {

namespace {

class Course {
 public:
  Course(const TwoTownsOptions& options, Random& random) : options_(options), random_(random) {}

  Highway run() {
    highway_.carriageway_width = options_.highway_lanes * options_.highway_lane_width;
    highway_.half = (highway_.carriageway_width + options_.median) / 2;
    highway_.outer = highway_.half + highway_.carriageway_width / 2;
    // The first road of a town starts at the latest after 65 % of its side.
    straight_ = std::max(options_.ramp_length + beyond_ramp, 0.65 * options_.town_size);
    const double bent = options_.distance - 2 * straight_;
    const double least = 2 * straight_ + options_.overpasses * between_overpasses;
    if (options_.distance < least)
      throw Error(ErrorKind::invalid_input,
                  "option \"distance\" is " + text_of(options_.distance) + ", expected " +
                      text_of(least) + " m or more",
                  "Towns of this size, with these ramps and overpasses, need so much.");
    add({{-straight_, 0, 0}, {0, 1, 0}, -straight_, true, true});
    interchange({0, 0, 0}, 0);
    at_ = {straight_, 0, 0};
    if (bent > 0) bends(bent);
    add({at_, normal({1, 0, 0}), options_.distance - straight_, true, true});
    interchange(at_ + Point{straight_, 0, 0}, options_.distance);
    add({at_ + Point{2 * straight_, 0, 0}, {0, 1, 0}, options_.distance + straight_, true, true});
    return std::move(highway_);
  }

 private:
  static constexpr double chord = 40;  // of which its bends are made
  static constexpr double longest_bend =
      1200;  // one to the left and one to the right follow each other
  static constexpr double least_turned = 6, most_turned = 18;  // degrees, of a bend
  static constexpr double side_friction = 0.1;  // that a bend asks of a car, banked or not
  // Behind a ramp: its merging lane, the taper of that, and a stretch without either.
  static constexpr double beyond_ramp = 500;
  static constexpr double between_overpasses = 200;
  static constexpr double in_country =
      80;  // from vertex to vertex of country roads on a straight stretch

  void add(const HighwayStation& station) { highway_.stations.push_back(station); }
  void add_crossing(const Point& at, const Point& left, double abscissa) {
    highway_.crossings.push_back(highway_.stations.size());
    add({at, left, abscissa, false, true});
  }

  // The vertices of the carriageways are the nodes of the ramps.
  void interchange(const Point& at, double abscissa) {
    const auto beside = [&](double x, bool carriageways) {
      add({at + Point{x, 0, 0}, {0, 1, 0}, abscissa + x, carriageways, !carriageways});
    };
    const int vertices = static_cast<int>(std::ceil(straight_ / in_country));
    const auto country = [&](int from, int to) {
      for (int i = from; i < to; ++i) beside(straight_ * i / vertices, false);
    };
    country(1 - vertices, 0);
    beside(-options_.ramp_length, true);
    add_crossing(at, {0, 1, 0}, abscissa);
    beside(options_.ramp_length, true);
    country(1, vertices);
  }

  // To one side and back, as often as the way is long.
  void bends(double bent) {
    const int pairs = std::max(1, static_cast<int>(std::round(bent / (2 * longest_bend))));
    const int in_bend =
        std::max(2, static_cast<int>(std::round(bent / (2 * pairs) / chord)));  // chords
    const int chords = 2 * pairs * in_bend;
    const double speed = options_.highway_speed / 3.6;
    const double radius = speed * speed / (9.81 * side_friction);
    const double most =
        std::min(most_turned, bent / (2 * pairs) / radius * (180 / 3.14159265358979323846));
    const std::vector<int> overpasses = overpass_chords(chords);
    double turned = 0;  // degrees at each chord
    for (int i = 0; i < chords; ++i) {
      poll_cancel();
      if (i % (2 * in_bend) == 0) {
        turned = std::min(random_.uniform(least_turned, most_turned), most) / in_bend;
        if (random_.chance(0.5)) turned = -turned;
      } else if (i % in_bend == 0) {
        turned = -turned;
      }
      const Point to = portable::turned(direction_, turned);
      const double length = bent / chords, abscissa = straight_ + i * length;
      add({at_, normal(to), abscissa, true, true});
      direction_ = to;
      if (std::find(overpasses.begin(), overpasses.end(), i) != overpasses.end())
        add_crossing(at_ + direction_ * (length / 2), left_normal(direction_),
                     abscissa + length / 2);
      at_ = at_ + direction_ * length;
    }
  }

  // The chords in whose middle a road passes over the highway.
  std::vector<int> overpass_chords(int chords) {
    std::vector<int> at;
    for (int i = 0; i < static_cast<int>(options_.overpasses); ++i)
      at.push_back(
          static_cast<int>((i + random_.uniform(0.25, 0.75)) / options_.overpasses * chords));
    return at;
  }

  // At a vertex where the line turns into a direction.
  Point normal(const Point& to) const {
    return (left_normal(direction_) + left_normal(to)) * (1 / (1 + dot(direction_, to)));
  }

  const TwoTownsOptions& options_;
  Random& random_;
  Highway highway_;
  double straight_ = 0;
  Point at_, direction_{1, 0, 0};
};

}  // namespace

Highway highway_between(const TwoTownsOptions& options, Random& random) {
  return Course(options, random).run();
}

}  // namespace streetgen
