// PostGIS' stored form of a geometry (gserialized, version 2): numbers of types, and its flags.
#pragma once

#include <cstdint>

namespace streetgen::pg {

namespace stored_type {
constexpr std::uint32_t point = 1, line = 2, polygon = 3, multi_polygon = 6, circular_string = 8,
                        compound_curve = 9;
}  // namespace stored_type

namespace stored_flag {
constexpr std::uint8_t z = 0x01, m = 0x02, box = 0x04, geodetic = 0x08, extended = 0x10,
                       version = 0x40;
}  // namespace stored_flag

}  // namespace streetgen::pg
