#include "frame/argument.hpp"

#include <cmath>

namespace streetgen::pg {

double in_range(double value, double low, double high, const std::string& name) {
  if (!(value >= low && value <= high))
    throw Error(ErrorKind::invalid_input, name + " is " + text_of(value) + ", expected " +
                                              text_of(low) + " to " + text_of(high));
  return value;
}

double finite(double value, const std::string& name) {
  if (!std::isfinite(value))
    throw Error(ErrorKind::invalid_input,
                name + " is " + text_of(value) + ", expected a finite number");
  return value;
}

void refuse_word(const std::string& word, const std::string& name, const std::string& expected) {
  throw Error(ErrorKind::invalid_input,
              "unknown " + name + " \"" + word + "\", expected " + expected);
}

}  // namespace streetgen::pg
