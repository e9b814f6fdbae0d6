// Which boxes lie near a box: an R-tree, packed where all boxes are known at once. A box that holds
// nothing lies near none and stays out of the tree.
#pragma once

#include <algorithm>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
// From Boost 1.76 on the tree does not bring the strategies of its boxes.
#if __has_include(<boost/geometry/strategies/index/cartesian.hpp>)
#include <boost/geometry/strategies/index/cartesian.hpp>
#include <boost/geometry/strategies/relate/cartesian.hpp>
#endif
#include <utility>
#include <vector>

#include "geometry/box.hpp"
#include "streetgen/geometry.hpp"

namespace streetgen {

class BoxIndex {
 public:
  using Corner = boost::geometry::model::d2::point_xy<double>;
  using Extent = boost::geometry::model::box<Corner>;
  using Entry = std::pair<Extent, int>;

  BoxIndex() = default;
  explicit BoxIndex(const std::vector<Box>& boxes) : tree_(entries(boxes)) {}

  void add(const Box& box, int index) {
    if (!box.empty()) tree_.insert({grown(box, 0), index});
  }

  // Indices of the boxes that meet `box` grown by `margin`, ascending.
  std::vector<int> near(const Box& box, double margin) const {
    std::vector<int> indices;
    each_near(box, margin, [&](int index) { indices.push_back(index); });
    std::sort(indices.begin(), indices.end());
    return indices;
  }

  // The same, one by one, in no order.
  template <class Use>
  void each_near(const Box& box, double margin, Use use) const {
    tree_.query(
        boost::geometry::index::intersects(grown(box, margin)),
        boost::make_function_output_iterator([&](const Entry& entry) { use(entry.second); }));
  }

  // Whether `holds` is true of any of them; asked in no order, and only until it is.
  template <class Holds>
  bool any_near(const Box& box, double margin, Holds holds) const {
    for (auto found = tree_.qbegin(boost::geometry::index::intersects(grown(box, margin)));
         found != tree_.qend(); ++found)
      if (holds(found->second)) return true;
    return false;
  }

 private:
  static Extent grown(const Box& box, double margin) {
    return {{box.min_x - margin, box.min_y - margin}, {box.max_x + margin, box.max_y + margin}};
  }
  static std::vector<Entry> entries(const std::vector<Box>& boxes) {
    std::vector<Entry> all;
    all.reserve(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (!boxes[i].empty()) all.push_back({grown(boxes[i], 0), static_cast<int>(i)});
    return all;
  }
  boost::geometry::index::rtree<Entry, boost::geometry::index::quadratic<16>> tree_;
};

}  // namespace streetgen
