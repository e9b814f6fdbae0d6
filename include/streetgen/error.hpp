// Everything the core refuses.  The border turns each kind into one SQLSTATE:
// invalid_input 22023, degenerate 22000, unsupported 0A000, cancelled 57014, spreads SG001 (the
// border makes it of ChangeSpreads).
// Messages are in PostgreSQL style: lower case, no full stop, the wrong value in them.
#pragma once

#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>

namespace streetgen {

enum class ErrorKind { invalid_input, degenerate, unsupported, cancelled, spreads };

class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message, std::string hint = "")
      : std::runtime_error(message), kind_(kind), hint_(std::move(hint)) {}
  ErrorKind kind() const noexcept { return kind_; }
  // The way out, a sentence; empty where the message says it.
  const std::string& hint() const noexcept { return hint_; }

 private:
  ErrorKind kind_;
  std::string hint_;
};

// A number as messages show it.
inline std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", value);
  return text;
}

}  // namespace streetgen
