#include "design/settle_vertices.hpp"

#include <algorithm>
#include <cmath>

#include "design/curve_room.hpp"
#include "design/section_cost.hpp"
#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"
#include "support/infinite.hpp"

namespace streetgen {
namespace {

// A vertex goes where the road without it costs no more than this beside the road with it.
constexpr double dearer_without = 1.02;

class VertexSettler {
 public:
  VertexSettler(const DesignSite& site, double cell, std::vector<PathVertex>& path)
      : site_(site), room_(site.rules), section_(site.rules), path_(path), step_(cell / 2) {
    sample_ = std::max(10.0, std::min(site.terrain.cell() / 2, cell / 3));
    for (std::size_t i = 1; i < path.size(); ++i)
      sides_.push_back(side_cost(path[i - 1].point, path[i].point));
  }

  void settle() {
    for (int round = 0; round < 5; ++round, step_ /= 2) {
      for (int pass = 0; pass < 4; ++pass)
        if (!move_all()) break;
      drop_all();
    }
  }

 private:
  double side_cost(const Point& a, const Point& b) const {
    const double length = distance(planar(a), planar(b));
    if (!(length > 1e-3) || std::abs(b.z - a.z) > site_.rules.grade * length * (1 + 1e-9))
      return infinite;
    if (site_.zones.bars(a, b)) return infinite;
    const int parts = std::max(1, static_cast<int>(std::ceil(length / sample_)));
    const double nx = -(b.y - a.y) / length, ny = (b.x - a.x) / length;
    double sum = 0;
    for (int i = 0; i < parts; ++i) {
      const double t = (i + 0.5) / parts, x = a.x + t * (b.x - a.x), y = a.y + t * (b.y - a.y);
      const Terrain::Ground g = site_.terrain.ground(x, y);
      if (std::isnan(g.height)) return infinite;
      sum += section_.cost(a.z + t * (b.z - a.z) - g.height, g.slope_x * nx + g.slope_y * ny,
                           site_.zones.at(x, y));
    }
    return sum * length / parts + site_.rules.climb_cost * std::abs(b.z - a.z);
  }

  double tangent_at(std::size_t i) const {
    if (i == 0 || i + 1 >= path_.size()) return 0;
    const Point a = path_[i].point - path_[i - 1].point, b = path_[i + 1].point - path_[i].point;
    return room_.tangent(std::atan2(cross(a, b), dot(a, b)));
  }

  // Whether the curves fit on the sides from vertex `from` to vertex `to`.
  bool curves_fit(std::size_t from, std::size_t to) const {
    double before = tangent_at(from);
    for (std::size_t i = from + 1; i <= to; ++i) {
      const double here = tangent_at(i);
      const double side = distance(planar(path_[i - 1].point), planar(path_[i].point));
      if (before + here > side) return false;
      before = here;
    }
    return true;
  }

  bool fits_around(std::size_t i) const {
    return curves_fit(i > 1 ? i - 2 : 0, std::min(i + 2, path_.size() - 1));
  }

  bool try_place(std::size_t i, const Point& place) {
    const Point before = path_[i].point;
    path_[i].point = place;
    const double in = side_cost(path_[i - 1].point, place);
    const double out = in < infinite ? side_cost(place, path_[i + 1].point) : infinite;
    if (in + out < (sides_[i - 1] + sides_[i]) * (1 - 1e-9) && fits_around(i)) {
      sides_[i - 1] = in;
      sides_[i] = out;
      return true;
    }
    path_[i].point = before;
    return false;
  }

  bool move_all() {
    bool moved = false;
    for (std::size_t i = 1; i + 1 < path_.size(); ++i) {
      poll_cancel();
      if (path_[i].by_hand) continue;
      const Point along = unit(planar(path_[i + 1].point - path_[i - 1].point));
      const Point across = left_normal(along);
      const double climb = step_ * site_.rules.grade;
      for (double side : {1.0, -1.0})
        for (double up : {0.0, 1.0, -1.0}) {
          Point shifted = path_[i].point + across * (side * step_);
          shifted.z += up * climb;
          moved |= try_place(i, shifted);
        }
      for (double share : {1.0, -1.0}) {
        moved |= try_place(i, path_[i].point + along * (share * step_));
        moved |= try_place(i, path_[i].point + Point{0, 0, share * climb});
      }
    }
    return moved;
  }

  void drop_all() {
    for (std::size_t i = 1; i + 1 < path_.size();) {
      const PathVertex kept = path_[i];
      const double with = sides_[i - 1] + sides_[i];
      if (kept.by_hand) {
        ++i;
        continue;
      }
      const double without = side_cost(path_[i - 1].point, path_[i + 1].point);
      path_.erase(path_.begin() + i);
      if (without <= with * dearer_without &&
          curves_fit(i > 2 ? i - 3 : 0, std::min(i + 2, path_.size() - 1))) {
        sides_[i - 1] = without;
        sides_.erase(sides_.begin() + i);
      } else {
        path_.insert(path_.begin() + i, kept);
        ++i;
      }
    }
  }

  const DesignSite& site_;
  CurveRoom room_;
  SectionCost section_;
  std::vector<PathVertex>& path_;
  std::vector<double> sides_;
  double step_, sample_;
};

}  // namespace

void settle_vertices(const DesignSite& site, double cell, std::vector<PathVertex>& path) {
  if (path.size() > 2) VertexSettler(site, cell, path).settle();
}

}  // namespace streetgen
