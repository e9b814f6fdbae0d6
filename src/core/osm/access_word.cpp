#include "osm/access_word.hpp"

#include <algorithm>
#include <cctype>
#include <map>

#include "streetgen/osm_lanes.hpp"

namespace streetgen {

namespace {

std::string trimmed(const std::string& text) {
  const auto is_space = [](char letter) {
    return std::isspace(static_cast<unsigned char>(letter));
  };
  std::string word;
  for (const char letter : text)
    word += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  while (!word.empty() && is_space(word.back())) word.pop_back();
  word.erase(word.begin(), std::find_if_not(word.begin(), word.end(), is_space));
  return word;
}

}  // namespace

Access access_of_word(const std::string& word) {
  static const std::map<std::string, Access> meanings = {
      {"", Access::all},
      {"yes", Access::all},
      {"permissive", Access::all},
      {"public", Access::all},
      {"designated", Access::all},
      {"official", Access::all},
      {"discouraged", Access::all},
      {"use_sidepath", Access::all},
      {"unknown", Access::all},
      {"destination", Access::destination},
      {"local", Access::destination},
      {"customers", Access::customers},
      {"customer", Access::customers},
      {"delivery", Access::delivery},
      {"loading", Access::delivery},
      {"private", Access::owners},
      {"permit", Access::owners},
      {"residents", Access::owners},
      {"resident", Access::owners},
      {"employees", Access::owners},
      {"restricted", Access::owners},
      {"carpool", Access::carpool},
      {"hov", Access::carpool},
      {"bus", Access::bus},
      {"psv", Access::bus},
      {"taxi", Access::bus},
      {"cycle", Access::cycle},
      {"bicycle", Access::cycle},
      {"no", Access::nobody},
      {"none", Access::nobody},
      {"closed", Access::nobody},
      {"agricultural", Access::nobody},
      {"forestry", Access::nobody},
      {"emergency", Access::nobody},
      {"military", Access::nobody},
      {"construction", Access::nobody},
      {"foot", Access::nobody},
      {"dismount", Access::nobody},
  };
  const auto found = meanings.find(trimmed(word));
  return found == meanings.end() ? Access::strange : found->second;
}

Access access_of(const std::string& said) {
  Access most = Access::nobody;
  for (std::size_t from = 0; from <= said.size();) {
    const std::size_t to = std::min(said.find(';', from), said.size());
    most = std::min(most, access_of_word(said.substr(from, to - from)));
    from = to + 1;
  }
  return most;
}

const char* access_name(Access access) {
  switch (access) {
    case Access::all:
      return "";
    case Access::strange:
      return "?";
    case Access::destination:
      return "destination";
    case Access::customers:
      return "customers";
    case Access::delivery:
      return "delivery";
    case Access::owners:
      return "private";
    case Access::carpool:
      return "carpool";
    case Access::bus:
      return "bus";
    case Access::cycle:
      return "cycle";
    case Access::nobody:
      return "no";
  }
  return "?";
}

const char* access_word(const std::string& said) { return access_name(access_of_word(said)); }

bool shuts_cars_out(Access access) { return access == Access::owners || access == Access::nobody; }

bool lets_cars_end(Access access) {
  return access == Access::destination || access == Access::customers || access == Access::delivery;
}

bool lets_in(Access access) {
  return access != Access::nobody && access != Access::strange && access != Access::owners;
}

}  // namespace streetgen
