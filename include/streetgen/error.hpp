// Everything the core refuses.  The border turns each kind into one SQLSTATE:
// invalid_input 22023, degenerate 22000, unsupported 0A000, cancelled 57014.
// Messages are in PostgreSQL style: lower case, no full stop, the wrong value in them.
#pragma once

#include <stdexcept>
#include <string>

namespace streetgen {

enum class ErrorKind { invalid_input, degenerate, unsupported, cancelled };

class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
  ErrorKind kind() const noexcept { return kind_; }

 private:
  ErrorKind kind_;
};

}  // namespace streetgen
