// Numbers and words from SQL, proven before the core sees them.  Each refusal is an
// Error{invalid_input} that names the argument and its value.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>

#include "streetgen/error.hpp"

namespace streetgen::pg {

double in_range(double value, double low, double high, const std::string& name);
double finite(double value, const std::string& name);

[[noreturn]] void refuse_word(const std::string& word, const std::string& name,
                              const std::string& expected);

// What the word stands for; another word is refused with those that would do.
template <class Meaning>
Meaning word_of(const std::string& word, const std::string& name,
                std::initializer_list<std::pair<const char*, Meaning>> words) {
  std::string expected;
  for (const auto& [known, meaning] : words) {
    if (word == known) return meaning;
    expected += (expected.empty() ? "" : " or ") + std::string(known);
  }
  refuse_word(word, name, expected);
}

}  // namespace streetgen::pg
