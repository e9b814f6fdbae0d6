#include "value/line_array.hpp"

namespace streetgen::pg {

LineArray take_lines(ArrayType* array, const char* name) {
  LineArray lines;
  bool* nulls;
  deconstruct_array(array, BYTEAOID, -1, false, 'i', &lines.values, &nulls, &lines.count);
  for (int i = 0; i < lines.count; ++i) {
    if (nulls[i])
      ereport(ERROR, (errcode(ERRCODE_NULL_VALUE_NOT_ALLOWED),
                      errmsg("element %d of %s is NULL", i + 1, name)));
    lines.values[i] = PointerGetDatum(PG_DETOAST_DATUM_PACKED(lines.values[i]));
  }
  return lines;
}

std::vector<Line> read_lines(const LineArray& array, const std::string& what, Form* form) {
  std::vector<Line> lines;
  lines.reserve(array.count);
  for (int i = 0; i < array.count; ++i) {
    ReadLine read = read_line(bytes_of(array.values[i]), what + " " + std::to_string(i + 1));
    if (form != nullptr) *form = {read.srid, read.has_z};
    lines.push_back(std::move(read.line));
  }
  return lines;
}

}  // namespace streetgen::pg
