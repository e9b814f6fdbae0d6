#include <cmath>
#include <limits>

#include "streetgen/error.hpp"
#include "truths.hpp"
#include "value/stored.hpp"
#include "value/wkb.hpp"

namespace streetgen::fuzz {

namespace {

template <class Read>
bool refuses(Read read) {
  try {
    read();
    return false;
  } catch (const Error& e) {
    return e.kind() == ErrorKind::invalid_input;
  }
}

bool refused(const std::string& wkb) {
  return refuses([&] { pg::read_line({wkb.data(), wkb.size()}, "the line"); });
}

void curves_come_back(Random& random, const Line& line, pg::Form form, Faults& faults) {
  CurvedLine curve;
  for (std::size_t i = 2; i < line.size(); i += 2)
    curve.push_back({{line[i - 2], line[i - 1], line[i]}, random.one_in(2)});
  if (curve.empty()) return;
  const std::string wkb = pg::write_curve(curve, form);
  const pg::ReadCurve read = pg::read_curve(wkb, "the curve");
  if (read.curve.size() != curve.size() || pg::write_curve(read.curve, form) != wkb)
    faults.push_back("a curve does not come back as it went");
  if (!refuses([&] {
        pg::read_curve(wkb.substr(0, random.below(static_cast<int>(wkb.size()))), "the curve");
      }))
    faults.push_back("a curve cut off is taken");
  // Bytes at random are refused, or are a curve or the head of something else.
  std::string stored;
  for (int bytes = random.below(80); bytes > 0; --bytes)
    stored += static_cast<char>(random.one_in(3) ? random.below(256) : random.below(10));
  refuses([&] { pg::read_curve(pg::wkb_of_stored(stored), "the curve"); });
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
  curves_come_back(random, line, form, faults);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Point& hit = line[random.below(static_cast<int>(line.size()))];
  (random.one_in(2) ? hit.x : hit.y) = random.one_in(2) ? nan : -INFINITY;
  if (!refused(pg::write_line(line, form))) faults.push_back("NaN or infinity is taken");
  return faults;
}

}  // namespace streetgen::fuzz
