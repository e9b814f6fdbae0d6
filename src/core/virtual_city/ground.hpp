// The ground of a virtual city: what stands where, and what a road in growth meets there.
#pragma once

#include <optional>
#include <vector>

#include "geometry/box_index.hpp"
#include "virtual_city/street.hpp"

namespace streetgen {

// A straight piece of a street.
struct CityPiece {
  int street = 0;
  Point a, b;
  double abscissa = 0;  // of a
  double width = 0;
};

// The way that a road in growth finds straight ahead.
struct CityWay {
  // Metres until it comes too near to a road beside it or across; infinite where it does not.
  double free = 0;
  std::optional<double> meets;  // metres to the road across, where it comes to no other before
  int piece = -1;               // of the road across
};

class CityGround {
 public:
  // `clearance`: metres between the kerbs of roads side by side; `angle_least`: degrees between
  // roads that meet; `widest`: metres, of any road.
  CityGround(double clearance, double angle_least, double widest);

  void add(int index, const CityStreet& street);
  const CityPiece& piece(int index) const { return pieces_[static_cast<std::size_t>(index)]; }

  std::size_t pieces() const { return pieces_.size(); }

  // Metres before a junction within which roads may be near.
  double ahead() const { return nearing_ * (widest_ + clearance_); }

  // Whether a street other than `main` is nearer than the clearance to a road of that width at p.
  bool occupied(const Point& p, double width, int main) const;

  // The way of a road of that width from `from` towards `to`.  Its main road counts only where it
  // is crossed again.
  CityWay way(const Point& from, const Point& to, double width, int main) const;

  // Whether a road from `from` may end in `at`, a place on a road: it crosses none before, runs
  // beside none, and meets those that are there at no less than the least angle.
  bool may_join(const Point& from, const Point& at, double width, int main) const;

 private:
  // Pieces near the segment, ascending.
  std::vector<int> near(const Point& a, const Point& b, double margin) const;
  double apart(double width, const CityPiece& other) const {
    return (width + other.width) / 2 + clearance_;
  }

  double clearance_;
  double cosine_;   // of the least angle
  double nearing_;  // how long before a junction roads may be near, as a multiple of `apart`
  double widest_;
  std::vector<CityPiece> pieces_;
  BoxIndex index_;
};

}  // namespace streetgen
