#include <cmath>

#include "streetgen/measure_text.hpp"
#include "truths.hpp"

namespace streetgen::fuzz {

namespace {

std::string random_text(Random& random) {
  static const std::vector<std::string> pieces{
      "7",  "3,5", "12", "1.234,5", "-",  ";",     "|",    "~",      "'",    "\"",      " ",
      "m",  "ft",  "in", "us-ft",   "to", "mph",   "kn",   "walk",   "DE:",  "GB:",     "zone",
      "30", "e-5", "e+", "urban",   ":",  "rural", "ca. ", "\u2032", "\xe2", "99999999"};
  std::string text;
  for (int count = random.below(8); count > 0; --count)
    text += random.one_in(12) ? std::string(1, static_cast<char>(random.below(256)))
                              : random.of(pieces);
  return text;
}

bool alike(const std::optional<double>& a, const std::optional<double>& b) {
  return a.has_value() == b.has_value() && (!a || std::abs(*a - *b) <= 1e-9 * (1 + std::abs(*a)));
}

}  // namespace

Faults measure_faults(std::uint64_t seed) {
  Random random(seed);
  Faults faults;
  for (int count = 0; count < 100; ++count) {
    const std::string text = random_text(random);
    const auto metres = read_metres(text), kmh = read_kmh(text);
    if (metres && !std::isfinite(*metres)) faults.push_back("'" + text + "' is no finite length");
    if (kmh && !(std::isfinite(*kmh) && *kmh >= 0))
      faults.push_back("'" + text + "' is no finite speed");
    if (!alike(metres, read_metres(" " + text + "\t")) || !alike(kmh, read_kmh(" " + text + "\n")))
      faults.push_back("spaces about '" + text + "' change it");
  }
  const int tenths = random.below(1000);
  const std::string whole = std::to_string(tenths / 10), rest = std::to_string(tenths % 10);
  for (const std::string text :
       {whole + "." + rest, whole + "," + rest + " m", "~" + whole + "." + rest + "m"})
    if (!alike(read_metres(text), tenths / 10.0)) faults.push_back("'" + text + "' is misread");
  return faults;
}

}  // namespace streetgen::fuzz
