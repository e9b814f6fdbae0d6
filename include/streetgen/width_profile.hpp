// The width of a street along an edge, on either side of its axis.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace streetgen {

// Half widths between places in ascending order, linear from each to the next and constant beyond
// the first and the last; none where the street is as wide as its axis says.
struct WidthProfile {
  struct Place {
    double abscissa = 0;  // metres along the edge
    double left = 0;      // metres from the axis to the kerb, in the direction of the edge
    double right = 0;

    double on(int side) const { return side > 0 ? left : right; }  // +1: left, -1: right
    friend bool operator==(const Place& a, const Place& b) {
      return a.abscissa == b.abscissa && a.left == b.left && a.right == b.right;
    }
  };
  std::vector<Place> places;

  // The end of an edge as which the street goes on beyond a change of width; edge -1: none.
  struct Beyond {
    int edge = -1;
    bool at_start = true;
  };
  Beyond beyond_start, beyond_end;  // at the start and at the end of this edge

  bool empty() const { return places.empty(); }

  Place at(double abscissa) const {
    const auto next = std::find_if(places.begin(), places.end(),
                                   [&](const Place& place) { return place.abscissa >= abscissa; });
    if (next == places.begin()) return {abscissa, next->left, next->right};
    if (next == places.end()) return {abscissa, places.back().left, places.back().right};
    const Place& before = *(next - 1);
    const double share = (abscissa - before.abscissa) / (next->abscissa - before.abscissa);
    return {abscissa, before.left + (next->left - before.left) * share,
            before.right + (next->right - before.right) * share};
  }

  // A value that is linear between two abscissas has these values at 0 and at `total`.
  static std::pair<double, double> extended(double from, double value_from, double to,
                                            double value_to, double total) {
    const double slope = (value_to - value_from) / (to - from), start = value_from - slope * from;
    return {start, start + slope * total};
  }

  // The places between which one side changes, without those that lie between two in its line.
  WidthProfile of_side(int side) const {
    WidthProfile bends;
    for (const Place& place : places) {
      auto& kept = bends.places;
      while (kept.size() > 1 && in_line(kept[kept.size() - 2], kept.back(), place, side))
        kept.pop_back();
      kept.push_back(place);
    }
    return bends;
  }

  // Gives each stretch between two places of the profile from abscissa u to v, u < v: its ends.
  template <class Use>
  void each_stretch(double u, double v, Use use) const {
    Place from = at(u);
    for (const Place& place : places) {
      if (place.abscissa <= u || place.abscissa >= v) continue;
      use(from, place);
      from = place;
    }
    if (from.abscissa < v) use(from, at(v));
  }

 private:
  static bool in_line(const Place& from, const Place& middle, const Place& to, int side) {
    constexpr double rounding = 1e-9;  // metres
    const double share = (middle.abscissa - from.abscissa) / (to.abscissa - from.abscissa);
    const double off = from.on(side) + (to.on(side) - from.on(side)) * share - middle.on(side);
    return -rounding < off && off < rounding;
  }
};

}  // namespace streetgen
