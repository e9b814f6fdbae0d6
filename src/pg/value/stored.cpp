#include "value/stored.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "frame/varlena.hpp"
#include "value/stored_format.hpp"

namespace streetgen::pg {

namespace {

// The nearest floats that a box may end at and still hold the number.
float at_most(double number) {
  const float near = static_cast<float>(number);
  return near <= number ? near : std::nextafter(near, -HUGE_VALF);
}
float at_least(double number) {
  const float near = static_cast<float>(number);
  return near >= number ? near : std::nextafter(near, HUGE_VALF);
}

struct Extent {
  static constexpr double beyond = std::numeric_limits<double>::infinity();
  Point low{beyond, beyond, beyond}, high{-beyond, -beyond, -beyond};

  void hold(const Line& line) {
    for (const Point& p : line) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
};

constexpr std::size_t bytes_of_point(bool has_z) { return (has_z ? 3 : 2) * sizeof(double); }

class Writer {
 public:
  // So many bytes come after the head; a point, two points and what is empty have no box.
  Writer(Form form, std::size_t bytes, const Extent* extent) : has_z_(form.has_z) {
    const std::size_t box = extent == nullptr ? 0 : (has_z_ ? 6 : 4) * sizeof(float);
    const std::size_t all = VARHDRSZ + 4 + box + bytes;
    out_.reset(new char[all]);
    at_ = out_.get() + VARHDRSZ;
    SET_VARSIZE(out_.get(), all);
    for (const int shift : {16, 8, 0}) put(static_cast<std::uint8_t>(form.srid >> shift));
    put<std::uint8_t>(stored_flag::version | (box > 0 ? stored_flag::box : 0) |
                      (has_z_ ? stored_flag::z : 0));
    if (extent == nullptr) return;
    put_range(extent->low.x, extent->high.x);
    put_range(extent->low.y, extent->high.y);
    if (has_z_) put_range(extent->low.z, extent->high.z);
  }
  void head(std::uint32_t type, std::size_t count) {
    put(type);
    put(static_cast<std::uint32_t>(count));
  }
  template <class T>
  void put(const T& value, std::size_t bytes = sizeof(T)) {
    std::memcpy(at_, &value, bytes);
    at_ += bytes;
  }
  void put(const Line& line) {
    if (has_z_)
      put_points<bytes_of_point(true)>(line);
    else
      put_points<bytes_of_point(false)>(line);
  }
  Stored take() { return std::move(out_); }

 private:
  void put_range(double low, double high) {
    put(at_most(low));
    put(at_least(high));
  }

  template <std::size_t bytes>
  void put_points(const Line& line) {
    char* at = at_;
    for (const Point& p : line) {
      std::memcpy(at, &p, bytes);
      at += bytes;
    }
    at_ = at;
  }

  bool has_z_;
  Stored out_;
  char* at_;
};

constexpr std::size_t head_bytes = 2 * sizeof(std::uint32_t);

// The counts of a polygon's rings end at a multiple of eight bytes.
std::size_t padded(std::size_t rings) { return rings + rings % 2; }

}  // namespace

Stored stored_point(const Point& point, Form form) {
  Writer writer(form, head_bytes + bytes_of_point(form.has_z), nullptr);
  writer.head(stored_type::point, 1);
  writer.put(point, bytes_of_point(form.has_z));
  return writer.take();
}

Stored stored_line(const Line& line, Form form) {
  Extent extent;
  extent.hold(line);
  Writer writer(form, head_bytes + line.size() * bytes_of_point(form.has_z),
                line.size() > 2 ? &extent : nullptr);
  writer.head(stored_type::line, line.size());
  writer.put(line);
  return writer.take();
}

Stored stored_surface(const MultiPolygon& surface, Form form) {
  Extent extent;
  std::size_t bytes = head_bytes;
  for (const Polygon& polygon : surface) {
    bytes += head_bytes + padded(polygon.size()) * sizeof(std::uint32_t);
    for (const Ring& ring : polygon) {
      extent.hold(ring);
      bytes += ring.size() * bytes_of_point(form.has_z);
    }
  }
  Writer writer(form, bytes, surface.empty() ? nullptr : &extent);
  writer.head(stored_type::multi_polygon, surface.size());
  for (const Polygon& polygon : surface) {
    writer.head(stored_type::polygon, polygon.size());
    for (const Ring& ring : polygon) writer.put(static_cast<std::uint32_t>(ring.size()));
    if (polygon.size() % 2 != 0) writer.put(std::uint32_t{0});
    for (const Ring& ring : polygon) writer.put(ring);
  }
  return writer.take();
}

}  // namespace streetgen::pg
