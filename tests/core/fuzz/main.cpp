// streetgen_fuzz FIRST COUNT [tiling]: every truth on COUNT seeds; a line for each that fails.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <optional>

#include "truths.hpp"

using namespace streetgen::fuzz;

// ASan's own: GEOS has no frame pointers, so that a whole stack is another one for each of its
// allocations, and keeping them takes most of the time. ASAN_OPTIONS goes before.
extern "C" __attribute__((visibility("default"))) const char* __asan_default_options() {
  return "malloc_context_size=1";
}

namespace {

template <class FaultsOf>
int count_faults(const char* what, std::uint64_t seed, FaultsOf faults_of) {
  Faults faults;
  // Stands alone when the process dies.
  std::fprintf(stderr, "\r%s seed %llu ", what, static_cast<unsigned long long>(seed));
  try {
    faults = faults_of();
  } catch (const std::exception& e) {
    faults.push_back(e.what());
  }
  for (const std::string& fault : faults)
    std::printf("%s seed %llu: %s\n", what, static_cast<unsigned long long>(seed), fault.c_str());
  return faults.empty() ? 0 : 1;
}

}  // namespace

int main(int count_of_arguments, char** arguments) {
  const bool tiling = count_of_arguments == 4 && std::strcmp(arguments[3], "tiling") == 0;
  if (count_of_arguments != 3 && !tiling) {
    std::fprintf(stderr, "usage: %s FIRST COUNT [tiling]\n", arguments[0]);
    return 2;
  }
  const std::uint64_t first = std::strtoull(arguments[1], nullptr, 10),
                      count = std::strtoull(arguments[2], nullptr, 10);
  int failed = 0;
  std::uint64_t checks = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    const auto check = [&](const char* what, auto faults_of) {
      failed += count_faults(what, seed, faults_of);
      ++checks;
    };
    std::optional<Made> made;
    check("streets", [&] {
      made.emplace(seed);
      return Faults{};
    });
    const auto check_made = [&](const char* what, Faults (*faults_of)(const Made&)) {
      if (made) check(what, [&] { return faults_of(*made); });
    };
    if (tiling) {
      check_made("tiling", tiling_faults);
      continue;
    }
    check_made("town", town_faults);
    // Two towns more.
    if (seed % 4 == 0) check_made("overrides", override_faults);
    check_made("lanes", lane_faults);
    check_made("interconnections", interconnection_faults);
    check("primitives", [&] { return primitive_faults(seed); });
    check("alignment", [&] { return alignment_faults(seed); });
    check("measures", [&] { return measure_faults(seed); });
    check("door", [&] { return door_faults(seed); });
  }
  std::fprintf(stderr, "\n");
  std::printf("%llu checks, %d failed\n", static_cast<unsigned long long>(checks), failed);
  return failed == 0 ? 0 : 1;
}
