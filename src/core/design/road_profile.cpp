// The heights of a road: stations, a first profile within the greatest grade, and its improvement.
#include <algorithm>
#include <cmath>

#include "design/profile_band.hpp"
#include "streetgen/cancel.hpp"
#include "streetgen/error.hpp"
#include "streetgen/road_design.hpp"
#include "support/infinite.hpp"

namespace streetgen {
namespace {

// Metres between grade points: a parabola of the least radius turns a few per cent over them.
double station_distance(const DesignRules& rules) {
  return std::clamp(rules.crest / 20, 50.0, 200.0);
}

GroundSample ground_at(const DesignSite& site, const std::vector<AlignmentElement>& elements,
                       double abscissa) {
  const AlignmentPlace place = alignment_place(elements, abscissa);
  const Terrain::Ground g = site.terrain.ground(place.point.x, place.point.y);
  return {0, g.height, -g.slope_x * std::sin(place.heading) + g.slope_y * std::cos(place.heading),
          site.zones.at(place.point.x, place.point.y)};
}

std::vector<ProfileStation> make_stations(const DesignRules& rules, double length,
                                          const ProfileWish& wish) {
  const double distance = station_distance(rules);
  // Counted from the start, so that a bend moves the stations behind it alone.
  std::vector<ProfileStation> stations{{0, wish.start_height, true},
                                       {length, wish.end_height, true}};
  for (const GradePoint& p : wish.fixed)
    if (p.abscissa > 1 && p.abscissa < length - 1) stations.push_back({p.abscissa, p.height, true});
  const std::size_t settled = stations.size();
  for (double at = distance; at <= length - distance / 2; at += distance) {
    bool free = true;
    for (std::size_t k = 2; k < settled; ++k)
      free = free && std::abs(stations[k].abscissa - at) > distance / 2;
    for (double rejected : wish.rejected) free = free && std::abs(rejected - at) > distance / 2;
    if (free) stations.push_back({at, 0, false});
  }
  std::sort(stations.begin(), stations.end(), [](const ProfileStation& a, const ProfileStation& b) {
    return a.abscissa < b.abscissa;
  });
  for (const GradePoint& p : wish.fixed)
    for (ProfileStation& s : stations)
      if (std::abs(s.abscissa - p.abscissa) <= 1) s.height = p.height, s.fixed = true;
  return stations;
}

std::vector<ProfileSide> make_sides(const DesignSite& site,
                                    const std::vector<AlignmentElement>& elements,
                                    const std::vector<ProfileStation>& stations,
                                    const std::vector<HeightLimit>& limits) {
  constexpr double sample_distance = 12.5;
  std::vector<ProfileSide> sides;
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    poll_cancel();
    const double from = stations[i].abscissa, run = stations[i + 1].abscissa - from;
    ProfileSide side;
    const int parts = std::max(2, static_cast<int>(std::ceil(run / sample_distance)));
    for (int k = 0; k < parts; ++k) {
      const double share = (k + 0.5) / parts;
      GroundSample sample = ground_at(site, elements, from + share * run);
      sample.share = share;
      if (!std::isnan(sample.ground)) side.samples.push_back(sample);
    }
    for (const HeightLimit& limit : limits)
      if (limit.abscissa >= from && limit.abscissa <= from + run)
        side.limits.push_back({(limit.abscissa - from) / run, limit.low, limit.high});
    sides.push_back(std::move(side));
  }
  return sides;
}

// The mean of the least profile above the ground and the greatest below it that keep the grade,
// moved between the cones of the fixed heights.
void first_profile(const DesignSite& site, const std::vector<AlignmentElement>& elements,
                   std::vector<ProfileStation>& stations) {
  const std::size_t n = stations.size();
  const double grade = site.rules.grade * 0.999;
  std::vector<double> above(n), below(n);
  double known = stations.front().height;
  for (std::size_t i = 0; i < n; ++i) {
    const double ground = ground_at(site, elements, stations[i].abscissa).ground;
    if (!std::isnan(ground)) known = ground;
    above[i] = below[i] = stations[i].fixed ? stations[i].height : known;
  }
  const auto climb = [&](std::size_t i) {
    return grade * (stations[i + 1].abscissa - stations[i].abscissa);
  };
  for (std::size_t i = 0; i + 1 < n; ++i) {
    above[i + 1] = std::max(above[i + 1], above[i] - climb(i));
    below[i + 1] = std::min(below[i + 1], below[i] + climb(i));
  }
  for (std::size_t i = n - 1; i-- > 0;) {
    above[i] = std::max(above[i], above[i + 1] - climb(i));
    below[i] = std::min(below[i], below[i + 1] + climb(i));
  }
  std::vector<double> low(n, -1e9), high(n, 1e9);
  for (std::size_t i = 0; i < n; ++i) {
    if (stations[i].fixed) low[i] = high[i] = stations[i].height;
    if (i > 0 && !stations[i].fixed) {
      low[i] = low[i - 1] - climb(i - 1);
      high[i] = high[i - 1] + climb(i - 1);
    }
  }
  for (std::size_t i = n - 1; i-- > 0;)
    if (!stations[i].fixed) {
      low[i] = std::max(low[i], low[i + 1] - climb(i));
      high[i] = std::min(high[i], high[i + 1] + climb(i));
    }
  for (std::size_t i = 0; i < n; ++i)
    if (!stations[i].fixed)
      stations[i].height = std::max(low[i], std::min(high[i], (above[i] + below[i]) / 2));
}

// Radii of the parabolas: as wide as half of both sides allows, up to a smooth ride.
std::vector<GradePoint> with_radii(const DesignRules& rules,
                                   const std::vector<ProfileStation>& stations,
                                   const std::vector<GradePoint>& fixed) {
  constexpr double widest = 5;  // times the least radius
  std::vector<GradePoint> points;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    GradePoint point{stations[i].abscissa, stations[i].height, 0};
    if (i > 0 && i + 1 < stations.size()) {
      const double before = point.abscissa - stations[i - 1].abscissa;
      const double after = stations[i + 1].abscissa - point.abscissa;
      const double change = (stations[i + 1].height - point.height) / after -
                            (point.height - stations[i - 1].height) / before;
      const double least = change < 0 ? rules.crest : rules.sag;
      if (std::abs(change) > 1e-9)
        point.radius = std::min(least * widest, std::min(before, after) / std::abs(change));
      else
        point.radius = least;
      for (const GradePoint& p : fixed)
        if (std::abs(p.abscissa - point.abscissa) <= 1 && p.radius > 0)
          point.radius = std::min(point.radius, p.radius);
    }
    points.push_back(point);
  }
  return points;
}

