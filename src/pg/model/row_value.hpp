// The values of a row: how the fillers of rows put what the core computed.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "model/streets_rows.hpp"
#include "streetgen/width_profile.hpp"

namespace streetgen::pg {

inline Form flat(const ComputedStreets& computed) { return {computed.srid, false}; }
inline Form with_z(const ComputedStreets& computed) { return {computed.srid, computed.has_z}; }

// Before they have ids, nodes and edges refer to each other by numbers from 1 on.
inline std::int32_t number(std::size_t index) { return static_cast<std::int32_t>(index) + 1; }
inline std::string_view end_name(bool at_start) { return at_start ? "start" : "end"; }
inline std::string_view name(const char* text) { return text; }

// NULL where it has no place.
inline Value borders_value(const WidthProfile& borders) {
  if (borders.empty()) return {};
  std::vector<double> values;
  for (const WidthProfile::Place& place : borders.places)
    values.insert(values.end(), {place.abscissa, place.left, place.right});
  return values;
}

template <class... Values>
bool put(Row& row, Values&&... values) {
  row.clear();
  (row.emplace_back(std::forward<Values>(values)), ...);
  return true;
}

// Frees the rows of a table that are given once.
template <class T>
void release(std::vector<T>& rows) {
  std::vector<T>().swap(rows);
}

}  // namespace streetgen::pg
