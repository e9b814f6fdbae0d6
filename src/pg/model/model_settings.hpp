// The settings of a model, and what the core makes of them.
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <utility>

#include "frame/argument.hpp"
#include "model/streets_call.hpp"
#include "streetgen/interconnection.hpp"
#include "streetgen/lane.hpp"
#include "streetgen/street.hpp"

namespace streetgen::pg {

// By name.  A setting without a value, or with one that means nothing, is refused by its name.
class Settings {
 public:
  explicit Settings(const StreetsCall& call);

  // streetgen._default_setting() has the range of each; here stands what the core can bear.
  double measure(const char* name, double low = 0, double high = 1000) const;
  // Whether a setting that may be NULL is not.
  bool is_given(const char* name) const { return values_.count(name) > 0; }
  double measure_or_none(const char* name) const { return is_given(name) ? measure(name) : 0; }
  double measure_or_unbounded(const char* name) const;
  // Of a JSON object of number to number, such as {"0": 10, "60": 20}.
  std::map<double, double> steps(const char* name) const;

  template <class Meaning>
  Meaning choice(const char* name,
                 std::initializer_list<std::pair<const char*, Meaning>> words) const {
    return word_of<Meaning>(word(name), name, words);
  }

  const std::string& word(const char* name) const;

 private:
  std::map<std::string, std::string> values_;
};

TransitionKind transition_kind_of(const std::string& word);

StreetSettings street_settings_of(const Settings& given);
LaneSettings lane_settings_of(const Settings& given);
InterconnectionSettings interconnection_settings_of(const Settings& given);

}  // namespace streetgen::pg
