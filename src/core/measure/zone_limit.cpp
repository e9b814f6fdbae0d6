#include "measure/zone_limit.hpp"

namespace streetgen {

namespace {

// 0: no limit of this kind is known.  The speed advised on German motorways stands for their limit.
struct CountryLimits {
  std::string_view country;
  double living_street, urban, rural, trunk, motorway;
};

constexpr CountryLimits countries[] = {
    {"ar", 0, 40, 110, 120, 130},
    {"at", walking_speed, 50, 100, 100, 130},
    {"au", 0, 50, 100, 0, 110},
    {"be", 20, 50, 90, 120, 120},
    {"be-bru", 20, 30, 70, 120, 120},
    {"be-vlg", 20, 50, 70, 120, 120},
    {"be-wal", 20, 50, 90, 120, 120},
    {"bg", 20, 50, 90, 120, 140},
    {"by", 20, 60, 90, 90, 110},
    {"ch", 20, 50, 80, 100, 120},
    {"cz", 20, 50, 90, 110, 130},
    {"de", walking_speed, 50, 100, 100, 130},
    {"dk", 15, 50, 80, 80, 130},
    {"ee", 20, 50, 90, 90, 0},
    {"es", 20, 50, 90, 90, 120},
    {"fi", 20, 50, 80, 100, 120},
    {"fr", 20, 50, 80, 110, 130},
    {"gb", 20 * mile, 30 * mile, 60 * mile, 70 * mile, 70 * mile},
    {"gr", 20, 50, 90, 110, 130},
    {"hr", walking_speed, 50, 90, 110, 130},
    {"hu", 20, 50, 90, 110, 130},
    {"ie", 0, 50, 80, 100, 120},
    {"it", 30, 50, 90, 110, 130},
    {"jp", 0, 60, 60, 60, 100},
    {"kz", 20, 60, 90, 100, 140},
    {"lt", 20, 50, 90, 120, 130},
    {"lu", 20, 50, 90, 90, 130},
    {"lv", 20, 50, 90, 90, 0},
    {"md", 20, 50, 90, 110, 110},
    {"nl", 15, 50, 80, 100, 100},
    {"no", walking_speed, 50, 80, 80, 110},
    {"nz", 0, 50, 100, 100, 100},
    {"pl", 20, 50, 90, 100, 140},
    {"pt", 20, 50, 90, 100, 120},
    {"ro", 20, 50, 90, 100, 130},
    {"rs", 10, 50, 80, 100, 130},
    {"ru", 20, 60, 90, 90, 110},
    {"se", walking_speed, 50, 70, 90, 110},
    {"si", 10, 50, 90, 110, 130},
    {"sk", 20, 50, 90, 130, 130},
    {"tr", 20, 50, 90, 110, 120},
    {"ua", 20, 50, 90, 110, 130},
    {"uk", 20 * mile, 30 * mile, 60 * mile, 70 * mile, 70 * mile},
    {"za", 0, 60, 100, 120, 120}};

std::optional<double> known(double limit) {
  if (limit == 0) return std::nullopt;
  return limit;
}

}  // namespace

std::optional<double> zone_limit(std::string_view country, std::string_view zone) {
  for (const CountryLimits& limits : countries) {
    if (limits.country != country) continue;
    if (zone == "living_street" || zone == "pedestrian_zone") return known(limits.living_street);
    if (zone == "urban") return limits.urban;
    if (zone == "rural") return limits.rural;
    if (zone == "trunk") return known(limits.trunk);
    if (zone == "motorway") return known(limits.motorway);
    if (zone == "bicycle_road") return 30;
    if (zone == "walk") return walking_speed;
    if (!signs_in_miles(country)) return std::nullopt;
    if (zone == "nsl_restricted") return 30 * mile;
    if (zone == "nsl_single") return 60 * mile;
    if (zone == "nsl_dual") return 70 * mile;
  }
  return std::nullopt;
}

bool signs_in_miles(std::string_view country) {
  return country == "gb" || country == "uk" || country == "us";
}

}  // namespace streetgen
