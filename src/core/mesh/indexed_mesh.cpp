#include "streetgen/indexed_mesh.hpp"

#include <cmath>
#include <cstddef>
#include <unordered_map>

#include "geometry/polyline.hpp"
#include "streetgen/cancel.hpp"

namespace streetgen {

namespace {

constexpr double thousandth = 1e-3;

// A list without repetitions, and the number of each value in it.
template <std::size_t size>
class NumberedList {
 public:
  using Value = std::array<std::int64_t, size>;

  explicit NumberedList(std::vector<Value>& values) : values_(values) {}

  int number(const Value& value) {
    const auto [known, added] = numbers_.try_emplace(value, static_cast<int>(values_.size()));
    if (added) values_.push_back(value);
    return known->second;
  }

 private:
  struct Hash {
    std::size_t operator()(const Value& value) const {
      std::size_t hash = 0;
      for (const std::int64_t part : value)
        hash = (hash ^ (hash >> 29)) * 0x9e3779b97f4a7c15 + static_cast<std::size_t>(part);
      return hash * 0x9e3779b97f4a7c15;
    }
  };
  std::vector<Value>& values_;
  std::unordered_map<Value, int, Hash> numbers_;
};

std::int64_t steps(double metres, double step) { return std::llround(metres / step); }

}  // namespace

IndexedMesh indexed_mesh(const std::vector<const SurfaceMesh*>& meshes, const Point& origin,
                         double step) {
  IndexedMesh indexed;
  NumberedList<3> places(indexed.places), normals(indexed.normals);
  NumberedList<2> texture(indexed.texture);
  for (const SurfaceMesh* mesh : meshes) {
    poll_cancel();
    auto& triangles = indexed.triangles.emplace_back();
    for (std::size_t i = 0; i < mesh->triangles.size(); ++i) {
      std::array<NumberedList<3>::Value, 3> place;
      for (std::size_t k = 0; k < 3; ++k) {
        const Point from_origin = mesh->triangles[i][k] - origin;
        place[k] = {steps(from_origin.x, step), steps(from_origin.y, step),
                    steps(from_origin.z, step)};
      }
      if (place[0] == place[1] || place[1] == place[2] || place[2] == place[0]) continue;
      auto& corners = triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const Point& normal = mesh->normals[3 * i + k];
        const auto& [along, aside] = mesh->texture[3 * i + k];
        corners[k] = {places.number(place[k]),
                      normals.number({steps(normal.x, thousandth), steps(normal.y, thousandth),
                                      steps(normal.z, thousandth)}),
                      texture.number({steps(along, thousandth), steps(aside, thousandth)})};
      }
    }
  }
  return indexed;
}

}  // namespace streetgen
