#include <cmath>
#include <limits>

#include "streetgen/error.hpp"
#include "truths.hpp"
#include "value/wkb.hpp"

namespace streetgen::fuzz {

namespace {

bool refused(const std::string& wkb) {
  try {
    pg::read_line({wkb.data(), wkb.size()}, "the line");
    return false;
  } catch (const Error& e) {
    return e.kind() == ErrorKind::invalid_input;
  }
}

}  // namespace

Faults door_faults(std::uint64_t seed) {
  Random random(seed);
  Line line = random_line(random, {random.between(-1e9, 1e9), random.between(-1e9, 1e9), 0});
  const pg::Form form{random.one_in(2) ? 2154 : 0, random.one_in(2)};
  const std::string wkb = pg::write_line(line, form);
  Faults faults;
  const pg::ReadLine read = pg::read_line({wkb.data(), wkb.size()}, "the line");
  if (pg::write_line(read.line, {read.srid, read.has_z}) != wkb)
    faults.push_back("a line does not come back as it went");
  if (!refused(wkb.substr(0, random.below(static_cast<int>(wkb.size())))))
    faults.push_back("a line cut off is taken");
  std::string broken = wkb;
  for (int hits = 1 + random.below(4); hits > 0; --hits)
    broken[random.below(static_cast<int>(wkb.size()))] = static_cast<char>(random.below(256));
  if (!refused(broken))
    for (const Point& p : pg::read_line({broken.data(), broken.size()}, "the line").line)
      if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        faults.push_back("a vertex that is not finite is taken");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Point& hit = line[random.below(static_cast<int>(line.size()))];
  (random.one_in(2) ? hit.x : hit.y) = random.one_in(2) ? nan : -INFINITY;
  if (!refused(pg::write_line(line, form))) faults.push_back("NaN or infinity is taken");
  return faults;
}

}  // namespace streetgen::fuzz
