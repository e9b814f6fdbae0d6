// Do two surfaces share ground, or do they only touch?
#pragma once

#include <memory>
#include <vector>

#include "geometry/box.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

bool inside(const Point& p, const Polygon& polygon);
bool inside(const Point& p, const MultiPolygon& surface);

// A surface that is asked about others; it keeps what it finds out about its boundary, and the
// surface must outlive it unchanged.
class PreparedSurface {
 public:
  explicit PreparedSurface(const MultiPolygon& surface);
  PreparedSurface(PreparedSurface&&) noexcept;
  ~PreparedSurface();

  const Box& box() const { return box_; }
  bool holds(const Point& p) const;
  // Or has it on its boundary, to a micrometre.
  bool reaches(const Point& p) const;
  // Of what lies in the box, to a micrometre.
  Box box_within(const Box& box) const;
  // False only of segments that have no part on it.
  bool comes_near(const Point& from, const Point& to) const;
  // Appends where the segment meets the boundary, as shares of its length.
  void cut(const Point& from, const Point& to, std::vector<double>& at) const;
  // The vertex at the place, but for noise; nullptr: there is none.
  const Point* vertex_at(const Point& place) const;

 private:
  friend bool overlap(const PreparedSurface& a, const PreparedSurface& b);
  class Boundary;
  bool crosses(const PreparedSurface& other, const Box& shared) const;
  bool reaches_into(const PreparedSurface& other, const Box& shared) const;
  const Boundary& boundary() const;
  bool has_on_boundary(const Point& p) const;
  // Deeper than a micrometre.
  bool holds_deeply(const Point& p) const { return holds(p) && !has_on_boundary(p); }

  const MultiPolygon* surface_;
  Box box_;
  mutable std::unique_ptr<Boundary> boundary_;
};

// True when the surfaces share ground deeper than a micrometre; touching ones do not.
bool overlap(const PreparedSurface& a, const PreparedSurface& b);

}  // namespace streetgen