// By how much a road misses a limit: positive below it.
double miss_of(const std::vector<GradePiece>& pieces, const HeightLimit& limit) {
  const double height = grade_place(pieces, limit.abscissa).height;
  return std::max(0.0, limit.low - height) - std::max(0.0, height - limit.high);
}

// Moves stations beside limits until the road, parabolas included, keeps them. Limits that
// contradict each other are missed as little as was found.
std::vector<GradePoint> meet_limits(const DesignRules& rules, std::vector<ProfileStation> stations,
                                    const ProfileWish& wish) {
  std::vector<GradePoint> best = with_radii(rules, stations, wish.fixed), points = best;
  double least = infinite;
  for (int pass = 0; pass < 40; ++pass) {
    const std::vector<GradePiece> pieces = vertical_alignment(points);
    double missed = 0;
    for (const HeightLimit& limit : wish.limits) {
      const double miss = miss_of(pieces, limit);
      missed += std::abs(miss);
      for (std::size_t i = 0; i < stations.size(); ++i) {
        const double before = i > 0 ? stations[i - 1].abscissa : stations[i].abscissa;
        const double after =
            i + 1 < stations.size() ? stations[i + 1].abscissa : stations[i].abscissa;
        if (!stations[i].fixed && limit.abscissa >= before && limit.abscissa <= after)
          stations[i].height += miss;
      }
    }
    if (!(missed < least)) break;
    least = missed;
    best = points;
    if (missed < 1e-7) break;
    points = with_radii(rules, stations, wish.fixed);
  }
  return best;
}

}  // namespace

std::vector<GradePoint> road_profile(const DesignSite& site,
                                     const std::vector<AlignmentElement>& elements,
                                     const ProfileWish& wish) {
  const double length = alignment_length(elements);
  if (!(length > 0)) throw Error(ErrorKind::degenerate, "the road has no length");
  std::vector<ProfileStation> stations = make_stations(site.rules, length, wish);
  const std::vector<ProfileSide> sides = make_sides(site, elements, stations, wish.limits);
  first_profile(site, elements, stations);
  const SectionCost section(site.rules);
  for (double step : {12.0, 6.0, 6.0, 3.0, 1.5, 0.75, 0.375, 0.15})
    improve_profile(site, section, sides, step, stations);
  return meet_limits(site.rules, stations, wish);
}

}  // namespace streetgen
