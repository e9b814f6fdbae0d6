// An option of a city that is a number, or a list of numbers: its name, its meaning and its range.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "streetgen/error.hpp"

namespace streetgen {

struct OptionRange {
  double low;
  double high;
  bool whole;
  int fewest;  // numbers that the option takes
  int most;
};

// Error{invalid_input}, with a hint, for a value out of range, too few or many.
void check_option(const std::string& name, const std::string& description, const OptionRange& range,
                  const std::vector<double>& values);

template <class Options>
struct NumberOption {
  const char* name;
  std::variant<double Options::*, std::vector<double> Options::*> value;
  const char* unit;
  const char* description;
  OptionRange range;

  std::vector<double> of(const Options& options) const {
    if (const auto* number = std::get_if<double Options::*>(&value)) return {options.**number};
    return options.*std::get<std::vector<double> Options::*>(value);
  }
};

// Error{invalid_input}, with a hint, for an unknown name too.
template <class Options>
void set_option(const std::vector<NumberOption<Options>>& known, Options& options,
                const std::string& name, const std::vector<double>& values) {
  std::string names;
  for (const NumberOption<Options>& option : known) {
    names += (names.empty() ? "" : ", ") + std::string(option.name);
    if (name != option.name) continue;
    check_option(name, option.description, option.range, values);
    if (const auto* number = std::get_if<double Options::*>(&option.value))
      options.** number = values.front();
    else
      options.*std::get<std::vector<double> Options::*>(option.value) = values;
    return;
  }
  throw Error(ErrorKind::invalid_input, "unknown option \"" + name + "\"",
              "The options are " + names + ".");
}

}  // namespace streetgen
