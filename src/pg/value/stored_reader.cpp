// Points and curves from the form in which PostGIS stores them.
#include <cmath>
#include <cstdint>
#include <cstring>

#include "streetgen/error.hpp"
#include "value/stored.hpp"
#include "value/stored_format.hpp"

namespace streetgen::pg {

namespace {

constexpr std::uint32_t wkb_z = 0x80000000, wkb_m = 0x40000000, wkb_srid = 0x20000000;

class Transcript {
 public:
  explicit Transcript(std::string_view stored) : stored_(stored) {
    std::uint8_t srid[3];
    for (std::uint8_t& byte : srid) byte = take<std::uint8_t>();
    flags_ = take<std::uint8_t>();
    srid_ = (srid[0] & 0x1f) << 16 | srid[1] << 8 | srid[2];
    if ((flags_ & stored_flag::version) != 0 && (flags_ & stored_flag::extended) != 0) skip(8);
    const std::size_t stored_axes = (flags_ & stored_flag::geodetic) != 0 ? 3 : axes();
    if ((flags_ & stored_flag::box) != 0) skip(stored_axes * 2 * sizeof(float));
  }

  std::string wkb() {
    const std::uint32_t type = part(true);
    if (type == stored_type::compound_curve)
      for (std::uint32_t i = 0, parts = count(true); i < parts; ++i) points(part(false));
    else
      points(type);
    return std::move(out_);
  }

 private:
  std::size_t axes() const {
    return 2 + (flags_ & stored_flag::z ? 1 : 0) + (flags_ & stored_flag::m ? 1 : 0);
  }

  std::string_view skip(std::size_t bytes) {
    if (bytes > stored_.size() - at_)
      throw Error(ErrorKind::invalid_input, "the stored geometry is cut off");
    at_ += bytes;
    return stored_.substr(at_ - bytes, bytes);
  }
  template <class T>
  T take() {
    T value;
    std::memcpy(&value, skip(sizeof value).data(), sizeof value);
    return value;
  }
  template <class T>
  void put(T value) {
    out_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }

  // The head of a part; gives its type.
  std::uint32_t part(bool outer) {
    const auto type = take<std::uint32_t>();
    const bool with_srid = outer && srid_ != 0;
    put<std::uint8_t>(1);
    put<std::uint32_t>(type | (flags_ & stored_flag::z ? wkb_z : 0) |
                       (flags_ & stored_flag::m ? wkb_m : 0) | (with_srid ? wkb_srid : 0));
    if (with_srid) put<std::int32_t>(srid_);
    return type;
  }
  std::uint32_t count(bool written) {
    const auto number = take<std::uint32_t>();
    if (written) put(number);
    return number;
  }
  void points(std::uint32_t type) {
    const bool one = type == stored_type::point;
    if (!one && type != stored_type::line && type != stored_type::circular_string) return;
    const std::uint32_t number = count(!one);
    // A point that is empty has coordinates that are no numbers.
    if (one && number == 0)
      for (std::size_t i = 0; i < axes(); ++i) put(std::nan(""));
    out_.append(skip(number * axes() * sizeof(double)));
  }

  std::string_view stored_;
  std::size_t at_ = 0;
  std::uint8_t flags_ = 0;
  std::int32_t srid_ = 0;
  std::string out_;
};

}  // namespace

std::string wkb_of_stored(std::string_view stored) { return Transcript(stored).wkb(); }

}  // namespace streetgen::pg
