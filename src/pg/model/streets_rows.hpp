// What was computed, table by table: a row for each thing that the core found, in plain values.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "streetgen/street_model.hpp"
#include "value/stored.hpp"

namespace streetgen::pg {

struct ComputedStreets : StreetModel {
  ComputedStreets(StreetModel model, int srid, bool has_z)
      : StreetModel(std::move(model)), srid(srid), has_z(has_z) {}
  int srid = 0;
  bool has_z = false;  // nodes, edges and section limits carry Z
};

// The ids of computed things in their order, as the caller of a table keeps them; 0 where a thing
// has none and, as all beyond the last, is not written.
struct Ids {
  const std::int64_t* ids = nullptr;
  std::size_t count = 0;

  std::int64_t operator[](std::size_t index) const { return index < count ? ids[index] : 0; }
};
struct Named {
  Ids nodes, edges, lanes;
};

struct Geometry {
  Stored bytes;
};
// An arc: PostGIS knows its box.
struct Ewkb {
  std::string bytes;
};
// monostate: NULL. string_view: a word of the code.
using Value =
    std::variant<std::monostate, bool, std::int32_t, std::int64_t, double, std::string_view,
                 std::string, Geometry, Ewkb, std::vector<std::int64_t>, std::vector<double>>;
using Row = std::vector<Value>;

// The rows of a table, made one by one in the order of its columns in SQL after the first, the
// number by which others refer to it.
struct Table {
  std::size_t (*count)(const ComputedStreets& computed);
  // False: what it belongs to has no id, and nothing is written of this one.
  bool (*fill)(const ComputedStreets& computed, const Named& named, std::size_t index, Row& row);
  // Frees what these rows alone tell: they are given once. Null: they may be given again.
  void (*forget)(ComputedStreets& computed) = nullptr;
};

}  // namespace streetgen::pg
