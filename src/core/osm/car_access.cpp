#include "osm/car_access.hpp"

#include <algorithm>
#include <initializer_list>

namespace streetgen {

namespace {

// Of several words, parted by ;, the one that lets most in counts: is it one of these?
bool all_among(const std::string& said, std::initializer_list<const char*> words) {
  for (std::size_t from = 0; from <= said.size();) {
    const std::size_t to = std::min(said.find(';', from), said.size());
    const std::string word = said.substr(from, to - from);
    if (std::find(words.begin(), words.end(), word) == words.end()) return false;
    from = to + 1;
  }
  return true;
}

}  // namespace

bool shuts_cars_out(const std::string& said) {
  return all_among(said, {"no", "none", "closed", "agricultural", "forestry", "emergency",
                          "military", "construction", "private", "permit", "residents", "resident",
                          "employees", "restricted"});
}

bool lets_cars_end(const std::string& said) {
  return !shuts_cars_out(said) &&
         all_among(said, {"destination", "local", "customers", "customer", "delivery", "loading",
                          "private", "no", "agricultural", "forestry"});
}

}  // namespace streetgen
