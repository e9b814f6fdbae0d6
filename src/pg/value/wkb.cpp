#include "value/wkb.hpp"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "streetgen/error.hpp"

namespace streetgen::pg {

namespace {

enum Type : std::uint32_t {
  point_type = 1,
  line_type = 2,
  polygon_type = 3,
  multi_line_type = 5,
  multi_polygon_type = 6,
  circular_type = 8,
  compound_type = 9,
  curve_polygon_type = 10,
  tin_type = 16,
  triangle_type = 17
};
constexpr std::uint32_t z_flag = 0x80000000, m_flag = 0x40000000, srid_flag = 0x20000000;

class Reader {
 public:
  Reader(std::string_view bytes, const std::string& what) : bytes_(bytes), what_(what) {}

  [[noreturn]] void refuse(const std::string& why) const {
    throw Error(ErrorKind::invalid_input, what_ + " " + why);
  }
  template <class T>
  T take() {
    if (at_ + sizeof(T) > bytes_.size()) refuse("is cut off");
    T value;
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  std::size_t left() const { return bytes_.size() - at_; }

 private:
  std::string_view bytes_;
  const std::string& what_;
  std::size_t at_ = 0;
};

const char* type_name(std::uint32_t type) {
  switch (type) {
    case point_type:
      return "POINT";
    case line_type:
      return "LINESTRING";
    case polygon_type:
      return "POLYGON";
    case 4:
      return "MULTIPOINT";
    case multi_line_type:
      return "MULTILINESTRING";
    case multi_polygon_type:
      return "MULTIPOLYGON";
    case 7:
      return "GEOMETRYCOLLECTION";
    case circular_type:
      return "CIRCULARSTRING";
    case compound_type:
      return "COMPOUNDCURVE";
    case curve_polygon_type:
      return "CURVEPOLYGON";
    default:
      return "geometry of another type";
  }
}

struct Head {
  std::uint32_t type;
  bool has_z;
  int srid;
};

Head read_head(Reader& reader) {
  if (reader.take<std::uint8_t>() != 1) reader.refuse("is not little-endian EWKB");
  const auto word = reader.take<std::uint32_t>();
  if (word & m_flag) reader.refuse("has measures (M), drop them with ST_Force2D or ST_Force3DZ");
  Head head{word & 0xff, (word & z_flag) != 0, 0};
  if (word & srid_flag) head.srid = reader.take<std::int32_t>();
  return head;
}

class Writer {
 public:
  // Room is made once: for so many points, and heads with a count.
  Writer(Type type, Form form, std::size_t points, std::size_t heads = 1) : has_z_(form.has_z) {
    out_.reserve(points * bytes_of_point() + heads * 13);
    head(type, form, true);
  }
  void head(Type type, Form form, bool outer) {
    const bool with_srid = outer && form.srid != 0;
    put<std::uint8_t>(1);
    put<std::uint32_t>(type | (has_z_ ? z_flag : 0) | (with_srid ? srid_flag : 0));
    if (with_srid) put<std::int32_t>(form.srid);
  }
  template <class T>
  void put(T value) {
    out_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put(const Point& p) { out_.append(reinterpret_cast<const char*>(&p), bytes_of_point()); }
  void put(const Line& line) {
    put<std::uint32_t>(line.size());
    for (const Point& p : line) put(p);
  }
  void put(const Polygon& polygon) {
    put<std::uint32_t>(polygon.size());
    for (const Ring& ring : polygon) put(static_cast<const Line&>(ring));
  }
  std::string take() { return std::move(out_); }

 private:
  std::size_t bytes_of_point() const { return has_z_ ? sizeof(Point) : 2 * sizeof(double); }

  bool has_z_;
  std::string out_;
};

Point read_vertex(Reader& reader, bool has_z, std::uint32_t number) {
  Point p;
  p.x = reader.take<double>();
  p.y = reader.take<double>();
  if (has_z) p.z = reader.take<double>();
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
    reader.refuse("has a vertex that is not finite, number " + std::to_string(number));
  if (std::abs(p.x) > 1e12 || std::abs(p.y) > 1e12 || std::abs(p.z) > 1e12)
    reader.refuse("has a coordinate beyond 1e12 m at vertex " + std::to_string(number));
  return p;
}

// The points of one part of a curve.
Line read_points(Reader& reader, bool has_z) {
  const auto count = reader.take<std::uint32_t>();
  if (count > reader.left() / 16) reader.refuse("is cut off");
  Line points;
  for (std::uint32_t i = 0; i < count; ++i) points.push_back(read_vertex(reader, has_z, i + 1));
  return points;
}

void append_part(Reader& reader, const Head& head, CurvedLine& curve) {
  const Line points = read_points(reader, head.has_z);
  if (head.type == line_type)
    for (std::size_t i = 1; i < points.size(); ++i)
      curve.push_back({{points[i - 1], {}, points[i]}, false});
  else if (points.size() % 2 == 0 && !points.empty())
    reader.refuse("has an arc of two points");
  else
    for (std::size_t i = 2; i < points.size(); i += 2)
      curve.push_back({{points[i - 2], points[i - 1], points[i]}, true});
}

}  // namespace

ReadCurve read_curve(std::string_view wkb, const std::string& what) {
  Reader reader(wkb, what);
  const Head head = read_head(reader);
  ReadCurve read{{}, head.srid, head.has_z};
  if (head.type == line_type || head.type == circular_type) {
    append_part(reader, head, read.curve);
  } else if (head.type == compound_type) {
    const auto parts = reader.take<std::uint32_t>();
    for (std::uint32_t i = 0; i < parts; ++i) {
      const Head part = read_head(reader);
      if (part.type != line_type && part.type != circular_type)
        reader.refuse(std::string("has a part that is a ") + type_name(part.type));
      append_part(reader, part, read.curve);
    }
  } else {
    reader.refuse(std::string("is a ") + type_name(head.type) +
                  ", expected a COMPOUNDCURVE or a LINESTRING");
  }
  if (read.curve.empty()) reader.refuse(std::string("is an empty ") + type_name(head.type));
  return read;
}

ReadPoint read_point(std::string_view wkb, const std::string& what) {
  Reader reader(wkb, what);
  const Head head = read_head(reader);
  if (head.type != point_type)
    reader.refuse(std::string("is a ") + type_name(head.type) + ", expected a POINT");
  return {read_vertex(reader, head.has_z, 1), head.srid, head.has_z};
}

ReadLine read_line(std::string_view wkb, const std::string& what) {
  Reader reader(wkb, what);
  Head head = read_head(reader);
  ReadLine read{{}, head.srid, head.has_z};
  if (head.type == multi_line_type) {
    const auto parts = reader.take<std::uint32_t>();
    if (parts != 1)
      reader.refuse("is a MULTILINESTRING of " + std::to_string(parts) +
                    " parts, expected a LINESTRING; ST_Dump takes it apart");
    head = read_head(reader);
  }
  if (head.type != line_type)
    reader.refuse(std::string("is a ") + type_name(head.type) + ", expected a LINESTRING");
  const auto count = reader.take<std::uint32_t>();
  if (count == 0) reader.refuse("is an empty LINESTRING");
  if (count > reader.left() / 16) reader.refuse("is cut off");
  bool distinct = false;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Point p = read_vertex(reader, head.has_z, i + 1);
    distinct = distinct || (i > 0 && (p.x != read.line[0].x || p.y != read.line[0].y));
    read.line.push_back(p);
  }
  if (!distinct) reader.refuse("has no length: all its points are one");
  return read;
}

Line read_vertices(std::string_view wkb, const std::string& what) {
  Reader reader(wkb, what);
  const Head head = read_head(reader);
  if (head.type != line_type)
    reader.refuse(std::string("is a ") + type_name(head.type) + ", expected a LINESTRING");
  return read_points(reader, head.has_z);
}

MultiPolygon read_surface(std::string_view wkb, const std::string& what) {
  Reader reader(wkb, what);
  const Head head = read_head(reader);
  if (head.type != multi_polygon_type)
    reader.refuse(std::string("is a ") + type_name(head.type) + ", expected a MULTIPOLYGON");
  const auto count = [&](std::size_t least_bytes) {
    const auto parts = reader.take<std::uint32_t>();
    if (parts > reader.left() / least_bytes) reader.refuse("is cut off");
    return parts;
  };
  MultiPolygon surface(count(9));
  for (Polygon& polygon : surface) {
    read_head(reader);
    polygon.resize(count(4));
    if (polygon.empty()) reader.refuse("has an empty part");
    for (Ring& ring : polygon) {
      ring.resize(count(16));
      if (ring.size() < 4) reader.refuse("has a ring of less than four points");
      for (std::size_t i = 0; i < ring.size(); ++i)
        ring[i] = read_vertex(reader, head.has_z, static_cast<std::uint32_t>(i) + 1);
    }
  }
  return surface;
}

std::string write_point(const Point& point, Form form) {
  Writer writer(point_type, form, 1);
  writer.put(point);
  return writer.take();
}

std::string write_line(const Line& line, Form form) {
  Writer writer(line_type, form, line.size());
  writer.put(line);
  return writer.take();
}

std::string write_arc(const Arc& arc, Form form) {
  Writer writer(circular_type, form, 3);
  writer.put(Line{arc.start, arc.middle, arc.end});
  return writer.take();
}

std::string write_surface(const MultiPolygon& surface, Form form) {
  std::size_t points = 0, heads = 1;
  for (const Polygon& polygon : surface) {
    heads += 1 + polygon.size();
    for (const Ring& ring : polygon) points += ring.size();
  }
  Writer writer(multi_polygon_type, form, points, heads);
  writer.put<std::uint32_t>(surface.size());
  for (const Polygon& polygon : surface) {
    writer.head(polygon_type, form, false);
    writer.put(polygon);
  }
  return writer.take();
}

std::string write_polygon(const MultiPolygon& surface, Form form) {
  if (surface.size() > 1) return write_surface(surface, form);
  Writer writer(polygon_type, form, 0);
  writer.put(surface.empty() ? Polygon{} : surface.front());
  return writer.take();
}

std::string write_curved(const CurvedRing& ring, Form form) {
  Writer writer(curve_polygon_type, form, 3 * ring.size(), 2 + ring.size());
  writer.put<std::uint32_t>(1);
  writer.head(compound_type, form, false);
  writer.put<std::uint32_t>(ring.size());
  for (const RingPiece& piece : ring) {
    writer.head(piece.curved ? circular_type : line_type, form, false);
    writer.put(piece.curved ? Line{piece.arc.start, piece.arc.middle, piece.arc.end}
                            : Line{piece.arc.start, piece.arc.end});
  }
  return writer.take();
}

std::string write_curve(const CurvedLine& curve, Form form) {
  // Straight pieces that follow each other are one LINESTRING.
  std::vector<Line> parts;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const Arc& arc = curve[i].arc;
    if (curve[i].curved)
      parts.push_back({arc.start, arc.middle, arc.end});
    else if (i > 0 && !curve[i - 1].curved)
      parts.back().push_back(arc.end);
    else
      parts.push_back({arc.start, arc.end});
  }
  Writer writer(compound_type, form, 3 * curve.size(), 1 + parts.size());
  writer.put<std::uint32_t>(parts.size());
  std::size_t piece = 0;
  for (const Line& part : parts) {
    const bool curved = curve[piece].curved;
    writer.head(curved ? circular_type : line_type, form, false);
    writer.put(part);
    piece += curved ? 1 : part.size() - 1;
  }
  return writer.take();
}

std::string write_tin(const std::vector<std::array<Point, 3>>& triangles, int srid) {
  const Form form{srid, true};
  Writer writer(tin_type, form, 4 * triangles.size(), 1 + 2 * triangles.size());
  writer.put<std::uint32_t>(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    writer.head(triangle_type, form, false);
    writer.put(Polygon{{a, b, c, a}});
  }
  return writer.take();
}

}  // namespace streetgen::pg
